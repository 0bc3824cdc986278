#include "campaign/stored_results.hpp"

#include <string_view>

#include "audit/registry.hpp"
#include "common/version.hpp"
#include "output.hpp"
#include "report/archive/archive.hpp"
#include "report/archive/report_archive.hpp"

namespace gapcheck::app {
namespace {

std::string_view consequence_of(std::string_view id) {
  const RuleIdentity* rule = audit::find_rule(id);
  return rule == nullptr ? std::string_view() : rule->consequence;
}

}  // namespace

DeckListId id_of_list(const std::vector<std::string>& decks) {
  report::ArchiveWriter paths;
  paths(decks);
  return {hash_of(paths.take()), decks.size()};
}

DeckResult entry_of(const AuditedDeck& audited, const DeckListId& call) {
  DeckResult entry;
  entry.version = version_line("gapcheck");
  entry.call = call;
  entry.position = audited.position;
  entry.deck = audited.deck;
  entry.key = audited.key;
  entry.contacts = audited.asked.contacts;
  entry.parts = audited.asked.parts;
  entry.failed = audited.failed;
  entry.unread = audited.unread;
  if (audited.diagnostics != nullptr) {
    entry.diagnostics = audited.diagnostics->sorted();
    entry.diagnostics_left_out = audited.diagnostics->dropped();
  }
  if (audited.why != nullptr) entry.diagnostics.push_back(*audited.why);
  if (audited.report != nullptr) entry.report = report::archived(*audited.report);
  return entry;
}

Result<Report> report_of(const DeckResult& entry, const std::string& file) {
  auto report = report::unarchived(entry.report, consequence_of);
  if (!report)
    return Diagnostic{Severity::error, file, 0, "the result of " + entry.deck + " is damaged; audit the deck again"};
  return report;
}

void print_again(const DeckResult& entry, bool quiet) {
  print(entry.diagnostics, static_cast<std::size_t>(entry.diagnostics_left_out), quiet);
}

}  // namespace gapcheck::app
