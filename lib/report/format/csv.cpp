#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "report/format/formats.hpp"
#include "report/item/describe.hpp"
#include "report/item/item.hpp"
#include "report/write/harmless.hpp"
#include "report/write/stream.hpp"
#include "report/write/xml_text.hpp"

namespace gapcheck::report {
namespace {

/// Fields of one line, with commas between them.
class Line {
 public:
  explicit Line(Buffer& out) : out_(out) {}
  void text(std::string_view bytes) {
    comma();
    if (plain(bytes)) return out_.append(bytes);
    std::string text = plain_text(bytes);
    if (!text.empty() && calculated(text.front())) text.insert(text.begin(), '\'');
    if (std::none_of(text.begin(), text.end(), special)) return out_.append(std::string_view(text));
    out_.push_back('"');
    for (const char c : text) {
      if (c == '"') out_.push_back('"');
      out_.push_back(c);
    }
    out_.push_back('"');
  }
  /// Empty for 0: not known.
  void id(std::int64_t value) {
    comma();
    if (value != 0) append_number(value, out_);
  }
  /// Empty unless `known` and finite.
  void number(double value, bool known) {
    comma();
    if (known && std::isfinite(value)) append_number(value, out_);
  }
  void end() { out_.append(std::string_view("\r\n")); }

 private:
  /// Spreadsheets calculate what begins so.
  static bool calculated(char c) { return std::string_view("=+-@\t").find(c) != std::string_view::npos; }
  static bool special(char c) { return c == ',' || c == '"' || c == '\r' || c == '\n'; }
  /// Needs no change: as most texts.
  static bool plain(std::string_view text) {
    return text.empty() || (!calculated(text.front()) && std::all_of(text.begin(), text.end(), [](char c) {
             return c >= ' ' && c < '\x7f' && c != ',' && c != '"';
           }));
  }
  void comma() {
    if (!first_) out_.push_back(',');
    first_ = false;
  }
  Buffer& out_;
  bool first_ = true;
};

}  // namespace

namespace {

/// The columns that only some tables have.
struct Columns {
  bool baseline = false, deck = false;
};

void append_names(const Columns& columns, Stream& stream) {
  stream.text(
      "id,rule,severity,contact,node,part,element,element_part,penetration,remaining,contact_distance,"
      "x,y,z,outcome,count,file,line,fingerprint,message");
  if (columns.baseline) stream.text(",baseline");
  if (columns.deck) stream.text(",deck");
  stream.text("\r\n");
}

void append_item(const Report& report, const Item& item, const Columns& columns, Buffer& out) {
  Line line(out);
  line.text(item.id);
  line.text(item.rule);
  line.text(name(item.severity));
  for (const std::int64_t id : {item.contact, item.node, item.part, item.element, item.element_part}) line.id(id);
  const bool depth = item.penetration >= 0, distance = item.contact_distance >= 0;
  line.number(item.penetration, depth);
  line.number(item.contact_distance - item.penetration, depth && distance);
  line.number(item.contact_distance, distance);
  for (int axis = 0; axis < 3; ++axis)
    line.number(item.position ? (*item.position)[axis] : 0, item.position.has_value());
  line.text(item.outcome);
  line.id(static_cast<std::int64_t>(item.count));
  line.text(harmless_path(item.file));
  line.id(item.line);
  line.text(fmt::format(FMT_COMPILE("{:016x}"), item.fingerprint));
  line.text(item.message);
  if (columns.baseline) line.text(item.state ? name(*item.state) : "");
  if (columns.deck) line.text(harmless_path(report.input));
  line.end();
}

}  // namespace

void csv(const Reports& reports, const Sink& sink) {
  const bool baseline = std::any_of(reports.all.begin(), reports.all.end(),
                                    [](const Report& report) { return report.baseline.has_value(); });
  const Columns columns{baseline, reports.several()};
  Stream stream(sink);
  append_names(columns, stream);
  for (const Report& report : reports.all) {
    const Items items(report);
    stream.entries(items.size(), [&](std::size_t i, Buffer& out) { append_item(report, items[i], columns, out); });
  }
  stream.flush();
}

}  // namespace gapcheck::report
