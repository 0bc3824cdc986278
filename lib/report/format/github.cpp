#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "report/format/formats.hpp"
#include "report/item/describe.hpp"
#include "report/item/item.hpp"
#include "report/write/normal_path.hpp"
#include "report/write/stream.hpp"
#include "report/write/xml_text.hpp"

namespace gapcheck::report {
namespace {

/// As the runner's commands require; properties must also avoid colons and commas.
std::string escaped(std::string_view text, bool property) {
  std::string out;
  for (const char c : plain_text(text)) {
    const bool special = c == '%' || c == '\r' || c == '\n' || (property && (c == ':' || c == ','));
    out += special ? fmt::format("%{:02X}", static_cast<unsigned char>(c)) : std::string(1, c);
  }
  return out;
}

std::string_view command(Severity severity) { return severity == Severity::note ? "notice" : name(severity); }

void annotate(Severity severity, std::string_view file, std::uint32_t line, std::string_view title,
              std::string_view message, Stream& stream) {
  stream.text(fmt::format("::{} file={}", command(severity), escaped(normal_path(file), true)));
  if (line != 0) stream.text(fmt::format(",line={}", line));
  stream.text(fmt::format(",title={}::{}\n", escaped(title, true), escaped(message, false)));
  stream.pause();
}

void annotate(const Report& report, const ItemGroup& group, Stream& stream) {
  const std::string title = fmt::format("{} {}", group.id, group.rule);
  for (const Item& item : group.shown) {
    const std::string link = link_to(report, item.number);
    annotate(item.severity, item.file.empty() ? report.input : item.file, item.line, title,
             link.empty() ? item.message : item.message + " (" + link + ")", stream);
  }
  const std::size_t more = group.items - group.shown.size();
  if (more == 0) return;
  const bool of_contact = group.contact_position != no_position;
  const ContactSummary none, &contact = of_contact ? report.contacts[group.contact_position] : none;
  const std::string where = of_contact ? fmt::format(" in contact {}", contact.id) : "";
  annotate(group.severity, contact.file.empty() ? report.input : contact.file, contact.line, title,
           fmt::format("{} more{}: see the whole report", more, where), stream);
}

}  // namespace

namespace {

void annotate(const Report& report, std::size_t top, Stream& stream) {
  std::vector<ItemGroup> groups = item_groups(report, top);
  std::stable_sort(groups.begin(), groups.end(),
                   [](const ItemGroup& a, const ItemGroup& b) { return a.severity > b.severity; });
  std::size_t known = 0;
  for (const ItemGroup& group : groups) {
    annotate(report, group, stream);
    known += group.known;
  }
  if (known > 0)
    annotate(Severity::note, report.input, 0, "baseline",
             fmt::format("{} findings that the baseline knows are left out", known), stream);
  if (const std::size_t ignored = report.ignored.size(); ignored > 0) {
    const std::vector<IgnoreSource>& sources = report.ignored.sources;
    const std::string more = sources.size() > 1 ? fmt::format(" and {} more", sources.size() - 1) : "";
    annotate(Severity::note, sources.front().file, sources.front().line, "ignored",
             fmt::format("{} left out on purpose by {}{}", ignored, describe(sources.front()), more), stream);
  }
}

}  // namespace

void github(const Reports& reports, std::size_t top, const Sink& sink) {
  Stream stream(sink);
  for (const Report& report : reports.all) annotate(report, top, stream);
  stream.flush();
}

}  // namespace gapcheck::report
