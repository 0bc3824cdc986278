#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "audit/judge.hpp"
#include "audit/mesh/element_mesh.hpp"
#include "audit/mesh/scene_mesh.hpp"
#include "base/parallel.hpp"
#include "commands.hpp"
#include "common/mesh.hpp"
#include "common/version.hpp"
#include "options.hpp"
#include "output.hpp"
#include "output_guard.hpp"
#include "progress.hpp"
#include "report/item/describe.hpp"
#include "report/text/check_c_view.hpp"
#include "results/curves/run_results.hpp"
#include "results/log/input_kind.hpp"
#include "results/log/solver_log.hpp"

namespace gapcheck::app {
namespace {

struct MessagArguments {
  std::vector<std::string> files;  ///< or directories
  results::LogOptions log;
  report::CheckCOptions pick;
  audit::JudgeOptions judge;
  std::string deck, d3plot;
  OutputOptions output;
  ExportOptions exports;
  std::size_t jobs = 0;
};

void add_run_selection(CLI::App& command, MessagArguments& arguments) {
  const CLI::Validator amount(check_amount, ""), id(check_id, "");
  const std::vector<CLI::Option*> options{
      add_list(command, "--contact", arguments.pick.sid, "Only these contacts")->check(id)->type_name("IDS"),
      command.add_option("--ptol", arguments.pick.ptol, "Only penetrations and separations above X")
          ->check(amount)
          ->type_name("X"),
      command.add_option("--rtol", arguments.pick.rtol, "Only penetrations with a remaining distance below X")
          ->check(amount)
          ->type_name("X"),
      add_list(command, "--select", arguments.judge.select, "Judge the run by these rules only (GC6xx)")
          ->check(CLI::Validator(check_run_rule, ""))
          ->type_name("RULES"),
      add_list(command, "--ignore", arguments.judge.ignore, "Judge it without these rules")
          ->check(CLI::Validator(check_run_rule, ""))
          ->type_name("RULES")};
  for (CLI::Option* option : options) option->group("Selection");
}

void add_input(CLI::App& command, MessagArguments& arguments) {
  const std::vector<CLI::Option*> options{
      command.add_option("--d3hsp", arguments.log.d3hsp, "d3hsp file, if it is not beside the first file")
          ->type_name("FILE"),
      add_list(command, "--messages", arguments.log.message_files, "Additions to the table of known messages")
          ->type_name("FILE"),
      command.add_option("--deck", arguments.deck, "Keyword deck of the run: coordinates and parts of the nodes")
          ->type_name("DECK"),
      command
          .add_option("-g,--d3plot", arguments.d3plot,
                      "d3plot of the run, for the same; one beside the first file is found")
          ->type_name("FILE")};
  for (CLI::Option* option : options) option->group("Input");
}

/// Judges the run by the result files beside its first log. Reports what was not judged if the user may expect it: if
/// there is any such file, or a directory was given.
void judge(const MessagArguments& arguments, const std::string& first_file, Report& report, Diagnostics& diagnostics) {
  const std::string directory = std::filesystem::path(first_file).parent_path().string();
  const results::RunResults files = results::read_run_results(directory, false, diagnostics);
  audit::JudgeOptions options = arguments.judge;
  options.contacts = arguments.pick.sid;
  const std::vector<std::string> skips = audit::judge_run(files, options, report);
  const bool nothing_there = files.missing.size() == 4 && first_file == arguments.files.front();
  if (nothing_there || arguments.output.text.quiet) return;
  for (const std::string& skip : skips) print(Diagnostic{Severity::note, directory, 0, "not judged: " + skip});
}

/// What pictures and sets need from the deck.
void add_deck(const model::Model& model, bool picture, bool grid, Report& report) {
  report.highest_set = audit::highest_set(model.sets);
  if (picture) report.scene = audit::scene_mesh(model, report);
  if (!grid) return;
  contact::SurfaceStore surfaces(model);
  report.mesh = audit::element_mesh(model, surfaces, gapcheck::positions<ContactIndex>(model.contacts.size()).list());
}

/// An error if the files cannot be written without overwriting an input.
Status check_files(const MessagArguments& arguments, const std::vector<std::string>& logs,
                   const keyword::ReadOptions& deck_options) {
  std::vector<PlannedOutput> outputs = planned_outputs(arguments.output);
  for (PlannedOutput& output : planned_outputs(arguments.exports)) outputs.push_back(std::move(output));
  std::vector<ReadInput> read;
  read.reserve(logs.size());
  for (const std::string& log : logs) read.push_back({log, "a log that is read"});
  add_run_files(std::filesystem::path(logs.front()).parent_path().string(), read);
  read.push_back({arguments.log.d3hsp, "the d3hsp file"});
  read.push_back({arguments.d3plot, "the d3plot file"});
  for (const std::string& table : arguments.log.message_files) read.push_back({table, "a table of messages"});
  DeckFiles files(deck_options);
  if (!arguments.deck.empty()) add_deck_files(arguments.deck, files, outputs, read);
  return check_outputs(read, outputs);
}

int show_logs(const MessagArguments& arguments) {
  const JobLimit limit(arguments.jobs);
  Diagnostics diagnostics;
  const bool talk = !arguments.output.text.quiet;
  const auto files = results::log_files(arguments.files);
  if (!files) {
    print(files.error());
    return failed;
  }
  const std::string& first_file = files.value().front();
  keyword::FileCache cache;
  keyword::ReadOptions deck_options;
  deck_options.cache = &cache;
  if (const Status status = check_files(arguments, files.value(), deck_options); !status.ok()) {
    print(status.error());
    return failed;
  }
  auto read = [&] {
    const Progress progress("reading " + report::printable(arguments.files.front()), talk);
    auto report = results::read_solver_logs(files.value(), arguments.log, diagnostics);
    if (report) judge(arguments, first_file, report.value(), diagnostics);
    return report;
  }();
  std::optional<model::Model> model;
  const bool picture = !arguments.output.html.empty(), grid = !arguments.exports.vtu.empty();
  const bool with_model = picture || grid || !arguments.exports.sets.empty();
  auto mesh = find_mesh({arguments.deck, deck_options, arguments.d3plot, first_file}, diagnostics,
                        with_model ? &model : nullptr);
  print(diagnostics, !talk);
  Failures failures(print);
  failures.count(diagnostics);
  if (!read || !mesh) failures.add(!read ? read.error() : mesh.error());
  if (!read) return failed;
  Report report = report::pick(std::move(read).value(), arguments.pick);
  results::MeshSource known;
  if (mesh) known = std::move(mesh).value();
  results::add_parts(known, report);
  if (model) add_deck(*model, picture, grid, report);
  const Status page = write_page(report, arguments.output, positions(known));
  failures.add(page);
  if (page.ok()) report.page = arguments.output.html;
  failures.add(write(report, arguments.output));
  write(report, arguments.exports, positions(known), failures);
  return failures.any() ? failed : exit_code(report, arguments.output.fail_on);
}

}  // namespace

void add_messag(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("messag", "Show what the solver's message files say of the contacts, and judge the run");
  command->set_version_flag("--version", version_line("gapcheck"));
  const auto arguments = std::make_shared<MessagArguments>();
  command->add_option("FILE", arguments->files, "messag, mesNNNN, d3hsp, status.out files of one run, or its directory")
      ->required()
      ->type_name("");
  add_run_selection(*command, *arguments);
  add_output(*command, arguments->output);
  add_exports(*command, arguments->exports);
  add_input(*command, *arguments);
  add_jobs(*command, arguments->jobs);
  command->callback([&action, arguments] { action = [arguments] { return show_logs(*arguments); }; });
}

}  // namespace gapcheck::app
