#pragma once
#include <span>

#include "geometry/intersect.hpp"

namespace gapcheck::contact {

/// Whether two surfaces that meet in a line go through each other there: seen along the line, one leaves it on both
/// sides of the other. A way that both take within the tolerance is a touch: bricks with flush sides lie on each other
/// along their common edges, they do not cross. `a`, `b`: the triangles at the line; `tolerance`: a length.
[[nodiscard]] bool cross_around(const geometry::Line& line, std::span<const geometry::Triangle> a,
                                std::span<const geometry::Triangle> b, double tolerance);

}  // namespace gapcheck::contact
