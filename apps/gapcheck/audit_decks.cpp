#include "audit_decks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "audit/registry.hpp"
#include "base/parallel.hpp"
#include "campaign/deck_key.hpp"
#include "campaign/deck_results.hpp"
#include "campaign/results_file.hpp"
#include "campaign/stored_results.hpp"
#include "commands.hpp"
#include "common/version.hpp"
#include "deck_list.hpp"
#include "fix/finding_fixes.hpp"
#include "keyword/file_cache.hpp"
#include "output.hpp"
#include "output_guard.hpp"
#include "progress.hpp"
#include "report/item/describe.hpp"

namespace gapcheck::app {
namespace {

namespace fs = std::filesystem;

/// The files that hold the results of one deck.
template <class Arguments>
auto names_of(Arguments& arguments) {
  auto& exports = arguments.exports;
  return std::vector{&arguments.output.html, &exports.key, &exports.ani,  &exports.a4sel,
                     &exports.medina,        &exports.vtu, &exports.sets, &arguments.baseline.write};
}

/// The arguments for one of the decks: its names in place of {deck}.
AuditArguments arguments_for(const std::string& deck, AuditArguments arguments) {
  for (std::string* name : names_of(arguments)) *name = name_for(*name, deck);
  const bool by_settings = arguments.baseline.by_settings;
  arguments.baseline.compare =
      name_for(arguments.baseline.compare, by_settings ? seen_from_settings(deck, arguments.settings) : deck);
  arguments.audit.ignores = ignores_for(deck, arguments.settings);
  return arguments;
}

/// Every file that the call writes.
std::vector<PlannedOutput> files_written(const AuditArguments& arguments, const std::vector<std::string>& decks) {
  std::vector<PlannedOutput> outputs{{"--output", arguments.output.output},
                                     {"--html-index", arguments.overview.html_index},
                                     {"--summary", arguments.overview.summary},
                                     {"--results", arguments.results}};
  for (const std::string& deck : decks) {
    const AuditArguments own = arguments_for(deck, arguments);
    outputs.push_back({"--html", own.output.html, deck});
    for (PlannedOutput& output : planned_outputs(own.exports))
      outputs.push_back({std::move(output.option), std::move(output.path), deck});
    outputs.push_back({"--write-baseline", own.baseline.write, deck});
  }
  std::erase_if(outputs, [](const PlannedOutput& output) { return output.path.empty(); });
  return outputs;
}

/// Every file that the call reads. A baseline that is updated is written after it has been read.
std::vector<ReadInput> files_read(const AuditArguments& arguments, const std::vector<std::string>& decks,
                                  DeckFiles& of_decks, const std::vector<PlannedOutput>& outputs) {
  std::vector<ReadInput> files{{arguments.settings.path, "the settings file"}};
  for (const std::string& deck : decks) {
    add_deck_files(deck, of_decks, outputs, files);
    const BaselineOptions baseline = arguments_for(deck, arguments).baseline;
    if (!same_file(baseline)) files.push_back({baseline.compare, "the baseline to compare with"});
  }
  return files;
}

/// An error if the files cannot all be written: one would overwrite an input or another deck's results, or a baseline
/// would lose what a selection leaves out.
Status check_files(const AuditArguments& arguments, const std::vector<std::string>& decks, DeckFiles& files) {
  const std::vector<PlannedOutput> outputs = files_written(arguments, decks);
  if (!outputs.empty())
    if (Status status = check_outputs(files_read(arguments, decks, files, outputs), outputs); !status.ok())
      return status;
  for (const std::string& deck : decks)
    if (arguments.selection && same_file(arguments_for(deck, arguments).baseline))
      return plain_error(
          "--write-baseline into the file of --baseline would lose what the selection leaves out; write another file");
  if (arguments.overview.html_index.find("{deck}") != std::string::npos)
    return plain_error("--html-index is one page about all decks; {deck} belongs into the name of --html");
  if (decks.size() > 1 && !arguments.baseline.compare.empty() &&
      arguments.baseline.compare.find("{deck}") == std::string::npos)
    return plain_error("--baseline: each deck has a baseline of its own; write {deck} into the name");
  return {};
}

/// The folders that names with {deck} lead to.
Status make_folders(const AuditArguments& arguments, AuditArguments& own) {
  const auto patterns = names_of(arguments);
  const auto names = names_of(own);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const fs::path folder = fs::path(*names[i]).parent_path();
    if (folder.empty() || patterns[i]->find("{deck}") == std::string::npos) continue;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return Diagnostic{Severity::error, folder.string(), 0, "the folder cannot be made: " + error.message()};
  }
  return {};
}

/// "known/a: cannot be opened: …"
std::string reason_of(const Diagnostic& why) {
  std::string place = report::printable_path(why.file);
  if (why.line != 0) place += fmt::format(":{}", why.line);
  return (place.empty() ? "" : place + ": ") + report::printable(why.message);
}

/// What a deck's result depends on besides its files and options: the program and the files that belong to the deck.
std::vector<std::string> other_dependences(AuditArguments& own) {
  std::vector<std::string> texts{version_line("gapcheck"), own.settings.path, own.baseline.compare};
  for (const std::string* name : names_of(own)) texts.push_back(*name);
  return texts;
}

/// True if the files that belong to a deck alone are there.
bool own_files_exist(AuditArguments& own) {
  const auto names = names_of(own);
  std::error_code failed;
  return std::all_of(names.begin(), names.end(),
                     [&](const std::string* name) { return name->empty() || fs::exists(*name, failed); });
}

/// The decks of one call, or of a shard of them.
struct ChosenDecks {
  std::vector<std::string> decks;        ///< paths
  std::vector<std::uint64_t> positions;  ///< of each, in the whole list
  DeckListId call;                       ///< of the whole list
};

/// The decks of one call, one after the other.
class Run {
 public:
  /// `stored`: the results of earlier calls, to which new ones are added; none: not requested.
  Run(AuditArguments arguments, ChosenDecks decks, DeckFiles& files, std::optional<ResultsFile> stored)
      : arguments_(std::move(arguments)), decks_(std::move(decks)), files_(files), stored_(std::move(stored)) {}

  int run() {
    for (std::size_t i = 0; i < decks_.decks.size(); ++i) take_or_audit(i);
    if (results_.reports.empty() && !several()) return failed;
    if (arguments_.shard.whole())
      check_ids(results_, {arguments_.audit.contacts, arguments_.audit.parts}, several(), failures_);
    return write_results(results_, arguments_.output, arguments_.overview, failures_);
  }

 private:
  [[nodiscard]] bool several() const { return decks_.call.count > 1; }

  /// The stored result of a deck if it holds, or a new one.
  void take_or_audit(std::size_t i) {
    const std::string& deck = decks_.decks[i];
    AuditArguments own = arguments_for(deck, arguments_);
    AuditedDeck audited;
    audited.deck = deck;
    audited.position = decks_.positions[i];
    audited.asked = {own.audit.contacts, own.audit.parts};
    if (stored_) {
      audited.key = key_of(deck, own.audit, own.baseline.compare, other_dependences(own), files_);
      if (take_stored(own, audited)) return;
    }
    audit(std::move(own), audited);
  }

  /// True if an earlier call has audited the same deck in the same way, and its own files are there.
  bool take_stored(AuditArguments& own, const AuditedDeck& wanted) {
    std::optional<DeckResult> entry = stored_->find(wanted.deck);
    if (!entry || entry->failed || entry->key != wanted.key || !own_files_exist(own)) return false;
    auto report = report_of(*entry, arguments_.results);
    if (!report) return false;
    print_again(*entry, own.output.text.quiet);
    results_.reports.push_back(std::move(report).value());
    if (entry->call == decks_.call && entry->position == wanted.position) return true;
    entry->call = decks_.call;
    entry->position = wanted.position;
    failures_.add(stored_->add(*entry));
    return true;
  }

  void keep(const AuditedDeck& audited) {
    if (stored_) failures_.add(stored_->add(entry_of(audited, decks_.call)));
  }

  /// Reads and audits one deck and writes its own files.
  void audit(AuditArguments own, AuditedDeck& audited) {
    const std::string& deck = audited.deck;
    // Before the work: a baseline that cannot be read makes it worthless.
    const auto baseline = read(own.baseline);
    if (!baseline) return unread(baseline.error(), audited);
    Diagnostics diagnostics;
    audited.diagnostics = &diagnostics;
    auto result = [&] {
      const std::size_t number = results_.reports.size() + results_.unread.size() + 1;
      const std::string place = several() ? fmt::format(" ({} of {})", number, decks_.decks.size()) : "";
      const Progress progress("auditing " + report::printable(deck) + place, !own.output.text.quiet);
      return audit::audit_deck(deck, own.audit, diagnostics);
    }();
    print(diagnostics, own.output.text.quiet);
    if (!result) return unread(result.error(), audited);
    Report& report = results_.reports.emplace_back(std::move(result).value());
    if (const std::string& settings = own.settings.path; !settings.empty()) {
      report.settings = settings;
      report.statistics.emplace_back("settings file", settings);
    }
    compare(
        baseline.value(), [&own](const KnownFinding& known) { return looked_for(known, own.audit); }, report);
    Failures failures(print);
    failures.count(diagnostics);
    write_own_files(own, !diagnostics.has_errors(), report, failures);
    if (own.fixes) find_fixes(own, report);
    audited.report = &report;
    audited.failed = failures.any();
    failures_.count(failures);
    keep(audited);
  }

  /// `read`: without errors.
  void write_own_files(AuditArguments& own, bool read, Report& report, Failures& failures) {
    const auto& contacts = own.audit.contacts;
    const bool known =
        report.unknown_parts.empty() &&
        std::all_of(contacts.begin(), contacts.end(), [&report](std::int64_t id) { return has_contact(report, id); });
    const bool whole = read && (several() || known);
    // Every record of a deck knows where its node is.
    const auto position = [](std::int64_t) { return std::nullopt; };
    const Status made = make_folders(arguments_, own);
    const Status page = made.ok() ? write_page(report, own.output, position) : made;
    failures.add(page);
    if (page.ok()) report.page = own.output.html;
    failures.add(write(report, own.baseline, whole));
    write(report, own.exports, position, failures);
    report.scene.reset();
    report.mesh.reset();
    for (Finding& finding : report.findings) finding.members = {};
  }

  /// The fixes of the report's findings; a deck whose repairs cannot be listed has none.
  void find_fixes(const AuditArguments& own, const Report& report) {
    results_.plans.emplace_back();
    if (!repairable(report)) return;
    const Progress progress("trying repairs of " + report::printable(report.input), !own.output.text.quiet);
    if (auto plan = plan_of_cards(report.input, own.audit.read))
      results_.plans.back() = std::move(plan).value();
    else if (!own.output.text.quiet)
      print(Diagnostic{Severity::note, report.input, 0, "no fixes: " + plan.error().message});
  }

  void unread(const Diagnostic& why, AuditedDeck& audited) {
    failures_.add(why);
    audited.unread = reason_of(why);
    audited.why = &why;
    audited.failed = true;
    results_.unread.push_back({audited.deck, audited.unread});
    keep(audited);
  }

  AuditArguments arguments_;
  ChosenDecks decks_;
  DeckFiles& files_;
  std::optional<ResultsFile> stored_;
  DeckResults results_;
  Failures failures_{print};
};

/// The decks of the shard.
ChosenDecks chosen(const std::vector<std::string>& all, const Shard& shard, DeckFiles& files) {
  ChosenDecks chosen;
  chosen.call = id_of_list(all);
  const std::vector<std::uint64_t> sizes =
      shard.whole() ? std::vector<std::uint64_t>(all.size()) : sizes_of(all, files);
  for (const std::size_t i : share_of(sizes, shard)) {
    chosen.decks.push_back(all[i]);
    chosen.positions.push_back(i);
  }
  return chosen;
}

/// Opens the file of results and audits. A share without decks is done at once.
int audit_all(AuditArguments arguments, ChosenDecks decks, DeckFiles& files) {
  const bool quiet = arguments.output.text.quiet;
  std::optional<ResultsFile> stored;
  if (!arguments.results.empty()) {
    auto opened = ResultsFile::open(arguments.results);
    if (!opened) {
      print(opened.error());
      return failed;
    }
    if (opened.value().cut_off() > 0 && !quiet)
      print(Diagnostic{Severity::note, arguments.results, 0,
                       "the last result was not written to its end, and its deck is audited again"});
    stored.emplace(std::move(opened).value());
  }
  if (decks.decks.empty()) {
    if (!quiet)
      print(Diagnostic{Severity::note, "", 0,
                       fmt::format("share {} of {} has no decks: there are only {}", arguments.shard.number,
                                   arguments.shard.count, decks.call.count)});
    return clean;
  }
  return Run(std::move(arguments), std::move(decks), files, std::move(stored)).run();
}

/// Which files of the list are not audited alone.
void print_left_out(const DeckList& list) {
  const auto say = [](const std::vector<std::string>& files, std::string_view what) {
    if (const std::size_t count = files.size(); count > 0)
      print(Diagnostic{Severity::note, "", 0,
                       fmt::format("{} {} found {}; the first is {}", count, count == 1 ? "file was" : "files were",
                                   what, files.front())});
  };
  say(list.parts_of_others, "that other decks include, and not audited alone");
  say(list.incomplete, "that no deck includes, without nodes or *CONTROL_TERMINATION, and not audited");
  if (list.decks.empty()) print(Diagnostic{Severity::note, "", 0, "no deck has one of the changed files"});
}

}  // namespace

bool selects(const audit::AuditOptions& audit) {
  return !audit.select.empty() || !audit.ignore.empty() || !audit.contacts.empty() || !audit.parts.empty() ||
         audit.ptol >= 0 || audit.rtol >= 0 || audit.ratio >= 0;
}

// Limits by depth or part leave out more than a baseline can show.
bool looked_for(const KnownFinding& known, const audit::AuditOptions& options) {
  if (!options.parts.empty() || options.ptol >= 0 || options.rtol >= 0 || options.ratio >= 0 || !options.as_if.empty())
    return false;
  const auto& ids = options.contacts;
  if (!ids.empty() && std::find(ids.begin(), ids.end(), known.contact) == ids.end()) return false;
  const RuleIdentity* rule = audit::find_rule(known.id);
  return rule == nullptr || audit::selected(*rule, options.select, options.ignore);
}

int audit_decks(AuditArguments arguments) {
  keyword::FileCache cache;
  arguments.audit.read.cache = &cache;
  DeckFiles files(arguments.audit.read);
  Diagnostics diagnostics;
  const bool all = arguments.changed.empty() && arguments.deleted.empty();
  const DeckList list =
      all ? list_decks(arguments.decks, files, diagnostics)
          : changed_decks(arguments.decks, {arguments.changed, arguments.deleted}, files, diagnostics);
  print(diagnostics, arguments.output.text.quiet);
  if (diagnostics.has_errors()) return failed;
  if (const Status status = check_files(arguments, list.decks, files); !status.ok()) {
    print(status.error());
    return failed;
  }
  if (!arguments.output.text.quiet) print_left_out(list);
  if (list.decks.empty()) return clean;
  constexpr std::uint64_t kept_for_others = std::uint64_t{1} << 30;
  if (list.decks.size() > 1) cache.keep_included(kept_for_others);
  const JobLimit limit(arguments.jobs);
  ChosenDecks decks = chosen(list.decks, arguments.shard, files);
  return audit_all(std::move(arguments), std::move(decks), files);
}

}  // namespace gapcheck::app
