#include "baseline_options.hpp"

#include <CLI/Option.hpp>
#include <filesystem>
#include <system_error>

#include "base/file_bytes.hpp"
#include "base/file_writer.hpp"

namespace gapcheck::app {

void add_baseline(CLI::App& command, BaselineOptions& options) {
  const std::vector<CLI::Option*> added{
      command
          .add_option("--baseline", options.compare, "Only what is new or worse than there counts for the exit code")
          ->type_name("FILE"),
      command.add_option("--write-baseline", options.write, "Write the findings there, to compare with later")
          ->type_name("FILE")};
  for (CLI::Option* option : added) option->group("Baseline");
}

bool same_file(const BaselineOptions& options) {
  if (options.compare.empty() || options.write.empty()) return false;
  std::error_code failed;
  const auto place = [&](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, failed), failed);
  };
  return options.compare == options.write || place(options.compare) == place(options.write);
}

Result<Baseline> read(const BaselineOptions& options) {
  if (options.compare.empty()) return Baseline();
  std::error_code failed;
  if (options.by_settings && same_file(options) && !std::filesystem::exists(options.compare, failed)) return Baseline();
  const auto file = FileBytes::open(options.compare);
  if (!file) {
    Diagnostic why = file.error();
    if (!std::filesystem::exists(options.compare, failed)) why.message += "; --write-baseline writes a first one";
    return why;
  }
  auto findings = report::read_baseline(file.value().bytes(), options.compare);
  if (!findings) return findings.error();
  return Baseline(std::move(findings).value());
}

void compare(const Baseline& baseline, const report::LookedFor& looked_for, Report& report) {
  if (baseline) report.baseline = report::compare_with_baseline(report, *baseline, looked_for);
}

Status write(const Report& report, const BaselineOptions& options, bool complete) {
  if (options.write.empty()) return {};
  if (!complete)
    return Diagnostic{Severity::error, options.write, 0, "not written: the deck was not read without errors"};
  return write_file(options.write, report::baseline_text(report::known_findings(report)));
}

}  // namespace gapcheck::app
