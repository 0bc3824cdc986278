#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "campaign/deck_results.hpp"
#include "campaign/results_file.hpp"
#include "campaign/stored_results.hpp"
#include "commands.hpp"
#include "common/file_guard.hpp"
#include "common/version.hpp"
#include "options.hpp"
#include "output.hpp"
#include "output_guard.hpp"

namespace gapcheck::app {
namespace {

struct MergeArguments {
  std::vector<std::string> files;
  OutputOptions output;
  OverviewOptions overview;
};

/// One entry and the file that it is from.
struct Entry {
  DeckResult result;
  const std::string* file;
};

/// An error if an entry does not belong to the call of the first one.
Status check_call(const Entry& entry, const Entry& first) {
  if (entry.result.version != version_line("gapcheck"))
    return Diagnostic{Severity::error, *entry.file, 0,
                      fmt::format("was written by {}, and this is {}; audit its decks again", entry.result.version,
                                  version_line("gapcheck"))};
  if (entry.result.call != first.result.call || entry.result.contacts != first.result.contacts ||
      entry.result.parts != first.result.parts || entry.result.position >= first.result.call.count)
    return Diagnostic{Severity::error, *entry.file, 0,
                      fmt::format("holds results of another call than {}: {} is one of {} decks there, and {} one of "
                                  "{} here; merge the shares of one call, made with the same decks and options",
                                  *first.file, first.result.deck, first.result.call.count, entry.result.deck,
                                  entry.result.call.count)};
  return {};
}

/// An error if decks of the call have no result in any file.
Status check_complete(const std::vector<Entry>& entries) {
  const std::uint64_t count = entries.front().result.call.count, missing = count - entries.size();
  if (missing == 0) return {};
  std::uint64_t first = 0;
  while (first < entries.size() && entries[static_cast<std::size_t>(first)].result.position == first) ++first;
  return plain_error(
      fmt::format("{} of {} decks {} no result; the first is number {} of the list. Run the shares that were not "
                  "finished again: what they have done already they do not do twice",
                  missing, count, missing == 1 ? "has" : "have", first + 1));
}

/// All entries, each deck once, in the order of the call.
Result<std::vector<Entry>> read_entries(const std::vector<std::string>& files) {
  std::vector<Entry> entries;
  for (const std::string& file : files) {
    auto results = ResultsFile::read(file);
    if (!results) return results.error();
    for (DeckResult& result : results.value()) entries.push_back({std::move(result), &file});
  }
  if (entries.empty()) return plain_error("the files hold no result; write them by gapcheck audit --results");
  for (const Entry& entry : entries)
    if (Status status = check_call(entry, entries.front()); !status.ok()) return status.error();
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.result.position < b.result.position; });
  for (std::size_t i = 1; i < entries.size(); ++i) {
    if (entries[i].result.position != entries[i - 1].result.position) continue;
    return Diagnostic{Severity::error, *entries[i].file, 0,
                      fmt::format("has a result of {}, and so has {}; give only one of them", entries[i].result.deck,
                                  *entries[i - 1].file)};
  }
  if (Status status = check_complete(entries); !status.ok()) return status.error();
  return entries;
}

/// Nothing that is read is overwritten.
Status check_files(const MergeArguments& arguments) {
  std::vector<ReadInput> read;
  for (const std::string& file : arguments.files) read.push_back({file, "a file of results"});
  std::vector<PlannedOutput> outputs{{"--output", arguments.output.output},
                                     {"--html-index", arguments.overview.html_index},
                                     {"--summary", arguments.overview.summary}};
  std::erase_if(outputs, [](const PlannedOutput& output) { return output.path.empty(); });
  return check_outputs(read, outputs);
}

/// The errors of a deck have been printed again, but for those about files that only its job wrote.
void repeat_failure(const DeckResult& entry, Failures& failures) {
  Diagnostics printed;
  for (const Diagnostic& diagnostic : entry.diagnostics) printed.add(diagnostic);
  failures.count(printed);
  if (!printed.has_errors())
    failures.add(Diagnostic{Severity::error, entry.deck, 0,
                            "a file that belongs to this deck could not be written when it was audited; run its share "
                            "again"});
}

int merge(const MergeArguments& arguments) {
  Failures failures(print);
  failures.add(check_files(arguments));
  if (failures.any()) return failed;
  auto entries = read_entries(arguments.files);
  if (!entries) {
    failures.add(entries.error());
    return failed;
  }
  DeckResults results;
  for (const auto& [entry, file] : entries.value()) {
    print_again(entry, arguments.output.text.quiet);
    if (entry.failed) repeat_failure(entry, failures);
    if (!entry.unread.empty()) {
      results.unread.push_back({entry.deck, entry.unread});
      continue;
    }
    auto report = report_of(entry, *file);
    if (!report) {
      failures.add(report.error());
      return failed;
    }
    results.reports.push_back(std::move(report).value());
  }
  const DeckResult& first = entries.value().front().result;
  check_ids(results, {first.contacts, first.parts}, first.call.count > 1, failures);
  return write_results(results, arguments.output, arguments.overview, failures);
}

}  // namespace

void add_merge(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("merge", "Put the results of audit --shard together, as one call gives them");
  command->set_version_flag("--version", version_line("gapcheck"));
  const auto arguments = std::make_shared<MergeArguments>();
  command->add_option("FILE", arguments->files, "Files of audit --results, of all shares")->required()->type_name("");
  add_output(*command, arguments->output);
  command->remove_option(command->get_option("--html"));
  add_overview(*command, arguments->overview);
  command->callback([&action, arguments] { action = [arguments] { return merge(*arguments); }; });
}

}  // namespace gapcheck::app
