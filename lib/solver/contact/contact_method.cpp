#include "solver/contact/contact_method.hpp"

#include "contact/definition/active_time.hpp"

namespace gapcheck::solver {
namespace {

constexpr std::string_view times_by_curve = "birth and death by a curve (DT = -9999) are not calculated";

ContactChoice no(std::string_view why) { return {ContactMethod::none, why}; }

ContactChoice choose_tie(const model::Contact& contact, const contact::ContactType& type) {
  if (type.treatment == contact::Treatment::single_surface) return no("ties of a single surface are not calculated");
  if (contact::active_time(contact).by_curve) return no(times_by_curve);
  return {ContactMethod::tie, ""};
}

/// Of the automatic ones OPTION 2 (until failure) and 6 (linear damage).
ContactChoice choose_tiebreak(const model::Contact& contact, const contact::ContactType& type) {
  if (type.treatment == contact::Treatment::single_surface)
    return no("tiebreaks of a single surface are not calculated");
  if (contact.kind->automatic_tiebreak()) {
    if (contact.kind->tie == model::TieForm::automatic_tiebreak_user)
      return no("tiebreaks by a user's law are not calculated");
    if (contact.kind->tie == model::TieForm::automatic_tiebreak_damping)
      return no("the damping of tiebreaks is not calculated");
    if (contact.tiebreak_option != 2 && contact.tiebreak_option != 6)
      return no("of tiebreaks OPTION 2 and 6 alone are calculated");
    if (contact.tiebreak_option == 6 && !(contact.tiebreak.param > 0))
      return no("OPTION 6 without a critical opening (PARAM) is not calculated");
  }
  if (contact.tiebreak.curve != 0) return no("stress after the failure of a tiebreak (TBLCID) is not calculated");
  if (contact.soft != 0 && contact.soft != 1) return no("of tiebreaks SOFT = 0 and 1 alone are calculated");
  if (contact::active_time(contact).by_curve) return no(times_by_curve);
  return {ContactMethod::tiebreak, ""};
}

ContactChoice choose_penalty(const model::Contact& contact) {
  if (contact::active_time(contact).by_curve) return no(times_by_curve);
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
