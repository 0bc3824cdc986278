#include <fmt/format.h>

#include "audit/rules.hpp"

namespace gapcheck::audit::rule::soft_scale {
namespace {

/// SOFSCL: the default, and the least that the workshop recommends for unstable runs (contact rules, section 11).
constexpr double highest = 0.1, lowest = 0.04;
constexpr double rounding = 1e-9;

void run(const RuleIdentity& rule, Context& context, Report& report) {
  for (const ContactIndex i : context.contacts()) {
    const model::Contact& contact = context.model().contact(i);
    if (!contact.known || contact.own_layout || (contact.soft != 1 && contact.soft != 2)) continue;
    const double scale = contact.sofscl;
    if (scale >= lowest * (1 - rounding) && scale <= highest * (1 + rounding)) continue;
    report.findings.push_back(finding_at(
        rule, context, contact,
        fmt::format(
            "SOFSCL = {:.6g} with SOFT = {} is {}; take 0.1, or 0.04 to 0.07 where the contact is unstable", scale,
            contact.soft,
            scale > highest ? "above 0.1: the springs may become unstable" : "below 0.04: the contact is soft")));
  }
}

}  // namespace

const Rule definition{
    {"GC411", "soft-scale", Severity::note, "SOFSCL of a contact with SOFT = 1 or 2 lies outside 0.04 to 0.1",
     Need::model, "The contact is softer or less stable than usual"},
    run};

}  // namespace gapcheck::audit::rule::soft_scale
