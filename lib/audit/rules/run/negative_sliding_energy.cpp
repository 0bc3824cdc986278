#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audit/rules.hpp"
#include "audit/shared/sliding_energy.hpp"

namespace gapcheck::audit::rule::negative_sliding_energy {
namespace {

constexpr double warning_share = 0.01, error_share = 0.10;  ///< of the reference energy

/// ", 12 % of the internal energy then"; empty where there is none.
std::string share_then(const RunContext& context, const SlidingState& lowest) {
  const auto& states = context.files().glstat;
  const auto later = std::find_if(states.begin(), states.end(), [&](const auto& s) { return s.time >= lowest.time; });
  if (later == states.end() || !(later->internal > 0)) return "";
  return fmt::format(", {:.4g} % of the internal energy then", 100 * (lowest.energy / later->internal));
}

void judge(const RuleIdentity& rule, RunContext& context, Report& report) {
  const auto histories = sliding_energies(context);
  if (histories.empty()) return context.skipped(rule, "there is neither sleout nor glstat");
  const ReferenceEnergy& reference = context.reference();
  if (reference.value == 0) return context.skipped(rule, "glstat has no energy to hold it against");
  for (const SlidingHistory& history : histories) {
    const auto negative = [&](const SlidingState& s) {
      return s.energy < -warning_share * reference.value && s.energy < -s.print_error;
    };
    const auto since = std::find_if(history.states.begin(), history.states.end(), negative);
    if (since == history.states.end()) continue;
    const auto lowest = std::min_element(
        since, history.states.end(), [](const SlidingState& a, const SlidingState& b) { return a.energy < b.energy; });
    const bool severe = lowest->energy < -error_share * reference.value;
    Finding f = context.finding(
        rule, history.file, severe ? Severity::error : Severity::warning,
        fmt::format("the sliding energy{} falls to {:.5g} at time {:.6g}: {}{}; below -1 % since time {:.6g}",
                    history.without_friction ? " without friction" : "", lowest->energy, lowest->time,
                    share_text(lowest->energy, reference), share_then(context, *lowest), since->time));
    f.contact = history.contact;
    report.findings.push_back(std::move(f));
  }
}

}  // namespace

const Rule definition{
    {"GC601", "negative-sliding-energy", Severity::warning, "a contact gives the model energy that nobody put in",
     Need::run_files, "The results hold energy that nobody put in"},
    nullptr,
    judge};

}  // namespace gapcheck::audit::rule::negative_sliding_energy
