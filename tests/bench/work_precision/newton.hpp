#pragma once
#include <string>

#include "patch.hpp"

namespace gapcheck::bench {

/// A fixed number of Newton steps on the bilinear patch from its centre, without proof. Triangles as triangles.
template <class Number, int steps>
struct Newton {
  [[nodiscard]] static std::string name() { return "Newton " + std::to_string(steps); }
  [[nodiscard]] static Answer<Number> answer(const ContactPair<Number>& pair) {
    using Point = typename ContactPair<Number>::Point;
    const auto e = seen_from_query(pair);
    if (pair.triangle) return plain_answer(squared_distance_of_triangle(e[0], e[1], e[2]), pair.bound);
    const BilinearPatch<Point> patch(e);
    Number s = 0, t = 0;
    for (int i = 0; i < steps; ++i) {
      const Point along_s = patch.a + t * patch.c, along_t = patch.b + s * patch.c;
      const Point r = patch.m + s * patch.a + t * along_t;
      const Number slope_s = r.dot(along_s), slope_t = r.dot(along_t);
      const Number ss = along_s.squaredNorm(), tt = along_t.squaredNorm(), st = along_s.dot(along_t) + r.dot(patch.c);
      const Number determinant = ss * tt - st * st;
      s += (st * slope_t - tt * slope_s) / determinant;
      t += (st * slope_s - ss * slope_t) / determinant;
    }
    return plain_answer(squared_distance_at(e, patch, s, t), pair.bound);
  }
};

}  // namespace gapcheck::bench
