#include "audit/fix/fix.hpp"

#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/number.hpp"
#include "base/parallel.hpp"
#include "changed_files.hpp"
#include "commands.hpp"
#include "common/version.hpp"
#include "fix/fix_repairs.hpp"
#include "options.hpp"
#include "output.hpp"
#include "output_guard.hpp"
#include "progress.hpp"
#include "report/format/fix_report.hpp"
#include "report/item/describe.hpp"
#include "settings/settings.hpp"
#include "solver/trial/run_trial.hpp"

namespace gapcheck::app {
namespace {

/// `PART`, `FIRST-LAST`, or the same for nodes after `node:`.
std::optional<audit::Lock> parse_lock(std::string_view text) {
  audit::Lock lock;
  constexpr std::string_view nodes = "node:";
  lock.nodes = text.starts_with(nodes);
  if (lock.nodes) text.remove_prefix(nodes.size());
  const std::size_t dash = text.find('-');
  const auto first = parse_integer(text.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : parse_integer(text.substr(dash + 1));
  if (!first || !last || *first <= 0 || *last < *first) return std::nullopt;
  lock.first = *first;
  lock.last = *last;
  return lock;
}

/// `PART=FACTOR`.
std::optional<std::pair<std::int64_t, double>> parse_priority(std::string_view text) {
  const std::size_t sign = text.find('=');
  if (sign == std::string_view::npos) return std::nullopt;
  const auto part = parse_integer(text.substr(0, sign));
  const auto factor = parse_real(text.substr(sign + 1));
  if (!part || !factor || *part <= 0 || !(*factor >= 1e-6 && *factor <= 1e6)) return std::nullopt;
  return std::pair{*part, *factor};
}

std::string check_lock(const std::string& text) {
  return parse_lock(text) ? "" : text + " is neither a part id, a range of them (3-7), nor the same behind node:";
}

std::string check_priority(const std::string& text) {
  return parse_priority(text) ? "" : text + " is not PART=FACTOR with a factor between 1e-6 and 1e6";
}

Status write_report(const FixArguments& arguments, const FixReport& report) {
  Output output(arguments.output);
  output.write(arguments.format == "json" ? report::fix_json(report) : report::fix_text(report, arguments.text));
  return output.close();
}

/// The deck before and after, if that is asked for.
Status write_pictures(const FixArguments& arguments, const FixReport& report) {
  std::vector<NodeMove> moves;
  for (const MovedNode& node : report.moved) moves.push_back({node.node, node.to});
  return write(arguments.pictures, arguments.deck, arguments.read, std::move(moves), report::said_of(report));
}

/// The corrected files, unless it is a dry run, and the report.
Status write(const keyword::Deck& deck, const FixArguments& arguments, audit::Fix& fix) {
  Status status;
  status = arguments.dry_run ? deck.unchanged()
                             : choose_places(deck, arguments.deck, {"-o", arguments.directory}, fix.report.changed);
  if (status.ok()) status = check_fix_report(deck, arguments, fix.report.changed);
  if (status.ok() && !arguments.dry_run) status = write_files(deck, fix.files, fix.report.changed);
  if (status.ok()) status = write_pictures(arguments, fix.report);
  return status.ok() ? write_report(arguments, fix.report) : status;
}

/// Runs the deck before and after the correction.
Status verify(const keyword::Deck& deck, const FixArguments& arguments, FixReport& report) {
  const Progress progress("running " + report::printable(arguments.deck) + " before and after", !arguments.text.quiet);
  Diagnostics repeated, warnings;  // the model was read before
  auto model = model::read_model(deck, repeated);
  if (!model) return model.error();
  report.proof = solver::prove_fix(deck, model.value(), report.moved, arguments.trial, warnings);
  return {};
}

/// Counters and the time, on standard error.
void print_statistics(const keyword::Deck& deck, const FixReport& report, double seconds) {
  const auto line = [](std::string_view name, const auto& value) { fmt::print(stderr, "  {:<16}  {}\n", name, value); };
  line("files read", deck.counters().files);
  line("bytes read", deck.counters().bytes);
  line("rounds", report.rounds);
  line("nodes moved", report.moved.size());
  line("elements touched", report.elements_touched);
  line("time: total", fmt::format("{:.3f} s", seconds));
}

int fix_deck(const FixArguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const JobLimit limit(arguments.jobs);
  if (arguments.directory.empty() && !arguments.dry_run) {
    print(plain_error("give a directory for the corrected files with -o, or --dry-run"));
    return failed;
  }
  Diagnostics diagnostics;
  std::optional<Progress> progress;
  progress.emplace("correcting " + report::printable(arguments.deck), !arguments.text.quiet);
  const auto deck = keyword::read_deck(arguments.deck, arguments.read, diagnostics);
  if (!deck) {
    progress.reset();
    print(deck.error());
    return failed;
  }
  auto fix = audit::fix_penetrations(deck.value(), arguments.fix, diagnostics);
  progress.reset();
  print(diagnostics, arguments.text.quiet);
  if (!fix) {
    print(fix.error());
    return failed;
  }
  // Unread input may be what holds the nodes.
  if (diagnostics.has_errors()) return failed;
  FixReport& report = fix.value().report;
  report.input = arguments.deck;
  report.dry_run = arguments.dry_run;
  Status status = arguments.verify ? verify(deck.value(), arguments, report) : Status();
  if (status.ok()) status = write(deck.value(), arguments, fix.value());
  if (!status.ok()) {
    print(status.error());
    return failed;
  }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  if (arguments.stats) print_statistics(deck.value(), report, spent.count());
  return complete(report) && (!report.proof || report.proof->holds()) ? clean : findings;
}

void add_repairs(CLI::App& command, FixArguments& arguments) {
  CLI::Option* plan = command.add_flag("--plan", arguments.plan,
                                       "List what can be done for each pair of parts, each tried and audited");
  CLI::Option* best =
      command.add_flag("--best", arguments.best, "Do what the plan lists first for each pair of parts")->excludes(plan);
  add_list(command, "--apply", arguments.apply, "Repairs of the plan: 1-optt,2-move")
      ->excludes(plan)
      ->excludes(best)
      ->type_name("IDS");
}

void add_choices(CLI::App& command, FixArguments& arguments) {
  const CLI::Validator lock(check_lock, ""), priority(check_priority, "");
  add_list(command, "--lock", arguments.locks, "Parts and nodes that must not move: 3, 7-9, node:100-200")
      ->check(lock)
      ->type_name("IDS");
  add_list(command, "--priority", arguments.priorities, "A part with a larger factor moves less")
      ->check(priority)
      ->type_name("PART=FACTOR");
}

/// Cycles of a run that proves a correction, unless a time or a number is given.
constexpr std::uint64_t default_cycles = 1000;

void add_verify(CLI::App& command, FixArguments& arguments) {
  CLI::Option* verify =
      command.add_flag("--verify", arguments.verify, "Run the deck for a short time before and after, and compare");
  const CLI::Validator amount(check_amount, "");
  command.add_option("--until", arguments.trial.until, "With --verify: end time of the runs")
      ->check(amount)
      ->needs(verify)
      ->type_name("T");
  command
      .add_option("--cycles", arguments.trial.cycles,
                  fmt::format("With --verify: most cycles of each run (default {} without --until)", default_cycles))
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000'000}).description(""))
      ->needs(verify)
      ->type_name("N");
  command
      .add_flag("--ignore-unsupported", arguments.trial.leave_out,
                "With --verify: run without the keywords that are not calculated")
      ->needs(verify);
}

}  // namespace

void add_fix(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("fix", "Remove initial penetrations of a keyword deck with the least movement");
  command->set_version_flag("--version", version_line("gapcheck"));
  const auto arguments = std::make_shared<FixArguments>();
  command->add_option("DECK", arguments->deck, "Keyword file")->required()->type_name("");
  command->add_option("-o", arguments->directory, "Directory for the files that change; made where it is not there")
      ->type_name("DIR");
  command->add_flag("--dry-run", arguments->dry_run, "Write nothing but the report");
  add_repairs(*command, *arguments);
  add_choices(*command, *arguments);
  command->add_flag(
      "--recommended", arguments->fix.recommended,
      "Move nodes of contacts with IGNORE = 2 to the coordinates that the solver recommends, and no others");
  command->add_flag("--free-welds", arguments->fix.free_welds,
                    "Nodes of spot welds, rivets and weld elements may move against each other");
  add_verify(*command, *arguments);
  command->get_option("--plan")->excludes(command->get_option("-o"))->excludes(command->get_option("--verify"));
  add_plain_report(*command, {"text", "json", "sarif"}, arguments->format, arguments->output, arguments->text.top,
                   "Nodes and pairs of parts", arguments->text.quiet);
  add_before_after(*command, arguments->pictures);
  for (const char* page : {"--html", "--vtu"}) command->get_option("--plan")->excludes(command->get_option(page));
  command->add_flag("--stats", arguments->stats, "Show counters and times, on standard error");
  add_settings(*command, arguments->settings);
  add_includes(*command, arguments->read, arguments->missing_includes);
  add_jobs(*command, arguments->jobs);
  command->callback([&action, arguments, command] {
    action = [arguments, command] {
      Failures failures(print);
      arguments->settings_path = use_settings(arguments->settings, arguments->deck, false, *command, failures).path;
      if (arguments->format == "sarif" && !arguments->plan)
        failures.add(plain_error("--format sarif has the repairs of --plan; give --plan too"));
      if (failures.any()) return static_cast<int>(failed);
      arguments->read.skip_missing_includes = arguments->missing_includes == "skip";
      for (const std::string& text : arguments->locks) arguments->fix.locks.push_back(*parse_lock(text));
      for (const std::string& text : arguments->priorities) arguments->fix.priorities.push_back(*parse_priority(text));
      if (arguments->trial.until == 0 && arguments->trial.cycles == 0) arguments->trial.cycles = default_cycles;
      return asks_for_repairs(*arguments) ? repair_deck(*arguments) : fix_deck(*arguments);
    };
  });
}

}  // namespace gapcheck::app
