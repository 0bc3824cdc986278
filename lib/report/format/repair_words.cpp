#include "report/format/repair_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "report/format/fix_words.hpp"
#include "report/item/describe.hpp"

namespace gapcheck::report {
namespace {

using fix_words::plural;

/// "32 nodes in all, here by at most 0.2078; 2 ties fewer".
std::string effects(const Repair& repair) {
  const RepairOutcome& outcome = repair.outcome;
  std::vector<std::string> list;
  if (outcome.moved > 0)
    list.push_back(fmt::format("{} in all, here by at most {:.4g}; {:.3g} % of all elements change",
                               plural(outcome.moved, "node"), outcome.largest_move, 100 * outcome.changed_elements));
  if (outcome.forgiven > 0 && repair.kind != RepairKind::ignore)
    list.push_back(plural(outcome.forgiven, "node") + " stay without force");
  if (outcome.added > 0) list.push_back(plural(outcome.added, "penetration") + " more elsewhere");
  if (outcome.lost_ties > 0) list.push_back(plural(outcome.lost_ties, "tie") + " fewer");
  if (outcome.untied > 0) list.push_back(plural(outcome.untied, "penetrating node") + " not tied");
  if (outcome.crossings > 0) list.push_back(plural(outcome.crossings, "crossing") + " more");
  return fmt::format("{}", fmt::join(list, "; "));
}

}  // namespace

std::string what_it_does(const Repair& repair) {
  if (!repair.outcome.refused.empty()) return repair.text + "; not possible: " + printable(repair.outcome.refused);
  const std::string more = effects(repair);
  return more.empty() ? repair.text : fmt::format("{} ({})", repair.text, more);
}

}  // namespace gapcheck::report
