#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <gapcheck/includes.hpp>
#include <gapcheck/result.hpp>
#include <string>
#include <vector>

namespace gapcheck::api {

/// What one contact does at a moment of a run, and has done since its start. Units of the model.
struct RunContact {
  std::int64_t id = 0;
  std::uint64_t touching = 0;               ///< tracked nodes with a force
  std::uint64_t released = 0;               ///< tracked nodes without a force because they were too deep
  std::uint64_t moved = 0;                  ///< nodes that were put onto the surface since the start
  double force_a[3] = {}, force_b[3] = {};  ///< on the nodes of either side; zero for single surfaces
  double energy_a = 0, energy_b = 0;        ///< taken from the nodes of either side since the start
  double friction = 0;                      ///< of it by friction
};

/// A moment of a run. Units of the model.
struct RunState {
  double time = 0, end_time = 0;  ///< `end_time` infinite: the run ends after a number of cycles
  double step = 0;                ///< the coming time step
  std::uint64_t cycle = 0;
  double kinetic = 0, internal = 0, hourglass = 0, sliding = 0, external = 0, total = 0;  ///< energies, external work
  double energy_ratio = 1;           ///< total energy over what was there or was put in
  double seconds = 0;                ///< of wall clock since the first cycle
  std::vector<RunContact> contacts;  ///< those that are calculated, in deck order
};

/// How a deck is run. The defaults are those of `gapcheck run`.
struct RunOptions {
  Includes includes = {};
  double until = 0;                 ///< end time; 0: that of the deck
  std::uint64_t cycles = 0;         ///< ends after so many cycles; 0: as the deck says
  bool ignore_unsupported = false;  ///< run without the keywords that are not calculated; else they are an error
  /// Contact springs as stiff as the surface time step that LS-DYNA prints has them, not as its manual says.
  bool printed_stiffness = false;
  bool binout = false;           ///< all files of curves also in a binout, whatever BINARY of their cards says
  bool replace_foreign = false;  ///< replace results in the directory that gapcheck did not write; else an error
  /// Called in every cycle by the thread of run_deck(), which waits for it. False ends the run one cycle later, with a
  /// last state in the files and a last call. The state is valid during the call. It must not throw. Empty: no calls.
  std::function<bool(const RunState&)> watch = {};
  std::size_t jobs = 0;  ///< as AuditOptions::jobs; results do not depend on it
};

/// Why a run ended.
enum class RunEnd : std::uint8_t {
  time,     ///< its end time
  cycles,   ///< the number of cycles
  energy,   ///< ENDENG: the change of energy that the deck allows
  step,     ///< DTMIN: the smallest step that the deck allows
  stopped,  ///< `watch` ended it
  failed,   ///< it cannot go on
};

/// The energy of the elements of a part, of a contact or of all discrete springs, since the start: by the work that it
/// took from the nodes, and by what its present state stores and what it has dissipated. State above work: it has
/// created energy; below: some has vanished.
struct RunEnergy {
  std::string name;  ///< "contact 3", "shells of part 7", "discrete springs"
  double work = 0, state = 0;
  bool covered = true;  ///< false: no state tells its energy (constraints, tiebreaks)
};

/// What became of a run.
struct RunSummary {
  RunEnd end = RunEnd::failed;
  std::string failure;                  ///< why it failed; empty: it did not
  RunState state;                       ///< the last one
  double state_energy_ratio = 1;        ///< RunState::energy_ratio with the energies of the state
  std::vector<RunEnergy> energies;      ///< of parts, springs and contacts
  std::vector<std::string> files;       ///< names of the files in the directory; further d3plot files are d3plot01, …
  std::size_t plotted_states = 0;       ///< in the d3plot
  std::vector<Diagnostic> diagnostics;  ///< what is calculated in another way than the deck says, by file and line
};

/// Runs a keyword deck with the verification solver and writes messag, d3hsp, glstat, rcforc, d3plot, … into
/// `directory`, which is made if it is not there; gapcheck's own files of these names are replaced, but never a file of
/// the deck. Errors: the deck
/// cannot be read in full, has no end time, or holds what is not calculated (all of it is in Error::diagnostics, with
/// file and line); the directory or a file in it cannot be written; an option with no valid number. A run that begins
/// and fails later is a result with RunEnd::failed. May be called from several threads at once, each with a directory
/// of its own.
///
///     const auto run = gapcheck::api::run_deck("model.k", "out", {.cycles = 100});
///     if (!run) return fail(run.error());
///     print(run.value().state.energy_ratio);
[[nodiscard]] Result<RunSummary> run_deck(const std::string& deck, const std::string& directory,
                                          const RunOptions& options = {});

}  // namespace gapcheck::api
