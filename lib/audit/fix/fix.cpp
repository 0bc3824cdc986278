#include "audit/fix/fix.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "audit/fix/left_crossings.hpp"
#include "audit/fix/mover.hpp"
#include "audit/fix/proposals.hpp"
#include "base/work_watch.hpp"

namespace gapcheck::audit {
namespace {

std::uint64_t separated(const Judgement& judgement) {
  const auto& judged = judgement.state.judged;
  return static_cast<std::uint64_t>(std::count_if(
      judged.begin(), judged.end(), [](const contact::JudgedNode& node) { return node.reason == TieReason::sep; }));
}

class Reporter {
 public:
  Reporter(model::Model& model, const std::vector<Vector>& deck, Mover& mover, FixReport& report)
      : model_(model), deck_(deck), mover_(mover), report_(report) {}

  void contacts() {
    for (const ContactIndex c : positions<ContactIndex>(model_.contacts.size())) {
      FixContact contact;
      contact.id = model_.contact(c).id.value;
      contact.keyword = model_.contact(c).keyword;
      contact.title = model_.contact(c).title;
      const auto not_checked = mover_.before().not_checked.find(c);
      if (not_checked != mover_.before().not_checked.end()) contact.not_checked = not_checked->second;
      contact.before = mover_.before().counts[c.value];
      contact.after = mover_.after().counts[c.value];
      contact.edges_before = mover_.before().edges[c.value];
      contact.edges_after = mover_.after().edges[c.value];
      contact.by_segments = contact::classify(model_.contact(c)).by_segments();
      report_.contacts.push_back(std::move(contact));
    }
  }

  void walls() {
    std::map<std::uint32_t, FixWall> found;
    const auto count = [](const WallHit& hit, FixContact::State& state) {
      ++state.penetrations;
      state.deepest = std::max(state.deepest, hit.depth);
    };
    for (const WallHit& hit : mover_.before().walls) count(hit, found[hit.wall].before);
    for (const WallHit& hit : mover_.after().walls) {
      FixWall& wall = found[hit.wall];
      count(hit, wall.after);
      const model::Nodes& all = model_.mesh.nodes;
      UnfixedNode& node = wall.unfixed.emplace_back();
      node.node = all.id[hit.node.value];
      node.depth = hit.depth;
      node.reason = mover_.reason(hit);
      node.file = all.origins.file(hit.node.value).value;
      node.line = all.line[hit.node.value];
    }
    for (auto& [position, wall] : found) {
      wall.id = model_.rigid_walls[position].id;
      wall.title = model_.rigid_walls[position].title;
      report_.walls.push_back(std::move(wall));
    }
  }

  void moved(const std::vector<NodeIndex>& nodes) {
    const model::Nodes& all = model_.mesh.nodes;
    for (const NodeIndex n : nodes) {
      MovedNode moved{
          all.id[n.value],  deck_[n.value], all.x[n.value], mover_.onto_tie(n), all.origins.file(n.value).value,
          all.line[n.value]};
      report_.largest_move = std::max(report_.largest_move, moved.distance());
      report_.total_move += moved.distance();
      report_.moved.push_back(moved);
    }
    std::sort(report_.moved.begin(), report_.moved.end(),
              [](const MovedNode& a, const MovedNode& b) { return a.node < b.node; });
  }

  void unfixed() {
    for (const Penetration& p : mover_.after().state.penetrations) {
      if (!to_be_fixed(p.kind)) continue;
      UnfixedNode node{p.contact,
                       p.node,
                       p.part,
                       p.element,
                       p.element_part,
                       p.depth,
                       p.contact_distance,
                       p.kind == PenetrationKind::released,
                       mover_.reason(p),
                       p.file,
                       p.line};
      report_.unfixed.push_back(node);
    }
  }

  void notes(const UnreadConstraints& unread) {
    if (mover_.cut_short())
      report_.notes.push_back(
          fmt::format("the search was ended after {} round{}: it took too much work, or gained too "
                      "little in each; {} nodes remain",
                      mover_.rounds(), mover_.rounds() == 1 ? "" : "s", report_.unfixed.size()));
    if (!unread.keywords.empty())
      report_.notes.push_back(fmt::format("nodes that *{} name are held", fmt::join(unread.keywords, ", *")));
    if (!unread.unknown.empty())
      report_.notes.push_back(
          fmt::format("what *{} hold is not known, and may have been moved", fmt::join(unread.unknown, ", *")));
    for (const auto& [why, nodes] : mover_.unwritable()) {
      const std::uint32_t n = nodes.first.value;
      const model::Nodes& all = model_.mesh.nodes;
      std::string note =
          fmt::format("{}:{}: node {} stays: {}", model_.files[all.origins.file(n).value], all.line[n], all.id[n], why);
      if (nodes.count > 1) note += fmt::format("; {} more such nodes", nodes.count - 1);
      report_.notes.push_back(std::move(note));
    }
    for (const std::string& note : mover_.before().state.notes) report_.notes.push_back(note);
    welds();
  }

 private:
  /// With --free-welds.
  void welds() {
    const auto move = [&](NodeIndex n) { return Vector(model_.mesh.nodes.x[n.value] - deck_[n.value]); };
    const double rounding = 1e-3 * report_.largest_move;
    const auto stretched = [&](const model::Weld& weld) {
      return std::any_of(weld.nodes.begin(), weld.nodes.end(),
                         [&](NodeIndex n) { return (move(n) - move(weld.nodes.front())).norm() > rounding; });
    };
    const auto count = std::count_if(model_.welds.begin(), model_.welds.end(), stretched);
    if (count > 0)
      report_.notes.push_back(fmt::format("{} spot welds have nodes that have moved against each other", count));
  }

  model::Model& model_;
  const std::vector<Vector>& deck_;
  Mover& mover_;
  FixReport& report_;
};

/// Entries of --lock and --priority that name nothing in the model.
Status check_choice(const model::Model& model, const FixOptions& options) {
  for (const Lock& lock : options.locks) {
    const auto part = model.part_of_id.lower_bound(lock.first);
    bool found = !lock.nodes && part != model.part_of_id.end() && part->first <= lock.last;
    if (lock.nodes)
      model.mesh.nodes.lookup.for_each_in(lock.first, lock.last,
                                          [&](std::int64_t, std::uint32_t) { return !(found = true); });
    if (!found)
      return plain_error(fmt::format("--lock {}{}: the deck has no such {}", lock.nodes ? "node:" : "", lock.first,
                                     lock.nodes ? "node" : "part"));
  }
  for (const auto& [part, factor] : options.priorities)
    if (!model.part_of_id.contains(part))
      return plain_error(fmt::format("--priority {}: the deck has no such part", part));
  return {};
}

/// The lines of the moved nodes, file by file.
std::vector<ChangedLines> edits(const model::Model& model, NodeLines& lines, const Mover& mover,
                                const std::vector<NodeIndex>& moved) {
  std::map<std::uint32_t, std::vector<keyword::LineEdit>> by_file;
  for (const NodeIndex n : moved)
    by_file[model.mesh.nodes.origins.file(n.value).value].push_back(lines.edit(n, mover.target(n)));
  std::vector<ChangedLines> files;
  for (auto& [file, list] : by_file) {
    std::sort(list.begin(), list.end(),
              [](const keyword::LineEdit& a, const keyword::LineEdit& b) { return a.line < b.line; });
    files.push_back({FileIndex{file}, std::move(list)});
  }
  return files;
}

/// Alternatives for the original deck.
std::vector<FixProposal> proposals(model::Model& model, std::vector<Vector> deck, const contact::InitialState& before) {
  std::swap(model.mesh.nodes.x, deck);
  std::vector<FixProposal> list = propose(model, before);
  std::swap(model.mesh.nodes.x, deck);
  return list;
}

}  // namespace

Result<Fix> fix_penetrations(const keyword::Deck& deck, const FixOptions& options, Diagnostics& diagnostics) {
  if (const Status status = check_geometry(deck); !status.ok()) return status.error();
  auto read = model::read_model(deck, diagnostics);
  if (!read) return read.error();
  model::Model& model = read.value();
  keyword::note_missing_end(deck, diagnostics);
  model::report_unknown_keywords(model, diagnostics);
  if (const Status status = check_choice(model, options); !status.ok()) return status.error();
  const std::vector<Vector> x = model.mesh.nodes.x;
  NodeLines lines(deck, model, x);
  ElementBounds bounds(model, x, options.limits);
  Fix fix;
  FixReport& report = fix.report;
  report.files = model.files;
  const UnreadConstraints unread = unread_constraints(deck, model);
  const model::Links links = model::read_links(deck, model, diagnostics);
  const Freedoms freedoms = find_freedoms(model, options.locks, options.priorities, unread.held,
                                          JoinedNodes(model, links.joined, !options.free_welds));
  const auto moved_by = [&](Mover::Crossings crossings) {
    model.mesh.nodes.x = x;
    auto one = std::make_unique<Mover>(model, lines, bounds, x, freedoms, links.hanging, options, crossings);
    one->run();
    return one;
  };
  // Shallow crossings part while nodes keep to their sides, and with less movement. Where that is not enough, the
  // better of two results counts.
  std::unique_ptr<Mover> chosen = moved_by(Mover::Crossings::stay);
  if (options.untangle && !options.recommended && chosen->crossings_after() > 0) {
    std::unique_ptr<Mover> untangled = moved_by(Mover::Crossings::untangle);
    const auto left = [](const Mover& one) { return std::pair(one.crossings_after(), one.after().penetrating); };
    if (untangled->has_untangled() && left(*untangled) < left(*chosen))
      chosen = std::move(untangled);
    else
      chosen->show();
  }
  if (work_stopped()) return plain_error("the correction was stopped");
  Mover& mover = *chosen;
  const std::vector<NodeIndex> moved = mover.moved();
  report.crossings_before = mover.crossings_before();
  report.crossings_after = mover.crossings_after();
  report.rounds = mover.rounds();
  report.cut_short = mover.cut_short();
  report.separated_ties_before = separated(mover.before());
  report.separated_ties_after = separated(mover.after());
  const ElementBounds::Change change = bounds.change(model.mesh.nodes.x, moved);
  report.elements_touched = change.touched;
  report.elements_worsened = change.worsened;
  if (options.proposals) report.proposals = proposals(model, x, mover.before().state);
  Reporter reporter(model, x, mover, report);
  reporter.contacts();
  reporter.walls();
  reporter.moved(moved);
  reporter.unfixed();
  if (report.crossings_after > 0)
    report.crossings = left_crossings(model, [&](NodeIndex n) { return mover.reason(n); });
  report.enclosed = enclosed_solids(model);
  reporter.notes(unread);
  fix.files = edits(model, lines, mover, moved);
  for (const ChangedLines& file : fix.files)
    report.changed.push_back({deck.file(file.file).path, "", file.edits.size()});
  return fix;
}

}  // namespace gapcheck::audit
