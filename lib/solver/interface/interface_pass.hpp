#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "contact/pair/node_contact.hpp"
#include "records/penetration.hpp"
#include "solver/interface/contact_source.hpp"
#include "solver/interface/touch.hpp"

namespace gapcheck::solver {

/// Work that contact skipped and did.
struct ContactCounters {
  std::uint64_t searches = 0;    ///< global ones
  std::uint64_t candidates = 0;  ///< pairs that these left
  std::uint64_t crowded = 0;     ///< nodes and edges that were searched for the nearest only, over all searches
  std::uint64_t nodes = 0;       ///< checked, over all cycles
  std::uint64_t pairs = 0;       ///< decided, over all cycles
  std::uint64_t followed = 0;    ///< of these: started from their position in the last cycle
  std::uint64_t asleep = 0;      ///< nodes near something that needed no check, over all cycles
  double search_s = 0, force_s = 0;
};

/// What a pass remembers of its nodes from cycle to cycle.
struct PassMemory {
  virtual ~PassMemory() = default;
};

/// One part of what a penalty contact does in every cycle: nodes against segments, edges against edges, …
class InterfacePass {
 public:
  virtual ~InterfacePass() = default;
  /// What the initialisation did to a node of this contact; records of other passes are skipped.
  virtual void set_memory(const Penetration& /*record*/, const contact::NodeContact& /*memory*/) {}
  /// The step that the stiffness follows, if it does.
  virtual void set_timestep(double timestep) = 0;
  /// Global search, valid until anything has come closer to anything else by `margin`.
  virtual void find_candidates(double margin, ContactCounters& counters) = 0;
  /// Checks everything that may have come into contact since the search; `used`: how far anything may have come closer
  /// since then. Moves shooting nodes in `state`, returns the longest such move.
  virtual double advance_state(State& state, double used, ContactCounters& counters) = 0;
  /// Adds the forces, and what they did since the last cycle.
  virtual void add_forces(const State& state, Forces& forces, ContactState& result) const = 0;
  /// Continues from the pass `before`, which had other surfaces of the same contact: memory of nodes, forces whose
  /// segments still exist; the other forces end. Call it before the first search.
  virtual void continue_from(InterfacePass& before, const State& state, ContactState& result) {
    before.deactivate(state, result);
  }
  /// For a new pass of a contact that was active in the last cycle: its nodes may have been followed.
  virtual void set_followed() {}
  /// What it remembers, for continue_as(); null: a pass of this kind acts for no other contact.
  [[nodiscard]] virtual std::unique_ptr<PassMemory> memory() const { return nullptr; }
  /// Continues as the pass `other` of a contact with the same cards and surfaces would have from that memory.
  virtual void continue_as(const InterfacePass& /*other*/, const PassMemory& /*memory*/) {}
  /// The contact is not active: forces end, memory is lost.
  virtual void deactivate(const State& state, ContactState& result) = 0;
  /// What the user must be told, once; lines of a message block.
  [[nodiscard]] virtual std::string take_message() { return {}; }
  /// The energy of its springs at that time.
  [[nodiscard]] virtual double stored() const = 0;
  /// The nodes that it affects.
  [[nodiscard]] virtual std::vector<ContactNode> nodes() const = 0;
  /// The nodes that it pushes, where these can be tied.
  [[nodiscard]] virtual std::vector<Touch> touches() const { return {}; }
  /// Adds its forces at the time of the last advance_state().
  virtual void add_links(std::vector<ContactLink>& links) const = 0;
};

}  // namespace gapcheck::solver
