#pragma once
#include "geometry/batch/pair_kernel.hpp"

namespace gapcheck::bench {
namespace {

constexpr int steps_to_settle = 8;

template <class V>
inline void plain_quads(geometry::PairArrays& p, std::size_t first) {
  using namespace geometry;
  const auto e0 = load<V>(p.corner[0], first), e1 = load<V>(p.corner[1], first), e2 = load<V>(p.corner[2], first),
             e3 = load<V>(p.corner[3], first);
  const auto low = e0 + e1, high = e3 + e2, right = e1 - e0, left = e2 - e3;
  const V quarter = all<V>(0.25);
  const auto m = quarter * (low + high), a = quarter * (right + left), b = quarter * (high - low),
             c = quarter * (left - right);
  const Products<V> g(m, a, b, c);
  Trials<V> at = stationary_point(g, steps_to_settle);
  if (bits<V>(~at.inside) != 0) move_to_border(g, at);
  const V bound = load<V>(p.bound + first);
  p.closer |= bits<V>(g.squared_distance(at.s, at.t) < bound * bound) << first;
}

template <class V>
inline void plain_triangles(geometry::PairArrays& p, std::size_t first) {
  using namespace geometry;
  const auto e = load<V>(p.corner[0], first), u = load<V>(p.corner[1], first) - e, v = load<V>(p.corner[2], first) - e;
  const V ee = dot(e, e), eu = dot(e, u), ev = dot(e, v), uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
  const V unit = 1.0 / (uu * vv - uv * uv);
  const V x = (uv * ev - vv * eu) * unit, y = (uv * eu - uu * ev) * unit;
  const Mask<V> inside = (x > 0.0) & (y > 0.0) & (x + y < 1.0);
  V square = ee + x * (2.0 * eu + x * uu) + y * (2.0 * ev + y * vv) + 2.0 * x * y * uv;
  if (bits<V>(~inside) != 0) {
    const V on_u = clamped<V>(-eu / uu, 0, 1), on_v = clamped<V>(-ev / vv, 0, 1);
    const V to_v = vv - uv - (uv - uu), from_u = ev - eu + uv - uu, third = clamped<V>(-from_u / to_v, 0, 1);
    const V by_u = ee + on_u * (2.0 * eu + on_u * uu), by_v = ee + on_v * (2.0 * ev + on_v * vv);
    const V by_third = (ee + 2.0 * eu + uu) + third * (2.0 * from_u + third * to_v);
    square = inside ? square : smaller(by_third, smaller(by_u, by_v));
  }
  const V bound = load<V>(p.bound + first);
  p.closer |= bits<V>(square < bound * bound) << first;
}

template <std::size_t N>
inline void plain_all(geometry::PairArrays& p, bool triangles) {
  p.closer = 0;
  for (std::size_t first = 0; first < p.size; first += N)
    triangles ? plain_triangles<geometry::Lanes<N>>(p, first) : plain_quads<geometry::Lanes<N>>(p, first);
  p.apart = ~p.closer;
}

}  // namespace
}  // namespace gapcheck::bench
