#include "audit/fix/writable_nodes.hpp"

#include "audit/fix/move_start.hpp"

namespace gapcheck::audit {

void WritableNodes::hold_others(std::span<const NodeIndex> nodes, Freedoms& freedoms) {
  for (const NodeIndex n : nodes) {
    if (known_[n.value] != 0 || freedoms.held(n)) continue;
    known_[n.value] = 1;
    const Status status = deck_[n.value].allFinite() ? lines_.check(n) : plain_error("its coordinates are no numbers");
    if (status.ok()) continue;
    freedoms.hold(n, HoldReason::unwritable);
    const auto [entry, added] = unwritable_.try_emplace(status.error().message, Unwritable{n, 0});
    ++entry->second.count;
  }
}

std::vector<Vector> WritableNodes::written(const std::vector<Vector>& x) {
  std::vector<NodeIndex> moved;
  for (const NodeIndex n : positions<NodeIndex>(x.size()))
    if (x[n.value] != deck_[n.value]) moved.push_back(n);
  std::vector<Vector> result = deck_;
  const double least = move_rounding * largest_difference(x, deck_, moved);
  for (const NodeIndex n : moved)
    if ((x[n.value] - deck_[n.value]).norm() > least) result[n.value] = lines_.written(n, x[n.value]);
  return result;
}

}  // namespace gapcheck::audit
