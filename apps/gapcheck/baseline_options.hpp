#pragma once
#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "report/baseline/baseline.hpp"

namespace gapcheck::app {

/// Files with known findings; empty names: not requested. Both may be the same.
struct BaselineOptions {
  std::string compare, write;
  bool by_settings = false;  ///< `compare` comes from a settings file, and may not exist yet
};
void add_baseline(CLI::App& command, BaselineOptions& options);

/// True if the file to compare with is the one to write.
[[nodiscard]] bool same_file(const BaselineOptions& options);

using Baseline = std::optional<std::vector<KnownFinding>>;

/// Reads the baseline to compare with, if there is one. One from a settings file need not exist when it is written for
/// the first time.
[[nodiscard]] Result<Baseline> read(const BaselineOptions& options);

/// Compares the report with it, if there is one.
void compare(const Baseline& baseline, const report::LookedFor& looked_for, Report& report);

/// Writes the report's findings as a baseline if requested. The baseline of an incomplete audit is not written, which
/// is an error: everything missing in it would be new the next time.
[[nodiscard]] Status write(const Report& report, const BaselineOptions& options, bool complete);

}  // namespace gapcheck::app
