#include "solver/run.hpp"

#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "commands.hpp"
#include "common/signals.hpp"
#include "common/version.hpp"
#include "options.hpp"
#include "output.hpp"
#include "output_guard.hpp"
#include "progress.hpp"
#include "report/item/describe.hpp"
#include "results/d3plot/run_folder.hpp"
#include "run_progress.hpp"
#include "run_summary.hpp"
#include "run_vtu.hpp"
#include "settings/settings.hpp"
#include "solver/output/run_files.hpp"
#include "solver/supported.hpp"

namespace gapcheck::app {
namespace {

struct RunArguments {
  std::string deck, directory;
  std::string missing_includes = "error", contact_stiffness = "documented";
  keyword::ReadOptions read;
  SettingsOptions settings;
  std::string settings_path;  ///< empty: none is used
  double until = 0;
  std::uint64_t cycles = 0;
  std::size_t jobs = 0;
  bool ignore_unsupported = false, force = false, vtu = false, binout = false, quiet = false, stats = false;
};

/// Files and the progress line.
class Watch : public solver::Run::Observer {
 public:
  Watch(solver::RunFiles& files, bool progress) : files_(files), progress_(progress) {}
  solver::SolverStatus observe(const solver::Run& run, std::optional<solver::RunEnd> end) override {
    progress_.show(run);
    return files_.observe(run, end);
  }

 private:
  solver::RunFiles& files_;
  RunProgress progress_;
};

/// Says what of the deck is not calculated, which is a failure unless the user wants to run without it.
void tell_unsupported(const std::vector<solver::Unsupported>& list, const RunArguments& arguments, Failures& failures) {
  const Severity severity = arguments.ignore_unsupported ? Severity::warning : Severity::error;
  for (const solver::Unsupported& one : list)
    if (!arguments.ignore_unsupported || !arguments.quiet)
      print(Diagnostic{severity, one.file, one.line,
                       fmt::format("*{} {}: {}", one.keyword,
                                   arguments.ignore_unsupported ? "is left out" : "is not supported", one.why)});
  if (list.empty() || arguments.ignore_unsupported) return;
  failures.add(plain_error(fmt::format("{} of the deck is not calculated; change it, or run with --ignore-unsupported",
                                       list.size() == 1 ? "a part" : "some")));
}

void tell_output_notes(const keyword::Deck& deck, const model::Model& model, Diagnostics& diagnostics) {
  for (const model::Output::Note& note : solver::output_notes(model))
    diagnostics.warning(deck.files()[note.place.file.value].path, note.place.line, note.text);
}

/// With its place in the deck, or the deck where it has none. Messages on result files name these.
Diagnostic located(const solver::Failure& failure, const model::Model& model, const std::string& deck) {
  if (failure.kind == solver::Failure::Kind::output) return plain_error(failure.message);
  const std::string file = model.file(failure.place);
  return {Severity::error, file.empty() ? deck : file, failure.place.line, failure.message};
}

/// The summary to standard output; errors to standard error.
int tell_end(const solver::Run& run, solver::RunEnd end, const RunArguments& arguments) {
  Failures failures(print);
  if (!run.status().ok()) failures.add(located(run.status().error(), run.model(), arguments.deck));
  if (end == solver::RunEnd::signal)
    failures.add(plain_error(
        fmt::format("terminated by {}; the files end at time {:g}", EndRequest::name(), run.stepper().state().time)));
  Output output("");
  if (!arguments.quiet) output.write(run_summary(run, end));
  if (arguments.stats) output.write(run_statistics(run));
  failures.add(output.close());
  return failures.any() || end == solver::RunEnd::failed ? failed : clean;
}

/// Steps to the end and reports the result.
int calculate(solver::Run& run, contact::SurfaceStore& surfaces, const RunArguments& arguments) {
  solver::RunFilesSettings settings;
  settings.directory = arguments.directory;
  settings.program = fmt::format("gapcheck {}", version());
  settings.binout = arguments.binout;
  std::optional<VtuSeries> series;
  if (arguments.vtu) {
    series.emplace(run, arguments.directory);
    settings.on_plot = [&](const results::D3plotState& state, const solver::Run& at, std::size_t) {
      return series->add(state, at);
    };
  }
  // From here on there are files that need an end.
  const EndRequest end_request;
  auto files = solver::RunFiles::create(run, surfaces, std::move(settings));
  if (!files) {
    print(located(files.error(), run.model(), arguments.deck));
    return failed;
  }
  run.drop_contact_summaries();
  solver::RunEnd end{};
  {
    Watch watch(files.value(), !arguments.quiet);
    end = run.go(watch);
  }
  return tell_end(run, end, arguments);
}

/// An error if the run would write over what it reads, or over results that others took days to calculate.
Status check_directory(const keyword::Deck& deck, const RunArguments& arguments) {
  std::vector<ReadInput> read{{arguments.settings_path, "the settings file"}};
  add_deck_files(deck, read);
  if (Status status = check_outputs(read, planned_run_outputs(arguments.directory, arguments.vtu)); !status.ok())
    return status;
  std::vector<std::string> foreign = results::foreign_results(arguments.directory);
  if (arguments.vtu)
    for (std::string& grid : foreign_grids(arguments.directory)) foreign.push_back(std::move(grid));
  if (foreign.empty() || arguments.force) return {};
  return plain_error(fmt::format(
      "-o: {} would be replaced{}, and gapcheck did not write it; give another directory, or --force", foreign.front(),
      foreign.size() > 1 ? fmt::format(", as would {} more results", foreign.size() - 1) : ""));
}

int run_deck(const RunArguments& arguments) {
  const JobLimit limit(arguments.jobs);
  Diagnostics diagnostics;
  std::optional<Progress> reading;
  reading.emplace("reading " + report::printable(arguments.deck), !arguments.quiet);
  auto deck = keyword::read_deck(arguments.deck, arguments.read, diagnostics);
  if (!deck) {
    reading.reset();
    print(deck.error());
    return failed;
  }
  if (const Status status = check_directory(deck.value(), arguments); !status.ok()) {
    reading.reset();
    print(status.error());
    return failed;
  }
  const auto model = model::read_model(deck.value(), diagnostics);
  reading.reset();
  if (!model || diagnostics.has_errors()) {
    print(diagnostics, arguments.quiet);
    if (!model) print(model.error());
    return failed;
  }
  keyword::note_missing_end(deck.value(), diagnostics);
  deck.value().drop_text([](std::string_view) { return true; });
  tell_output_notes(deck.value(), model.value(), diagnostics);
  Failures failures(print);
  tell_unsupported(solver::unsupported(deck.value(), model.value()), arguments, failures);
  if (failures.any()) {
    print(diagnostics, arguments.quiet);
    return failed;
  }
  solver::RunSettings settings;
  if (arguments.contact_stiffness == "printed") settings.springs = solver::SpringFormula::printed;
  settings.until = arguments.until;
  settings.cycles = arguments.cycles;
  settings.stop = [] { return EndRequest::name() != nullptr; };
  settings.stop_means = solver::RunEnd::signal;
  contact::SurfaceStore surfaces(model.value());
  auto run = solver::Run::prepare(model.value(), surfaces, settings, diagnostics);
  print(diagnostics, arguments.quiet);
  if (!run) {
    print(located(run.error(), model.value(), arguments.deck));
    return failed;
  }
  return calculate(run.value(), surfaces, arguments);
}

}  // namespace

void add_run(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("run", "Calculate a keyword deck with the verification solver");
  command->set_version_flag("--version", version_line("gapcheck"));
  const auto arguments = std::make_shared<RunArguments>();
  command->add_option("DECK", arguments->deck, "Keyword file")->required()->type_name("");
  const CLI::Validator amount(check_amount, "");
  command->add_option("-o", arguments->directory, "Directory for the result files; made where it is not there")
      ->required()
      ->type_name("DIR");
  command->add_option("--until", arguments->until, "End time, instead of that of the deck")
      ->check(amount)
      ->type_name("T");
  command->add_option("--cycles", arguments->cycles, "End after so many cycles")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000'000}).description(""))
      ->type_name("N");
  command->add_flag("--force", arguments->force,
                    "Replace results in the directory that gapcheck did not write, such as LS-DYNA's");
  command->add_flag("--ignore-unsupported", arguments->ignore_unsupported,
                    "Run without the keywords that are not calculated");
  command
      ->add_option("--contact-stiffness", arguments->contact_stiffness,
                   "Of contact springs: as the manual has it, or as in the surface time step that LS-DYNA prints")
      ->check(CLI::IsMember({"documented", "printed"}))
      ->capture_default_str();
  command->add_flag("--binout", arguments->binout,
                    "Also write all curves into binout0000, as if each card said BINARY = 3");
  command->add_flag("--vtu", arguments->vtu, "Also write each plot state as a .vtu file, and run.pvd that lists them");
  command->add_flag("--quiet", arguments->quiet, "No summary, no warnings");
  command->add_flag("--stats", arguments->stats, "Show counters and times");
  add_settings(*command, arguments->settings);
  add_includes(*command, arguments->read, arguments->missing_includes);
  add_jobs(*command, arguments->jobs);
  command->callback([&action, arguments, command] {
    action = [arguments, command] {
      Failures failures(print);
      arguments->settings_path = use_settings(arguments->settings, arguments->deck, false, *command, failures).path;
      if (failures.any()) return static_cast<int>(failed);
      arguments->read.skip_missing_includes = arguments->missing_includes == "skip";
      return run_deck(*arguments);
    };
  });
}

}  // namespace gapcheck::app
