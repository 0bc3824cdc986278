#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "as_if.hpp"
#include "audit/registry.hpp"
#include "audit/shared/length_unit.hpp"
#include "audit_decks.hpp"
#include "base/system/clock.hpp"
#include "commands.hpp"
#include "common/version.hpp"
#include "deck_list.hpp"
#include "options.hpp"
#include "output.hpp"
#include "settings/settings.hpp"

namespace gapcheck::app {
namespace {

/// Known systems of units, with a millimetre in their unit of length.
std::map<std::string, double> millimetres() {
  std::map<std::string, double> systems;
  for (const audit::UnitSystem& units : audit::unit_systems()) systems.emplace(units.name, 1e-3 / units.metre);
  return systems;
}

void add_deck_selection(CLI::App& command, AuditArguments& arguments) {
  audit::AuditOptions& audit = arguments.audit;
  const CLI::Validator rule(check_deck_rule, ""), amount(check_amount, ""), id(check_id, "");
  const std::vector<CLI::Option*> options{
      add_list(command, "--select", audit.select, "Only these rules: ids, names or beginnings of them")
          ->check(rule)
          ->type_name("RULES"),
      add_list(command, "--ignore", audit.ignore, "Not these rules")->check(rule)->type_name("RULES"),
      add_list(command, "--contact", audit.contacts, "Only these contacts")->check(id)->type_name("IDS"),
      add_list(command, "--part", audit.parts, "Only nodes of these parts")->check(id)->type_name("IDS"),
      command.add_option("--ptol", audit.ptol, "Only penetrations deeper than X")->check(amount)->type_name("X"),
      command.add_option("--rtol", audit.rtol, "Only nodes with a remaining distance below X")
          ->check(amount)
          ->type_name("X"),
      command.add_option("--ratio", audit.ratio, "Only penetrations deeper than X times the contact distance")
          ->check(amount)
          ->type_name("X")};
  for (CLI::Option* option : options) option->group("Selection");
  command
      .add_option("--changed", arguments.changed,
                  "Only decks that this file belongs to, be it the deck or an include; repeatable")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("FILE")
      ->group("Selection");
  command
      .add_option("--deleted", arguments.deleted,
                  "Only decks that still include this file, which may be gone; beside --changed, repeatable")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("FILE")
      ->group("Selection");
  add_list(
      command, "--as-if", arguments.as_if,
      "Audit as if all contacts had this value: SST=0.5, OPTT=0, …; 'thickness': the workshop's check, SST and MST "
      "of 0.5 mm without OPTT and IGNORE")
      ->check(CLI::Validator(check_assumption, ""))
      ->type_name("FIELD=VALUE")
      ->group("Selection");
}

void add_deck_output(CLI::App& command, AuditArguments& arguments) {
  add_overview(command, arguments.overview);
  command
      .add_flag("--portability", arguments.audit.portability,
                "Also list contact keywords, options and fields that other programs do not read")
      ->group("Output");
  command
      .add_flag("--fixes", arguments.fixes,
                "With --format sarif: what repairs would write, each tried and audited, as fixes of the findings")
      ->excludes(command.get_option("--as-if"))
      ->group("Output");
}

void add_work(CLI::App& command, AuditArguments& arguments) {
  add_includes(command, arguments.audit.read, arguments.missing_includes);
  const std::vector<CLI::Option*> options{
      command.get_option("-I"),
      command.get_option("--missing-includes"),
      command.get_option("--param"),
      command
          .add_option("--units", arguments.units, "Of the deck, for rules that know millimetres: mm-ms-kg, m-s-kg, …")
          ->check(CLI::IsMember(millimetres()))
          ->type_name("SYSTEM"),
      command.add_flag("--exact", arguments.audit.exact, "Decide everything in exact arithmetic (slow, same results)"),
      command.add_option("--jobs", arguments.jobs, "Threads; 0: as many as the machine has")
          ->check(CLI::Range(0, 4096).description(""))
          ->type_name("N")
          ->capture_default_str()};
  for (CLI::Option* option : options) option->group("Reading and work");
}

void add_campaign(CLI::App& command, AuditArguments& arguments, std::string& shard) {
  command.add_option("--shard", shard, "Only the K-th of N shares of the decks: one of N jobs")
      ->check(CLI::Validator(check_shard, ""))
      ->type_name("K/N")
      ->group("Campaigns");
  command
      .add_option("--results", arguments.results,
                  "Keep what is found in each deck there: for gapcheck merge, and to continue after an interruption")
      ->type_name("FILE")
      ->group("Campaigns");
  for (const char* option : {"--shard", "--results"}) command.get_option(option)->excludes("--fixes");
}

/// The local day, not UTC: ignores apply until the end of their last day.
std::chrono::sys_days today() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  if (!system::local_time(now, local)) return {};
  return std::chrono::year(local.tm_year + 1900) / (local.tm_mon + 1) / local.tm_mday;
}

/// Fills in what the settings file says, unless there are faults in it.
void use_settings_of(const std::string& deck, AuditArguments& arguments, CLI::App& command, Diagnostics& faults) {
  arguments.settings = use_settings(arguments.settings_file, deck, true, command, faults);
  if (faults.has_errors()) return;
  arguments.audit.severities = arguments.settings.severities;
  arguments.audit.thresholds = arguments.settings.thresholds;
  arguments.audit.today = today();
  if (!arguments.units.empty()) arguments.audit.millimetre = millimetres().at(arguments.units);
  auto as_if = assumptions(arguments.as_if, arguments.audit.millimetre);
  if (as_if)
    arguments.audit.as_if = std::move(as_if).value();
  else
    faults.add(as_if.error());
}

void add_options(CLI::App& command, AuditArguments& arguments) {
  add_deck_selection(command, arguments);
  add_output(command, arguments.output);
  add_deck_output(command, arguments);
  add_baseline(command, arguments.baseline);
  add_exports(command, arguments.exports);
  add_settings(command, arguments.settings_file);
  add_work(command, arguments);
}

}  // namespace

EditorAudit editor_audit_of(const std::string& deck, const AuditArguments& given, Diagnostics& faults) {
  CLI::App command;
  AuditArguments arguments;
  add_options(command, arguments);
  arguments.settings_file = given.settings_file;
  use_settings_of(deck, arguments, command, faults);
  if (faults.has_errors()) {
    arguments = AuditArguments();
    arguments.audit.today = today();
  }
  arguments.audit.ignores = ignores_for(deck, arguments.settings);
  keyword::ReadOptions& read = arguments.audit.read;
  const auto add = [](std::vector<std::string>& to, const std::vector<std::string>& more) {
    to.insert(to.end(), more.begin(), more.end());
  };
  add(read.include_directories, given.audit.read.include_directories);
  add(read.parameters, given.audit.read.parameters);
  read.skip_missing_includes = arguments.missing_includes == "skip" || given.missing_includes == "skip";
  BaselineOptions& baseline = arguments.baseline;
  baseline.by_settings = true;
  if (!baseline.compare.empty())
    baseline.compare = name_for(baseline.compare, seen_from_settings(deck, arguments.settings));
  return {std::move(arguments.audit), std::move(baseline), std::move(arguments.settings.path)};
}

Status compare_for_editor(const EditorAudit& editor, Report& report) {
  const auto baseline = read(editor.baseline);
  if (!baseline) {
    Diagnostic why = baseline.error();
    std::error_code failed;
    if (std::filesystem::exists(editor.baseline.compare, failed)) return why;
    why.message = fmt::format("the baseline {} {}", editor.baseline.compare, why.message);
    why.file = editor.settings;
    why.line = 0;
    return why;
  }
  compare(
      baseline.value(), [&editor](const KnownFinding& known) { return looked_for(known, editor.audit); }, report);
  return {};
}

void add_audit(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("audit", "Check the contacts of a keyword deck and its includes");
  command->set_version_flag("--version", version_line("gapcheck"));
  const auto arguments = std::make_shared<AuditArguments>();
  command->add_option("DECK", arguments->decks, "Keyword files; patterns in quotes find them: 'models/**/*.k'")
      ->required()
      ->type_name("");
  add_options(*command, *arguments);
  const auto shard = std::make_shared<std::string>();
  add_campaign(*command, *arguments, *shard);
  command->callback([&action, arguments, shard, command] {
    action = [arguments, shard, command] {
      if (!shard->empty()) arguments->shard = read_shard(*shard).value_or(Shard());
      arguments->selection = selects(arguments->audit);
      arguments->baseline.by_settings = arguments->baseline.compare.empty();
      Diagnostics faults;
      use_settings_of(arguments->decks.front(), *arguments, *command, faults);
      if (arguments->fixes && arguments->output.format != "sarif")
        faults.add(plain_error("--fixes are fixes of SARIF; give --format sarif too"));
      print(faults, false);
      if (faults.has_errors()) return static_cast<int>(failed);
      arguments->audit.scene = !arguments->output.html.empty();
      arguments->audit.mesh = !arguments->exports.vtu.empty();
      arguments->audit.members = !arguments->exports.sets.empty();
      arguments->audit.read.skip_missing_includes = arguments->missing_includes == "skip";
      return audit_decks(std::move(*arguments));
    };
  });
}

}  // namespace gapcheck::app
