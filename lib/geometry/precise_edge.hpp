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

/// True if the hull of an edge and some corners surely is nowhere nearer than the bound because its nearest point is
/// that of the edge: seen along the edge, or from its nearest end, the corners lie beyond that point.
[[nodiscard]] bool separated_by_edge(const Vector& a, const Vector& b, const std::array<Vector, 4>& corners,
                                     const Vector& query, double size, double bound);

}  // namespace gapcheck::geometry::precise
