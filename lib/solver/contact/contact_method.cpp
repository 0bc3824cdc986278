#include "solver/contact/contact_method.hpp"

#include <algorithm>
#include <array>

#include "contact/definition/active_time.hpp"

namespace gapcheck::solver {
namespace {

constexpr std::string_view times_by_curve = "birth and death by a curve (DT = -9999) are not calculated";

using Codes = std::initializer_list<std::string_view>;

bool among(std::string_view code, Codes codes) { return std::find(codes.begin(), codes.end(), code) != codes.end(); }

ContactChoice no(std::string_view why) { return {ContactMethod::none, why}; }

ContactChoice choose_tie(const model::Contact& contact, const contact::ContactType& type) {
  if (contact.keyword.ends_with("_FAILURE")) return no("the failure of ties is not calculated");
  if (type.treatment == contact::Treatment::single_surface) return no("ties of a single surface are not calculated");
  if (contact::active_time(contact).by_curve) return no(times_by_curve);
  return {ContactMethod::tie, ""};
}

/// Of the automatic ones OPTION 2 (until failure) and 6 (linear damage).
ContactChoice choose_tiebreak(const model::Contact& contact, const contact::ContactType& type) {
  if (type.treatment == contact::Treatment::single_surface)
    return no("tiebreaks of a single surface are not calculated");
  if (contact.keyword.starts_with("CONTACT_AUTOMATIC_")) {
    if (contact.keyword.find("_USER") != contact.keyword.npos)
      return no("tiebreaks by a user's law are not calculated");
    if (contact.keyword.find("_DAMPING") != contact.keyword.npos)
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

}  // namespace

ContactChoice choose_method(const model::Contact& contact) {
  if (!contact.known || contact.own_layout) return no("contacts of this kind are not calculated");
  const contact::ContactType type = contact::classify(contact);
  if (type.pairing == contact::Pairing::mortar) return no("mortar contacts are not calculated");
  if (type.code == "25") return {ContactMethod::transducer, ""};
  if (type.family == contact::Family::tied)
    return among(type.code, {"8", "9"}) || contact.keyword.find("TIEBREAK") != contact.keyword.npos
               ? choose_tiebreak(contact, type)
               : choose_tie(contact, type);
  if (contact::active_time(contact).by_curve) return no(times_by_curve);
  if (type.family == contact::Family::constraint) return {ContactMethod::constraint, ""};
  if (!among(type.code, {"3", "a3", "4", "5", "a5", "10", "a10", "13", "a13", "14", "15", "16", "m3", "m5", "m10", "22",
                         "26", "i26"}))
    return no("contacts of this type are not calculated");
  if (contact.soft != 0 && contact.soft != 1 && contact.soft != 2) return no("only SOFT = 0, 1 and 2 are calculated");
  return {ContactMethod::penalty, ""};
}

}  // namespace gapcheck::solver
