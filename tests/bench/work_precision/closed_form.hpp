#pragma once
#include <string>

#include "patch.hpp"

namespace gapcheck::bench {

/// The projection along the normal of the mean plane, which is the root of a quadratic equation: exact for flat quads.
/// Triangles as triangles.
template <class Number>
struct ClosedForm {
  [[nodiscard]] static std::string name() { return "closed form"; }
  [[nodiscard]] static Answer<Number> answer(const ContactPair<Number>& pair) {
    using Point = typename ContactPair<Number>::Point;
    const auto e = seen_from_query(pair);
    if (pair.triangle) return plain_answer(squared_distance_of_triangle(e[0], e[1], e[2]), pair.bound);
    const BilinearPatch<Point> patch(e);
    // In the plane spanned by a and b: query = s₀ a + t₀ b from the centre, c = α a + β b.
    const Number aa = patch.a.squaredNorm(), bb = patch.b.squaredNorm(), ab = patch.a.dot(patch.b);
    const Number determinant = aa * bb - ab * ab;
    const auto coordinates = [&](const Point& v) {
      const Number va = v.dot(patch.a), vb = v.dot(patch.b);
      return std::array{(bb * va - ab * vb) / determinant, (aa * vb - ab * va) / determinant};
    };
    const auto [alpha, beta] = coordinates(patch.c);
    const auto [s0, t0] = coordinates(-patch.m);
    // s + α s t = s₀ and t + β s t = t₀, s eliminated: α t² + p t - t₀ = 0; the root that stays finite as α vanishes.
    const Number p = 1 + beta * s0 - alpha * t0;
    const Number root = std::sqrt(p * p + 4 * alpha * t0);
    const Number t = 2 * t0 / (p + root);
    const Number s = s0 / (1 + alpha * t);
    return plain_answer(squared_distance_at(e, patch, s, t), pair.bound);
  }
};

}  // namespace gapcheck::bench
