#pragma once
#include <optional>

#include "geometry/certificate.hpp"
#include "geometry/closest_point.hpp"

namespace gapcheck::geometry::precise {

/// Parameters of a point of a patch, in [-1, 1].
struct Place {
  double s = 0, t = 0;
};

/// What can be proven about a quad by its four edges and by pieces of its inside: a piece is apart if the polynomials
/// of the squared distance or of a slope show it in doubles, or the point nearest to the query, found with about 106
/// bits, does. Closer, apart or open. `inside` is where that point is to be looked for, if the quad may be at the bound
/// there. `size` (size_of, of the corners less the query) must be usable() (view.hpp), the bound positive and finite.
/// Derivation: docs/theory/decisions.md.
[[nodiscard]] Verdict quad_verdict(const Facet& quad, const Vector& query, double size, double bound,
                                   const std::optional<Place>& place);

/// The same for a triangle whose nearest point lies on its edges.
[[nodiscard]] Verdict triangle_edges_verdict(const Facet& triangle, const Vector& query, double size, double bound);

}  // namespace gapcheck::geometry::precise
