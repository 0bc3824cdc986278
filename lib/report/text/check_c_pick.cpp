#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "base/ids.hpp"
#include "report/text/check_c_view.hpp"

namespace gapcheck::report {
namespace {

constexpr std::array<std::string_view, 20> selections{
    "tied",     "sep",     "offset",  "far",      "short",
    "notfound", "rigslav", "rigmast", "conflict", "untied",  // tied contacts
    "typ13",    "pen",     "mid",     "del",      "below",   // standard ones
    "soft2",    "inter",   "war",     "first",    "last",    // SOFT = 2
};

/// The name of element intersections in contacts with SOFT = 2 in the table of message kinds.
constexpr std::string_view intersection = "soft2-intersection";

/// Nodes too deep for contact are one kind of record; the words mid, del and below all pick it.
bool selects(std::string_view sel, const Penetration& record) {
  if (sel.empty() || sel == "typ13") return true;
  if (sel == "pen") return record.kind == PenetrationKind::initial;
  return (sel == "mid" || sel == "del" || sel == "below") && record.kind == PenetrationKind::released;
}

bool selects(std::string_view sel, const TieFailure& failure) {
  if (sel.empty() || sel == "tied") return true;
  return sel == "untied" ? untied(failure.reason) : sel == name(failure.reason);
}

bool selects(std::string_view sel, const SolverMessage& message) {
  if (sel.empty()) return true;
  if (sel == "soft2" || sel == "war") return message.kind.starts_with("soft2");
  return (sel == "inter" || sel == "first" || sel == "last") && message.kind == intersection;
}

bool picks(const Report& report, const CheckCOptions& options, const Penetration& record) {
  if (!selects(options.sel, record)) return false;
  if (options.ptol > 0 && record.depth > 0 && record.depth <= options.ptol) return false;
  return options.rtol < 0 || !knows_remaining(report, record) || record.remaining() < options.rtol;
}

bool picks(const CheckCOptions& options, const TieFailure& failure) {
  if (!selects(options.sel, failure)) return false;
  return options.ptol <= 0 || failure.distance < 0 || failure.distance > options.ptol;
}

/// Leaves only the contacts of -sid; returns the new position of each old one.
std::vector<std::uint32_t> keep_contacts(Report& report, const CheckCOptions& options) {
  std::vector<std::uint32_t> place(report.contacts.size(), no_position);
  std::vector<ContactSummary> kept;
  for (std::size_t i = 0; i < report.contacts.size(); ++i) {
    const auto& sid = options.sid;
    if (!sid.empty() && std::find(sid.begin(), sid.end(), report.contacts[i].id) == sid.end()) continue;
    place[i] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(std::move(report.contacts[i]));
  }
  report.contacts = std::move(kept);
  return place;
}

/// Erases the records of dropped contacts, and of contacts that do not exist, and renumbers the rest.
template <class Records>
void renumber(Records& records, const std::vector<std::uint32_t>& place) {
  const auto gone = [&](const auto& r) { return r.contact >= place.size() || place[r.contact] == no_position; };
  std::erase_if(records, gone);
  for (auto& record : records) record.contact = place[record.contact];
}

void keep_messages(SolverRun& run, const CheckCOptions& options) {
  std::erase_if(run.messages, [&](const SolverMessage& message) { return !selects(options.sel, message); });
  if (run.messages.empty() || (options.sel != "first" && options.sel != "last")) return;
  const auto earlier = [](const SolverMessage& a, const SolverMessage& b) {
    return std::pair(a.file, a.line) < std::pair(b.file, b.line);
  };
  const auto [first, last] = std::minmax_element(run.messages.begin(), run.messages.end(), earlier);
  run.messages = {options.sel == "first" ? *first : *last};
}

/// Counts of the contacts as they follow from the records.
void recount(Report& report) {
  for (ContactSummary& contact : report.contacts) {
    clear_counts(contact);
    contact.untied = 0;
  }
  for (const Penetration& record : report.penetrations) count(record, report.contacts[record.contact]);
  for (const TieFailure& failure : report.tie_failures)
    if (untied(failure.reason)) ++report.contacts[failure.contact].untied;
}

}  // namespace

bool known_selection(const std::string& sel) {
  return std::find(selections.begin(), selections.end(), sel) != selections.end();
}

std::uint64_t unlisted_penetrations(const ContactSummary& contact) {
  const std::uint64_t listed = contact.penetrations + contact.released;
  return contact.reported_penetrations > listed ? contact.reported_penetrations - listed : 0;
}

std::string summary_line(const ContactSummary& contact) {
  if (!contact.initial_summary) return "";
  const InitialSummary& said = *contact.initial_summary;
  std::string line = fmt::format("the solver's summary: {} penetrating node{}", said.nodes, said.nodes == 1 ? "" : "s");
  if (said.nodes + said.eliminated > 0) line += fmt::format(", {:.4g} to {:.4g}", said.least, said.greatest);
  if (said.eliminated > 0) line += fmt::format(", {} eliminated", said.eliminated);
  const std::uint64_t listed = contact.penetrations + contact.released;
  if (listed > 0 && listed < said.nodes) line += fmt::format("; {} listed: the file is cut", listed);
  return line;
}

bool knows_remaining(const Report& report, const Penetration& record) {
  return report.source == "deck" || record.contact_distance != 0;
}

Report pick(Report picked, const CheckCOptions& options) {
  const std::vector<std::uint32_t> place = keep_contacts(picked, options);
  renumber(picked.penetrations, place);
  renumber(picked.tie_failures, place);
  // No tolerance can pick unlisted records: the counts beyond the lists are kept unchanged.
  for (ContactSummary& contact : picked.contacts) {
    const bool counted = options.sel.empty() || options.sel == "typ13" || options.sel == "pen";
    contact.reported_penetrations = counted ? unlisted_penetrations(contact) : 0;
  }
  std::erase_if(picked.penetrations, [&](const Penetration& p) { return !picks(picked, options, p); });
  std::erase_if(picked.tie_failures, [&](const TieFailure& t) { return !picks(options, t); });
  recount(picked);
  for (ContactSummary& contact : picked.contacts)
    if (contact.reported_penetrations > 0) contact.reported_penetrations += contact.penetrations + contact.released;
  if (!picked.run) return picked;
  renumber(picked.run->surface_timesteps, place);
  if (!options.sid.empty() || !options.sel.empty()) picked.run->rigidwalls.clear();
  std::erase_if(picked.run->rigidwalls,
                [&](const auto& wall) { return options.ptol > 0 && wall.depth <= options.ptol; });
  keep_messages(*picked.run, options);
  return picked;
}

std::uint64_t warning_count(const Report& report) {
  std::uint64_t count = report.penetrations.size() + report.tie_failures.size();
  for (const ContactSummary& contact : report.contacts) count += unlisted_penetrations(contact);
  return count + run_warnings(report);
}

std::uint64_t run_warnings(const Report& report) {
  if (!report.run) return 0;
  std::uint64_t count = report.run->rigidwalls.size();
  for (const SolverMessage& message : report.run->messages)
    if (message.kind == intersection) count += message.count;
  return count;
}

}  // namespace gapcheck::report
