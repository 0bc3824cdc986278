#include <unordered_map>
#include <utility>

#include "report/formats.hpp"
#include "report/item.hpp"
#include "report/stream.hpp"

namespace gapcheck::report {
namespace {

/// GitLab's five degrees; what a deck check finds is neither a blocker of its own nor critical beyond an error.
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

void gitlab(const Report& report, const Sink& sink) {
  Stream stream(sink);
  stream.text("[");
  std::unordered_map<std::uint64_t, std::size_t> seen;
  bool first = true;
  for_each_item(report, [&](const Item& item) {
    if (!item.counts()) return true;
    stream.separator(std::exchange(first, false));
    const std::size_t before = seen[item.fingerprint]++;
    Members object(stream.buffer);
    object.string("description", item.message);
    object.string("check_name", fmt::format("{} {}", item.id, item.rule));
    object.plain("fingerprint", before == 0 ? fmt::format("{:016x}", item.fingerprint)
                                            : fmt::format("{:016x}-{}", item.fingerprint, before));
    object.plain("severity", degree(item.severity));
    object.raw("location", fmt::format("{{\"path\":{},\"lines\":{{\"begin\":{}}}}}",
                                       json_string(item.file.empty() ? report.input : item.file),
                                       item.line == 0 ? 1 : item.line));
    object.close();
    return stream.open();
  });
  stream.text(first ? "]\n" : "\n]\n");
  stream.flush();
}

}  // namespace gapcheck::report
