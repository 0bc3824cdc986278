#pragma once
#include <cstdint>
#include <gapcheck/result.hpp>
#include <string>
#include <vector>

namespace gapcheck::api {

/// The largest stable time step of the springs on one side of a contact.
struct SurfaceTimestep {
  std::uint32_t contact = 0;        ///< position in Report::contacts
  char side = 'A';                  ///< 'A', 'B'
  std::string type;                 ///< the contact's code: "a3"
  double timestep = 0;              ///< 1e16: no limit
  std::int64_t node = 0, part = 0;  ///< controlling; 0: unknown
};

/// Time steps that contacts and elements allow, printed by the solver or computed from a deck, in the model's unit of
/// time. 0: unknown.
struct Timesteps {
  double contact = 0;                     ///< the smallest of `surfaces`
  double element = 0;                     ///< the smallest of all elements
  std::vector<SurfaceTimestep> surfaces;  ///< by contact in deck order, side A before side B
};

/// One warning or error of the solver that is neither a penetration nor a tie.
struct SolverMessage {
  Severity severity = Severity::warning;
  std::int64_t code = 0;    ///< 40565
  std::string kind;         ///< name in the table of message kinds; empty: not understood
  std::string text;         ///< its lines joined with a blank
  std::uint64_t count = 1;  ///< messages of this kind that it represents
  std::uint32_t file = 0;   ///< position in Report::files
  std::uint32_t line = 0;
};

/// A node inside a rigid wall.
struct RigidwallPenetration {
  std::int64_t node = 0, wall = 0;  ///< ids
  double depth = 0;
  std::uint32_t file = 0;  ///< position in Report::files
  std::uint32_t line = 0;
};

/// What the solver's files say of the whole run. Empty or zero: unknown.
struct SolverRun {
  enum class Termination : std::uint8_t { unknown, normal, error };

  std::string version, revision, precision, platform, title;
  bool mpp = false;
  std::uint32_t ranks = 0;
  Termination termination = Termination::unknown;
  double problem_time = 0;  ///< reached
  double end_time = 0;      ///< requested by the deck
  std::int64_t cycles = 0;
  Timesteps timesteps;
  std::vector<RigidwallPenetration> rigidwalls;
  std::vector<SolverMessage> messages;  ///< by code, file and line
  bool counts_may_be_cut = false;       ///< the solver suppressed messages
};

}  // namespace gapcheck::api
