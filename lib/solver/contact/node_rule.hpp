#pragma once
#include <cstdint>

#include "contact/pair/node_contact.hpp"
#include "solver/interface/contact_link.hpp"
#include "solver/interface/contact_spring.hpp"

namespace gapcheck::solver {

struct State;
struct SegmentContact;

/// Factor of the stiffness of all springs of a contact in the last cycle and in this one. What springs store for more
/// of it nobody has paid for.
struct SpringGrowth {
  double before = 1, now = 1;
};

/// The decisions of one kind of contact about a tracked node and a segment: the spring between them, the side from
/// which the node came, and whether it is pushed, moved or released. Decisions about different nodes are independent
/// and may be made on several threads.
class NodeRule {
 public:
  virtual ~NodeRule() = default;
  /// False if the results of the initialisation are not used.
  [[nodiscard]] virtual bool keeps_initial_memory() const = 0;
  /// The step that the stiffness follows, if it does.
  virtual void set_timestep(double timestep) = 0;
  /// Called before all decisions of a cycle; true: the springs have changed.
  virtual bool begin_cycle(const State& /*state*/) { return false; }
  /// What begin_cycle() has done to all springs.
  [[nodiscard]] virtual SpringGrowth growth() const { return {}; }

  /// The spring between a node and a segment, and the penetration beyond which the node is released.
  [[nodiscard]] virtual ContactSprings::Spring spring(SlotIndex slot, SegmentIndex segment) const = 0;
  [[nodiscard]] virtual double release_depth(SlotIndex slot, SegmentIndex segment) const = 0;
  /// Changes the spring that spring() gave, in this cycle; `closing`: speed of penetration. Called once for each node
  /// with force.
  virtual void bend(SlotIndex /*slot*/, double /*depth*/, double /*closing*/, LinkSpring& /*law*/) {}
  /// Whether it remembers more about nodes than NodeContact.
  [[nodiscard]] virtual bool has_memory() const { return false; }
  /// Brings back a node that has passed the surface: changes the sign of the distance. Called once per check;
  /// `contact`: null if it penetrates nothing.
  virtual void bring_back(SlotIndex /*slot*/, SegmentContact* /*contact*/) {}
  /// What happens to a node in this cycle, and what is remembered.
  [[nodiscard]] virtual contact::NodeAction decide_action(contact::NodeContact& memory,
                                                          const contact::NodeEncounter& encounter) const = 0;

  /// Takes over what the rule of the same contact on other surfaces remembers about its nodes.
  virtual void continue_from(const NodeRule& /*before*/) {}
  /// Forgets everything; the contact is not active.
  virtual void forget() {}
};

}  // namespace gapcheck::solver
