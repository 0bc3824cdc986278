#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audit/rules.hpp"
#include "audit/run_context.hpp"

namespace gapcheck::audit::rule::contact_step {
namespace {

/// Rounding of four printed digits.
constexpr double printing = 1e-3;
/// Beyond this many times the smallest element step a run is implicit, whatever its mass scaling.
constexpr double implicit_factor = 100;

/// The surface with the smallest step; nullptr: the log names none.
const SurfaceTimestep* controlling(const RunContext& context) {
  const SurfaceTimestep* least = nullptr;
  for (const SurfaceTimestep& step : context.log().surface_timesteps)
    if (step.timestep > 0 && (least == nullptr || step.timestep < least->timestep)) least = &step;
  return least;
}

void judge(const RuleIdentity& rule, RunContext& context, Report& report) {
  const auto& states = context.files().glstat;
  if (states.empty()) return context.skipped(rule, "there is no glstat");
  const double limit = context.log().contact_timestep;
  if (!(limit > 0)) return context.skipped(rule, "the log names no time step that should not be exceeded");
  const auto exceeds = [&](const auto& state) { return state.time_step > limit * (1 + printing); };
  const auto first = std::find_if(states.begin(), states.end(), exceeds);
  if (first == states.end()) return;
  const auto largest = std::max_element(first, states.end(), [](const auto& a, const auto& b) {
    return !std::isfinite(a.time_step) || a.time_step < b.time_step;
  });
  const double elements = context.log().element_timestep;
  if (elements > 0 && largest->time_step > implicit_factor * elements)
    return context.skipped(rule, "steps of this size are implicit");
  const SurfaceTimestep* side = controlling(context);
  std::string who;
  if (side != nullptr && side->node != 0) who = fmt::format(" (surface {}, node {})", side->side, side->node);
  Finding f = context.finding(
      rule, "glstat", rule.severity,
      fmt::format(
          "the time step is up to {:.4g}, {:.3g} times the {:.4g} that the solver says should not be exceeded{}",
          largest->time_step, largest->time_step / limit, limit, who));
  if (side != nullptr) {
    f.node = side->node;
    f.part = side->part;
    if (side->contact < context.contacts().size()) f.contact = context.contacts()[side->contact].id;
  }
  report.findings.push_back(std::move(f));
}

}  // namespace

const Rule definition{
    {"GC605", "contact-step", Severity::note, "the run's time step exceeds what the solver names for the contacts",
     Need::run_files, "The contact may have been unstable"},
    nullptr,
    judge};

}  // namespace gapcheck::audit::rule::contact_step
