#include "solver/start/start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/work_watch.hpp"
#include "solver/loss/expected_contacts.hpp"
#include "solver/run.hpp"
#include "solver/start/start_contacts.hpp"
#include "solver/start/start_crossings.hpp"
#include "solver/start/start_elements.hpp"
#include "solver/start/start_moves.hpp"
#include "solver/supported.hpp"

namespace gapcheck::solver {
namespace {

/// Ends a run as soon as its first cycle is calculated.
class FirstCycle : public Run::Observer {
 public:
  SolverStatus observe(const Run& /*run*/, std::optional<RunEnd> /*end*/) override { return {}; }
};

StartRefusal refusal(const model::Model& model, const Failure& failure) {
  return {"", model.file(failure.place), failure.place.line, failure.message};
}

/// Builds the report from what is known about the start.
class StartReporter {
 public:
  StartReporter(const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& initial)
      : model_(model), surfaces_(surfaces), initial_(initial), contacts_(model, initial) {
    start_.x = initial.x;
    start_.report.notes = initial.notes;
  }

  [[nodiscard]] StartReport& report() { return start_.report; }

  /// What the run did in its first cycle. It may have failed there.
  void add_run(const Run& run, std::span<const ShotNode> shot) {
    start_.x = run.stepper().state().x;
    cycle_ = cycle_steps(shot);
    for (const ContactView& view : run.contacts()) {
      contacts_.add_first_cycle(view);
      start_.report.first_cycle = true;
    }
    if (!run.status().ok()) {
      start_.report.refused.push_back(refusal(model_, run.status().error()));
      return;
    }
    start_.report.first_cycle = true;
    start_.report.kinetic = run.stepper().energies().printed_kinetic;
    start_.report.first_step = run.stepper().next_step();
  }

  [[nodiscard]] Start finish() {
    if (work_stopped()) return std::move(start_);
    contacts_.add_others();
    std::vector<NodeStep> steps = initial_steps(model_, initial_);
    steps.insert(steps.end(), cycle_.begin(), cycle_.end());
    contacts_.add_moves(steps);
    list_moves(steps);
    StartReport& report = start_.report;
    report.contacts = contacts_.contacts();
    report.pairs = contacts_.pairs();
    report.nodes = contacts_.nodes();
    for (const StartContact& contact : report.contacts) report.energy += contact.energy;
    if (work_stopped()) return std::move(start_);
    list_elements();
    if (work_stopped()) return std::move(start_);
    if (report.moved > 0) report.crossings = created_crossings(model_, surfaces_, start_.x, mover_);
    return std::move(start_);
  }

 private:
  void list_moves(const std::vector<NodeStep>& steps) {
    StartReport& report = start_.report;
    const auto id_of = [&](PartIndex part) { return part == none<PartIndex> ? 0 : model_.part(part).id.value; };
    std::map<NodeIndex, std::vector<const NodeStep*>> by_node;
    for (const NodeStep& step : steps) {
      report.moves.push_back({step.contact.value, model_.mesh.nodes.id[step.node.value], id_of(step.part),
                              id_of(step.other_part), step.from, step.to, step.cause});
      if (step.way().norm() > rounding_at(step.from)) by_node[step.node].push_back(&step);
    }
    for (const auto& [node, list] : by_node) {
      const Vector& deck = model_.mesh.nodes.x[node.value];
      const double net = (start_.x[node.value] - deck).norm();
      mover_[node] = model_.contact(list.back()->contact).id.value;
      if (list.size() > 1) report.repeats.push_back(repeat(node, list, net));
      if (!(net > rounding_at(deck))) continue;
      moved_.push_back(node);
      report.largest_move = std::max(report.largest_move, net);
    }
    report.moved = moved_.size();
    std::ranges::sort(report.repeats, {}, &StartRepeat::node);
  }

  [[nodiscard]] StartRepeat repeat(NodeIndex node, const std::vector<const NodeStep*>& steps, double net) const {
    StartRepeat repeat;
    repeat.node = model_.mesh.nodes.id[node.value];
    repeat.net = net;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      repeat.contacts.push_back(steps[i]->contact.value);
      repeat.path += steps[i]->way().norm();
      for (std::size_t k = 0; k < i; ++k) repeat.back = repeat.back || steps[i]->way().dot(steps[k]->way()) < 0;
    }
    return repeat;
  }

  void list_elements() {
    StartElements elements(model_, start_.x);
    StartReport& report = start_.report;
    report.step_before = report.step_after = elements.smallest_step(model_.mesh.nodes.x);
    if (moved_.empty()) return;
    report.step_after = elements.smallest_step(start_.x);
    report.elements = elements.list_changed(moved_, mover_);
    report.shapes = elements.shapes_at(moved_);
    for (std::size_t c = 0; c < report.contacts.size(); ++c)
      report.contacts[c].shapes = elements.shapes_at(contacts_.moved_by_contact()[c]);
    for (std::size_t p = 0; p < report.pairs.size(); ++p)
      report.pairs[p].shapes = elements.shapes_at(contacts_.moved_by_pair()[p]);
  }

  const model::Model& model_;
  contact::SurfaceStore& surfaces_;
  const contact::InitialState& initial_;
  StartContacts contacts_;
  Start start_;
  std::vector<NodeStep> cycle_;
  std::vector<NodeIndex> moved_;             ///< visibly, from the deck to the start
  std::map<NodeIndex, std::int64_t> mover_;  ///< id of the contact that moved the node last
};

}  // namespace

Start follow_start(const keyword::Deck& deck, const model::Model& model, contact::SurfaceStore& surfaces,
                   Diagnostics& diagnostics) {
  std::vector<StartRefusal> refused;
  for (const Unsupported& one : unsupported(deck, model)) refused.push_back({one.keyword, one.file, one.line, one.why});
  std::vector<ShotNode> shot;
  RunSettings settings;
  settings.cycles = 1;
  settings.relax = false;
  settings.shot = &shot;
  settings.stop = [] { return true; };
  auto run = Run::prepare(model, surfaces, settings, diagnostics);
  std::optional<contact::InitialState> alone;
  if (!run) {
    refused.push_back(refusal(model, run.error()));
    contact::InitialCounters counters;
    alone = contact::initialise_contacts(model, surfaces, {}, counters);
  }
  StartReporter reporter(model, surfaces, run ? run.value().initial() : *alone);
  reporter.report().refused = std::move(refused);
  if (run && !work_stopped()) {
    FirstCycle observer;
    std::optional<StartMotion> motion;
    if (may_move(model)) motion.emplace(run.value().stepper().state());
    run.value().go(observer);
    reporter.add_run(run.value(), shot);
    if (motion && run.value().status().ok() && !work_stopped())
      reporter.report().expected = expect_contacts(run.value(), *motion);
  }
  return reporter.finish();
}

ShownMoves shown_moves(const model::Nodes& nodes, const Start& start) {
  ShownMoves shown;
  double largest = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (start.x[n] == nodes.x[n] || !start.x[n].allFinite()) continue;
    shown.moves.push_back({nodes.id[n], start.x[n]});
    largest = std::max(largest, (start.x[n] - nodes.x[n]).norm());
  }
  shown.said = fmt::format("{} node{} moved before the first cycle, by at most {:.6g}", shown.moves.size(),
                           shown.moves.size() == 1 ? " is" : "s are", largest);
  return shown;
}

}  // namespace gapcheck::solver
