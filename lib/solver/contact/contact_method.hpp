#pragma once
#include <cstdint>
#include <string_view>

#include "contact/definition/contact_type.hpp"

namespace gapcheck::solver {

/// Which code calculates a contact.
enum class ContactMethod : std::uint8_t {
  none,        ///< nothing does
  penalty,     ///< ContactForces: nodes in segments, SOFT = 0 and 1
  constraint,  ///< ConstraintContact: types 17 and 18
  tie,         ///< TieConstraints and TieForces, chosen node by node
  tiebreak,    ///< TieForces until a tie fails, then ContactForces
  transducer,  ///< Transducers: it only measures
};

struct ContactChoice {
  ContactMethod method = ContactMethod::none;
  std::string_view why_not;  ///< for none: the reason
};

/// The single place that decides which contacts are calculated, and by what.
[[nodiscard]] ContactChoice choose_method(const model::Contact& contact);

}  // namespace gapcheck::solver
