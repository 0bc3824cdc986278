#pragma once
#include <Eigen/LU>
#include <array>

#include "base/vector.hpp"

namespace gapcheck::solver {

/// What a warped quad has besides the flat one in the mean of its corners (Belytschko, Wong and Chiang, Comput. Methods
/// Appl. Mech. Engng 96, 1992; LS-DYNA Theory Manual, "Belytschko–Wong–Chiang Improvements"): normals at the corners,
/// by whose change over the quad motion in its plane bends it. `full`: the projection that takes the rigid rotation out
/// of the motion (Belytschko and Leviathan, ibid. 115, 1994), fitted to the corners' places; otherwise the rotations
/// about the normals alone are taken out.
class ShellWarping {
 public:
  /// `axes`: of the quad, e3 normal to both diagonals.
  ShellWarping(const std::array<Vector, 4>& x, const Vector& e1, const Vector& e2, double area, bool full)
      : full_(full) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector& at = x[i];
      normal_[i] = Vector(x[(i + 1) % 4] - at).cross(x[(i + 3) % 4] - at).normalized();
      // Where two sides are in line, or two corners the same, there is no normal: that of the quad has no effect.
      if (!normal_[i].allFinite() || normal_[i].dot(e1.cross(e2)) < least_cosine) normal_[i] = e1.cross(e2);
    }
    const Vector n13 = normal_[0] - normal_[2], n24 = normal_[1] - normal_[3];
    const double half = 1 / (2 * area);
    cx1 = half * n24.dot(e2);
    cx2 = -half * n13.dot(e2);
    cy1 = -half * n24.dot(e1);
    cy2 = half * n13.dot(e1);
    if (full) fit(x);
  }

  /// ∂²N/∂x∂z of corners 1 and 2 at the mid-surface; 3 and 4 have the opposite.
  double cx1 = 0, cx2 = 0, cy1 = 0, cy2 = 0;

  /// Takes out of the corners' velocities what must not strain the quad.
  void project(std::array<Vector, 4>& v, std::array<Vector, 4>& w) const {
    Vector turn = Vector::Zero();
    if (full_) {
      for (std::size_t i = 0; i < 4; ++i) turn += place_[i].cross(v[i]);
      turn = inverse_ * turn;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      if (full_) v[i] -= turn.cross(place_[i]);
      w[i] -= turn;
      w[i] -= w[i].dot(normal_[i]) * normal_[i];
    }
  }
  /// The transpose, for forces and moments.
  void transpose(std::array<Vector, 4>& force, std::array<Vector, 4>& moment) const {
    Vector sum = Vector::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      moment[i] -= moment[i].dot(normal_[i]) * normal_[i];
      sum += moment[i];
    }
    if (!full_) return;
    for (std::size_t i = 0; i < 4; ++i) sum += place_[i].cross(force[i]);
    const Vector turn = inverse_ * sum;
    for (std::size_t i = 0; i < 4; ++i) force[i] -= turn.cross(place_[i]);
  }
  /// The largest square of what the normals have in the plane with the normal e3.
  [[nodiscard]] double squared_tilt(const Vector& e3) const {
    double largest = 0;
    for (const Vector& n : normal_) largest = std::max(largest, 1 - n.dot(e3) * n.dot(e3));
    return largest;
  }

 private:
  static constexpr double least_cosine = 0.1;

  void fit(const std::array<Vector, 4>& x) {
    const Vector mean = (x[0] + x[1] + x[2] + x[3]) / 4;
    Matrix inertia = Matrix::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      place_[i] = x[i] - mean;
      inertia += place_[i].squaredNorm() * Matrix::Identity() - place_[i] * place_[i].transpose();
    }
    inverse_ = inertia.inverse();
  }

  bool full_;
  std::array<Vector, 4> normal_, place_;
  Matrix inverse_ = Matrix::Zero();
};

}  // namespace gapcheck::solver
