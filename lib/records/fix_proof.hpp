#pragma once
#include <cstdint>
#include <string>

#include "records/start.hpp"

namespace gapcheck {

/// The contacts of a deck at its start and over a short run.
struct RunTrial {
  StartReport start;         ///< `refused` says why there was no run, if there was none
  bool ran = false;          ///< what follows is known
  double largest_force = 0;  ///< of contact on one node at time 0
  std::string end;           ///< why the run ended: "end time", "cycles", …, or what failed
  bool failed = false;
  double time = 0;             ///< reached
  std::uint64_t cycles = 0;    ///< calculated
  double supplied = 0;         ///< energy: at the start, and external work until the end
  double largest_kinetic = 0;  ///< energy, during the run
  double least_sliding = 0;    ///< sliding interface energy, during the run: negative where contacts give energy
  double created = 0;          ///< at the end: what elements and contacts gave and still hold beyond what they took
  std::uint64_t shot = 0;      ///< nodes that contacts moved after the first cycle, each time counted
  std::uint64_t released = 0;  ///< tracked nodes at the end that are too deep to be in contact
  /// Nodes that contacts push, or have released, at the start.
  [[nodiscard]] std::uint64_t forced_at_start() const;
  [[nodiscard]] std::uint64_t released_at_start() const;
};

/// The same deck before and after a correction.
struct FixProof {
  double until = 0;          ///< end time asked for; 0: that of the deck
  std::uint64_t cycles = 0;  ///< most cycles; 0: no limit
  RunTrial before, after;
  /// The corrected deck was run, its contacts start clean, and the run did not fail.
  [[nodiscard]] bool holds() const;
};

}  // namespace gapcheck
