#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <gapcheck/report.hpp>
#include <gapcheck/result.hpp>
#include <optional>
#include <string>
#include <vector>

namespace gapcheck::api {

/// What is read from a run and how it is judged. The defaults are those of `gapcheck messag`. Limits are numbers of 0
/// or more; anything else is an error.
struct RunReadOptions {
  std::string d3hsp = {};                        ///< empty: the one beside the first file, if there is one
  std::string d3plot = {};                       ///< for the parts of nodes; empty: the one beside the first file
  std::vector<std::string> message_tables = {};  ///< files with additions to the table of known messages
  std::vector<std::int64_t> contacts = {};       ///< only the contacts with these ids; empty: all
  std::optional<double> ptol = {};               ///< only penetrations and separations above this
  std::optional<double> rtol = {};               ///< only penetrations with a smaller remaining distance
  std::vector<std::string> select = {};          ///< judge only by these rules (GC6xx); empty: by all
  std::vector<std::string> ignore = {};          ///< not by these
  std::size_t jobs = 0;                          ///< as AuditOptions::jobs
  /// Called now and then by the thread that works, which waits for it. False stops the reading, which is an error then.
  /// It must not throw. Empty: no calls.
  std::function<bool()> watch = {};
};

/// Reads what the solver's message files say about the contacts: one or more of messag, mesNNNN, d3hsp, status.out of
/// one run, or its directory. Judges the run by glstat, matsum, rcforc and sleout beside the first file, as text or in
/// a binout, and gives matsum as arrays; what cannot be judged is a diagnostic (note). Errors: no path, a path that
/// cannot be opened, a directory without such files; an option that names no rule, no file or no valid number. With
/// faults inside files there is still a report, with Report::complete false. A contact that the files do not mention is
/// not an error: it has no records. May be called from several threads at once.
///
///     const auto run = gapcheck::api::read_run({"out"});
///     if (!run) return fail(run.error());
///     print(run.value().run->version, run.value().penetrations.size());
[[nodiscard]] Result<Report> read_run(const std::vector<std::string>& paths, const RunReadOptions& options = {});

/// One quantity of a run over time, in the units of the model.
struct Curve {
  std::string name;                   ///< "rcforc contact 3 side A x-force"; unique in the run
  std::string file;                   ///< "rcforc"
  std::string quantity;               ///< "force"
  std::int64_t contact = 0;           ///< id; 0: of no contact
  std::vector<double> times, values;  ///< of one length; times ascend, values are finite
  std::uint64_t not_numbers = 0;      ///< NaN values of the file, left out
};

/// The curves of a run.
struct Curves {
  std::vector<Curve> curves;            ///< in order of the files: glstat, rcforc, sleout, nodout, …, matsum last
  bool complete = true;                 ///< false: a file could not be read in full
  std::vector<Diagnostic> diagnostics;  ///< errors first, then by file and line
};

/// Reads the curves of the result files in a run's directory: energies, contact forces and energies, motion of nodes,
/// energies and momenta of parts.
/// Missing files have no curves. Errors: the directory does not exist. Memory: 16 bytes per value.
[[nodiscard]] Result<Curves> read_curves(const std::string& directory);

}  // namespace gapcheck::api
