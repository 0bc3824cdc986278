#pragma once
#include <string>

#include "triangle.hpp"

namespace gapcheck::bench {

/// The quad as two triangles on the diagonal from the first corner to the third.
template <class Number>
struct TwoTriangles {
  [[nodiscard]] static std::string name() { return "two triangles"; }
  [[nodiscard]] static Answer<Number> answer(const ContactPair<Number>& pair) {
    const auto e = seen_from_query(pair);
    Number best = squared_distance_of_triangle(e[0], e[1], e[2]);
    if (!pair.triangle) best = std::min(best, squared_distance_of_triangle(e[0], e[2], e[3]));
    return plain_answer(best, pair.bound);
  }
};

}  // namespace gapcheck::bench
