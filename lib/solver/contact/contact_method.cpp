#include "solver/contact/contact_method.hpp"

#include <cstdlib>

#include "contact/definition/active_time.hpp"
#include "solver/contact/curve_rule.hpp"

namespace gapcheck::solver {
namespace {

constexpr std::string_view times_by_curve =
    "birth and death by a curve (DT = -9999) are calculated for penalty contacts alone";

ContactChoice no(std::string_view why) { return {ContactMethod::none, why}; }

ContactChoice choose_tie(const model::Contact& contact, const contact::ContactType& type) {
  if (type.treatment == contact::Treatment::single_surface) return no("ties of a single surface are not calculated");
  if (contact::active_time(contact).by_curve) return no(times_by_curve);
  return {ContactMethod::tie, ""};
}

/// Why a tiebreak of an automatic type is not calculated; empty if it is. What else its card needs is checked before
/// the run.
std::string_view option_not_calculated(const model::Contact& contact) {
  const model::TiebreakStrength& card = contact.tiebreak;
  switch (contact.tiebreak_option) {
    case 1:
    case -1:
    case 2:
    case -2:
    case 3:
    case -3:
    case 4:
      return {};
    case 5:
      return card.normal > 0 ? "" : "OPTION 5 without a yield stress (NFLS) is not calculated";
    case 6:
    case 8:
      return card.param > 0 ? "" : "OPTION 6 and 8 without a critical opening (PARAM) are not calculated";
    case 9:
    case 11:
      if (card.param == 0) return "OPTION 9 and 11 need an exponent of the energies (PARAM)";
      if (card.stiffness < 0 || !(card.stiffness_ratio > 0)) return "CN and CT2CN must be positive";
      [[fallthrough]];
    case 7:
    case 10:
      return card.normal > 0 && card.shear > 0 && card.normal_energy > 0 && card.shear_energy > 0
                 ? ""
                 : "OPTION 7, 9, 10 and 11 need positive values of NFLS, SFLS, ERATEN and ERATES; curves are not "
                   "calculated";
    default:
      return "of tiebreaks OPTION 1 to 11, -1, -2 and -3 alone are calculated";
  }
}

ContactChoice choose_tiebreak(const model::Contact& contact, const contact::ContactType& type) {
  if (type.treatment == contact::Treatment::single_surface &&
      (type.code != contact::ContactCode::automatic_single || std::abs(contact.tiebreak_option) == 3))
    return no(
        "of tiebreaks of a single surface AUTOMATIC_SINGLE_SURFACE without OPTION 3 and -3 is calculated: how the "
        "nodes "
        "of both faces that touch later share a strength is not published; use AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK");
  if (contact.kind->automatic_tiebreak()) {
    if (contact.kind->tie == model::TieForm::automatic_tiebreak_user)
      return no("tiebreaks by a user's law are not calculated");
    if (contact.kind->tie == model::TieForm::automatic_tiebreak_damping)
      return no("the damping of tiebreaks is not calculated");
    if (const std::string_view why = option_not_calculated(contact); !why.empty()) return no(why);
  }
  if (contact.soft != 0 && contact.soft != 1) return no("of tiebreaks SOFT = 0 and 1 alone are calculated");
  if (contact::active_time(contact).by_curve) return no(times_by_curve);
  return {ContactMethod::tiebreak, ""};
}

ContactChoice choose_penalty(const model::Contact& contact) {
  if (acts_by_curve(contact)) {
    const std::string_view why = curve_not_calculated(contact);
    return why.empty() ? ContactChoice{ContactMethod::penalty, ""} : no(why);
  }
  if (contact.kind->can(contact::Ability::interference) && contact.soft == 2)
    return no("of INTERFERENCE contacts SOFT = 0 and 1 alone are calculated");
  if (contact.soft != 0 && contact.soft != 1 && contact.soft != 2) return no("only SOFT = 0, 1 and 2 are calculated");
  return {ContactMethod::penalty, ""};
}

/// Of mortar contacts those of one and two surfaces.
ContactChoice choose_mortar(const model::Contact& contact) {
  if (contact.kind->tie != model::TieForm::none) return no("the ties of mortar contacts are not calculated");
  const model::ContactCode code = contact.kind->code;
  if (code != model::ContactCode::automatic_surface && code != model::ContactCode::automatic_single &&
      code != model::ContactCode::forming_surface)
    return no("mortar contacts of this type are not calculated");
  if (contact::active_time(contact).by_curve) return no(times_by_curve);
  return {ContactMethod::penalty, ""};
}

/// Option words of the keyword that change what the contact does.
std::string_view unsupported_option(const model::ContactOptions& options) {
  if (options.ortho_friction) return "orthotropic friction (ORTHO_FRICTION) is not calculated";
  if (options.thermal_friction) return "friction by temperature (THERMAL_FRICTION) is not calculated";
  if (options.smooth) return "smoothed surfaces (SMOOTH) are not calculated";
  return {};
}

}  // namespace

ContactChoice choose_method(const model::Contact& contact) {
  const contact::ContactType type = contact::classify(contact);
  if (contact.kind == nullptr || type.code == contact::ContactCode::unknown)
    return no("contacts of this kind are not calculated");
  if (!contact.kind->not_run.empty()) return no(contact.kind->not_run);
  if (const std::string_view why = unsupported_option(contact.options); !why.empty()) return no(why);
  if (contact.options.mortar) return choose_mortar(contact);
  switch (contact.kind->method) {
    case model::RunMethod::none:
      return no("contacts of this type are not calculated");
    case model::RunMethod::transducer:
      return {ContactMethod::transducer, ""};
    case model::RunMethod::tie:
      return choose_tie(contact, type);
    case model::RunMethod::tiebreak:
      return choose_tiebreak(contact, type);
    case model::RunMethod::constraint:
      if (contact::active_time(contact).by_curve) return no(times_by_curve);
      return {ContactMethod::constraint, ""};
    case model::RunMethod::penalty:
      return choose_penalty(contact);
  }
  return no("contacts of this type are not calculated");
}

}  // namespace gapcheck::solver
