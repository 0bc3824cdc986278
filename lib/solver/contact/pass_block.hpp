#pragma once
#include <cstdint>
#include <vector>

#include "solver/interface/contact_link.hpp"
#include "solver/interface/contact_state.hpp"
#include "solver/interface/interface_pass.hpp"

namespace gapcheck::solver {

/// Nodes and pairs checked in one cycle, as in ContactCounters.
struct PairCounts {
  std::uint64_t nodes = 0, pairs = 0, followed = 0, asleep = 0;
  void add_to(ContactCounters& counters) const {
    counters.nodes += nodes;
    counters.pairs += pairs;
    counters.followed += followed;
    counters.asleep += asleep;
  }
};

/// A shooting node that is moved.
struct NodeMove {
  SlotIndex slot;
  Vector way = Vector::Zero();
};

/// Results of checking consecutive places, besides their tracked nodes.
struct PassBlock {
  double sleep = 0;  ///< until this much of the margin is used up all of them rest
  PairCounts counts;
  std::uint64_t released = 0, touching = 0;
  LinkWork work;
  double lost = 0;  ///< energy of springs of nodes that are released now
  std::vector<NodeMove> moves;

  void clear() {
    sleep = 0;
    counts = {};
    released = touching = 0;
    work = {};
    lost = 0;
    moves.clear();
  }
  /// All of its nodes, `places` of them, sleep in this cycle: nothing has changed, and released nodes stay so.
  void keep_asleep(std::uint64_t places) {
    const std::uint64_t still_released = released;
    const double until = sleep;
    clear();
    sleep = until;
    released = still_released;
    counts.asleep = places;
  }
  /// Adds counts and energies to those of the contact. `exchanged`: the tracked nodes are on side B.
  void add_to(bool exchanged, ContactState& result) const {
    result.moved += moves.size();
    result.released += released;
    result.touching += touching;
    result.lost += lost;
    add_energies(work, exchanged, result);
  }
};

}  // namespace gapcheck::solver
