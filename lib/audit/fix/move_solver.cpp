#include "audit/fix/move_solver.hpp"

#include <algorithm>

namespace gapcheck::audit {
namespace {

constexpr std::size_t sweeps = 2000;
/// Relative to the largest gap to open: the accuracy of the least movement, and the limit of a contradiction.
constexpr double solved = 1e-7, contradicted = 1e-3;
/// Attempts to find moves that keep all elements in shape; each holds at least one more node.
constexpr int attempts = 200;

}  // namespace

/// All nodes that some condition names, or that are tied or joined to such nodes.
void MoveSolver::choose_nodes() {
  std::vector<std::uint8_t> marked(start_.deck.size());
  for (std::size_t i = 0; i < marked.size(); ++i) marked[i] = start_.x[i] != start_.deck[i];
  conditions_.mark_nodes(marked, start_.freedoms.joined);
  moving_.set(marked, start_.freedoms.joined);
  writable_.hold_others(moving_.nodes(), start_.freedoms);
}

std::vector<Vector> MoveSolver::solve(const std::vector<Vector>& at) {
  choose_nodes();
  std::vector<Vector> moves, mobility;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    moves.resize(moving_.leaders().size());
    mobility.clear();
    for (const NodeIndex n : moving_.leaders()) mobility.push_back(start_.freedoms.mobility[n.value]);
    MoveConditions::List list = conditions_.at(at, start_.x, moving_);
    double largest = 0;
    for (const MoveCondition& c : list.all) largest = std::max(largest, c.bound);
    const MovementResult result = least_movement(list.all, mobility, moves, solved * largest, sweeps);
    conditions_.keep_multipliers(list);
    budget_.done += result.sweeps * list.all.size();
    if (budget_.used_up()) break;
    if (drop_unsolvable(list, moves, mobility, result.sweeps < sweeps)) continue;
    std::vector<Vector> x = start_.x;
    for (const NodeIndex n : moving_.nodes()) x[n.value] += moves[moving_.slot(n)];
    const std::vector<ElementOfKind> broken = bounds_.broken(x, moving_.nodes());
    if (broken.empty()) return x;
    // Neighbours first move along; elements that this does not help are held.
    if (conditions_.add_shapes(mesh_, start_.deck, broken, bounds_))
      choose_nodes();
    else
      for (const NodeIndex n : bounds_.offenders(x, broken)) start_.hold_in_deck(n, HoldReason::shape);
  }
  return start_.x;
}

/// Gives up gaps that no node can move for, and holds the nodes of contradicting conditions. True if there were any:
/// then the moves must be found again.
bool MoveSolver::drop_unsolvable(const MoveConditions::List& list, std::span<const Vector> moves,
                                 std::span<const Vector> mobility, bool converged) {
  bool any = false;
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < list.gap.size(); ++i) {
    Gap& gap = conditions_.gaps().list()[list.gap[i]];
    const double missing = violation(list.all[i], moves);
    largest = std::max(largest, list.all[i].bound);
    if (compliance(list.all[i], mobility) > 0) {
      worst = std::max(worst, missing);
    } else if (missing > gap.clearance * (1 - move_rounding)) {
      const HoldReason why = start_.freedoms.reason[gap.node.value];
      gap.given_up = why == HoldReason::none ? HoldReason::conflict : why;
      any = true;
    }
  }
  if (converged || !(worst > contradicted * largest)) return any;
  hold_contradicting(list, moves, mobility, worst);
  conditions_.reset_multipliers();
  return true;
}

/// Holds the nodes of the gaps that are farthest from opening. `worst`: how far the farthest is.
void MoveSolver::hold_contradicting(const MoveConditions::List& list, std::span<const Vector> moves,
                                    std::span<const Vector> mobility, double worst) {
  Freedoms& freedoms = start_.freedoms;
  for (std::size_t i = 0; i < list.gap.size(); ++i) {
    const Gap& gap = conditions_.gaps().list()[list.gap[i]];
    if (compliance(list.all[i], mobility) == 0 || !(violation(list.all[i], moves) >= worst / 2)) continue;
    if (freedoms.held(gap.node))
      for (const NodeIndex n : gap.corners) freedoms.hold(n, HoldReason::conflict);
    if (gap.kind == GapKind::edges) freedoms.hold(gap.end, HoldReason::conflict);
    freedoms.hold(gap.node, HoldReason::conflict);
  }
}

}  // namespace gapcheck::audit
