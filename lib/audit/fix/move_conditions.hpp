#pragma once
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "audit/fix/gaps.hpp"
#include "audit/fix/held_ties.hpp"
#include "audit/fix/least_movement.hpp"
#include "audit/fix/moving_nodes.hpp"
#include "audit/fix/shape_conditions.hpp"
#include "audit/untangle/crossing_pairs.hpp"

namespace gapcheck::audit {

/// What moves have to observe: gaps that must open, ties that stay together, elements that keep their shape. Each keeps
/// its multiplier from one solution to the next.
class MoveConditions {
 public:
  /// `index`: of the model whose records `gaps` will take; must outlive this.
  explicit MoveConditions(contact::MeshIndex& index) : gaps_(index) {}
  [[nodiscard]] Gaps& gaps() { return gaps_; }
  [[nodiscard]] const Gaps& gaps() const { return gaps_; }

  /// Replaces the ties that stay together.
  void set_ties(std::vector<HeldTie> ties) { all_ties_ = std::move(ties); }
  /// Adds conditions that keep the shape of elements that have none yet; true if there were any. `x`: the deck's
  /// coordinates.
  bool add_shapes(const model::Mesh& mesh, const std::vector<Vector>& x, std::span<const ElementOfKind> elements,
                  ElementBounds& bounds);
  /// Marks the nodes that some condition names, and those that are tied or joined to marked ones. Of the ties, those of
  /// marked nodes count from now on.
  void mark_nodes(std::vector<std::uint8_t>& marked, const JoinedNodes& joined);

  /// The conditions at some coordinates: one for each gap that counts there, then three for each tie, then those of
  /// shapes.
  struct List {
    std::vector<MoveCondition> all;
    std::vector<std::size_t> gap;  ///< of the first conditions: positions in gaps().list()
  };
  /// `start`: coordinates that the moves begin at.
  [[nodiscard]] List at(const std::vector<Vector>& x, const std::vector<Vector>& start, const MovingNodes& moving);
  /// Keeps the multipliers of a list that at() gave last.
  void keep_multipliers(const List& list);
  void reset_multipliers();

 private:
  void add_gaps(List& list, const std::vector<Vector>& x, const std::vector<Vector>& start, const MovingNodes& moving);
  void mark_tied(std::vector<std::uint8_t>& marked, const JoinedNodes& joined);

  Gaps gaps_;
  std::vector<HeldTie> all_ties_, ties_;  ///< `ties_`: those of moving nodes
  std::vector<double> tie_multipliers_;   ///< three for each of `ties_`
  std::set<ElementOfKind> shaped_;        ///< elements that have shape conditions
  std::vector<ShapeCondition> shapes_;
};

}  // namespace gapcheck::audit
