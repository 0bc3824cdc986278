#include "solver/tie/tie_strengths.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "contact/stiffness/element_sizes.hpp"
#include "contact/stiffness/segment_spring.hpp"
#include "solver/contact/contact_method.hpp"

namespace gapcheck::solver {
namespace {

/// PARAM of OPTION 5.
std::int64_t damage_curve(const model::TiebreakStrength& card) { return static_cast<std::int64_t>(card.param); }

bool dycoss(std::int64_t option) { return option == 7 || option == 10; }

const model::Curve* curve_of(const model::Model& model, std::int64_t id) {
  const auto found = model.curves.find(id);
  return id == 0 || found == model.curves.end() ? nullptr : &found->second;
}

}  // namespace

bool ties_slide(const model::Contact& contact) {
  return contact.kind->automatic_tiebreak() && contact.tiebreak_option == 4;
}

TieStrengths::TieStrengths(const model::Model& model, ContactIndex contact, const contact::Segments& own,
                           const std::vector<Vector>& x)
    : model_(model),
      contact_(model.contact(contact)),
      fails_(choose_method(contact_).method == ContactMethod::tiebreak ||
             contact_.kind->tie == model::TieForm::with_failure) {
  if (!fails_) return;
  for (const model::SegmentNodes& corners : own.nodes) {
    const std::size_t count = contact::corner_count(corners);
    for (std::size_t i = 0; i < count; ++i)
      area_[corners[i].value] += contact::shell_area(corners, x) / static_cast<double>(count);
  }
}

void TieStrengths::set_law(TieStrength& strength) const {
  const model::TiebreakStrength& card = contact_.tiebreak;
  strength.curve = curve_of(model_, card.curve);
  switch (std::abs(contact_.tiebreak_option)) {
    case 1:
      strength.normal = strength.shear = 0;
      break;
    case 4:
      strength.shear = 0;
      break;
    case 5:
      strength.law = TieLaw::plastic;
      strength.curve = curve_of(model_, damage_curve(card));
      break;
    case 6:
    case 8:
      strength.law = TieLaw::linear;
      strength.opening = card.param;
      break;
    case 7:
    case 10:
      strength.law = TieLaw::cohesive;
      // As the manual prints it: SFLS (1 - sin(PARAM) min(0, stress)), with the stress in the units of the deck.
      strength.friction = strength.shear * std::sin(card.param * std::numbers::pi / 180) / strength.area;
      break;
    case 9:
    case 11:
      strength.law = TieLaw::cohesive;
      strength.exponent = card.param;
      strength.stiffness_ratio = card.stiffness_ratio;
      break;
    default:
      break;
  }
  strength.normal_energy = card.normal_energy * strength.area;
  strength.shear_energy = card.shear_energy * strength.area;
}

TieStrength TieStrengths::of(const Tie& tie, const std::vector<Vector>& x) const {
  TieStrength strength;
  if (!fails_) return strength;
  const auto found = area_.find(tie.node.value);
  const bool forces = contact_.kind->code == model::ContactCode::tiebreak_nodes;
  strength.area = forces ? 1 : found != area_.end() ? found->second : contact::shell_area(tie.point.nodes, x);
  if (contact_.kind->tie == model::TieForm::with_failure) {
    strength.normal = contact_.fs * strength.area;
    strength.shear = contact_.fd * strength.area;
    return strength;
  }
  const model::TiebreakStrength& card = contact_.tiebreak;
  strength.normal = card.normal * strength.area;
  strength.shear = card.shear * strength.area;
  strength.normal_power = card.normal_power;
  strength.shear_power = card.shear_power;
  set_law(strength);
  const SegmentAxes axes(tie.point.nodes, x);
  const double height = axes.axes.col(2).dot(x[tie.node.value] - tie.point.of(x));
  constexpr double on_the_surface = 1e-6;  // of the segment's size: facets that touch
  if (contact::sides_are_remembered(contact_) &&
      height < -on_the_surface * std::sqrt(contact::shell_area(tie.point.nodes, x)))
    strength.side = -1;
  return strength;
}

double TieStrengths::stiffness(const TieStrength& strength) const {
  const std::int64_t option = std::abs(contact_.tiebreak_option);
  return fails_ && (option == 9 || option == 11) ? contact_.tiebreak.stiffness * strength.area : 0;
}

SolverStatus check_tie_strength(const model::Model& model, const model::Contact& contact, Diagnostics& diagnostics) {
  const auto warn = [&](const std::string& text) {
    diagnostics.warning(model.file(contact.place), contact.place.line,
                        fmt::format("contact {}: {}", contact.id.value, text));
  };
  const auto fail = [&](const std::string& text) {
    return Failure{Failure::Kind::contradiction,
                   fmt::format("contact {} (*{}): {}", contact.id.value, contact.written, text), contact.place};
  };
  if (contact.kind->tie == model::TieForm::with_failure) {
    if (!(contact.fs >= 0) || !(contact.fd >= 0) || !std::isfinite(contact.fs) || !std::isfinite(contact.fd))
      return fail("the stresses at failure (FS, FD) must be 0 or more");
    if (contact.fs == 0 && contact.fd == 0) warn("FS and FD are 0: its ties never fail");
    warn("after the failure its nodes meet nothing by this contact; add another contact if they may");
    return {};
  }
  if (!contact.kind->breaks() || choose_method(contact).method != ContactMethod::tiebreak) return {};
  const model::TiebreakStrength& card = contact.tiebreak;
  for (const double value : {card.normal, card.shear, card.normal_power, card.shear_power, card.param,
                             card.normal_energy, card.shear_energy, card.stiffness, card.stiffness_ratio})
    if (!std::isfinite(value)) return fail("a value of its card 4 is not a number");
  if (card.normal < 0 || card.shear < 0 || !(card.normal_power > 0) || !(card.shear_power > 0))
    return fail("strengths must be 0 or more, and powers (NEN, MES) above 0");
  if (dycoss(contact.tiebreak_option) && card.param != 0)
    warn(fmt::format("PARAM = {:g}: the angle of friction acts as the manual prints it, which depends on the units",
                     card.param));
  const std::int64_t id = std::abs(contact.tiebreak_option) == 5 ? damage_curve(card) : card.curve;
  if (id == 0) return {};
  const model::Curve* const curve = curve_of(model, id);
  if (curve == nullptr || curve->points.empty())
    return fail(fmt::format("there is no curve {} of card 4, or it has no points; define it with *DEFINE_CURVE", id));
  for (const auto& [opening, value] : curve->points)
    if (!std::isfinite(opening) || !(value >= 0) || !std::isfinite(value))
      return fail(fmt::format("curve {} of card 4 has the value {:g}; use values from 0 up", id, value));
  return {};
}

}  // namespace gapcheck::solver
