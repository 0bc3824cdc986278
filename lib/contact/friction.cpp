#include "contact/friction.hpp"

#include <algorithm>

#include "contact/contact_type.hpp"

namespace gapcheck::contact {
namespace {

/// a5, a10, a3, 13, 26 with its interior form, 4, 15.
constexpr std::string_view with_table[] = {"a5", "a10", "a3", "13", "26", "i26", "4", "15"};

}  // namespace

bool has_friction(const model::Contact& contact) {
  const ContactType type = classify(contact);
  return type.family != Family::tied && type.treatment != Treatment::none;
}

bool takes_friction_table(const model::Contact& contact) {
  const std::string code = classify(contact).code;
  return std::find(std::begin(with_table), std::end(with_table), code) != std::end(with_table);
}

bool takes_part_friction(const model::Contact& contact) {
  return takes_friction_table(contact) || classify(contact).code == "a13";
}

}  // namespace gapcheck::contact
