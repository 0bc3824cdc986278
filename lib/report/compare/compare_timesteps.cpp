#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "report/compare/compare.hpp"
#include "report/text/text_run.hpp"

namespace gapcheck::report {
namespace {

/// By contact id and side; of equal ids the first counts.
using Sides = std::map<std::pair<std::int64_t, char>, const SurfaceTimestep*>;

Sides sides_of(const Report& report, const Timesteps& steps) {
  Sides sides;
  for (const SurfaceTimestep& side : steps.surface_timesteps)
    if (side.contact < report.contacts.size())
      sides.emplace(std::pair(report.contacts[side.contact].id, side.side), &side);
  return sides;
}

/// Half a unit in the fourth digit, which is what the solver prints.
bool same_step(double a, double b) {
  const double larger = std::max(a, b);
  if (!(larger > 0) || !std::isfinite(larger)) return a == b;
  return std::abs(a - b) <= 0.5 * std::pow(10.0, std::floor(std::log10(larger)) - 3) * (1 + 1e-6);
}

}  // namespace

TimestepComparison compare_timesteps(const Report& first, const Report& second) {
  TimestepComparison sum;
  const Timesteps *a = timesteps(first), *b = timesteps(second);
  if (a == nullptr || b == nullptr) return sum;
  const Sides in_first = sides_of(first, *a), in_second = sides_of(second, *b);
  for (const auto& [key, one] : in_first) {
    const auto other = in_second.find(key);
    if (other == in_second.end()) {
      ++sum.only_first;
      continue;
    }
    const TimestepDifference pair{key.first, key.second,         one->timestep, other->second->timestep,
                                  one->node, other->second->node};
    const bool limited = std::min(pair.first, pair.second) < no_timestep_limit;
    if (!same_step(pair.first, pair.second)) {
      ++sum.differ;
      sum.differences.push_back(pair);
    } else if (limited && pair.node_first != pair.node_second) {
      ++sum.other_node;
      sum.differences.push_back(pair);
    } else {
      ++sum.agree;
    }
  }
  for (const auto& [key, side] : in_second) sum.only_second += in_first.contains(key) ? 0 : 1;
  return sum;
}

}  // namespace gapcheck::report
