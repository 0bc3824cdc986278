#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "solver/state/tensor_lanes.hpp"

/// Bricks with one point, one of many: what solid_brick.cpp calculates of their shape, rounded in the same order.
namespace gapcheck::solver::lanes {

/// The four hourglass shapes ηζ, ζξ, ξη, ξηζ at the corners.
constexpr double shapes[4][8] = {{1, 1, -1, -1, -1, -1, 1, 1},
                                 {1, -1, -1, 1, -1, 1, 1, -1},
                                 {1, -1, 1, -1, 1, -1, 1, -1},
                                 {-1, 1, -1, 1, 1, -1, 1, -1}};

/// Of the corners of a brick.
struct Eight {
  Triple at[8];
};
template <std::size_t N>
GAPCHECK_INLINE Eight load(const std::array<std::array<std::array<double, N>, 3>, 8>& rows, std::size_t i) {
  return {{load(rows[0], i), load(rows[1], i), load(rows[2], i), load(rows[3], i), load(rows[4], i), load(rows[5], i),
           load(rows[6], i), load(rows[7], i)}};
}
template <std::size_t N>
GAPCHECK_INLINE void store(std::array<std::array<std::array<double, N>, 3>, 8>& rows, std::size_t i, const Eight& p) {
  store(rows[0], i, p.at[0]);
  store(rows[1], i, p.at[1]);
  store(rows[2], i, p.at[2]);
  store(rows[3], i, p.at[3]);
  store(rows[4], i, p.at[4]);
  store(rows[5], i, p.at[5]);
  store(rows[6], i, p.at[6]);
  store(rows[7], i, p.at[7]);
}

GAPCHECK_INLINE Nine outer_sum(const Eight& p, const Eight& q) {
  Nine sum{zero, zero, zero};
  add_outer(sum, p.at[0], q.at[0]);
  add_outer(sum, p.at[1], q.at[1]);
  add_outer(sum, p.at[2], q.at[2]);
  add_outer(sum, p.at[3], q.at[3]);
  add_outer(sum, p.at[4], q.at[4]);
  add_outer(sum, p.at[5], q.at[5]);
  add_outer(sum, p.at[6], q.at[6]);
  add_outer(sum, p.at[7], q.at[7]);
  return sum;
}

template <int x, int y, int z>
GAPCHECK_INLINE Triple with_signs(Triple a, Triple b, Triple c) {
  return (x < 0 ? -a : a) + (y < 0 ? -b : b) + (z < 0 ? -c : c);
}
GAPCHECK_INLINE Eight centre_slopes(const Eight& p) {
  const Triple low02 = p.at[2] - p.at[0], low13 = p.at[3] - p.at[1], high46 = p.at[6] - p.at[4],
               high57 = p.at[7] - p.at[5];
  const Triple e1 = 0.125 * (low02 - low13 + high46 - high57), e2 = 0.125 * (low02 + low13 + high46 + high57);
  const Triple e3 = 0.125 * (p.at[4] - p.at[0] + p.at[5] - p.at[1] + p.at[6] - p.at[2] + p.at[7] - p.at[3]);
  const Triple a = cross(e2, e3), b = cross(e3, e1), c = cross(e1, e2);
  return {{with_signs<-1, -1, -1>(a, b, c), with_signs<1, -1, -1>(a, b, c), with_signs<1, 1, -1>(a, b, c),
           with_signs<-1, 1, -1>(a, b, c), with_signs<-1, -1, 1>(a, b, c), with_signs<1, -1, 1>(a, b, c),
           with_signs<1, 1, 1>(a, b, c), with_signs<-1, 1, 1>(a, b, c)}};
}

GAPCHECK_INLINE Triple face_part(Triple first, Triple across, Triple second) {
  return cross(first, second) + cross(first, across) + cross(across, second);
}
/// One corner, its neighbours along the edges and the corners across the faces, as in mean_gradient().
GAPCHECK_INLINE Triple mean_slope(Triple p, Triple e0, Triple e1, Triple e2, Triple f0, Triple f1, Triple f2) {
  const Triple a = e0 - p, b = e1 - p, c = e2 - p;
  const Triple sum = zero + face_part(a, f0 - p, b) + face_part(b, f1 - p, c) + face_part(c, f2 - p, a);
  return -sum / 12;
}
GAPCHECK_INLINE Eight mean_slopes(const Eight& p) {
  const auto& q = p.at;
  return {{mean_slope(q[0], q[1], q[3], q[4], q[2], q[7], q[5]), mean_slope(q[1], q[2], q[0], q[5], q[3], q[4], q[6]),
           mean_slope(q[2], q[3], q[1], q[6], q[0], q[5], q[7]), mean_slope(q[3], q[0], q[2], q[7], q[1], q[6], q[4]),
           mean_slope(q[4], q[7], q[5], q[0], q[6], q[1], q[3]), mean_slope(q[5], q[4], q[6], q[1], q[7], q[2], q[0]),
           mean_slope(q[6], q[5], q[7], q[2], q[4], q[3], q[1]), mean_slope(q[7], q[6], q[4], q[3], q[5], q[0], q[2])}};
}

GAPCHECK_INLINE double volume_of(const Eight& x, const Eight& slope) {
  return (0 + dot(x.at[0], slope.at[0]) + dot(x.at[1], slope.at[1]) + dot(x.at[2], slope.at[2]) +
          dot(x.at[3], slope.at[3]) + dot(x.at[4], slope.at[4]) + dot(x.at[5], slope.at[5]) +
          dot(x.at[6], slope.at[6]) + dot(x.at[7], slope.at[7])) /
         3;
}

template <std::size_t m>
GAPCHECK_INLINE Triple shape_sum(const Eight& p) {
  constexpr const double* s = shapes[m];
  return zero + s[0] * p.at[0] + s[1] * p.at[1] + s[2] * p.at[2] + s[3] * p.at[3] + s[4] * p.at[4] + s[5] * p.at[5] +
         s[6] * p.at[6] + s[7] * p.at[7];
}

GAPCHECK_INLINE double squared_diagonals(Triple a, Triple b, Triple c, Triple d) {
  const Triple normal = cross(c - a, d - b);
  return dot(normal, normal);
}
GAPCHECK_INLINE double largest_face(const Eight& p) {
  const auto& q = p.at;
  const double low = squared_diagonals(q[0], q[1], q[2], q[3]), high = squared_diagonals(q[4], q[5], q[6], q[7]),
               front = squared_diagonals(q[0], q[1], q[5], q[4]), right = squared_diagonals(q[1], q[2], q[6], q[5]),
               back = squared_diagonals(q[2], q[3], q[7], q[6]), left = squared_diagonals(q[3], q[0], q[4], q[7]);
  return std::sqrt(larger(larger(larger(low, high), larger(front, right)), larger(back, left))) / 2;
}

}  // namespace gapcheck::solver::lanes
