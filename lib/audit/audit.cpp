#include "audit/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "audit/causes.hpp"
#include "audit/ids_in_files.hpp"
#include "audit/ignore_reviews.hpp"
#include "audit/members.hpp"
#include "audit/mesh/element_mesh.hpp"
#include "audit/mesh/elements_in_contact.hpp"
#include "audit/mesh/scene_mesh.hpp"
#include "audit/portability/portability.hpp"
#include "audit/rule_log.hpp"
#include "audit/run_rules.hpp"
#include "audit/shared_results.hpp"
#include "audit/unread_fields.hpp"
#include "contact/tie/record_tie.hpp"
#include "model/read/node_references.hpp"

namespace gapcheck::audit {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

ModelCounts counts(const model::Model& model) {
  ModelCounts c;
  c.nodes = model.mesh.nodes.size();
  c.shells = model.mesh.shells.size();
  c.solids = model.mesh.solids.size();
  c.beams = model.mesh.beams.size();
  c.thick_shells = model.mesh.thick_shells.size();
  c.discrete = model.mesh.discrete.size();
  c.masses = model.mesh.masses.size();
  c.particles = model.mesh.particles.size();
  c.parts = model.parts.size();
  c.contacts = model.contacts.size();
  return c;
}

/// Contacts as in the deck, if no rule asked for their initialisation.
std::vector<ContactSummary> contacts_alone(const model::Model& model) {
  std::vector<ContactSummary> list;
  for (const model::Contact& contact : model.contacts) {
    ContactSummary s;
    s.id = contact.id.value;
    s.order = contact.order;
    s.title = contact.title;
    s.keyword = contact.keyword;
    s.type = contact::classify(contact).printed();
    s.not_checked = "no selected rule asks for it";
    s.line = contact.place.line;
    list.push_back(std::move(s));
  }
  return list;
}

bool keep(const Penetration& p, const Selection& selection) {
  const AuditOptions& o = selection.options();
  if (!selection.wanted(p.kind)) return false;
  if (o.rtol >= 0 && !(p.remaining() < o.rtol)) return false;
  if (o.ratio >= 0 && !(p.depth > o.ratio * p.contact_distance)) return false;
  const auto chosen = [&](std::int64_t part) {
    return std::find(o.parts.begin(), o.parts.end(), part) != o.parts.end();
  };
  return o.parts.empty() || chosen(p.part) || chosen(p.element_part);
}

/// True if the selection keeps every penetration.
bool keeps_all(const Selection& selection) {
  const AuditOptions& o = selection.options();
  for (std::size_t kind = 0; kind < penetration_kinds; ++kind)
    if (!selection.wanted(static_cast<PenetrationKind>(kind))) return false;
  return o.rtol < 0 && o.ratio < 0 && o.parts.empty();
}

/// --part applies to findings that name a part; others concern no particular part.
bool keep(const Finding& f, const std::vector<std::int64_t>& parts) {
  if (parts.empty() || (f.part == 0 && f.element_part == 0)) return true;
  return std::any_of(parts.begin(), parts.end(), [&](std::int64_t id) { return id == f.part || id == f.element_part; });
}

/// Nodes that did not tie, or tied with a separation, as far as rules ask for them; by contact, reason, node.
std::vector<TieFailure> tie_failures(const contact::InitialState& initial, const Selection& selection) {
  std::vector<TieFailure> list;
  for (const contact::JudgedNode& judged : initial.judged)
    if (judged.reason && selection.wanted(*judged.reason) && selection.part_chosen(judged.part))
      list.push_back(contact::record_tie(judged, selection.model()));
  std::sort(list.begin(), list.end(), [](const TieFailure& a, const TieFailure& b) {
    return std::tie(a.contact, a.reason, a.node) < std::tie(b.contact, b.reason, b.node);
  });
  return list;
}

/// Findings that name a node get its position, by which they are recognised after renumbering.
void place_at_nodes(std::vector<Finding>& findings, const model::Nodes& nodes) {
  for (Finding& f : findings) {
    if (f.point || f.node == 0) continue;
    const auto node = nodes.lookup.find(f.node);
    if (node && nodes.x[*node].allFinite()) f.point = nodes.x[*node];
  }
}

void set_severities(const Severities& severities, Report& report) {
  report.severities = severities;
  for (std::vector<Finding>* findings : {&report.findings, &report.ignored.findings})
    for (Finding& f : *findings)
      if (const auto changed = severities.find(f.id); changed != severities.end()) f.severity = changed->second;
}

/// Numbers of a contact's block after the filters, so that totals and list agree. `found`: penetrations before them.
void recount(std::size_t found, Report& report) {
  for (ContactSummary& contact : report.contacts) contact.untied = 0;
  for (const TieFailure& failure : report.tie_failures)
    if (untied(failure.reason)) ++report.contacts[failure.contact].untied;
  const bool shortened = std::any_of(report.contacts.begin(), report.contacts.end(),
                                     [](const ContactSummary& contact) { return contact.reported_penetrations > 0; });
  if (found == report.penetrations.size() && !shortened) return;  // they were counted when they were found
  for (ContactSummary& contact : report.contacts) clear_counts(contact);
  for (const Penetration& p : report.penetrations) count(p, report.contacts[p.contact]);
}

/// "bucket grid 3, sorted sweep 1".
std::string searches_taken(const contact::SearchTally& tally) {
  std::string text;
  for (const contact::SearchKind kind : contact::all_searches)
    if (const std::uint64_t runs = tally.of(kind); runs > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", contact::make_search(kind)->name(), runs);
  return text;
}

void add_statistics(Report& report, const keyword::Deck& deck, const model::Model& model, SharedResults& results,
                    const RuleLog& log) {
  const auto add = [&](std::string name, std::uint64_t value) {
    report.statistics.emplace_back(std::move(name), fmt::format("{}", value));
  };
  add("files read", deck.counters().files);
  add("bytes read", deck.counters().bytes);
  add("bytes skipped unparsed", model.skipped_bytes);
  add("encrypted blocks skipped", deck.counters().encrypted_blocks);
  add("includes missing", deck.counters().missing_includes);
  if (deck.counters().shared_files > 0) add("files read before in this call", deck.counters().shared_files);
  const auto& c = results.counters();
  add("rules run", log.rules_run());
  add("rules that asked for no surface and no search", log.content_rules());
  add("contact surfaces built", c.surfaces_built + results.surface_store().built());
  add("contacts searched", c.contacts_searched);
  add("contacts culled by boxes", c.contacts_culled);
  add("searches", c.sweep.searches);
  add("searches culled by boxes", c.sweep.searches_culled);
  if (const std::string kinds = searches_taken(c.searches_by_kind); !kinds.empty())
    report.statistics.emplace_back("searches by", kinds);
  add("nodes culled by boxes", c.sweep.points_culled);
  add("segments culled by boxes", c.sweep.segments_culled);
  add("candidate pairs", c.sweep.candidate_pairs);
  if (c.edges > 0) add("edges", c.edges);
  add("decided by the filter", c.decisions.filter);
  add("decided by intervals", c.decisions.interval);
  add("decided exactly", c.decisions.exact);
  add("decided on the triangulation", c.decisions.triangulated);
  add("nodes tied", c.tied_nodes);
  add("penetrating pairs of tied nodes not reported", c.tied_pairs);
  add("penetrating pairs excluded by the deck", c.excluded_pairs);
  if (results.other_surfaces() > 0) {
    add("surfaces built with another thickness", results.other_surfaces());
    add("searches with another thickness", results.other_counters().sweep.searches);
    add("candidate pairs with another thickness", results.other_counters().sweep.candidate_pairs);
  }
  const auto& crossings = results.crossing_counters();
  add("element pairs with boxes that meet", crossings.box_pairs);
  add("triangle pairs decided by the filter", crossings.decisions.filter);
  add("triangle pairs decided exactly", crossings.decisions.exact);
  if (results.initialised())
    for (const std::string& note : results.initial().notes) report.statistics.emplace_back("note", note);
  for (const std::string& skip : log.skips()) report.statistics.emplace_back("not looked at", skip);
  for (const auto& [keyword, blocks] : model.skipped_keywords)
    report.statistics.emplace_back("keyword skipped: " + keyword, fmt::format("{}", blocks));
}

Diagnostic stopped() { return plain_error("the audit was stopped"); }

Result<Report> make_report(const std::string& input, const keyword::Deck& deck, const model::Model& model,
                           const AuditOptions& options, AuditSteps& steps, Diagnostics& diagnostics) {
  Report report;
  report.source = "deck";
  report.input = input;
  for (const model::Assumption& a : options.as_if) report.as_if.push_back(fmt::format("{}={:g}", a.field, a.value));
  for (const keyword::SourceFile& file : deck.files()) report.files.push_back(file.path);
  report.model = counts(model);
  const Selection selection(model, options);
  report.unknown_parts = selection.unknown_parts();
  SharedResults results(selection);
  RuleLog log;
  Context context(deck, selection, results, log);
  if (!run_rules(context, steps, log, report) || !steps.begin("records")) return stopped();
  std::size_t found = 0;
  if (selection.records_wanted() || results.initialised()) {
    contact::InitialState& initial = results.initial();
    report.contacts = std::move(initial.contacts);
    report.penetrations = std::move(initial.penetrations);
    found = report.penetrations.size();
    if (!keeps_all(selection))
      std::erase_if(report.penetrations, [&](const Penetration& p) { return !keep(p, selection); });
    report.tie_failures = tie_failures(initial, selection);
  } else {
    report.contacts = contacts_alone(model);
  }
  if (const std::size_t left_out = leave_out_follow_ups(deck, model, diagnostics, report); left_out > 0)
    diagnostics.add(
        {Severity::note, input, 0,
         fmt::format("{} findings about things with fields that could not be read are left out", left_out)});
  std::erase_if(report.findings, [&](const Finding& f) { return !keep(f, options.parts); });
  place_at_nodes(report.findings, model.mesh.nodes);
  link_causes(context, report);
  name_ids_in_files(deck, model, report.findings);
  const IgnoreOutcome ignores = leave_out_ignored(report, deck, options);
  const std::size_t reviews = report.findings.size();
  review_ignores(options, ignores, report);
  leave_out_reviews(report, reviews, options);
  set_severities(options.severities, report);
  if (results.initialised()) recount(found, report);
  for (std::size_t i = 0; i < report.contacts.size(); ++i)
    report.contacts[i].file = context.path(model.contacts[i].place.file);
  report.timing.surface_s = results.counters().surface_s + results.surface_store().seconds();
  report.timing.search_s = results.counters().search_s;
  add_statistics(report, deck, model, results, log);
  report.highest_set = highest_set(model.sets);
  if (options.portability) report.portability = find_portability(deck, model, selection.contacts());
  if (options.members) add_named_elements(model, report.findings);
  if (options.mesh) report.mesh = element_mesh(model, results.surface_store(), selection.contacts());
  if (options.scene) {
    const ElementsInContact in_contact(model, results.surface_store(), selection.contacts());
    report.scene = scene_mesh(model, report, {}, &in_contact);
  }
  return report;
}

/// `read`: gives the deck.
template <class Read>
Result<Report> audit(const Read& read, const std::string& input, const AuditOptions& options,
                     Diagnostics& diagnostics) {
  const auto start = Clock::now();
  AuditSteps steps(options.watch, selected_rules(options) + 3);  // read, model, records
  if (!steps.begin("read")) return stopped();
  Result<keyword::Deck> deck = read();
  if (!deck) return deck.error();
  if (!steps.begin("model")) return stopped();
  keyword::note_missing_end(deck.value(), diagnostics);
  const double read_s = since(start);
  const auto model_start = Clock::now();
  auto model = model::read_model(deck.value(), diagnostics);
  if (!model) return model.error();
  deck.value().drop_text(model::is_mesh);
  model::assume(options.as_if, model.value());
  const double model_s = since(model_start);
  Result<Report> report = make_report(input, deck.value(), model.value(), options, steps, diagnostics);
  if (!report) return report;
  Timing& timing = report.value().timing;
  timing.read_s = read_s;
  timing.model_s = model_s;
  timing.total_s = since(start);
  return report;
}

}  // namespace

Result<Report> audit_deck(const std::string& path, const AuditOptions& options, Diagnostics& diagnostics) {
  return audit([&] { return keyword::read_deck(path, options.read, diagnostics); }, path, options, diagnostics);
}

Result<Report> audit_with_moves(const std::string& path, const AuditOptions& options, std::vector<NodeMove> moves,
                                std::string said, Diagnostics& diagnostics) {
  auto report = audit_deck(path, options, diagnostics);
  if (!report) return report;
  report.value().moves = std::move(moves);
  std::ranges::sort(report.value().moves, {}, &NodeMove::node);
  report.value().said_of_moves = std::move(said);
  return report;
}

Result<Report> audit_text(std::string text, const std::string& name, const AuditOptions& options,
                          Diagnostics& diagnostics) {
  return audit([&] { return keyword::read_deck_text(std::move(text), name, options.read, diagnostics); }, name, options,
               diagnostics);
}

}  // namespace gapcheck::audit
