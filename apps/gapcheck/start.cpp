#include "solver/start/start.hpp"

#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "audit/fix/node_lines.hpp"
#include "base/parallel.hpp"
#include "changed_files.hpp"
#include "commands.hpp"
#include "common/version.hpp"
#include "fix/before_after.hpp"
#include "options.hpp"
#include "output.hpp"
#include "output_guard.hpp"
#include "progress.hpp"
#include "report/format/start_report.hpp"
#include "report/item/describe.hpp"
#include "settings/settings.hpp"

namespace gapcheck::app {
namespace {

namespace fs = std::filesystem;

struct StartArguments {
  std::string deck, directory, format = "text", output;
  std::string settings_path;  ///< empty: none is used
  std::string missing_includes = "error";
  keyword::ReadOptions read;
  report::StartTextOptions text;
  SettingsOptions settings;
  BeforeAfter pictures;
  std::size_t jobs = 0;
  bool stats = false;
};

/// A deck that is to be written, and where its files go.
struct DeckToWrite {
  std::vector<audit::ChangedLines> files;
  std::vector<FixedFile> places;
};

/// Adds the files in or below the folder of the main file that do not change, so that the directory holds all of them.
void add_unchanged(const keyword::Deck& deck, const std::string& main, DeckToWrite& written) {
  std::error_code error;
  const fs::path home = fs::weakly_canonical(fs::path(main), error).parent_path();
  std::set<fs::path> known;
  for (const FixedFile& file : written.places) known.insert(fs::weakly_canonical(file.path, error));
  for (std::uint32_t f = 0; f < deck.files().size(); ++f) {
    const std::string& path = deck.files()[f].path;
    const fs::path canonical = fs::weakly_canonical(path, error);
    const fs::path below = canonical.lexically_relative(home);
    if (below.empty() || *below.begin() == ".." || !known.insert(canonical).second) continue;
    written.files.push_back({FileIndex{f}, {}});
    written.places.push_back({path, "", 0});
  }
}

/// The moved coordinates as a deck, if it is asked for.
Result<DeckToWrite> plan_deck(const keyword::Deck& deck, const model::Model& model, const StartArguments& arguments,
                              solver::Start& start) {
  DeckToWrite written;
  if (arguments.directory.empty()) return written;
  auto moved = audit::move_deck(deck, model, start.x);
  if (!moved) return moved.error();
  written.files = std::move(moved.value().files);
  for (const audit::ChangedLines& file : written.files)
    written.places.push_back({deck.file(file.file).path, "", file.edits.size()});
  add_unchanged(deck, arguments.deck, written);
  const Status places = choose_places(deck, arguments.deck, {"--write-deck", arguments.directory}, written.places);
  if (!places.ok()) return places.error();
  start.report.rounding = moved.value().rounding;
  for (const FixedFile& file : written.places) start.report.written.push_back(file.written);
  return written;
}

/// An error if the report or the deck would overwrite an input or each other.
Status check_files(const keyword::Deck& deck, const StartArguments& arguments, const DeckToWrite& written) {
  std::vector<ReadInput> read{{arguments.settings_path, "the settings file"}};
  add_deck_files(deck, read);
  std::vector<PlannedOutput> outputs{{"--output", arguments.output}};
  for (const FixedFile& file : written.places) outputs.push_back({"--write-deck", file.written});
  for (const PlannedOutput& output : planned_outputs(arguments.pictures)) outputs.push_back(output);
  return check_outputs(read, outputs);
}

Status write_start(const StartArguments& arguments, const StartReport& report) {
  Output output(arguments.output);
  output.write(arguments.format == "json" ? report::start_json(report) : report::start_text(report, arguments.text));
  return output.close();
}

/// The deck and the start, if that is asked for.
Status write_pictures(const StartArguments& arguments, const model::Nodes& nodes, const solver::Start& start) {
  solver::ShownMoves shown = solver::shown_moves(nodes, start);
  return write(arguments.pictures, arguments.deck, arguments.read, std::move(shown.moves), std::move(shown.said));
}

/// Counters, on standard error.
void print_start_statistics(const keyword::Deck& deck, const StartReport& report) {
  const auto line = [](std::string_view name, const auto& value) { fmt::print(stderr, "  {:<16}  {}\n", name, value); };
  line("files read", deck.counters().files);
  line("bytes read", deck.counters().bytes);
  line("moves", report.moves.size());
  line("nodes moved", report.moved);
  line("elements touched", report.shapes.touched);
  if (!report.expected) return;
  line("groups that rest", report.expected->still);
  line("candidates", report.expected->candidates);
  line("closest points", report.expected->closest_points);
}

int start_deck(const StartArguments& arguments) {
  const JobLimit limit(arguments.jobs);
  Diagnostics diagnostics;
  std::optional<Progress> progress;
  progress.emplace("following the start of " + report::printable(arguments.deck), !arguments.text.quiet);
  const auto deck = keyword::read_deck(arguments.deck, arguments.read, diagnostics);
  if (!deck) {
    progress.reset();
    print(deck.error());
    return failed;
  }
  const auto model = model::read_model(deck.value(), diagnostics);
  if (!model || diagnostics.has_errors()) {
    progress.reset();
    print(diagnostics, arguments.text.quiet);
    if (!model) print(model.error());
    return failed;
  }
  keyword::note_missing_end(deck.value(), diagnostics);
  contact::SurfaceStore surfaces(model.value());
  solver::Start start = solver::follow_start(deck.value(), model.value(), surfaces, diagnostics);
  start.report.input = arguments.deck;
  progress.reset();
  print(diagnostics, arguments.text.quiet);
  const auto written = plan_deck(deck.value(), model.value(), arguments, start);
  Status status = written.ok() ? check_files(deck.value(), arguments, written.value()) : Status(written.error());
  if (status.ok() && !arguments.directory.empty())
    status = write_files(deck.value(), written.value().files, written.value().places);
  if (status.ok()) status = write_pictures(arguments, model.value().mesh.nodes, start);
  if (status.ok()) status = write_start(arguments, start.report);
  if (!status.ok()) {
    print(status.error());
    return failed;
  }
  if (arguments.stats) print_start_statistics(deck.value(), start.report);
  return starts_clean(start.report) ? clean : findings;
}

}  // namespace

void add_start(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "start", "Show the geometry and energy that a run starts with, and what each contact did to it");
  command->set_version_flag("--version", version_line("gapcheck"));
  const auto arguments = std::make_shared<StartArguments>();
  command->add_option("DECK", arguments->deck, "Keyword file")->required()->type_name("");
  command
      ->add_option("--write-deck", arguments->directory,
                   "Directory for the deck with the nodes where they start; made where it is not there")
      ->type_name("DIR");
  add_plain_report(*command, {"text", "json"}, arguments->format, arguments->output, arguments->text.top,
                   "Pairs of parts, elements and nodes", arguments->text.quiet);
  add_before_after(*command, arguments->pictures);
  command->add_flag("--stats", arguments->stats, "Show counters, on standard error");
  add_settings(*command, arguments->settings);
  add_includes(*command, arguments->read, arguments->missing_includes);
  add_jobs(*command, arguments->jobs);
  command->footer("Exit codes: 0 every contact starts clean, 1 something happens, 2 the tool could not do its job.");
  command->callback([&action, arguments, command] {
    action = [arguments, command] {
      Failures failures(print);
      arguments->settings_path = use_settings(arguments->settings, arguments->deck, false, *command, failures).path;
      if (failures.any()) return static_cast<int>(failed);
      arguments->read.skip_missing_includes = arguments->missing_includes == "skip";
      return start_deck(*arguments);
    };
  });
}

}  // namespace gapcheck::app
