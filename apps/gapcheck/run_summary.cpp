#include "run_summary.hpp"

#include <fmt/format.h>

#include <cmath>

#include "run_progress.hpp"
#include "solver/output/state_balance.hpp"

namespace gapcheck::app {
namespace {

const char* words(solver::RunEnd end) {
  switch (end) {
    case solver::RunEnd::time:
      return "Normal end";
    case solver::RunEnd::cycles:
      return "Ended after the cycles asked for";
    case solver::RunEnd::energy:
      return "Ended by the change of energy that ENDENG allows";
    case solver::RunEnd::step:
      return "Ended by the smallest step that DTMIN allows";
    case solver::RunEnd::stopped:
      return "Stopped on request";
    case solver::RunEnd::signal:
      return "Terminated by a signal";
    case solver::RunEnd::failed:
      break;
  }
  return "Ended with an error";
}

/// How the phase before the run ended.
std::string relaxation_line(const solver::Run& run) {
  if (!run.relaxed()) return "";
  const auto& [cycles, time, ratio, converged, unfinished] = *run.relaxed();
  std::string text =
      fmt::format("Dynamic relaxation {} at time {:g}, cycle {}: kinetic energy {:.3g} of its greatest.\n",
                  converged ? "converged" : "ended by DRTERM", time, cycles, ratio);
  if (unfinished != 0)
    text +=
        fmt::format("Curve {} (SIDR = 1) still changes after that; let it rise faster, or lower DRTOL.\n", unfinished);
  return text + "\n";
}

std::string row(const char* label, double value) { return fmt::format("  {:<24}{:>14.5g}\n", label, value); }

std::string contact_rows(const solver::Run& run) {
  const std::vector<solver::ContactView> contacts = run.contacts();
  if (contacts.empty()) return "";
  std::string text = fmt::format("\n  {:>10} {:>9} {:>9} {:>9} {:>12} {:>12} {:>12}\n", "contact", "touching",
                                 "released", "moved", "energy A", "energy B", "friction");
  for (const solver::ContactView& contact : contacts) {
    const solver::ContactState& c = contact.state();
    text += fmt::format("  {:>10} {:>9} {:>9} {:>9} {:>12.4g} {:>12.4g} {:>12.4g}\n",
                        run.model().contact(c.contact).id.value, c.touching, c.released, c.moved, c.energy_a,
                        c.energy_b, c.friction);
  }
  if (run.contact_counters().crowded > 0)
    text +=
        "  Some contacts are so thick that their nodes were compared to the nearest segments only; gapcheck audit "
        "names them.\n";
  return text;
}

/// The cross-sections with a preload.
std::string section_rows(const solver::Run& run) {
  const solver::SolidElements& solids = run.stepper().structure().solids;
  std::string text;
  for (std::size_t i = 0; i < solids.sections().size(); ++i) {
    const solver::SectionStress& section = solids.sections()[i];
    text += fmt::format("  section {}: preload {:g} until time {:g}, carries {:.5g} now\n", section.id,
                        section.curve.at(section.end), section.end, solids.section_force(i));
  }
  return text.empty() ? "" : "\n" + text;
}

/// Whose energy by its state is not the work that it took.
std::string fault_lines(const solver::StateBalance& balance) {
  std::string text;
  for (const solver::HeldEnergy& held : balance.faults())
    text += fmt::format("  {} {} {:.4g}, {:.1f} % of the largest energy: work {:.4g}, state {:.4g}\n", name(held),
                        held.created() > 0 ? "created" : "lost", std::abs(held.created()),
                        100 * std::abs(held.created()) / balance.largest, held.work, held.state);
  for (const solver::HeldEnergy& held : balance.held)
    if (!held.covered) text += fmt::format("  {} has no energy of its state; its work is taken\n", name(held));
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

std::string run_summary(const solver::Run& run, solver::RunEnd end) {
  const solver::Stepper& stepper = run.stepper();
  const solver::Energies& e = stepper.energies();
  std::string text = fmt::format("{} at time {:g}, cycle {}, after {}.\n\n", words(end), stepper.state().time,
                                 stepper.state().cycle, duration(run.seconds()));
  text += relaxation_line(run);
  text += row("kinetic energy", e.printed_kinetic) + row("internal energy", e.internal) +
          row("hourglass energy", e.hourglass);
  const auto add = [&](const char* label, double value) {
    if (value != 0) text += row(label, value);
  };
  add("sliding energy", e.absorbed.sliding());
  add("spring energy", e.absorbed.springs);
  add("stonewall energy", e.absorbed.walls);
  add("damping energy", e.absorbed.damping);
  add("added mass", stepper.structure().added_mass);
  text += row("external work", e.external) + row("total energy", e.printed_total()) +
          row("energy ratio", e.printed_ratio());
  const solver::StateBalance balance = state_balance(run);
  text += row("by the state", balance.ratio);
  return text + contact_rows(run) + section_rows(run) + fault_lines(balance);
}

std::string run_statistics(const solver::Run& run) {
  const solver::Structure& structure = run.stepper().structure();
  const auto cycles = static_cast<double>(run.stepper().state().cycle + 1);
  const auto elements = static_cast<double>(structure.shells.size() + structure.solids.size());
  std::string text = fmt::format("\n  shells {}, solids {}, rigid bodies {}\n", structure.shells.size(),
                                 structure.solids.size(), structure.rigid.size());
  text += fmt::format("  {:.3f} s, {:.3f} ms per cycle", run.seconds(), 1000 * run.seconds() / cycles);
  if (elements > 0) text += fmt::format(", {:.1f} ns per element and cycle", 1e9 * run.seconds() / cycles / elements);
  text += "\n";
  if (run.contacts().empty()) return text;
  const solver::ContactCounters& c = run.contact_counters();
  const auto per_cycle = [&](std::uint64_t count) { return static_cast<double>(count) / cycles; };
  text += fmt::format(
      "  contact {:.0f} % of the time: {} searches, {} candidate pairs; {:.1f} nodes and {:.1f} pairs "
      "looked at per cycle, {:.1f} of them where they were in the last one; {:.1f} nodes asleep\n",
      100 * (c.force_s + c.search_s) / std::max(run.seconds(), 1e-9), c.searches, c.candidates, per_cycle(c.nodes),
      per_cycle(c.pairs), per_cycle(c.followed), per_cycle(c.asleep));
  return text;
}

}  // namespace gapcheck::app
