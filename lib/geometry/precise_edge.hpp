#pragma once
#include <array>

#include "geometry/certificate.hpp"

namespace gapcheck::geometry::precise {

/// What numbers of about 106 bits prove about the straight edge from a to b: closer or apart. Ties are proven if their
/// products have no more digits than doubles, as those of whole numbers; other ties stay open. `size` (size_of, of both
/// ends less the query) must be usable() (view.hpp), the bound positive and finite. Derivation:
/// docs/theory/decisions.md.
[[nodiscard]] Verdict edge_verdict(const Vector& a, const Vector& b, const Vector& query, double size, double bound);

/// The same for a point.
[[nodiscard]] Verdict corner_verdict(const Vector& a, const Vector& query, double size, double bound);

/// True if all corners surely lie behind a plane that is as far away as the bound or farther: the plane through the
/// point of the edge from a to b nearest to the query, at right angles to the way there.
[[nodiscard]] bool separated_by_edge(const Vector& a, const Vector& b, const std::array<Vector, 4>& corners,
                                     const Vector& query, double size, double bound);

}  // namespace gapcheck::geometry::precise
