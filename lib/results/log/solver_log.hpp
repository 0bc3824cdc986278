#pragma once
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/result.hpp"
#include "records/report.hpp"

namespace gapcheck::results {

struct LogOptions {
  std::string d3hsp;                       ///< -hsp; empty: "d3hsp" beside the first file, if it is there
  std::vector<std::string> message_files;  ///< --messages: additions to the table of message kinds
  std::vector<std::int64_t> contacts;      ///< only these interfaces; empty = all
};

/// Reads messag, mesNNNN, d3hsp, status.out and stdout logs of one run, in any mix, SMP or MPP, old and new words, and
/// makes a report (source "messag") of them. Records that several ranks print are merged. Streaming: memory grows with
/// what is found. Blocks that became records are not among SolverRun::messages; all others are. Depth or contact
/// distance 0: not given. The readable part of a damaged file is in the report, its faults are in `diagnostics`
/// (error). The result is an error only if no file could be opened.
Result<Report> read_solver_logs(const std::vector<std::string>& paths, const LogOptions& options,
                                Diagnostics& diagnostics);

/// The same for one file in memory; tests and fuzzers use it.
Report read_solver_log_text(std::string_view text, const std::string& name, const LogOptions& options,
                            Diagnostics& diagnostics);

}  // namespace gapcheck::results
