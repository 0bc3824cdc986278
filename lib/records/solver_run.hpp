#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "records/timesteps.hpp"

namespace gapcheck {

/// One `*** Warning` or `*** Error` block of the solver, kept whether understood or not.
struct SolverMessage {
  Severity severity = Severity::warning;
  std::int64_t code = 0;    ///< 40565
  std::string group;        ///< "SOL"
  std::string kind;         ///< name in the table of message kinds; empty: not understood
  std::string text;         ///< lines joined with one blank
  std::uint64_t count = 1;  ///< equal kinds beyond the first ones kept are only counted
  std::uint32_t file = 0, line = 0;
};

/// "node N (rigidwall W) init. penetration= p".
struct RigidwallPenetration {
  std::int64_t node = 0, wall = 0;
  double depth = 0;
  std::uint32_t file = 0, line = 0;
};

/// What the files say about the whole run. Empty or zero: unknown.
struct SolverRun : Timesteps {
  std::string version, revision, precision, platform, title;
  bool mpp = false;
  std::uint32_t ranks = 0;
  enum class Termination : std::uint8_t { unknown, normal, error } termination = Termination::unknown;
  double problem_time = 0;
  double end_time = 0;  ///< requested by the deck
  std::int64_t cycles = 0;
  std::vector<RigidwallPenetration> rigidwalls;
  std::vector<SolverMessage> messages;  ///< by code, then file and line
  bool counts_may_be_cut = false;       ///< a file shows that messages were suppressed
};

}  // namespace gapcheck
