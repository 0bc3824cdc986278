#include <algorithm>
#include <map>
#include <span>

#include "report/compare/compare.hpp"
#include "report/text/check_c_tables.hpp"

namespace gapcheck::report {
namespace {

using UntiedNodes = std::map<std::int64_t, TieReason>;

/// What one source says about a contact's ties.
struct TieSide {
  bool judged = true;
  bool ties = false;                           ///< there are nodes that tie, or do not
  std::span<const std::int64_t> out_of_reach;  ///< ascending
  UntiedNodes nodes;
};

TieSide side_of(const Report& report, std::optional<std::uint32_t> position) {
  TieSide side;
  if (!position) return side;
  const ContactSummary& contact = report.contacts[*position];
  for (const TieFailure& failure : ties_of(report, *position))
    if (untied(failure.reason)) side.nodes.emplace(failure.node, failure.reason);
  side.out_of_reach = contact.nodes_out_of_reach;
  side.ties = contact.ties + contact.untied + contact.out_of_reach + side.nodes.size() > 0;
  side.judged = report.source != "deck" || side.ties || contact.not_checked.empty();
  return side;
}

bool beyond_reach(TieReason reason) { return reason == TieReason::too_far || reason == TieReason::not_found; }

/// The nodes of `from` that `other` lacks; `other` counts nodes out of reach without listing them.
void untied_only_in(const TieSide& from, const TieSide& other, bool is_first, ContactComparison& sum,
                    std::vector<TieDifference>& differences) {
  for (const auto& [node, reason] : from.nodes) {
    if (other.nodes.contains(node)) continue;
    if (beyond_reach(reason) && std::binary_search(other.out_of_reach.begin(), other.out_of_reach.end(), node)) {
      ++sum.ties_out_of_reach;
      continue;
    }
    ++(is_first ? sum.ties_only_first : sum.ties_only_second);
    differences.push_back({sum.id, node, is_first ? std::optional(reason) : std::nullopt,
                           is_first ? std::nullopt : std::optional(reason)});
  }
}

}  // namespace

void compare_ties(const Report& first, std::optional<std::uint32_t> in_first, const Report& second,
                  std::optional<std::uint32_t> in_second, ContactComparison& sum,
                  std::vector<TieDifference>& differences) {
  const TieSide a = side_of(first, in_first), b = side_of(second, in_second);
  if (!a.judged || !b.judged || (!a.ties && !b.ties)) return;
  sum.ties_compared = true;
  const std::size_t before = differences.size();
  untied_only_in(a, b, true, sum, differences);
  untied_only_in(b, a, false, sum, differences);
  for (const auto& [node, reason] : a.nodes) {
    const auto found = b.nodes.find(node);
    if (found == b.nodes.end()) continue;
    if (found->second == reason) {
      ++sum.ties_agree;
    } else {
      ++sum.ties_other_reason;
      differences.push_back({sum.id, node, reason, found->second});
    }
  }
  std::sort(differences.begin() + static_cast<std::ptrdiff_t>(before), differences.end(),
            [](const TieDifference& x, const TieDifference& y) { return x.node < y.node; });
}

}  // namespace gapcheck::report
