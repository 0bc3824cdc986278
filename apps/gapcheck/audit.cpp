#include "audit/audit.hpp"

#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "audit/registry.hpp"
#include "base/parallel.hpp"
#include "baseline_options.hpp"
#include "commands.hpp"
#include "common/version.hpp"
#include "options.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "report/describe.hpp"

namespace gapcheck::app {
namespace {

struct Arguments {
  std::string deck;
  std::string missing_includes = "error";
  std::string units;
  audit::AuditOptions audit;
  OutputOptions output;
  ExportOptions exports;
  BaselineOptions baseline;
  std::size_t jobs = 0;
};

/// Unit systems in use, as length-time-mass (pounds: force), with their unit of length in millimetres.
const std::map<std::string, double> unit_systems{
    {"mm-ms-kg", 1}, {"mm-s-t", 1},     {"mm-ms-g", 1},   {"mm-s-kg", 1},     {"cm-us-g", 10},
    {"cm-s-g", 10},  {"m-s-kg", 1000}, {"in-s-lbf", 25.4}, {"ft-s-lbf", 304.8},
};

void add_selection(CLI::App& command, Arguments& arguments) {
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
}

void add_work(CLI::App& command, Arguments& arguments) {
  const std::vector<CLI::Option*> options{
      command.add_option("-I", arguments.audit.read.include_directories, "Further directory for *INCLUDE")
          ->take_all()
          ->allow_extra_args(false)
          ->type_name("DIR"),
      command.add_option("--missing-includes", arguments.missing_includes, "What to do about missing include files")
          ->check(CLI::IsMember({"error", "skip"}))
          ->capture_default_str(),
      command.add_option("--units", arguments.units, "Of the deck, for rules that know millimetres: mm-ms-kg, m-s-kg, …")
          ->check(CLI::IsMember(unit_systems))
          ->type_name("SYSTEM"),
      command.add_flag("--exact", arguments.audit.exact, "Decide everything in exact arithmetic (slow, same results)"),
      command.add_option("--jobs", arguments.jobs, "Threads; 0: as many as the machine has")
          ->check(CLI::Range(0, 4096).description(""))
          ->type_name("N")
          ->capture_default_str()};
  for (CLI::Option* option : options) option->group("Reading and work");
}

/// True if every contact of --contact is in the deck: nothing is found in a contact that does not exist.
bool contacts_exist(const Report& report, const std::vector<std::int64_t>& wanted) {
  bool all = true;
  for (const std::int64_t id : wanted) {
    const auto matches = [id](const ContactSummary& contact) { return contact.id == id; };
    if (std::any_of(report.contacts.begin(), report.contacts.end(), matches)) continue;
    print_error(fmt::format("--contact {}: the deck has no such contact", id));
    all = false;
  }
  return all;
}

/// What the baseline has and the audit was not asked for is not gone. Limits by depth or part leave out more than can
/// be told from a baseline.
bool looked_for(const KnownFinding& known, const audit::AuditOptions& options) {
  if (!options.parts.empty() || options.ptol >= 0 || options.rtol >= 0 || options.ratio >= 0) return false;
  const auto& ids = options.contacts;
  if (!ids.empty() && std::find(ids.begin(), ids.end(), known.contact) == ids.end()) return false;
  const audit::RuleInfo* rule = audit::find_rule(known.id);
  return rule == nullptr || audit::selected(*rule, options.select, options.ignore);
}

/// True if nothing that is to be written would take the deck's place, and no baseline would lose what a selection leaves
/// out; what is wrong has been said.
bool can_be_written(const Arguments& arguments) {
  const BaselineOptions& baseline = arguments.baseline;
  for (const std::string& path : {arguments.output.output, arguments.output.html, arguments.exports.key,
                                  arguments.exports.ani, arguments.exports.a4sel, arguments.exports.medina,
                                  baseline.write}) {
    std::error_code none;
    if (path.empty() || !std::filesystem::equivalent(path, arguments.deck, none)) continue;
    print_error(report::printable(path) + " is the deck itself; give another file to write");
    return false;
  }
  const audit::AuditOptions& audit = arguments.audit;
  const bool selection = !audit.select.empty() || !audit.ignore.empty() || !audit.contacts.empty() ||
                         !audit.parts.empty() || audit.ptol >= 0 || audit.rtol >= 0 || audit.ratio >= 0;
  if (!selection || baseline.write.empty() || baseline.write != baseline.compare) return true;
  print_error("--write-baseline into the file of --baseline would lose what the selection leaves out; write another file");
  return false;
}

int audit_deck(const Arguments& arguments) {
  if (!can_be_written(arguments)) return failed;
  const JobLimit limit(arguments.jobs);
  Diagnostics diagnostics;
  // Before the work: a baseline that cannot be read makes it worthless.
  const auto baseline = read(arguments.baseline);
  if (!baseline) {
    print(baseline.error());
    return failed;
  }
  auto result = [&] {
    const Progress progress("auditing " + report::printable(arguments.deck), !arguments.output.text.quiet);
    return audit::audit_deck(arguments.deck, arguments.audit, diagnostics);
  }();
  print(diagnostics, arguments.output.text.quiet);
  if (!result) {
    print(result.error());
    return failed;
  }
  const bool complete = contacts_exist(result.value(), arguments.audit.contacts) && !diagnostics.has_errors();
  const auto asked = [&](const KnownFinding& known) { return looked_for(known, arguments.audit); };
  compare(baseline.value(), asked, result.value());
  // Every record of a deck knows where its node is.
  const auto position = [](std::int64_t) { return std::nullopt; };
  bool written = write(result.value(), arguments.output, position);
  written = write(result.value(), arguments.baseline, complete) && written;
  written = write(result.value(), arguments.exports, position) && written;
  if (!written || !complete) return failed;
  return exit_code(result.value(), arguments.output.fail_on);
}

}  // namespace

void add_audit(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("audit", "Check the contacts of a keyword deck and its includes");
  command->set_version_flag("--version", version_line("gapcheck"));
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("DECK", arguments->deck, "Keyword file")->required()->type_name("");
  add_selection(*command, *arguments);
  add_output(*command, arguments->output);
  add_baseline(*command, arguments->baseline);
  add_exports(*command, arguments->exports);
  add_work(*command, *arguments);
  command->callback([&action, arguments] {
    action = [arguments] {
      if (!arguments->units.empty()) arguments->audit.millimetre = 1 / unit_systems.at(arguments->units);
      arguments->audit.scene = !arguments->output.html.empty();
      arguments->audit.read.skip_missing_includes = arguments->missing_includes == "skip";
      return audit_deck(*arguments);
    };
  });
}

}  // namespace gapcheck::app
