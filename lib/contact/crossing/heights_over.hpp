#pragma once
#include "geometry/intersect.hpp"

namespace gapcheck::contact {

/// Range of heights over a plane; both 0 where there is nothing.
struct Heights {
  double low = 0, high = 0;
};

/// The heights over the plane of a triangle of that part of another one that lies above or below it, seen along its
/// normal; `slack`: how far beyond its edges. `up`: which side of the plane is high.
[[nodiscard]] Heights heights_over(const geometry::Triangle& base, const geometry::Triangle& t, double slack,
                                   const Vector& up);

}  // namespace gapcheck::contact
