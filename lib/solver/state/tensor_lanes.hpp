#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "base/triple.hpp"

/// Tensors of one of many elements: what tensor.hpp and Eigen's matrices do, rounded in the same order.
namespace gapcheck::solver::lanes {

using gapcheck::load;
using gapcheck::store;

constexpr Triple zero{0, 0, 0};

/// A matrix by rows. Eigen adds up the third row of a product from the right, others from the left.
struct Nine {
  Triple r0, r1, r2;
};
GAPCHECK_INLINE double dot_from_right(Triple p, Triple q) { return p.x * q.x + (p.y * q.y + p.z * q.z); }
GAPCHECK_INLINE Triple operator*(const Nine& m, Triple p) {
  return {dot(m.r0, p), dot(m.r1, p), dot_from_right(m.r2, p)};
}
GAPCHECK_INLINE double trace(const Nine& m) { return m.r0.x + (m.r1.y + m.r2.z); }

/// As Symmetric.
struct Tensor {
  double xx, yy, zz, xy, yz, zx;
};
template <std::size_t N>
GAPCHECK_INLINE Tensor load(const std::array<std::array<double, N>, 6>& rows, std::size_t i) {
  return {rows[0][i], rows[1][i], rows[2][i], rows[3][i], rows[4][i], rows[5][i]};
}
template <std::size_t N>
GAPCHECK_INLINE void store(std::array<std::array<double, N>, 6>& rows, std::size_t i, const Tensor& a) {
  rows[0][i] = a.xx;
  rows[1][i] = a.yy;
  rows[2][i] = a.zz;
  rows[3][i] = a.xy;
  rows[4][i] = a.yz;
  rows[5][i] = a.zx;
}
/// Of matrices by row.
template <std::size_t N>
GAPCHECK_INLINE Nine load(const std::array<std::array<std::array<double, N>, 3>, 3>& rows, std::size_t i) {
  return {load(rows[0], i), load(rows[1], i), load(rows[2], i)};
}
template <std::size_t N>
GAPCHECK_INLINE void store(std::array<std::array<std::array<double, N>, 3>, 3>& rows, std::size_t i, const Nine& m) {
  store(rows[0], i, m.r0);
  store(rows[1], i, m.r1);
  store(rows[2], i, m.r2);
}
GAPCHECK_INLINE Tensor symmetric(const Nine& m) {
  return {m.r0.x, m.r1.y, m.r2.z, (m.r0.y + m.r1.x) / 2, (m.r1.z + m.r2.y) / 2, (m.r2.x + m.r0.z) / 2};
}
GAPCHECK_INLINE Nine matrix(const Tensor& a) { return {{a.xx, a.xy, a.zx}, {a.xy, a.yy, a.yz}, {a.zx, a.yz, a.zz}}; }

/// rotated()
GAPCHECK_INLINE Tensor turned(const Tensor& tensor, const Nine& r) {
  const Nine a = matrix(tensor);
  const Triple t0 = r.r0.x * a.r0 + r.r0.y * a.r1 + r.r0.z * a.r2;
  const Triple t1 = r.r1.x * a.r0 + r.r1.y * a.r1 + r.r1.z * a.r2;
  const Triple t2 = r.r2.x * a.r0 + (r.r2.y * a.r1 + r.r2.z * a.r2);
  return symmetric({{dot(t0, r.r0), dot(t0, r.r1), dot(t0, r.r2)},
                    {dot(t1, r.r0), dot(t1, r.r1), dot(t1, r.r2)},
                    {dot_from_right(t2, r.r0), dot_from_right(t2, r.r1), dot_from_right(t2, r.r2)}});
}

/// spin_rotation()
GAPCHECK_INLINE Nine rotation_of(Triple w) {
  const Triple h = 0.5 * w;
  const double xx = h.x * h.x, yy = h.y * h.y, zz = h.z * h.z, factor = 2 / (1 + (xx + yy + zz));
  const double xy = h.x * h.y, yz = h.y * h.z, zx = h.z * h.x;
  return {{1 + factor * (0 + (-zz - yy)), 0 + factor * (-h.z + xy), 0 + factor * (h.y + zx)},
          {0 + factor * (h.z + xy), 1 + factor * (0 + (-zz - xx)), 0 + factor * (-h.x + yz)},
          {0 + factor * (-h.y + zx), 0 + factor * (h.x + yz), 1 + factor * (0 + (-yy - xx))}};
}

GAPCHECK_INLINE void add_outer(Nine& sum, Triple p, Triple q) {
  sum.r0 = sum.r0 + p.x * q;
  sum.r1 = sum.r1 + p.y * q;
  sum.r2 = sum.r2 + p.z * q;
}

/// Largest row sum of the absolute values of a symmetric matrix.
GAPCHECK_INLINE double row_bound(const Nine& m) {
  const double xx = std::abs(m.r0.x), yy = std::abs(m.r1.y), zz = std::abs(m.r2.z), xy = std::abs(m.r0.y),
               yz = std::abs(m.r1.z), zx = std::abs(m.r0.z);
  return larger(larger(xx + (xy + zx), xy + (yy + yz)), zx + (yz + zz));
}

}  // namespace gapcheck::solver::lanes
