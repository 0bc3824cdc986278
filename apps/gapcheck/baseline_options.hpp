#pragma once
#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "report/baseline/baseline.hpp"

namespace gapcheck::app {

/// Files with known findings; empty names: not asked for. Both may be the same.
struct BaselineOptions {
  std::string compare, write;
  bool by_settings = false;  ///< `compare` is named by a settings file, perhaps before there is one
};
void add_baseline(CLI::App& command, BaselineOptions& options);

/// True if the file that is compared with is the one that is written.
[[nodiscard]] bool same_file(const BaselineOptions& options);

using Baseline = std::optional<std::vector<KnownFinding>>;

/// Reads the baseline to compare with, if there is one. One that a settings file names need not be there when it is
/// written for the first time.
[[nodiscard]] Result<Baseline> read(const BaselineOptions& options);

/// Holds the report against it, if there is one.
void compare(const Baseline& baseline, const report::LookedFor& looked_for, Report& report);

/// Writes the report's findings as a baseline if it was asked for; false after a failure, which has been said. That of
/// an incomplete audit is not written: all that is missing in it would be new the next time.
bool write(const Report& report, const BaselineOptions& options, bool complete);

}  // namespace gapcheck::app
