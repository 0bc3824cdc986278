#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "audit/rules.hpp"
#include "audit/run_context.hpp"
#include "model/contact/contact_kind.hpp"

namespace gapcheck::audit::rule::unbalanced_contact_force {
namespace {

constexpr double largest_share = 1e-3;  ///< of the contact's largest force; print rounding is 1e-5

/// What rcforc says about one contact over the run.
struct Balance {
  std::array<double, 2> peak{};  ///< largest force of each side
  double unbalanced = 0, time = 0;
};

std::map<std::int64_t, Balance> balances(const RunContext& context) {
  std::map<std::int64_t, Balance> list;
  for (const results::InterfaceStates& state : context.files().rcforc.states)
    for (const results::InterfaceState& contact : state.contacts) {
      if (!context.chosen(contact.contact) || !contact.force[0].allFinite() || !contact.force[1].allFinite()) continue;
      Balance& balance = list[contact.contact];
      for (std::size_t side = 0; side < 2; ++side)
        balance.peak[side] = std::max(balance.peak[side], contact.force[side].stableNorm());
      const double sum = (contact.force[0] + contact.force[1]).stableNorm();
      if (!(sum > balance.unbalanced)) continue;
      balance.unbalanced = sum;
      balance.time = state.time;
    }
  return list;
}

/// A transducer measures the forces of other contacts, possibly on one side only.
bool measures_only(const RunContext& context, std::int64_t id) {
  const ContactSummary* contact = context.contact(id);
  return contact != nullptr && contact->type == model::printed(model::ContactCode::transducer);
}

void judge(const RuleIdentity& rule, RunContext& context, Report& report) {
  if (context.files().rcforc.states.empty())
    return context.skipped(rule, "there is no rcforc with forces of both sides");
  for (const auto& [id, balance] : balances(context)) {
    const double peak = std::max(balance.peak[0], balance.peak[1]);
    const bool one_sided = std::min(balance.peak[0], balance.peak[1]) == 0;
    if (one_sided || measures_only(context, id) || !(balance.unbalanced > largest_share * peak)) continue;
    Finding f = context.finding(
        rule, "rcforc", rule.severity,
        fmt::format("the forces on side A and side B add up to {:.5g} at time {:.6g}; the largest force is {:.5g}",
                    balance.unbalanced, balance.time, peak));
    f.contact = id;
    report.findings.push_back(std::move(f));
  }
}

}  // namespace

const Rule definition{{"GC607", "unbalanced-contact-force", Severity::warning,
                       "the forces on the two sides of a contact are not opposite", Need::run_files,
                       "The contact does not conserve momentum"},
                      nullptr,
                      judge};

}  // namespace gapcheck::audit::rule::unbalanced_contact_force
