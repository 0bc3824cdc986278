#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace gapcheck::bench {

/// A facet, a point and a contact distance in one precision. A triangle repeats its third corner.
template <class Number>
struct ContactPair {
  using Point = Eigen::Matrix<Number, 3, 1>;
  std::array<Point, 4> x;
  Point query;
  Number bound = 0;
  bool triangle = false;
};

/// What a method says of a pair.
template <class Number>
struct Answer {
  Number distance = 0;
  bool closer = false;  ///< distance < bound
};

/// The answer of methods that prove nothing: squares are compared as they come out.
template <class Number>
[[nodiscard]] Answer<Number> plain_answer(Number squared_distance, Number bound) {
  return {std::sqrt(squared_distance), squared_distance < bound * bound};
}

/// The corners less the query.
template <class Number>
[[nodiscard]] std::array<typename ContactPair<Number>::Point, 4> seen_from_query(const ContactPair<Number>& pair) {
  return {pair.x[0] - pair.query, pair.x[1] - pair.query, pair.x[2] - pair.query, pair.x[3] - pair.query};
}

}  // namespace gapcheck::bench
