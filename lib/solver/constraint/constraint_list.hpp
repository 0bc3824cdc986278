#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "solver/constraint/constraint_solve.hpp"

namespace gapcheck::solver {

/// The origin of a constraint: a node of a pass of a contact.
struct ConstraintOrigin {
  std::uint32_t interface = 0;  ///< position among the contacts calculated by constraints
  std::uint32_t pass = 0;       ///< 1: side B's nodes
  SlotIndex slot;
  double area = 0;  ///< of the segment
  /// Ascending order of contact, pass and slot.
  [[nodiscard]] static bool before(const ConstraintOrigin& a, const ConstraintOrigin& b);
};

/// The constraints of all contacts in one step with their origins, and the bookkeeping of their reactions: forces, sums
/// and work. `states`: one for each contact that is calculated by constraints.
class ConstraintList {
 public:
  void clear();
  void add(const SurfaceConstraint& constraint, const ConstraintOrigin& origin);
  /// Removes constraints that do not push.
  void remove_idle();
  [[nodiscard]] std::size_t size() const { return constraints_.size(); }
  [[nodiscard]] std::span<SurfaceConstraint> constraints() { return constraints_; }
  [[nodiscard]] std::vector<ConstraintOrigin> sorted_origins() const;

  /// Adds half of the work of the present reactions over the last step: to be called once when they are new and once
  /// when they are old.
  void add_work(const State& state, std::span<ContactState> states) const;
  /// Adds the reactions to both `net` and `external`, and to the sums of the contacts. `x`: present coordinates.
  void add_forces(const std::vector<Vector>& x, Forces& net, Forces& external, std::span<ContactState> states) const;
  /// Adds the nodes with reactions, or the reactions, of one contact.
  void add_nodes(std::size_t interface, std::vector<ContactNode>& nodes) const;
  void add_links(std::size_t interface, std::vector<ContactLink>& links) const;

 private:
  std::vector<SurfaceConstraint> constraints_;
  std::vector<ConstraintOrigin> origins_;  // parallel to constraints_
};

}  // namespace gapcheck::solver
