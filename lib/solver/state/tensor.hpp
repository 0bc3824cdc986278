#pragma once
#include <array>
#include <cmath>

#include "base/vector.hpp"

namespace gapcheck::solver {

/// Symmetric tensor, components xx yy zz xy yz zx. Strains are tensor components too: no factor 2 in the shear.
using Symmetric = std::array<double, 6>;
using Matrix = Eigen::Matrix3d;

enum Component : std::size_t { xx, yy, zz, xy, yz, zx };

inline double trace(const Symmetric& a) { return a[xx] + a[yy] + a[zz]; }

/// a : b
inline double contract(const Symmetric& a, const Symmetric& b) {
  return a[xx] * b[xx] + a[yy] * b[yy] + a[zz] * b[zz] + 2 * (a[xy] * b[xy] + a[yz] * b[yz] + a[zx] * b[zx]);
}

inline Symmetric deviator(const Symmetric& a) {
  const double mean = trace(a) / 3;
  return {a[xx] - mean, a[yy] - mean, a[zz] - mean, a[xy], a[yz], a[zx]};
}

inline Matrix to_matrix(const Symmetric& a) {
  Matrix m;
  m << a[xx], a[xy], a[zx], a[xy], a[yy], a[yz], a[zx], a[yz], a[zz];
  return m;
}

inline Symmetric to_symmetric(const Matrix& m) {
  return {m(0, 0), m(1, 1), m(2, 2), (m(0, 1) + m(1, 0)) / 2, (m(1, 2) + m(2, 1)) / 2, (m(2, 0) + m(0, 2)) / 2};
}

/// R a Rᵀ
inline Symmetric rotated(const Symmetric& a, const Matrix& r) { return to_symmetric(r * to_matrix(a) * r.transpose()); }

/// a × as a matrix
inline Matrix cross_matrix(const Vector& a) {
  Matrix m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

/// The rotation that a mid-step spin increment W (skew) represents: (I − W/2)⁻¹ (I + W/2), exactly orthogonal. Hughes
/// and Winget, Int. J. Numer. Meth. Engng 15 (1980). Closed form for the axial vector w of W.
inline Matrix spin_rotation(const Vector& w) {
  const Vector half = w / 2;
  const Matrix cross = cross_matrix(half);
  return Matrix::Identity() + 2 / (1 + half.squaredNorm()) * (cross + cross * cross);
}

}  // namespace gapcheck::solver
