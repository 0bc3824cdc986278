#pragma once
#include <string>

#include "triangle.hpp"

namespace gapcheck::bench {

/// The quad as four triangles between its edges and the mean of its corners.
template <class Number>
struct FourTriangles {
  [[nodiscard]] static std::string name() { return "four triangles"; }
  [[nodiscard]] static Answer<Number> answer(const ContactPair<Number>& pair) {
    const auto e = seen_from_query(pair);
    if (pair.triangle) return plain_answer(squared_distance_of_triangle(e[0], e[1], e[2]), pair.bound);
    const typename ContactPair<Number>::Point centre = Number(0.25) * ((e[0] + e[1]) + (e[2] + e[3]));
    Number best = squared_distance_of_triangle(e[3], e[0], centre);
    for (std::size_t i = 0; i < 3; ++i) best = std::min(best, squared_distance_of_triangle(e[i], e[i + 1], centre));
    return plain_answer(best, pair.bound);
  }
};

}  // namespace gapcheck::bench
