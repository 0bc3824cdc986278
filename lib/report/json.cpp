#include <fmt/compile.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>
#include <vector>

#include "report/describe.hpp"
#include "report/fingerprint.hpp"
#include "report/writers.hpp"

namespace gapcheck::report {
namespace {

using Buffer = fmt::memory_buffer;

/// A JSON string with its quotes; bytes that are no UTF-8 become U+FFFD.
std::string json_string(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Appends members of objects to a buffer; every call but the first of an object writes the comma before.
class Members {
 public:
  explicit Members(Buffer& out) : out_(out) { out_.push_back('{'); }
  void close() { out_.push_back('}'); }

  void key(std::string_view name) {
    if (!first_) out_.push_back(',');
    first_ = false;
    out_.push_back('"');
    out_.append(name);
    out_.append(std::string_view("\":"));
  }
  /// `text` needs no escapes.
  void plain(std::string_view name, std::string_view text) {
    key(name);
    out_.push_back('"');
    out_.append(text);
    out_.push_back('"');
  }
  void string(std::string_view name, std::string_view text) { raw(name, json_string(text)); }
  void raw(std::string_view name, std::string_view json) {
    key(name);
    out_.append(json);
  }
  template <class Integer>
  void integer(std::string_view name, Integer value) {
    key(name);
    fmt::format_to(fmt::appender(out_), FMT_COMPILE("{}"), value);
  }
  void number(std::string_view name, double value) {
    key(name);
    append_number(value);
  }
  /// An array of numbers or integers.
  template <class Range>
  void array(std::string_view name, const Range& values) {
    key(name);
    char separator = '[';
    for (const auto value : values) {
      out_.push_back(separator);
      if constexpr (std::is_floating_point_v<std::remove_const_t<decltype(value)>>)
        append_number(value);
      else
        fmt::format_to(fmt::appender(out_), FMT_COMPILE("{}"), value);
      separator = ',';
    }
    out_.push_back(']');
  }
  void fingerprint(std::uint64_t value) {
    key("fingerprint");
    fmt::format_to(fmt::appender(out_), FMT_COMPILE("\"{:016x}\""), value);
  }

 private:
  /// Shortest text that reads back as the same number; JSON has no infinity.
  void append_number(double value) {
    if (std::isfinite(value))
      fmt::format_to(fmt::appender(out_), FMT_COMPILE("{}"), value);
    else
      out_.append(std::string_view("null"));
  }

  Buffer& out_;
  bool first_ = true;
};

std::array<double, 3> coordinates(const Vector& x) { return {x[0], x[1], x[2]}; }

void append_model(const ModelCounts& model, Buffer& out) {
  Members object(out);
  object.integer("nodes", model.nodes);
  object.integer("shells", model.shells);
  object.integer("solids", model.solids);
  object.integer("beams", model.beams);
  object.integer("thick_shells", model.thick_shells);
  object.integer("discrete", model.discrete);
  object.integer("masses", model.masses);
  object.integer("particles", model.particles);
  object.integer("parts", model.parts);
  object.integer("contacts", model.contacts);
  object.close();
}

void append_contact(const ContactSummary& contact, Buffer& out) {
  Members object(out);
  object.integer("id", contact.id);
  object.integer("order", contact.order);
  object.string("title", contact.title);
  object.string("keyword", contact.keyword);
  object.string("type", contact.type);
  object.integer("tracked_nodes", contact.tracked_nodes);
  object.integer("segments", contact.segments);
  object.integer("penetrations", contact.penetrations);
  object.integer("released", contact.released);
  object.integer("edge_zone", contact.edge_zone);
  object.number("max_penetration", contact.max_penetration);
  object.integer("ties", contact.ties);
  object.integer("untied", contact.untied);
  if (!contact.not_checked.empty()) object.string("not_checked", contact.not_checked);
  if (!contact.file.empty()) object.string("file", contact.file);
  if (contact.line != 0) object.integer("line", contact.line);
  object.close();
}

/// `files`: the report's file names, quoted.
void append_penetration(const Report& report, const Penetration& record, const std::vector<std::string>& files,
                        Buffer& out) {
  const RecordRule rule = rule_of(record.kind);
  const bool contact_known = record.contact < report.contacts.size();
  const std::int64_t contact = contact_known ? report.contacts[record.contact].id : 0;
  Members object(out);
  object.plain("rule", rule.name);
  object.plain("id", rule.id);
  object.plain("severity", name(rule.severity));
  object.key("message");
  out.push_back('"');
  append_message(record, out);
  out.push_back('"');
  if (contact_known) object.integer("contact", contact);
  object.integer("node", record.node);
  if (record.part != 0) object.integer("part", record.part);
  if (record.segment[0] != 0) object.array("segment", record.segment);
  if (record.element != 0) object.integer("element", record.element);
  if (record.element_part != 0) object.integer("element_part", record.element_part);
  object.number("penetration", record.depth);
  object.number("remaining", record.remaining());
  object.number("contact_distance", record.contact_distance);
  object.array("st", std::array{record.s, record.t});
  object.plain("feature", name(record.feature));
  object.array("original", coordinates(record.original));
  object.array("point", coordinates(record.point));
  if (record.outcome == Outcome::moved || record.moved_to != record.original)
    object.array("moved_to", coordinates(record.moved_to));
  // The solver does not list nodes of the edge zone, so nothing happens to them yet.
  if (record.kind != PenetrationKind::edge_zone) object.plain("outcome", name(record.outcome));
  if (record.node_rule != ThicknessRule::none || record.segment_rule != ThicknessRule::none) {
    object.key("cause");
    out.push_back('"');
    append_cause(record, out);
    out.push_back('"');
  }
  if (record.line != 0 && record.file < files.size()) {
    object.raw("file", files[record.file]);
    object.integer("line", record.line);
  }
  object.fingerprint(fingerprint(record, contact));
  object.close();
}

void append_finding(const Finding& finding, Buffer& out) {
  Members object(out);
  object.string("rule", finding.rule);
  object.string("id", finding.id);
  object.plain("severity", name(finding.severity));
  object.string("message", finding.message);
  if (finding.contact != 0) object.integer("contact", finding.contact);
  if (!finding.file.empty()) object.string("file", finding.file);
  if (finding.line != 0) object.integer("line", finding.line);
  object.fingerprint(fingerprint(finding));
  object.close();
}

void append_timing(const Timing& timing, Buffer& out) {
  Members object(out);
  object.number("read_s", timing.read_s);
  object.number("model_s", timing.model_s);
  object.number("surface_s", timing.surface_s);
  object.number("search_s", timing.search_s);
  object.number("report_s", timing.report_s);
  object.number("total_s", timing.total_s);
  object.close();
}

/// One piece of output on its way; hands it on when it is large enough.
class Stream {
 public:
  explicit Stream(const Sink& sink) : sink_(sink) { buffer.reserve(limit + limit / 16); }
  void text(std::string_view text) { buffer.append(text); }
  /// Between the lines of a list; also the moment to hand on what is there.
  void separator(bool first) {
    text(first ? "\n  " : ",\n  ");
    if (buffer.size() >= limit) flush();
  }
  void flush() {
    if (open_) open_ = sink_({buffer.data(), buffer.size()});
    buffer.clear();
  }
  [[nodiscard]] bool open() const { return open_; }
  Buffer buffer;

 private:
  static constexpr std::size_t limit = std::size_t{1} << 20;
  const Sink& sink_;
  bool open_ = true;
};

void append_findings(const Report& report, Stream& stream) {
  std::vector<std::string> files;
  files.reserve(report.files.size());
  for (const std::string& file : report.files) files.push_back(json_string(file));
  bool first = true;
  for (const Penetration& record : report.penetrations) {
    if (!stream.open()) return;
    stream.separator(std::exchange(first, false));
    append_penetration(report, record, files, stream.buffer);
  }
  for (const Finding& finding : report.findings) {
    if (!stream.open()) return;
    stream.separator(std::exchange(first, false));
    append_finding(finding, stream.buffer);
  }
}

}  // namespace

void json(const Report& report, const Sink& sink) {
  Stream stream(sink);
  stream.text("{\"schema\":\"gapcheck/1\",\"source\":");
  stream.text(json_string(report.source));
  stream.text(",\"input\":");
  stream.text(json_string(report.input));
  stream.text(",\n\"model\":");
  append_model(report.model, stream.buffer);
  stream.text(",\n\"contacts\":[");
  bool first = true;
  for (const ContactSummary& contact : report.contacts) {
    stream.separator(std::exchange(first, false));
    append_contact(contact, stream.buffer);
  }
  stream.text("],\n\"findings\":[");
  append_findings(report, stream);
  const Totals sum = totals(report);
  fmt::format_to(fmt::appender(stream.buffer), "],\n\"summary\":{{\"errors\":{},\"warnings\":{},\"notes\":{}}},\n",
                 sum.errors, sum.warnings, sum.notes);
  stream.text("\"timing\":");
  append_timing(report.timing, stream.buffer);
  stream.text("}\n");
  stream.flush();
}

std::string json(const Report& report) {
  constexpr std::size_t typical_finding = 800;
  std::string result;
  result.reserve((report.penetrations.size() + report.findings.size()) * typical_finding);
  json(report, [&result](std::string_view piece) {
    result += piece;
    return true;
  });
  return result;
}

}  // namespace gapcheck::report
