#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "audit/shared/sliding_energy.hpp"

namespace gapcheck::audit::rule::hourglass_share {
namespace {

constexpr double largest_share = 0.10;  ///< of the peak internal energy, of the model or of the part
constexpr double least_part =
    0.01;  ///< parts whose hourglass energy is a smaller share of the model's energy do not count

struct PartPeaks {
  double hourglass = 0, internal = 0, time = 0;  ///< time: of the peak hourglass energy
};

std::map<std::int64_t, PartPeaks> peaks_of_parts(const results::PartHistory& history) {
  std::map<std::int64_t, PartPeaks> parts;
  for (const results::PartStates& state : history.states)
    for (const results::PartState& part : state.parts) {
      PartPeaks& peaks = parts[part.part];
      if (part.internal > peaks.internal) peaks.internal = part.internal;
      if (!(part.hourglass > peaks.hourglass)) continue;
      peaks.hourglass = part.hourglass;
      peaks.time = state.time;
    }
  return parts;
}

void judge_model(const RuleIdentity& rule, const RunContext& context, Report& report) {
  const auto& states = context.files().glstat;
  const auto worst = std::max_element(states.begin(), states.end(), [](const auto& a, const auto& b) {
    return !std::isfinite(a.hourglass) || a.hourglass < b.hourglass;
  });
  const ReferenceEnergy& reference = context.reference();
  if (worst == states.end() || !(worst->hourglass > largest_share * reference.value)) return;
  report.findings.push_back(
      context.finding(rule, "glstat", rule.severity,
                      fmt::format("the hourglass energy reaches {:.5g} at time {:.6g}: {}", worst->hourglass,
                                  worst->time, share_text(worst->hourglass, reference))));
}

void judge_parts(const RuleIdentity& rule, const RunContext& context, Report& report) {
  const auto parts = peaks_of_parts(context.files().matsum);
  std::vector<Found> found;
  for (const auto& [part, peaks] : parts)
    if (peaks.hourglass > largest_share * peaks.internal && peaks.hourglass > least_part * context.reference().value)
      found.push_back({0, peaks.hourglass, static_cast<std::uint64_t>(part)});
  const auto words = [&](const Found& f) {
    const auto part = static_cast<std::int64_t>(f.item);
    const PartPeaks& peaks = parts.at(part);
    Finding result = context.finding(
        rule, "matsum", rule.severity,
        fmt::format(
            "part {}: the hourglass energy reaches {:.5g} at time {:.6g}; the part's peak internal energy is {:.5g}",
            part, peaks.hourglass, peaks.time, peaks.internal));
    result.part = part;
    return result;
  };
  const auto rest = [&](const Found&, std::uint64_t count) {
    return context.finding(rule, "matsum", rule.severity,
                           fmt::format("{} more parts with much hourglass energy", count));
  };
  add_grouped(report, std::move(found), words, rest);
}

void judge(const RuleIdentity& rule, RunContext& context, Report& report) {
  if (context.files().glstat.empty()) return context.skipped(rule, "there is no glstat");
  if (context.reference().value > 0) judge_model(rule, context, report);
  if (context.files().matsum.states.empty())
    context.skipped(rule, "there is no matsum: parts are not judged on their own");
  else
    judge_parts(rule, context, report);
}

}  // namespace

const Rule definition{
    {"GC604", "hourglass-share", Severity::warning, "hourglass energy is large beside internal energy", Need::run_files,
     "The deformation is partly hourglass modes, not physics"},
    nullptr,
    judge};

}  // namespace gapcheck::audit::rule::hourglass_share
