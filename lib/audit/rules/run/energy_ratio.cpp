#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "audit/rules.hpp"
#include "audit/run_context.hpp"

namespace gapcheck::audit::rule::energy_ratio {
namespace {

using results::GlobalState;

constexpr double warning_band = 0.05, error_band = 0.10;  ///< on both sides of 1
/// States with less energy than this share of the peak are not judged: their ratio is only rounding.
constexpr double least_share = 0.01;

/// Initial energy plus external work.
double expected(const GlobalState& first, const GlobalState& state) { return first.total + state.external; }

void judge(const RuleIdentity& rule, RunContext& context, Report& report) {
  const auto& states = context.files().glstat;
  if (states.empty()) return context.skipped(rule, "there is no glstat");
  const auto broken = std::find_if(states.begin(), states.end(), [](const GlobalState& s) {
    return !std::isfinite(s.total) || !std::isfinite(s.kinetic) || !std::isfinite(s.internal);
  });
  if (broken != states.end())
    report.findings.push_back(
        context.finding(rule, "glstat", Severity::error,
                        fmt::format("energies are no numbers any more from time {:.6g} on", broken->time)));
  const double least = least_share * std::max(context.peak(&GlobalState::total), context.peak(&GlobalState::external));
  const GlobalState *first = nullptr, *worst = nullptr;
  for (const GlobalState& state : states) {
    const double deviation = std::abs(state.ratio - 1);
    const double size = std::max(std::abs(state.total), std::abs(expected(states.front(), state)));
    if (!std::isfinite(deviation) || !(size > least) || deviation <= warning_band) continue;
    if (first == nullptr) first = &state;
    if (worst == nullptr || deviation > std::abs(worst->ratio - 1)) worst = &state;
  }
  if (first == nullptr) return;
  report.findings.push_back(context.finding(
      rule, "glstat", std::abs(worst->ratio - 1) > error_band ? Severity::error : Severity::warning,
      fmt::format("the energy ratio leaves 0.95 to 1.05 at time {:.6g}; farthest from 1 is {:.5g} at time {:.6g}",
                  first->time, worst->ratio, worst->time)));
}

}  // namespace

const Rule definition{
    {"GC603", "energy-ratio", Severity::warning, "energy appears or disappears: the ratio is far from 1",
     Need::run_files, "The results hold energy from nothing, or have lost some"},
    nullptr,
    judge};

}  // namespace gapcheck::audit::rule::energy_ratio
