#pragma once
#include <cstdint>
#include <vector>

#include "contact/pair/node_contact.hpp"
#include "records/penetration.hpp"
#include "solver/contact/contact_source.hpp"

namespace gapcheck::solver {

/// What contact did not need to do, and did.
struct ContactCounters {
  std::uint64_t searches = 0;    ///< global ones
  std::uint64_t candidates = 0;  ///< pairs that these left
  std::uint64_t nodes = 0;       ///< looked at, of all cycles
  std::uint64_t pairs = 0;       ///< decided, of all cycles
  std::uint64_t followed = 0;    ///< of these: from where they were in the last cycle
  std::uint64_t asleep = 0;      ///< nodes near something that needed no look, of all cycles
  double search_s = 0, force_s = 0;
};

/// One part of what a penalty contact does in every cycle: nodes against segments, edges against edges, …
class InterfacePass {
 public:
  virtual ~InterfacePass() = default;
  /// What the initialisation did to a node of this contact; records of other passes are passed over.
  virtual void remember(const Penetration& /*record*/, const contact::NodeContact& /*memory*/) {}
  /// The step that stiffness follows where it does.
  virtual void set_timestep(double timestep) = 0;
  /// Global search, good until anything has come closer to anything else by `margin`.
  virtual void search(double margin, ContactCounters& counters) = 0;
  /// Looks at all that can have come into contact since the search; `used`: how far anything can have come closer since
  /// then. Moves shooting nodes in `state`, returns the longest such move.
  virtual double update(State& state, double used, ContactCounters& counters) = 0;
  /// Adds the forces, and what they did since the last cycle.
  virtual void apply(const State& state, Forces& forces, ContactState& result) const = 0;
  /// Goes on where the pass `before` has been, which had other surfaces of the same contact: memory of nodes, forces
  /// whose segments are still there; the other forces end. Comes before the first search.
  virtual void carry_over(InterfacePass& before, const State& state, ContactState& result) {
    before.rest(state, result);
  }
  /// The contact is not active: forces end, memory is lost.
  virtual void rest(const State& state, ContactState& result) = 0;
  [[nodiscard]] virtual std::vector<ContactNode> nodes() const = 0;
  virtual void links(std::vector<ContactLink>& links) const = 0;
};

}  // namespace gapcheck::solver
