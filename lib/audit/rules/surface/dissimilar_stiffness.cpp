#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "audit/rules.hpp"
#include "contact/definition/exclusions.hpp"
#include "contact/stiffness/stiffness.hpp"
#include "contact/surface/surface_parts.hpp"

namespace gapcheck::audit::rule::dissimilar_stiffness {
namespace {

/// A stiff part can press with about its yield stress, this share of its bulk modulus (steel: 350 of 175000).
constexpr double yield_share = 0.002;
/// A node is given up at this share of the element's thickness (PENMAX of solids; contact rules, section 5).
constexpr double given_up = 0.5;
constexpr double rounding = 1e-9;

/// The ratio of the bulk moduli from which on the soft part's springs, SLSFAC SF K A / h, let a stiff part sink in
/// until it is given up: yield_share K_stiff A = SLSFAC SF K_soft A / h · given_up h.
double dissimilar(const model::Model& model, const model::Contact& contact) {
  return given_up / yield_share * model.controls.slsfac * std::min(contact.sfs, contact.sfm);
}

/// A part of a side and the modulus that contact takes for it.
struct StiffPart {
  PartIndex part;
  double modulus = 0;
};

/// The parts of a side whose stiffness is known, soft ones first.
std::vector<StiffPart> by_stiffness(const model::Model& model, const contact::ContactSide& side) {
  std::vector<StiffPart> list;
  for (const PartIndex part : contact::parts_of(model, side)) {
    const double modulus = contact::contact_modulus(model, part);
    if (modulus > 0 && std::isfinite(modulus)) list.push_back({part, modulus});
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const StiffPart& a, const StiffPart& b) { return a.modulus < b.modulus; });
  return list;
}

struct PartPair {
  StiffPart soft, stiff;
  [[nodiscard]] double ratio() const { return stiff.modulus / soft.modulus; }
};

/// The pair with the largest ratio from `limit` on that the deck does not exclude.
std::optional<PartPair> worst(double limit, const std::vector<StiffPart>& softer, const std::vector<StiffPart>& stiffer,
                              const contact::Exclusions& exclusions, const Context& context) {
  std::optional<PartPair> found;
  for (const StiffPart& soft : softer) {
    for (auto stiff = stiffer.rbegin(); stiff != stiffer.rend(); ++stiff) {
      const PartPair pair{soft, *stiff};
      if (pair.ratio() < limit * (1 - rounding) || (found && pair.ratio() <= found->ratio())) break;
      if (exclusions.excluded(soft.part, stiff->part)) continue;
      if (context.part_chosen(soft.part) || context.part_chosen(stiff->part)) found = pair;
    }
  }
  return found;
}

/// Penalty contact whose springs take their stiffness from the material.
bool penalty(const contact::ContactType& type) {
  using contact::Family;
  return type.treatment != contact::Treatment::none &&
         (type.family == Family::old || type.family == Family::automatic || type.family == Family::forming);
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  for (const ContactIndex i : context.contacts()) {
    const model::Contact& contact = model.contact(i);
    if (contact.soft != 0 || !contact.known || contact.own_layout || !penalty(contact::classify(contact))) continue;
    const contact::ContactSurfaces& surfaces = context.surfaces(i);
    const contact::Exclusions exclusions(model, contact.id);
    const double limit = dissimilar(model, contact);
    const auto a = by_stiffness(model, surfaces.a);
    std::optional<PartPair> pair;
    if (surfaces.two_sided()) {
      const auto b = by_stiffness(model, surfaces.b);
      pair = worst(limit, a, b, exclusions, context);
      const auto other = worst(limit, b, a, exclusions, context);
      if (other && (!pair || other->ratio() > pair->ratio())) pair = other;
    } else {
      pair = worst(limit, a, a, exclusions, context);
    }
    if (!pair) continue;
    const std::int64_t soft = model.part(pair->soft.part).id.value, stiff = model.part(pair->stiff.part).id.value;
    Finding f = finding_at(
        rule, context, contact,
        fmt::format(
            "SOFT = 0, but part {} (K = {:.4g}) is {:.4g} times as stiff as part {} (K = {:.4g}): the springs are "
            "as weak as the soft part; set SOFT = 1",
            stiff, pair->stiff.modulus, pair->ratio(), soft, pair->soft.modulus));
    f.part = soft;
    f.element_part = stiff;
    report.findings.push_back(std::move(f));
  }
}

}  // namespace

const Rule definition{{"GC410", "dissimilar-stiffness", Severity::warning,
                       "a contact with SOFT = 0 joins parts of very different stiffness", Need::surfaces,
                       "The contact is far too soft: the parts pass into each other"},
                      run};

}  // namespace gapcheck::audit::rule::dissimilar_stiffness
