#pragma once
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "common/failures.hpp"
#include "keyword/deck.hpp"
#include "records/report.hpp"
#include "report/export/exports.hpp"
#include "report/format/formats.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::app {

// Options that several commands have, and what they do.

/// A finite number that is not negative; CLI11's own ranges let NaN pass.
[[nodiscard]] std::string check_amount(const std::string& text);

/// CLI11 alone would clamp larger ids to the largest number.
[[nodiscard]] std::string check_id(const std::string& text);

// Every entry of --select and --ignore must pick a rule on decks, or on runs: a misspelt one would silently hide
// findings.
[[nodiscard]] std::string check_deck_rule(const std::string& text);
[[nodiscard]] std::string check_run_rule(const std::string& text);

/// An option that takes a list: commas, or the option repeated. Never more than one argument, or it would consume the
/// input.
template <class Value>
CLI::Option* add_list(CLI::App& command, const std::string& name, std::vector<Value>& values, const std::string& text) {
  return command.add_option(name, values, text)->delimiter(',')->take_all()->allow_extra_args(false);
}

/// How results are written.
struct OutputOptions {
  std::string format = "text", output, fail_on = "error";
  std::string html;  ///< path of the page; empty: not requested
  std::string group_by = "severity";
  bool limit_per_rule = false;  ///< --top was given: it holds for the lines of each rule too
  report::TextOptions text;
};
void add_output(CLI::App& command, OutputOptions& options);

/// Writes the results of one report or of several. `fixes`: of each report, for SARIF; or of none.
[[nodiscard]] Status write(const report::Reports& reports, const OutputOptions& options,
                           std::span<const report::FindingFixes> fixes = {});

/// Writes the page if requested. `position` may be empty.
[[nodiscard]] Status write_page(const Report& report, const OutputOptions& options,
                                const report::NodePosition& position);

/// Clean or findings, according to --fail-on.
[[nodiscard]] int exit_code(const Report& report, const std::string& fail_on);

/// Files about all decks of a call; empty names: not requested.
struct OverviewOptions {
  std::string html_index, summary;
};
void add_overview(CLI::App& command, OverviewOptions& options);

/// Writes the files, as many as can be written.
void write(const report::Reports& reports, const OverviewOptions& options, Failures& failures);

/// Files for post-processors; empty names: not requested.
struct ExportOptions {
  std::string key, ani, a4sel, medina, vtu, sets;
  std::int64_t medina_node = 9999999;
  std::int64_t set_id = 0;  ///< 0: above the deck's sets
};
void add_exports(CLI::App& command, ExportOptions& options);

/// Writes the files, as many as can be written.
void write(const Report& report, const ExportOptions& options, const report::NodePosition& position,
           Failures& failures);

/// --format, --output, --top and --quiet of a report in one of `formats`; `listed`: what the text lists --top of.
void add_plain_report(CLI::App& command, const std::vector<std::string>& formats, std::string& format,
                      std::string& output, std::size_t& top, const std::string& listed, bool& quiet);

void add_jobs(CLI::App& command, std::size_t& jobs);

/// Options that every command accepts, even without work to share: --quiet, --stats, --jobs, --version.
struct CommonOptions {
  bool quiet = false, stats = false;
  std::size_t jobs = 0;  ///< without effect
};
/// `quiet`: the output that --quiet keeps.
void add_common(CLI::App& command, CommonOptions& options, const std::string& quiet);

/// -I, --param and --missing-includes; `missing` is "error" or "skip" once the arguments are read.
void add_includes(CLI::App& command, keyword::ReadOptions& read, std::string& missing);

}  // namespace gapcheck::app
