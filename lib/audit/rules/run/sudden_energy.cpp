#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audit/rules.hpp"
#include "audit/run_context.hpp"

namespace gapcheck::audit::rule::sudden_energy {
namespace {

using results::GlobalState;

constexpr double largest_jump = 0.05;  ///< of the peak energy, within one output interval

double walls(const GlobalState& state) {
  double sum = 0;
  for (const GlobalState::Wall& wall : state.walls) sum += wall.energy;
  return sum;
}

/// Energy that elements, springs and closed contacts can give back. A contact below zero has nothing to give.
double stored(const GlobalState& s) {
  return s.internal + s.springs + s.hourglass + s.damping + std::max(s.sliding, 0.0) + std::max(walls(s), 0.0);
}

/// Change of the total energy that no work explains.
double unexplained_total(const GlobalState& from, const GlobalState& to) {
  return std::abs(to.total - from.total - (to.external - from.external));
}

/// Gain of kinetic energy that neither work nor stored energy explains.
double unexplained_kinetic(const GlobalState& from, const GlobalState& to) {
  const double gain = to.kinetic - from.kinetic;
  return std::min(gain, gain + stored(to) - stored(from) - (to.external - from.external));
}

void judge_jumps(const RuleIdentity& rule, const RunContext& context, std::string_view what, double peak,
                 double (*jump)(const GlobalState&, const GlobalState&), Report& report) {
  const auto& states = context.files().glstat;
  std::size_t worst = 0;
  std::uint64_t intervals = 0;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const double size = jump(states[i - 1], states[i]);
    if (!std::isfinite(size) || !(size > largest_jump * peak)) continue;
    ++intervals;
    if (worst == 0 || size > jump(states[worst - 1], states[worst])) worst = i;
  }
  if (worst == 0) return;
  const double size = jump(states[worst - 1], states[worst]);
  std::string message =
      fmt::format("{} {:.5g} between time {:.6g} and {:.6g}, {:.3g} % of the peak energy, without work", what, size,
                  states[worst - 1].time, states[worst].time, 100 * (size / peak));
  if (intervals > 1) message += fmt::format("; the largest of {} such jumps", intervals);
  report.findings.push_back(context.finding(rule, "glstat", rule.severity, std::move(message)));
}

void judge(const RuleIdentity& rule, RunContext& context, Report& report) {
  if (context.files().glstat.size() < 2) return context.skipped(rule, "there is no glstat with two states");
  const double peak = std::max(context.peak(&GlobalState::total), context.peak(&GlobalState::external));
  if (peak == 0) return;
  judge_jumps(rule, context, "the total energy changes by", peak, unexplained_total, report);
  judge_jumps(rule, context, "the kinetic energy gains", peak, unexplained_kinetic, report);
}

}  // namespace

const Rule definition{
    {"GC606", "sudden-energy", Severity::warning, "energy jumps from one output to the next, and no work explains it",
     Need::run_files, "Something sudden and unphysical happened at that time"},
    nullptr,
    judge};

}  // namespace gapcheck::audit::rule::sudden_energy
