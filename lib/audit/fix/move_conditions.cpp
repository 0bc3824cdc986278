#include "audit/fix/move_conditions.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::audit {
namespace {

/// Adds the moves of nodes to a condition, and how much they have moved from `start` to `x`.
class Terms {
 public:
  Terms(MoveCondition& condition, const std::vector<Vector>& x, const std::vector<Vector>& start,
        const MovingNodes& moving)
      : condition_(condition), x_(x), start_(start), moving_(moving) {}
  void add(NodeIndex node, double share) {
    if (share == 0) return;
    condition_.add(moving_.slot(node), share);
    sum_ += share * condition_.direction.dot(x_[node.value] - start_[node.value]);
  }
  void subtract(const model::SegmentNodes& corners, const std::array<double, 4>& share) {
    for (std::size_t i = 0; i < 4; ++i) add(corners[i], -share[i]);
  }
  /// How much they have moved.
  [[nodiscard]] double sum() const { return sum_; }

 private:
  MoveCondition& condition_;
  const std::vector<Vector>&x_, &start_;
  const MovingNodes& moving_;
  double sum_ = 0;
};

}  // namespace

bool MoveConditions::add_shapes(const model::Mesh& mesh, const std::vector<Vector>& x,
                                std::span<const ElementOfKind> elements, ElementBounds& bounds) {
  bool any = false;
  for (const ElementOfKind& element : elements) {
    if (!shaped_.insert(element).second) continue;
    for (const ShapeCondition& c : shape_conditions(mesh, x, element, bounds.limits_of(element))) {
      shapes_.push_back(c);
      any = true;
    }
  }
  return any;
}

void MoveConditions::mark_nodes(std::vector<std::uint8_t>& marked, const JoinedNodes& joined) {
  for (const Gap& gap : gaps_.list()) {
    marked[gap.node.value] = 1;
    if (gap.kind == GapKind::edges) marked[gap.end.value] = 1;
    for (const NodeIndex n : gap.corners) marked[n.value] = 1;
  }
  for (const ShapeCondition& shape : shapes_)
    for (const NodeIndex n : shape.nodes) marked[n.value] = 1;
  mark_tied(marked, joined);
}

void MoveConditions::mark_tied(std::vector<std::uint8_t>& marked, const JoinedNodes& joined) {
  const std::size_t known = ties_.size();
  for (bool more = true; more;) {
    ties_ = ties_of(all_ties_, marked);
    more = false;
    for (const NodeIndex leader : joined.leaders()) {
      const auto followers = joined.followers(leader);
      const auto count =
          std::count_if(followers.begin(), followers.end(), [&](NodeIndex n) { return marked[n.value] != 0; });
      if (count == 0 || static_cast<std::size_t>(count) == followers.size()) continue;
      for (const NodeIndex n : followers) marked[n.value] = 1;
      more = true;
    }
  }
  if (ties_.size() != known) tie_multipliers_.assign(3 * ties_.size(), 0);
}

MoveConditions::List MoveConditions::at(const std::vector<Vector>& x, const std::vector<Vector>& start,
                                        const MovingNodes& moving) {
  List list;
  add_gaps(list, x, start, moving);
  for (std::size_t i = 0; i < ties_.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      MoveCondition c;
      c.equal = true;
      c.direction = Vector::Unit(axis);
      Terms terms(c, x, start, moving);
      terms.add(ties_[i].node, 1);
      terms.subtract(ties_[i].corners, ties_[i].share);
      c.multiplier = tie_multipliers_[3 * i + static_cast<std::size_t>(axis)];
      list.all.push_back(c);
    }
  for (const ShapeCondition& shape : shapes_) {
    MoveCondition c;
    c.direction = shape.direction;
    c.bound = shape.bound;
    for (std::size_t i = 0; i < 4; ++i)
      if (shape.coefficient[i] != 0) c.add(moving.slot(shape.nodes[i]), shape.coefficient[i]);
    c.multiplier = shape.multiplier;
    list.all.push_back(c);
  }
  return list;
}

void MoveConditions::add_gaps(List& list, const std::vector<Vector>& x, const std::vector<Vector>& start,
                              const MovingNodes& moving) {
  for (std::size_t i = 0; i < gaps_.list().size(); ++i) {
    Gap& gap = gaps_.list()[i];
    if (gap.given_up != HoldReason::none) continue;
    const GapState state = measure_gap(gap, x);
    MoveCondition c;
    c.direction = state.direction;
    Terms terms(c, x, start, moving);
    terms.add(gap.node, state.own);
    if (gap.kind == GapKind::edges) terms.add(gap.end, 1 - state.own);
    terms.subtract(gap.corners, state.share);
    c.bound = gap.distance + gap.clearance - state.gap + terms.sum();
    c.multiplier = gap.multiplier;
    if (!state.counts || !std::isfinite(c.bound) || !c.direction.allFinite()) {
      gap.multiplier = 0;
      continue;
    }
    list.all.push_back(c);
    list.gap.push_back(i);
  }
}

void MoveConditions::keep_multipliers(const List& list) {
  std::size_t i = 0;
  for (const std::size_t gap : list.gap) gaps_.list()[gap].multiplier = list.all[i++].multiplier;
  for (double& multiplier : tie_multipliers_) multiplier = list.all[i++].multiplier;
  for (ShapeCondition& shape : shapes_) shape.multiplier = list.all[i++].multiplier;
}

void MoveConditions::reset_multipliers() {
  for (Gap& gap : gaps_.list()) gap.multiplier = 0;
  std::fill(tie_multipliers_.begin(), tie_multipliers_.end(), 0.0);
  for (ShapeCondition& shape : shapes_) shape.multiplier = 0;
}

}  // namespace gapcheck::audit
