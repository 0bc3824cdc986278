#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "base/ids.hpp"
#include "records/report.hpp"

namespace gapcheck::audit {

/// One thing that a rule found, before it becomes a message.
struct Found {
  std::int64_t group = 0;  ///< things of one group are counted together; groups are reported ascending
  double weight = 0;       ///< the heaviest of a group are reported in full; equal ones by ids
  std::uint64_t item = 0;  ///< by which the rule finds it again
  /// Equally heavy ones are reported by this, then by item: ids, so that the order of the deck's rows does not matter.
  std::array<std::int64_t, 2> ids{};
};

/// A weight that rounding in the last digits does not change, for things that are equally heavy by construction.
[[nodiscard]] inline double rough_weight(double weight) {
  return static_cast<double>(static_cast<float>(std::clamp(weight, -1e38, 1e38)));
}

/// The group of two parts, in whichever order.
[[nodiscard]] inline std::int64_t part_pair(PartIndex a, PartIndex b) {
  const auto [low, high] = std::minmax(a.value, b.value);
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) << 32 | high);
}

/// How many findings of one group are reported in full if more than one is left over.
inline constexpr std::size_t found_in_full = 10;

/// Adds the nodes and segments of one thing to those of a finding; empty: not asked for.
using Collect = std::function<void(const Found&, FindingMembers&)>;

/// Adds the heaviest findings of each group in full and one finding for the rest of it, if any: a fault of the whole
/// mesh must not drown the others. `words(found)` makes one finding; `rest(heaviest of the rest, count)` the one that
/// represents `count` more, whose `count` is filled in here. `collect` is called for each thing that a finding
/// represents.
void add_grouped(Report& report, std::vector<Found> found, const std::function<Finding(const Found&)>& words,
                 const std::function<Finding(const Found&, std::uint64_t)>& rest, const Collect& collect = {});

/// Adds the first findings of a rule in full and one finding for the rest, if any: for rules that can fire for every
/// contact of a deck. `what` names the rest: "more tied contacts have friction values".
void add_first(Report& report, std::vector<Finding> found, std::string_view what);

}  // namespace gapcheck::audit
