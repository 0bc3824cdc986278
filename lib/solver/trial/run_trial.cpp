#include "solver/trial/run_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/output/state_balance.hpp"
#include "solver/run.hpp"
#include "solver/start/start.hpp"
#include "solver/supported.hpp"

namespace gapcheck::solver {
namespace {

const char* end_in_words(RunEnd end) {
  switch (end) {
    case RunEnd::time:
      return "end time";
    case RunEnd::cycles:
      return "cycles";
    case RunEnd::energy:
      return "change of energy (ENDENG)";
    case RunEnd::step:
      return "smallest step (DTMIN)";
    case RunEnd::stopped:
    case RunEnd::signal:
      return "stopped";
    case RunEnd::failed:
      break;
  }
  return "failed";
}

/// The largest force of contact on one node.
double largest_node_force(const Run& run) {
  double largest = 0;
  for (const ContactView& view : run.contacts())
    for (const ContactNode& node : view.nodes())
      if (node.kind == ContactNode::Kind::touching) largest = std::max(largest, node.force.norm());
  return largest;
}

/// Follows the energy and takes the forces of the first cycle.
class TrialObserver : public Run::Observer {
 public:
  explicit TrialObserver(RunTrial& trial) : trial_(trial) {}
  SolverStatus observe(const Run& run, std::optional<RunEnd> /*end*/) override {
    if (std::exchange(first_, false)) trial_.largest_force = largest_node_force(run);
    const Energies& energies = run.stepper().energies();
    trial_.supplied = energies.printed_initial + energies.external;
    trial_.largest_kinetic = std::max(trial_.largest_kinetic, energies.printed_kinetic);
    trial_.least_sliding = std::min(trial_.least_sliding, energies.absorbed.sliding());
    return {};
  }

 private:
  RunTrial& trial_;
  bool first_ = true;
};

/// What the run has reached.
void add_end(const Run& run, RunEnd end, std::span<const ShotNode> shot, RunTrial& trial) {
  const State& state = run.stepper().state();
  trial.ran = true;
  trial.failed = end == RunEnd::failed;
  trial.end = end_in_words(end);
  if (!run.status().ok()) trial.end += ": " + run.status().error().message;
  trial.time = state.time;
  trial.cycles = state.cycle;
  trial.created = state_balance(run).created();
  const auto at_start = std::count_if(trial.start.moves.begin(), trial.start.moves.end(),
                                      [](const StartMove& move) { return move.cause == StartCause::first_cycle; });
  trial.shot = shot.size() - std::min(shot.size(), static_cast<std::size_t>(at_start));
  for (const ContactView& view : run.contacts()) trial.released += view.state().released;
}

RunTrial tried(const keyword::Deck& deck, const model::Model& model, const TrialSettings& settings,
               Diagnostics& diagnostics) {
  contact::SurfaceStore surfaces(model);
  return try_run(deck, model, surfaces, settings, diagnostics);
}

}  // namespace

RunTrial try_run(const keyword::Deck& deck, const model::Model& model, contact::SurfaceStore& surfaces,
                 const TrialSettings& settings, Diagnostics& diagnostics) {
  RunTrial trial;
  trial.start = follow_start(deck, model, surfaces, diagnostics).report;
  if (!unsupported(deck, model).empty() && !settings.leave_out) return trial;
  std::vector<ShotNode> shot;
  RunSettings run_settings;
  run_settings.until = settings.until;
  run_settings.cycles = settings.cycles;
  run_settings.shot = &shot;
  Diagnostics repeated;
  auto run = Run::prepare(model, surfaces, run_settings, repeated);
  if (!run) return trial;
  TrialObserver observer(trial);
  const RunEnd end = run.value().go(observer);
  add_end(run.value(), end, shot, trial);
  return trial;
}

FixProof prove_fix(const keyword::Deck& deck, model::Model& model, std::span<const MovedNode> moved,
                   const TrialSettings& settings, Diagnostics& diagnostics) {
  FixProof proof{settings.until, settings.cycles, tried(deck, model, settings, diagnostics), {}};
  model::Nodes& nodes = model.mesh.nodes;
  for (const MovedNode& node : moved)
    if (const auto at = nodes.lookup.find(node.node)) nodes.x[*at] = node.to;
  Diagnostics repeated;
  proof.after = tried(deck, model, settings, repeated);
  return proof;
}

FixProof prove_repair(const keyword::Deck& before, const model::Model& model_before, const keyword::Deck& after,
                      const model::Model& model_after, const TrialSettings& settings, Diagnostics& diagnostics) {
  FixProof proof{settings.until, settings.cycles, tried(before, model_before, settings, diagnostics), {}};
  Diagnostics repeated;
  proof.after = tried(after, model_after, settings, repeated);
  return proof;
}

}  // namespace gapcheck::solver
