#include <unordered_map>
#include <utility>

#include "report/format/formats.hpp"
#include "report/item/item.hpp"
#include "report/write/normal_path.hpp"
#include "report/write/stream.hpp"

namespace gapcheck::report {
namespace {

/// GitLab's five levels; findings of a deck check are neither blockers nor more critical than an error.
std::string_view degree(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "info";
    case Severity::warning:
      return "minor";
    case Severity::error:
      return "major";
  }
  return "major";
}

}  // namespace

namespace {

/// `seen`: how often each fingerprint has occurred.
void append_items(const Report& report, std::unordered_map<std::uint64_t, std::size_t>& seen, Stream& stream) {
  for_each_item(report, [&](const Item& item) {
    if (!item.counts()) return true;
    stream.separator(seen.empty());
    const std::size_t before = seen[item.fingerprint]++;
    Members object(stream.buffer);
    object.string("description", item.message);
    object.string("check_name", fmt::format("{} {}", item.id, item.rule));
    object.plain("fingerprint", before == 0 ? fmt::format("{:016x}", item.fingerprint)
                                            : fmt::format("{:016x}-{}", item.fingerprint, before));
    object.plain("severity", degree(item.severity));
    object.object("location", [&](Members& location) {
      location.string("path", normal_path(item.file.empty() ? report.input : item.file));
      location.object("lines", [&](Members& lines) { lines.integer("begin", item.line == 0 ? 1 : item.line); });
    });
    object.close();
    return stream.open();
  });
}

}  // namespace

void gitlab(const Reports& reports, const Sink& sink) {
  Stream stream(sink);
  stream.text("[");
  std::unordered_map<std::uint64_t, std::size_t> seen;
  for (const Report& report : reports.all) append_items(report, seen, stream);
  stream.text(seen.empty() ? "]\n" : "\n]\n");
  stream.flush();
}

}  // namespace gapcheck::report
