#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "audit/rules.hpp"

namespace gapcheck::audit::rule::soft_scale {
namespace {

/// SOFSCL: the default, and the least that the workshop recommends for unstable runs (contact rules, section 11).
constexpr std::array thresholds{Threshold{"highest", 0.1, 0, 1e6, "SOFSCL above which it is listed"},
                                Threshold{"lowest", 0.04, 0, 1e6, "SOFSCL below which it is listed"}};
constexpr double rounding = 1e-9;
/// Scale factors of at most this leave nothing of the springs that SOFT = 0 would have; then SOFSCL alone sets them,
/// and this much is advised (page of the rule, Sources).
constexpr double no_material_springs = 1e-6, advised_without_them = 0.5;

/// The largest SOFSCL that is not listed.
double bound(const model::Contact& contact, double highest) {
  const bool alone =
      contact.soft == 1 && std::abs(contact.sfs) <= no_material_springs && std::abs(contact.sfm) <= no_material_springs;
  return alone ? std::max(highest, advised_without_them) : highest;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const double highest = context.threshold(rule, thresholds[0]), lowest = context.threshold(rule, thresholds[1]);
  for (const ContactIndex i : context.contacts()) {
    const model::Contact& contact = context.model().contact(i);
    if (!contact.known || contact.own_layout || (contact.soft != 1 && contact.soft != 2)) continue;
    const double scale = contact.sofscl, most = bound(contact, highest);
    if (scale >= lowest * (1 - rounding) && scale <= most * (1 + rounding)) continue;
    report.findings.push_back(finding_at(
        rule, context, contact,
        fmt::format("SOFSCL = {:.6g} with SOFT = {} is {}; take 0.1, or 0.04 to 0.07 where the contact is unstable",
                    scale, contact.soft,
                    scale > most ? fmt::format("above {:g}: the springs may become unstable", most)
                                 : fmt::format("below {:g}: the contact is soft", lowest))));
  }
}

}  // namespace

const Rule definition{.identity = {"GC411", "soft-scale", Severity::note,
                                   "SOFSCL of a contact with SOFT = 1 or 2 lies outside 0.04 to 0.1", Need::model,
                                   "The contact is softer or less stable than usual"},
                      .run = run,
                      .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::soft_scale
