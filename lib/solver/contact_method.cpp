#include "solver/contact_method.hpp"

#include <algorithm>
#include <array>

#include "contact/active_time.hpp"

namespace gapcheck::solver {
namespace {

using Codes = std::initializer_list<std::string_view>;

bool among(std::string_view code, Codes codes) { return std::find(codes.begin(), codes.end(), code) != codes.end(); }

ContactChoice no(std::string_view why) { return {ContactMethod::none, why}; }

}  // namespace

ContactChoice choose_method(const model::Contact& contact) {
  if (!contact.known || contact.own_layout) return no("contacts of this kind are not calculated");
  const contact::ContactType type = contact::classify(contact);
  if (type.pairing == contact::Pairing::segments) return no("SOFT = 2 is not calculated");
  if (type.pairing == contact::Pairing::mortar) return no("mortar contacts are not calculated");
  if (type.code == "25") return {ContactMethod::transducer, ""};
  const bool constraint = among(type.code, {"17", "18"});
  const bool penalty = among(type.code, {"3", "a3", "4", "5", "a5", "10", "a10", "13", "a13", "14", "15", "16", "m3", "m5",
                                         "m10"});
  if (!(constraint || penalty) || type.edges) return no("contacts of this type are not calculated");
  if (penalty && contact.soft != 0 && contact.soft != 1 && contact.soft != 2)
    return no("only SOFT = 0 and 1 are calculated");
  if (contact::active_time(contact).by_curve) return no("birth and death by a curve (DT = -9999) are not calculated");
  return {constraint ? ContactMethod::constraint : ContactMethod::penalty, ""};
}

}  // namespace gapcheck::solver
