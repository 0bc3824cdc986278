#pragma once
#include <array>

#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// A number at each of the eight Gauss points of a brick, by the corner that a point is next to.
using Eight = Eigen::Array<double, 8, 1>;

/// A matrix at each of these points, component by component, so that one instruction serves several points.
struct EightMatrices {
  std::array<Eight, 9> component;
  [[nodiscard]] Eight& operator()(int row, int column) { return component[place(row, column)]; }
  [[nodiscard]] const Eight& operator()(int row, int column) const { return component[place(row, column)]; }

  /// The matrix at one point.
  [[nodiscard]] Matrix at(std::size_t point) const {
    Matrix m;
    for (std::size_t c = 0; c < 9; ++c) m.data()[c] = component[c][static_cast<Eigen::Index>(point)];
    return m;
  }
  void set(std::size_t point, const Matrix& m) {
    for (std::size_t c = 0; c < 9; ++c) component[c][static_cast<Eigen::Index>(point)] = m.data()[c];
  }

 private:
  static constexpr std::size_t place(int row, int column) { return static_cast<std::size_t>(3 * column + row); }
};

/// a b at each point.
inline EightMatrices operator*(const EightMatrices& a, const EightMatrices& b) {
  EightMatrices product;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) product(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
  return product;
}

/// a bᵀ at each point.
inline EightMatrices times_transposed(const EightMatrices& a, const EightMatrices& b) {
  EightMatrices product;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) product(i, j) = a(i, 0) * b(j, 0) + a(i, 1) * b(j, 1) + a(i, 2) * b(j, 2);
  return product;
}

/// One matrix times that at each point.
inline EightMatrices operator*(const Matrix& a, const EightMatrices& b) {
  EightMatrices product;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) product(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
  return product;
}

/// det M M⁻ᵀ at each point.
inline EightMatrices cofactor(const EightMatrices& m) {
  EightMatrices result;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      const int k = (j + 1) % 3, l = (j + 2) % 3, p = (i + 1) % 3, q = (i + 2) % 3;
      result(i, j) = m(p, k) * m(q, l) - m(q, k) * m(p, l);
    }
  return result;
}

/// The determinants of matrices with these cofactors.
inline Eight determinant(const EightMatrices& m, const EightMatrices& cofactors) {
  return m(0, 0) * cofactors(0, 0) + m(1, 0) * cofactors(1, 0) + m(2, 0) * cofactors(2, 0);
}

/// The inverses of matrices with these cofactors and determinants.
inline EightMatrices inverse(const EightMatrices& cofactors, const Eight& determinants) {
  EightMatrices result;
  const Eight reciprocal = 1 / determinants;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) result(i, j) = cofactors(j, i) * reciprocal;
  return result;
}

/// Symmetric tensors at the points, components as in Symmetric.
using EightSymmetric = std::array<Eight, 6>;

/// R a Rᵀ at each point.
inline EightSymmetric rotated(const EightSymmetric& a, const EightMatrices& r) {
  EightMatrices half;  // R a
  for (int i = 0; i < 3; ++i) {
    half(i, 0) = r(i, 0) * a[xx] + r(i, 1) * a[xy] + r(i, 2) * a[zx];
    half(i, 1) = r(i, 0) * a[xy] + r(i, 1) * a[yy] + r(i, 2) * a[yz];
    half(i, 2) = r(i, 0) * a[zx] + r(i, 1) * a[yz] + r(i, 2) * a[zz];
  }
  const auto entry = [&](int i, int j) {
    return Eight(half(i, 0) * r(j, 0) + half(i, 1) * r(j, 1) + half(i, 2) * r(j, 2));
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)};
}

/// spin_rotation() of each point's axial vector.
inline EightMatrices spin_rotation(const std::array<Eight, 3>& w) {
  const std::array<Eight, 3> half{w[0] / 2, w[1] / 2, w[2] / 2};
  const Eight square = half[0] * half[0] + half[1] * half[1] + half[2] * half[2], factor = 2 / (1 + square);
  EightMatrices r;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const int row = static_cast<int>(i), next = static_cast<int>(j);
    const Eight both = half[i] * half[j];
    r(row, row) = 1 - factor * (square - half[i] * half[i]);
    r(row, next) = factor * (both - half[k]);
    r(next, row) = factor * (both + half[k]);
  }
  return r;
}

}  // namespace gapcheck::solver
