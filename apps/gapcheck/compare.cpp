#include "report/compare/compare.hpp"

#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "audit/audit.hpp"
#include "base/file_writer.hpp"
#include "base/parallel.hpp"
#include "commands.hpp"
#include "common/version.hpp"
#include "compare_curves.hpp"
#include "options.hpp"
#include "output.hpp"
#include "output_guard.hpp"
#include "progress.hpp"
#include "report/item/describe.hpp"
#include "report/text/check_c_view.hpp"
#include "results/log/input_kind.hpp"
#include "results/log/solver_log.hpp"

namespace gapcheck::app {
namespace {

struct CompareArguments {
  std::string first, second;
  std::vector<std::int64_t> contacts;
  double tolerance = 0;
  std::string format = "text", output;
  std::size_t top = 10, jobs = 0;
  bool quiet = false, stats = false;
  audit::AuditOptions audit;
  results::LogOptions log;
  CurveArguments curves;
};

/// A deck is audited, everything else read. Nothing after a failure.
std::optional<Report> read_source(const std::string& path, const Result<results::InputKind>& input,
                                  const CompareArguments& arguments, Failures& failures) {
  Diagnostics diagnostics;
  auto report = [&]() -> Result<Report> {
    if (!input) return input.error();
    const Progress progress("reading " + report::printable(path), !arguments.quiet);
    if (input.value().deck) return audit::audit_deck(path, arguments.audit, diagnostics);
    return results::read_solver_logs(input.value().files, arguments.log, diagnostics);
  }();
  print(diagnostics, arguments.quiet);
  failures.count(diagnostics);
  if (!report) {
    failures.add(report.error());
    return std::nullopt;
  }
  report::CheckCOptions only;
  only.sid = arguments.contacts;
  Report picked = report::pick(std::move(report).value(), only);
  picked.input = path;
  return picked;
}

/// A contact that neither source has is a misspelt one.
void check_contacts(const report::Comparison& comparison, const std::vector<std::int64_t>& wanted, Failures& failures) {
  for (const std::int64_t id : wanted) {
    const auto& contacts = comparison.contacts;
    if (std::any_of(contacts.begin(), contacts.end(), [&](const auto& contact) { return contact.id == id; })) continue;
    failures.add(plain_error(fmt::format("--contact {}: neither source has such a contact", id)));
  }
}

/// What the two paths hold.
struct Inputs {
  Result<results::InputKind> first, second;
};

/// An error if the results cannot be written without overwriting an input.
Status check_output(const Inputs& inputs, const CompareArguments& arguments) {
  const std::vector<PlannedOutput> outputs{{"--output", arguments.output}, {"--html", arguments.curves.html}};
  DeckFiles files(arguments.audit.read);
  std::vector<ReadInput> read;
  for (const auto& [path, input] :
       {std::tie(arguments.first, inputs.first), std::tie(arguments.second, inputs.second)}) {
    if (!input) continue;  // reported when it is read
    if (input.value().deck) {
      add_deck_files(path, files, outputs, read);
      continue;
    }
    for (const std::string& file : input.value().files) read.push_back({file, "one of those compared"});
    add_run_files(input.value().directory ? path : std::filesystem::path(path).parent_path().string(), read);
  }
  for (const std::string& table : arguments.log.message_files) read.push_back({table, "a table of messages"});
  return check_outputs(read, outputs);
}

struct Compared {
  const report::Comparison& comparison;
  const Report &first, &second;
  const RunsOfBoth& runs;
};

Status write_page(const Compared& compared, const std::string& path) {
  if (path.empty()) return {};
  return write_file(path, report::comparison_html(compared.comparison, compared.first, compared.second,
                                                  compared.runs.comparison(), compared.runs.curves(), version()));
}

Status write_results(const Compared& compared, const CompareArguments& arguments) {
  const auto& [comparison, first, second, runs] = compared;
  Output output(arguments.output);
  output.write(arguments.format == "json"
                   ? report::comparison_json(comparison, first, second, runs.comparison())
                   : report::comparison_text(comparison, first, second, arguments.top, runs.comparison()));
  if (arguments.stats)
    for (const Report* source : {&first, &second})
      std::fputs((report::printable_path(source->input) + '\n' + report::statistics(*source)).c_str(), stderr);
  Status written = output.close();
  if (written.ok()) written = runs.write_plots(arguments.top);
  if (written.ok()) written = write_page(compared, arguments.curves.html);
  return written;
}

int compare_sources(CompareArguments arguments) {
  if (const Status status = check_curve_options(arguments.curves); !status.ok()) {
    print(status.error());
    return failed;
  }
  keyword::FileCache cache;
  arguments.audit.read.cache = &cache;
  const JobLimit limit(arguments.jobs);
  const Inputs inputs{results::recognise(arguments.first), results::recognise(arguments.second)};
  if (const Status status = check_output(inputs, arguments); !status.ok()) {
    print(status.error());
    return failed;
  }
  Failures failures(print);
  const auto first = read_source(arguments.first, inputs.first, arguments, failures),
             second = read_source(arguments.second, inputs.second, arguments, failures);
  if (!first || !second) return failed;
  const report::Comparison comparison = report::compare(*first, *second, arguments.tolerance);
  const RunsOfBoth runs(arguments.first, arguments.second, arguments.contacts, arguments.curves, arguments.quiet,
                        failures);
  const Compared compared{comparison, *first, *second, runs};
  const Status written = write_results(compared, arguments);
  failures.add(written);
  if (written.ok()) check_contacts(comparison, arguments.contacts, failures);
  if (failures.any()) return failed;
  return comparison.equal() && runs.comparison().equal() ? clean : findings;
}

void add_options(CLI::App& command, CompareArguments& arguments) {
  const CLI::Validator amount(check_amount, ""), id(check_id, "");
  command.add_option("--tol", arguments.tolerance, "Depths may differ by X, besides the rounding of printed numbers")
      ->check(amount)
      ->type_name("X")
      ->capture_default_str();
  add_list(command, "--contact", arguments.contacts, "Only these contacts")->check(id)->type_name("IDS");
  command.add_option("--format", arguments.format, "Of the results")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  command.add_option("--output", arguments.output, "Write the results there instead of to standard output")
      ->type_name("FILE");
  command.add_option("--top", arguments.top, "Largest differences to show per contact, and of the curves")
      ->check(CLI::Range(0, std::numeric_limits<int>::max()).description(""))
      ->type_name("N")
      ->capture_default_str();
  command.add_flag("--quiet", arguments.quiet, "No warnings about the input");
  command.add_flag("--stats", arguments.stats, "Show counters and times of both, on standard error");
  add_list(command, "--messages", arguments.log.message_files, "Additions to the table of known messages")
      ->type_name("FILE");
  command.add_option("-I", arguments.audit.read.include_directories, "Further directory for *INCLUDE")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("DIR");
  add_jobs(command, arguments.jobs);
  add_curve_options(command, arguments.curves);
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("compare", "Compare two decks or runs: penetrations and ties node by node, result curves");
  command->set_version_flag("--version", version_line("gapcheck"));
  const auto arguments = std::make_shared<CompareArguments>();
  const char* what = "Keyword deck, messag or d3hsp file, or the directory of a run";
  command->add_option("A", arguments->first, what)->required()->type_name("");
  command->add_option("B", arguments->second, what)->required()->type_name("");
  add_options(*command, *arguments);
  command->footer("Exit codes: 0 no differences, 1 differences, 2 the tool could not do its job.");
  command->callback([&action, arguments] { action = [arguments] { return compare_sources(*arguments); }; });
}

}  // namespace gapcheck::app
