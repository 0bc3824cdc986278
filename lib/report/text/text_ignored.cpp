#include "report/text/text_ignored.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "report/item/describe.hpp"
#include "report/item/item.hpp"
#include "report/text/text_item.hpp"

namespace gapcheck::report {
namespace {

/// "deck.k:14 (10) welded on purpose".
std::string source_line(const IgnoreSource& source, bool whole) {
  std::string line = "  " + printable_path(source.file);
  if (source.line != 0) line += fmt::format(":{}", source.line);
  line += fmt::format(" ({})", source.matched);
  if (source.reason.empty()) return line + '\n';
  return line + ' ' + printable(whole ? source.reason : shortened(source.reason, reason_shown)) + '\n';
}

}  // namespace

void append_ignored(const Report& report, std::size_t top, bool list, std::string& out) {
  const Ignored& ignored = report.ignored;
  if (ignored.size() == 0) return;
  out += fmt::format("\n{} ignored\n", ignored.size());
  std::vector<std::string> findings(list ? ignored.sources.size() : 0);
  if (list)
    for_each_ignored(report, [&](const Item& item) {
      findings[static_cast<std::size_t>(item.ignored - ignored.sources.data())] += line_of(item, 4);
      return true;
    });
  const std::size_t shown = list ? ignored.sources.size() : std::min(top, ignored.sources.size());
  for (std::size_t i = 0; i < shown; ++i) {
    out += source_line(ignored.sources[i], list);
    if (list) out += findings[i];
  }
  if (shown < ignored.sources.size()) out += fmt::format("  … and {} more\n", ignored.sources.size() - shown);
}

}  // namespace gapcheck::report
