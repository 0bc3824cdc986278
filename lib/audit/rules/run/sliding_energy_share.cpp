#include <fmt/format.h>

#include <algorithm>

#include "audit/rules.hpp"
#include "audit/shared/sliding_energy.hpp"

namespace gapcheck::audit::rule::sliding_energy_share {
namespace {

constexpr double note_share = 0.05, warning_share = 0.10;  ///< of the peak internal energy

void judge(const RuleIdentity& rule, RunContext& context, Report& report) {
  const auto histories = sliding_energies(context);
  if (histories.empty() || !histories.front().without_friction)
    return context.skipped(rule, "there is no sleout: friction cannot be told from the rest");
  const ReferenceEnergy& reference = context.reference();
  if (reference.value == 0) return context.skipped(rule, "glstat has no energy to hold it against");
  if (!reference.of_elements) return context.skipped(rule, "the elements hardly deform: the share says nothing");
  for (const SlidingHistory& history : histories) {
    const auto highest =
        std::max_element(history.states.begin(), history.states.end(),
                         [](const SlidingState& a, const SlidingState& b) { return a.energy < b.energy; });
    if (highest == history.states.end() || !(highest->energy > note_share * reference.value)) continue;
    const bool large = highest->energy > warning_share * reference.value;
    Finding f = context.finding(rule, history.file, large ? Severity::warning : Severity::note,
                                fmt::format("the sliding energy without friction reaches {:.5g} at time {:.6g}: {}",
                                            highest->energy, highest->time, share_text(highest->energy, reference)));
    f.contact = history.contact;
    report.findings.push_back(std::move(f));
  }
}

}  // namespace

const Rule definition{
    {"GC602", "sliding-energy-share", Severity::note, "the contact springs of a contact hold much energy",
     Need::run_files, "Much energy is in contact springs: the parts overlap in the results"},
    nullptr,
    judge};

}  // namespace gapcheck::audit::rule::sliding_energy_share
