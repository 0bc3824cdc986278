#include "report/text/text_baseline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/baseline/baseline.hpp"
#include "report/item/describe.hpp"
#include "report/item/item.hpp"
#include "report/text/text_item.hpp"

namespace gapcheck::report {
namespace {

void append_more(std::size_t total, std::size_t shown, std::string& out) {
  if (shown < total) out += fmt::format("    … and {} more\n", total - shown);
}

void append_findings_in_state(const Report& report, BaselineState state, std::size_t top, std::string& out) {
  const std::size_t total = report.baseline->count(state);
  if (total == 0) return;
  out += fmt::format("  {}\n", name(state));
  std::size_t shown = 0;
  for_each_item(report, [&](const Item& item) {
    if (shown == top) return false;
    if (item.state == state) out += line_of(item, 4), ++shown;
    return true;
  });
  append_more(total, shown, out);
}

}  // namespace

void append_baseline(const Report& report, std::size_t top, std::string& out) {
  if (!report.baseline) return;
  out += fmt::format("\nagainst the baseline: {}\n", summary(*report.baseline));
  append_findings_in_state(report, BaselineState::fresh, top, out);
  append_findings_in_state(report, BaselineState::worse, top, out);
  const auto& gone = report.baseline->gone;
  if (gone.empty()) return;
  out += "  gone\n";
  const std::size_t shown = std::min(top, gone.size());
  for (std::size_t i = 0; i < shown; ++i) out += "    " + printable(describe(gone[i])) + '\n';
  append_more(gone.size(), shown, out);
}

}  // namespace gapcheck::report
