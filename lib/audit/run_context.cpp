#include "audit/run_context.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gapcheck::audit {
namespace {

/// Below this share of the total energy the internal energy is not a usable reference.
constexpr double rigid_share = 0.01;

}  // namespace

RunContext::RunContext(const results::RunResults& files, const SolverRun& log,
                       const std::vector<ContactSummary>& contacts, const JudgeOptions& options)
    : files_(files), log_(log), contacts_(contacts), options_(options) {
  const double internal = peak(&results::GlobalState::internal);
  const double total = std::max(peak(&results::GlobalState::total), peak(&results::GlobalState::external));
  reference_.of_elements = internal >= rigid_share * total;
  reference_.value = reference_.of_elements ? internal : total;
}

const ContactSummary* RunContext::contact(std::int64_t id) const {
  const auto found = std::find_if(contacts_.begin(), contacts_.end(), [&](const auto& c) { return c.id == id; });
  return found == contacts_.end() ? nullptr : &*found;
}

bool RunContext::chosen(std::int64_t contact) const {
  const auto& wanted = options_.contacts;
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), contact) != wanted.end();
}

double RunContext::peak(double results::GlobalState::*value) const {
  double largest = 0;
  for (const results::GlobalState& state : files_.glstat)
    if (std::isfinite(state.*value)) largest = std::max(largest, std::abs(state.*value));
  return largest;
}

void RunContext::skipped(const RuleIdentity& rule, std::string_view why) {
  skips_.push_back(fmt::format("{} {}: {}", rule.id, rule.name, why));
}

Finding RunContext::finding(const RuleIdentity& rule, std::string_view file, Severity severity,
                            std::string message) const {
  Finding f = audit::finding(rule, std::move(message), files_.path(file), 0);
  f.severity = severity;
  return f;
}

}  // namespace gapcheck::audit
