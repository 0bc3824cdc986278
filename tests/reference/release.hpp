#pragma once
#include "reference/surfaces.hpp"

namespace gapcheck::reference {

/// The penetration beyond which a node is released (contact rules, section 5); infinite: never. `h`: contact distance.
[[nodiscard]] double release_depth(const Rules& rules, const Facet& facet, double h, const Positions& x);

}  // namespace gapcheck::reference
