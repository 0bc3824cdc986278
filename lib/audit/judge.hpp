#pragma once
#include <string>
#include <vector>

#include "records/report.hpp"
#include "results/curves/run_results.hpp"

namespace gapcheck::audit {

struct JudgeOptions {
  std::vector<std::string> select, ignore;  ///< rule ids, names or prefixes; empty select = all
  std::vector<std::int64_t> contacts;       ///< --contact; empty = all
};

/// Adds to the report of a run's log what the selected rules on runs find in the run's result files. Only existing
/// files are judged; returns what could not be judged, and why: "GC604 hourglass-share: there is no glstat".
std::vector<std::string> judge_run(const results::RunResults& files, const JudgeOptions& options, Report& report);

}  // namespace gapcheck::audit
