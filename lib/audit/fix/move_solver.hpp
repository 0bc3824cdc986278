#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "audit/fix/element_bounds.hpp"
#include "audit/fix/move_conditions.hpp"
#include "audit/fix/move_start.hpp"
#include "audit/fix/writable_nodes.hpp"
#include "base/work_watch.hpp"

namespace gapcheck::audit {

/// How much work was done, and how much may be (FixOptions::work); none any more once it is stopped.
struct WorkBudget {
  std::uint64_t done = 0, most = 0;
  void allow(std::uint64_t more) { most = done + more; }
  [[nodiscard]] bool used_up() const { return done > most || work_stopped(); }
  [[nodiscard]] std::uint64_t left() const { return used_up() ? 0 : most - done; }
};

/// Solves for the least movement that meets all conditions at some coordinates. Conditions that nothing can meet are
/// dropped or hold their nodes, and so do elements that lose their shape. All references must outlive it.
class MoveSolver {
 public:
  MoveSolver(const model::Mesh& mesh, MoveStart& start, MoveConditions& conditions, WritableNodes& writable,
             ElementBounds& bounds, WorkBudget& budget)
      : mesh_(mesh),
        start_(start),
        conditions_(conditions),
        writable_(writable),
        bounds_(bounds),
        budget_(budget),
        moving_(start.deck.size()) {}

  /// The coordinates with the least movement from the start that open all gaps as at `at`. Elements keep their shape.
  [[nodiscard]] std::vector<Vector> solve(const std::vector<Vector>& at);
  /// The nodes that the last solution could move, ascending.
  [[nodiscard]] const std::vector<NodeIndex>& nodes() const { return moving_.nodes(); }

 private:
  void choose_nodes();
  [[nodiscard]] bool drop_unsolvable(const MoveConditions::List& list, std::span<const Vector> moves,
                                     std::span<const Vector> mobility, bool converged);
  void hold_contradicting(const MoveConditions::List& list, std::span<const Vector> moves,
                          std::span<const Vector> mobility, double worst);

  const model::Mesh& mesh_;
  MoveStart& start_;
  MoveConditions& conditions_;
  WritableNodes& writable_;
  ElementBounds& bounds_;
  WorkBudget& budget_;
  MovingNodes moving_;
};

}  // namespace gapcheck::audit
