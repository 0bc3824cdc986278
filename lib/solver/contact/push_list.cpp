#include "solver/contact/push_list.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace gapcheck::solver {
namespace {

/// Minimum number of nodes that one thread sums, and maximum number of such ranges.
constexpr std::uint32_t least_range = 2048, most_ranges = 64;
/// If lists reach into more ranges than this on average, a single pass over them is faster.
constexpr std::size_t most_visits = 3;

/// Adds the forces on the corners in the range [`low`, `high`) of nodes.
void add_to_corners(const PushList& list, const contact::Segments& segments, std::uint32_t low, std::uint32_t high,
                    Forces& forces) {
  const bool all = list.low >= low && list.high < high;
  for (const NodePush& push : list.pushes) {
    const model::SegmentNodes& corners = segments.nodes[push.segment];
    for (std::size_t c = 0; c < 4; ++c)
      if (all || (corners[c].value >= low && corners[c].value < high))
        forces.force[corners[c].value] -= push.weights[c] * push.force;
  }
}

/// Force and moment about the origin on the tracked nodes and on the segments of a list.
struct PushTotals {
  Vector force = Vector::Zero(), tracked_moment = Vector::Zero(), reference_moment = Vector::Zero();
};

PushTotals totals(const PushList& list, const contact::Segments& segments, const std::vector<Vector>& x) {
  PushTotals totals;
  for (const NodePush& push : list.pushes) {
    const model::SegmentNodes& corners = segments.nodes[push.segment];
    Vector foot = Vector::Zero();
    for (std::size_t c = 0; c < 4; ++c) foot += push.weights[c] * x[corners[c].value];
    totals.force += push.force;
    totals.tracked_moment += x[push.node].cross(push.force);
    totals.reference_moment -= foot.cross(push.force);
  }
  return totals;
}

}  // namespace

void PushList::clear() {
  pushes.clear();
  low = 0xffffffffu;
  high = 0;
}

void PushList::add(const NodePush& push, const model::SegmentNodes& corners) {
  pushes.push_back(push);
  for (const NodeIndex corner : corners) {
    low = std::min(low, corner.value);
    high = std::max(high, corner.value);
  }
}

void add_pushes(std::span<const PushList> lists, const contact::Segments& segments, Forces& forces) {
  parallel_for(lists.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (const NodePush& push : lists[i].pushes) forces.force[push.node] += push.force;
  });
  const auto nodes = static_cast<std::uint32_t>(forces.force.size());
  const std::uint32_t range = std::max(least_range, nodes / most_ranges + 1);
  std::size_t visits = 0, filled = 0;
  for (const PushList& list : lists) {
    if (list.pushes.empty()) continue;
    ++filled;
    visits += list.high / range - list.low / range + 1;
  }
  if (visits > most_visits * filled) {
    for (const PushList& list : lists) add_to_corners(list, segments, 0, nodes, forces);
    return;
  }
  parallel_for(nodes / range + 1, 1, [&](std::size_t begin, std::size_t end) {
    for (auto r = static_cast<std::uint32_t>(begin); r < end; ++r)
      for (const PushList& list : lists)
        if (!list.pushes.empty() && list.low < (r + 1) * range && list.high >= r * range)
          add_to_corners(list, segments, r * range, (r + 1) * range, forces);
  });
}

void add_totals(std::span<const PushList> lists, const contact::Segments& segments, const std::vector<Vector>& x,
                bool exchanged, ContactState& result) {
  std::vector<PushTotals> sums(lists.size());
  parallel_for(lists.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) sums[i] = totals(lists[i], segments, x);
  });
  for (const PushTotals& sum : sums) {
    (exchanged ? result.force_b : result.force_a) += sum.force;
    (exchanged ? result.force_a : result.force_b) -= sum.force;
    (exchanged ? result.moment_b : result.moment_a) += sum.tracked_moment;
    (exchanged ? result.moment_a : result.moment_b) += sum.reference_moment;
  }
}

}  // namespace gapcheck::solver
