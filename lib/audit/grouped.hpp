#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "base/ids.hpp"
#include "records/report.hpp"

namespace gapcheck::audit {

/// One thing that a rule found, before it is put into words.
struct Found {
  std::int64_t group = 0;  ///< things of one group are counted together; groups are reported ascending
  double weight = 0;       ///< the heaviest of a group are reported in full; equal ones by item
  std::uint64_t item = 0;  ///< what the rule finds it by again
};

/// The group of two parts, in whichever order.
[[nodiscard]] inline std::int64_t part_pair(PartIndex a, PartIndex b) {
  const auto [low, high] = std::minmax(a.value, b.value);
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) << 32 | high);
}

/// How many findings of one group are reported in full where there are more than one beyond them.
inline constexpr std::size_t found_in_full = 10;

/// Adds the nodes and segments of one thing to those of a finding; empty: nobody asked for them.
using Collect = std::function<void(const Found&, FindingMembers&)>;

/// Adds the heaviest findings of each group in full and one finding for the rest of it, if there is a rest: a fault that
/// a whole mesh has must not drown the others. `words(found)` makes one finding; `rest(heaviest of the rest, count)` the
/// one that stands for `count` more, whose `count` is filled in here. `collect` is called for each thing that a finding
/// stands for.
void add_grouped(Report& report, std::vector<Found> found, const std::function<Finding(const Found&)>& words,
                 const std::function<Finding(const Found&, std::uint64_t)>& rest, const Collect& collect = {});

/// Adds the first findings of a rule in full and one finding for the rest, if there is a rest: for rules that can fire
/// for every contact of a deck. `what` names the rest: "more tied contacts have friction values".
void add_first(Report& report, std::vector<Finding> found, std::string_view what);

}  // namespace gapcheck::audit
