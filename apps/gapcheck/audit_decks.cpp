#include "audit_decks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "audit/registry.hpp"
#include "base/file_writer.hpp"
#include "base/parallel.hpp"
#include "commands.hpp"
#include "common/freed_memory.hpp"
#include "common/version.hpp"
#include "deck_list.hpp"
#include "keyword/file_cache.hpp"
#include "output.hpp"
#include "output_guard.hpp"
#include "progress.hpp"
#include "report/html/html_index.hpp"
#include "report/item/describe.hpp"

namespace gapcheck::app {
namespace {

namespace fs = std::filesystem;

/// Baseline findings that the audit did not look for are not gone. Limits by depth or part leave out more than a
/// baseline can show.
bool looked_for(const KnownFinding& known, const audit::AuditOptions& options) {
  if (!options.parts.empty() || options.ptol >= 0 || options.rtol >= 0 || options.ratio >= 0 || !options.as_if.empty())
    return false;
  const auto& ids = options.contacts;
  if (!ids.empty() && std::find(ids.begin(), ids.end(), known.contact) == ids.end()) return false;
  const RuleIdentity* rule = audit::find_rule(known.id);
  return rule == nullptr || audit::selected(*rule, options.select, options.ignore);
}

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
  std::vector<PlannedOutput> outputs{{"--output", arguments.output.output}, {"--html-index", arguments.html_index}};
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
  if (arguments.html_index.find("{deck}") != std::string::npos)
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

/// The decks of one call, one after the other.
class Run {
 public:
  Run(AuditArguments arguments, std::vector<std::string> decks)
      : arguments_(std::move(arguments)), decks_(std::move(decks)) {}

  int run() {
    for (const std::string& deck : decks_) audit(deck);
    if (reports_.empty() && !several()) return failed;
    check_ids();
    if (const std::string& index = arguments_.html_index; !index.empty())
      failures_.add(write_file(index, report::html_index({reports_, unread_}, index, version())));
    failures_.add(write({reports_, unread_}, arguments_.output));
    if (failures_.any()) return failed;
    int code = clean;
    for (const Report& report : reports_) code = std::max(code, exit_code(report, arguments_.output.fail_on));
    return code;
  }

 private:
  [[nodiscard]] bool several() const { return decks_.size() > 1; }

  /// Nothing is found in contacts and parts that do not exist.
  void check_ids() {
    check("--contact", "contact", arguments_.audit.contacts, has_contact);
    check("--part", "part", arguments_.audit.parts, has_part);
  }
  static bool has_contact(const Report& report, std::int64_t id) {
    return std::any_of(report.contacts.begin(), report.contacts.end(),
                       [id](const ContactSummary& summary) { return summary.id == id; });
  }
  static bool has_part(const Report& report, std::int64_t id) {
    return std::find(report.unknown_parts.begin(), report.unknown_parts.end(), id) == report.unknown_parts.end();
  }
  template <class Has>
  void check(std::string_view option, std::string_view thing, const std::vector<std::int64_t>& ids, const Has& has) {
    for (const std::int64_t id : ids)
      if (!reports_.empty() &&
          std::none_of(reports_.begin(), reports_.end(), [&](const Report& r) { return has(r, id); }))
        failures_.add(plain_error(fmt::format(
            "{} {}: {} {}", option, id, several() ? "none of the decks has such a" : "the deck has no such", thing)));
  }

  /// Reads and audits one deck and writes its own files.
  void audit(const std::string& deck) {
    AuditArguments own = arguments_for(deck, arguments_);
    // Before the work: a baseline that cannot be read makes it worthless.
    const auto baseline = read(own.baseline);
    if (!baseline) return unread(deck, baseline.error());
    Diagnostics diagnostics;
    auto result = [&] {
      const std::size_t number = reports_.size() + unread_.size() + 1;
      const std::string place = several() ? fmt::format(" ({} of {})", number, decks_.size()) : "";
      const Progress progress("auditing " + report::printable(deck) + place, !own.output.text.quiet);
      return audit::audit_deck(deck, own.audit, diagnostics);
    }();
    print(diagnostics, own.output.text.quiet);
    failures_.count(diagnostics);
    if (!result) return unread(deck, result.error());
    Report& report = reports_.emplace_back(std::move(result).value());
    if (const std::string& settings = own.settings.path; !settings.empty()) {
      report.settings = settings;
      report.statistics.emplace_back("settings file", settings);
    }
    compare(
        baseline.value(), [&own](const KnownFinding& known) { return looked_for(known, own.audit); }, report);
    const auto& contacts = own.audit.contacts;
    const bool known =
        report.unknown_parts.empty() &&
        std::all_of(contacts.begin(), contacts.end(), [&report](std::int64_t id) { return has_contact(report, id); });
    const bool whole = !diagnostics.has_errors() && (several() || known);
    // Every record of a deck knows where its node is.
    const auto position = [](std::int64_t) { return std::nullopt; };
    const Status made = make_folders(arguments_, own);
    const Status page = made.ok() ? write_page(report, own.output, position) : made;
    failures_.add(page);
    if (page.ok()) report.page = own.output.html;
    failures_.add(write(report, own.baseline, whole));
    write(report, own.exports, position, failures_);
    report.scene.reset();
    report.mesh.reset();
    for (Finding& finding : report.findings) finding.members = {};
  }

  void unread(const std::string& deck, const Diagnostic& why) {
    failures_.add(why);
    unread_.push_back({deck, reason_of(why)});
  }

  AuditArguments arguments_;
  std::vector<std::string> decks_;
  std::vector<Report> reports_;
  std::vector<report::Unread> unread_;
  Failures failures_{print};
};

}  // namespace

bool selects(const audit::AuditOptions& audit) {
  return !audit.select.empty() || !audit.ignore.empty() || !audit.contacts.empty() || !audit.parts.empty() ||
         audit.ptol >= 0 || audit.rtol >= 0 || audit.ratio >= 0;
}

int audit_decks(AuditArguments arguments) {
  keep_freed_memory();
  keyword::FileCache cache;
  arguments.audit.read.cache = &cache;
  DeckFiles files(arguments.audit.read);
  Diagnostics diagnostics;
  const DeckList list = list_decks(arguments.decks, files, diagnostics);
  print(diagnostics, arguments.output.text.quiet);
  if (diagnostics.has_errors()) return failed;
  if (const Status status = check_files(arguments, list.decks, files); !status.ok()) {
    print(status.error());
    return failed;
  }
  if (const std::size_t parts = list.parts_of_others.size(); parts > 0 && !arguments.output.text.quiet)
    print(Diagnostic{Severity::note, "", 0,
                     fmt::format("{} {} found that other decks include, and not audited alone; the first is {}", parts,
                                 parts == 1 ? "file was" : "files were", list.parts_of_others.front())});
  constexpr std::uint64_t kept_for_others = std::uint64_t{1} << 30;
  if (list.decks.size() > 1) cache.keep_included(kept_for_others);
  const JobLimit limit(arguments.jobs);
  return Run(std::move(arguments), list.decks).run();
}

}  // namespace gapcheck::app
