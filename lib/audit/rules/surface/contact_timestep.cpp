#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "audit/shared/element_text.hpp"
#include "audit/shared_results.hpp"

namespace gapcheck::audit::rule::contact_timestep {
namespace {

/// "3.4E-07 (0.9 of shell 77)".
std::string step_of_run(const model::Model& model, const contact::PredictedTimesteps& steps) {
  const bool scaled = std::abs(model.controls.dt2ms) > steps.element.timestep;
  return fmt::format(
      "{:.3E} ({:.6g} of {})", steps.run, model.controls.tssfac,
      scaled ? std::string("DT2MS") : element_text(model.mesh, {steps.element.kind, steps.element.element}));
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const contact::PredictedTimesteps& steps = context.results().timesteps();
  const model::Model& model = context.model();
  report.predicted = steps.timesteps;
  if (!(steps.run > 0)) context.skipped(rule, "no element has a time step to compare with");
  std::vector<Found> found;
  for (std::uint64_t i = 0; i < steps.unstable.size(); ++i) {
    const SurfaceTimestep& side = steps.timesteps.surface_timesteps[steps.unstable[i].surface];
    const PartIndex part = steps.unstable[i].limit.part;
    const bool solver_cares = side.type.starts_with('1') && side.type.size() == 2 && side.type >= "14" &&
                              side.type <= "16" && model.controls.ecdt == 0;
    if (!solver_cares && context.part_chosen(part))
      found.push_back(
          {0,
           rough_weight(steps.run / steps.unstable[i].limit.timestep),
           i,
           {model.contacts[side.contact].id.value, model.mesh.nodes.id[steps.unstable[i].limit.node.value]}});
  }
  const auto words = [&](const Found& f) {
    const contact::UnstableSide& unstable = steps.unstable[f.item];
    const SurfaceTimestep& side = steps.timesteps.surface_timesteps[unstable.surface];
    const std::uint32_t node = unstable.limit.node.value;
    Finding finding = finding_at(
        rule, context, model.contacts[side.contact],
        fmt::format(
            "side {}: contact springs are stable below a step of {:.3E} (node {}{}), but the run's step is {}; scale "
            "SF{} by {:.2g} or lower TSSFAC (the solver will print {:.3E})",
            side.side, unstable.limit.timestep, model.mesh.nodes.id[node],
            unstable.alone ? "" : " against nodes as light", step_of_run(model, steps), side.side == 'A' ? 'S' : 'M',
            1 / (f.weight * f.weight), side.timestep));
    if (!unstable.alone) finding.severity = Severity::note;
    finding.node = model.mesh.nodes.id[node];
    finding.part = model.part(unstable.limit.part).id.value;
    finding.point = model.mesh.nodes.x[node];
    return finding;
  };
  const auto rest = [&](const Found&, std::uint64_t count) {
    return finding(rule, fmt::format("{} more sides of contacts whose springs are unstable at the run's step", count),
                   "", 0);
  };
  add_grouped(report, std::move(found), words, rest);
}

}  // namespace

const Rule definition{{"GC420", "contact-timestep", Severity::warning,
                       "contact springs are unstable at the time step that the elements allow", Need::time_steps,
                       "The contact becomes unstable: nodes shoot away"},
                      run};

}  // namespace gapcheck::audit::rule::contact_timestep
