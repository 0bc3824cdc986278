#include <fmt/format.h>

#include "audit/rules.hpp"
#include "audit/shared_results.hpp"
#include "contact/surface/erosion.hpp"

namespace gapcheck::audit::rule::eroding_timestep {
namespace {

/// The smallest step of the contact's sides; no_timestep_limit without any.
double step_of(const Timesteps& steps, ContactIndex contact) {
  double least = no_timestep_limit;
  for (const SurfaceTimestep& step : steps.surface_timesteps)
    if (step.contact == contact.value) least = std::min(least, step.timestep);
  return least;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Controls& controls = context.model().controls;
  if (controls.ecdt != 0) return;
  for (const ContactIndex i : context.contacts()) {
    const model::Contact& contact = context.model().contact(i);
    if ((contact.soft != 0 && contact.soft != 1) || !contact::is_eroding(contact::classify(contact))) continue;
    const auto& predicted = context.results().timesteps();
    const double step = step_of(predicted.timesteps, i);
    std::string message =
        "ECDT of *CONTROL_CONTACT is not set, so this eroding contact may set the time step of the run";
    if (step < predicted.run) message += fmt::format(": about {:.3E} instead of {:.3E}", step, predicted.run);
    report.findings.push_back(
        finding_at(rule, context, contact, message + "; set ECDT = 1, or lower SFS and SFM where that is too small"));
  }
}

}  // namespace

const Rule definition{{"GC419", "eroding-timestep", Severity::warning,
                       "an eroding contact may set the time step of the run, because ECDT is not set", Need::time_steps,
                       "The run may become slow: the contact sets the time step"},
                      run};

}  // namespace gapcheck::audit::rule::eroding_timestep
