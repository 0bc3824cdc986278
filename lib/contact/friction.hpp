#pragma once
#include "model/contact.hpp"

namespace gapcheck::contact {

/// Values of FS with a meaning of their own.
inline constexpr double friction_of_parts = -1;  ///< *PART_CONTACT
inline constexpr double friction_by_table = -2;  ///< *DEFINE_FRICTION, the one that FD names if there are several

/// True for contacts that slide: not for tied ones (TIEBREAK is one until it fails) and transducers.
[[nodiscard]] bool has_friction(const model::Contact& contact);

/// Types for which FS = -1 holds. Source: workshop slides, *PART_CONTACT; their MORTAR and SMOOTH forms count as they
/// do.
[[nodiscard]] bool takes_part_friction(const model::Contact& contact);

/// Types for which FS = -2 holds: the same without airbags. Source: workshop slides, *DEFINE_FRICTION.
[[nodiscard]] bool takes_friction_table(const model::Contact& contact);

}  // namespace gapcheck::contact
