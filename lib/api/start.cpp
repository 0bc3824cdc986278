#include "solver/start/start.hpp"

#include <gapcheck/start.hpp>
#include <gapcheck/version.hpp>
#include <utility>

#include "api/convert.hpp"
#include "api/start_store.hpp"
#include "api/watched.hpp"
#include "audit/audit.hpp"
#include "report/export/finding_grid.hpp"
#include "report/format/start_report.hpp"
#include "report/html/html.hpp"

namespace gapcheck::api {
namespace {

void take_counts(const gapcheck::StartCounts& from, StartCounts& to) {
  to.moved = from.moved;
  to.largest_move = from.largest_move;
  to.total_move = from.total_move;
  to.histogram = from.histogram;
  to.kept = from.kept;
  to.deepest_kept = from.deepest_kept;
  to.least_share = from.least_share;
  to.forced = from.forced;
  to.deepest_forced = from.deepest_forced;
  to.energy = from.energy;
  to.released = from.released;
  to.way_out = from.way_out;
  to.to_release = from.to_release;
  to.touched = from.shapes.touched;
  to.changed = from.shapes.changed;
  to.collapsed = from.shapes.collapsed;
}

StartContact start_contact(const gapcheck::StartContact& from) {
  StartContact contact;
  take_counts(from, contact);
  contact.id = from.id;
  contact.title = from.title;
  contact.keyword = from.keyword;
  contact.score = score(from);
  contact.not_known = from.not_known;
  contact.no_energy = from.no_energy;
  return contact;
}

StartPair start_pair(const gapcheck::StartPair& from) {
  StartPair pair;
  take_counts(from, pair);
  pair.contact = from.contact;
  pair.part = from.part;
  pair.other_part = from.other_part;
  return pair;
}

StartElement start_element(const gapcheck::StartElement& from) {
  const auto shape = [](const gapcheck::StartElement::Shape& s) {
    return StartElement::Shape{s.edge_ratio, s.warp, s.size, s.step};
  };
  return {from.kind, from.id, from.part, from.contact, shape(from.before), shape(from.after), from.inverted, from.flat};
}

StartCrossing start_crossing(const gapcheck::StartCrossing& from) {
  return {from.a.kind, from.b.kind,  from.a.id,     from.a.part, from.b.id,
          from.b.part, from.contact, from.moved_by, from.depth};
}

ExpectedContact expected_contact(const gapcheck::ExpectedContact& from) {
  ExpectedContact to;
  to.contact = from.contact;
  to.part = from.part;
  to.other_part = from.other_part;
  to.nodes = from.nodes;
  to.node = from.node;
  to.time = from.time;
  to.speed = from.speed;
  to.in_step = from.in_step;
  to.crossing = from.crossing;
  to.margin = from.margin;
  to.alone = from.alone;
  to.low = from.low;
  to.high = from.high;
  to.reason = from.reason;
  to.lost = from.lost();
  to.held = from.held();
  to.never_released = from.never_released;
  return to;
}

ExpectedContacts expected_contacts(const gapcheck::ExpectedContacts& from) {
  ExpectedContacts to{from.until, from.end, from.step, {}, {}, from.not_looked_at};
  for (const gapcheck::ExpectedContact& each : from.contacts) to.contacts.push_back(expected_contact(each));
  for (const gapcheck::ExpectedWall& each : from.walls)
    to.walls.push_back({each.wall, each.part, each.nodes, each.node, each.time, each.speed});
  return to;
}

void take_lists(const StartReport& from, Start& to) {
  for (const gapcheck::StartContact& each : from.contacts) to.contacts.push_back(start_contact(each));
  for (const gapcheck::StartPair& each : from.pairs) to.pairs.push_back(start_pair(each));
  for (const gapcheck::StartRepeat& each : from.repeats)
    to.repeats.push_back({each.node, each.contacts, each.path, each.net, each.back});
  for (const gapcheck::StartElement& each : from.elements) to.elements.push_back(start_element(each));
  for (const gapcheck::StartCrossing& each : from.crossings) to.crossings.push_back(start_crossing(each));
  for (const gapcheck::StartRefusal& each : from.refused)
    to.refused.push_back({each.keyword, each.file, each.line, each.why});
  if (from.expected) to.expected = expected_contacts(*from.expected);
  to.notes = from.notes;
}

Start public_start(std::shared_ptr<const StartStore> store) {
  const StartReport& from = store->report;
  Start start;
  start.input = from.input;
  start.clean = starts_clean(from);
  take_lists(from, start);
  start.moves = store->moves.view();
  start.nodes = store->nodes.view();
  start.positions = store->positions();
  start.moved = from.moved;
  start.largest_move = from.largest_move;
  start.energy = from.energy;
  start.touched = from.shapes.touched;
  start.changed = from.shapes.changed;
  start.collapsed = from.shapes.collapsed;
  start.kinetic = from.kinetic;
  start.first_step = from.first_step;
  start.step_before = from.step_before;
  start.step_after = from.step_after;
  start.first_cycle = from.first_cycle;
  start.store = std::move(store);
  return start;
}

/// Audits the deck for the pictures of its start.
Status add_audit(const std::string& path, const StartOptions& options, solver::ShownMoves shown, StartStore& store) {
  audit::AuditOptions settings;
  settings.read = read_options(options.includes);
  settings.scene = store.picture = options.picture;
  settings.mesh = store.mesh = options.mesh;
  settings.watch = [](const audit::AuditStep&) { return !work_stopped(); };
  gapcheck::Diagnostics repeated;  // the deck was read before
  auto report = audit::audit_with_moves(path, settings, std::move(shown.moves), std::move(shown.said), repeated);
  if (!report) return report.error();
  store.audited = std::move(report).value();
  return {};
}

Result<Start> followed(const std::string& path, const StartOptions& options) {
  gapcheck::Diagnostics diagnostics;
  const auto deck = keyword::read_deck(path, read_options(options.includes), diagnostics);
  if (!deck) return error_of(deck.error(), diagnostics);
  const auto model = model::read_model(deck.value(), diagnostics);
  if (!model) return error_of(model.error(), diagnostics);
  if (diagnostics.has_errors()) return first_error(diagnostics);
  keyword::note_missing_end(deck.value(), diagnostics);
  if (work_stopped()) return plain_error("");  // watched() says why
  contact::SurfaceStore surfaces(model.value());
  solver::Start start = solver::follow_start(deck.value(), model.value(), surfaces, diagnostics);
  start.report.input = path;
  solver::ShownMoves shown = solver::shown_moves(model.value().mesh.nodes, start);
  const auto store = std::make_shared<StartStore>(std::move(start), model.value().mesh.nodes);
  if (options.picture || options.mesh)
    if (const Status audited = add_audit(path, options, std::move(shown), *store); !audited.ok())
      return error_of(audited.error(), diagnostics);
  Start result = public_start(store);
  for (const keyword::SourceFile& file : deck.value().files()) result.files.push_back(file.path);
  result.diagnostics = listed(diagnostics);
  return result;
}

const StartReport& report_in(const Start& start) {
  static const StartReport none;
  return start.store ? start.store->report : none;
}

}  // namespace

std::string_view name(StartCause cause) { return gapcheck::name(static_cast<gapcheck::StartCause>(cause)); }

Result<Start> start_deck(const std::string& path, const StartOptions& options) {
  const Jobs jobs(options.jobs);
  return watched(options.watch, "following the start was stopped", [&] { return followed(path, options); });
}

std::string text(const Start& start, std::size_t top) { return report::start_text(report_in(start), {.top = top}); }

std::string json(const Start& start) { return report::start_json(report_in(start)); }

std::string html(const Start& start) {
  if (!start.store || !start.store->picture) return "";
  report::HtmlOptions page;
  page.version = version();
  return report::html(start.store->audited, {}, page);
}

std::string vtu(const Start& start) {
  return start.store && start.store->mesh ? report::vtu(report::finding_grid(start.store->audited, {})) : "";
}

}  // namespace gapcheck::api
