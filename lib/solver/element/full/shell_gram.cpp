#include "solver/element/full/shell_gram.hpp"

#include <algorithm>

namespace gapcheck::solver {
double largest_eigenvalue(const Eigen::Matrix3d& a) {
  const double mean = a.trace() / 3;
  const Eigen::Matrix3d rest = a - mean * Eigen::Matrix3d::Identity();
  const double size = std::sqrt(rest.squaredNorm() / 6);
  if (!(size > 0)) return mean;
  const double cosine = std::clamp(rest.determinant() / (2 * size * size * size), -1.0, 1.0);
  return mean + 2 * size * std::cos(std::acos(cosine) / 3);
}

double QuadGram::gradient() const {
  Eigen::Matrix3d a;
  a(0, 0) = xi.sum();
  a(1, 1) = eta.sum();
  a(0, 1) = a(1, 0) = both.sum();
  a(0, 2) = a(2, 0) = (point_eta * xi + point_xi * both).sum();
  a(1, 2) = a(2, 1) = (point_eta * both + point_xi * eta).sum();
  // Both places squared are 1/3 at every point.
  a(2, 2) = ((xi + eta) / 3 + 2 * point_xi * point_eta * both).sum();
  return largest_eigenvalue(a) / 4;
}

double QuadGram::shear(const Vector& along, const Vector& across, const Vector& skew, double inertia) const {
  // Shear along ξ: mean and slope over η; along η: mean and slope over ξ.
  Eigen::Matrix4d energy;
  energy.setZero();
  energy(0, 0) = xi.sum();
  energy(0, 1) = (point_eta * xi).sum();
  energy(0, 2) = both.sum();
  energy(0, 3) = (point_xi * both).sum();
  energy(1, 1) = energy(0, 0) / 3;
  energy(1, 2) = (point_eta * both).sum();
  energy(1, 3) = (point_xi * point_eta * both).sum();
  energy(2, 2) = eta.sum();
  energy(2, 3) = (point_xi * eta).sum();
  energy(3, 3) = energy(2, 2) / 3;
  energy = Eigen::Matrix4d(energy.selfadjointView<Eigen::Upper>());
  // Each of these four by the deflections and rotations, whose squares are over their masses.
  const double i = 1 / inertia, aa = i * along.squaredNorm(), cc = i * across.squaredNorm(),
               ss = i * skew.squaredNorm();
  const double as = i * along.dot(skew), cs = i * across.dot(skew), ac = i * along.dot(across);
  Eigen::Matrix4d motion;
  motion << 1 + aa + ss, 2 * as, ac, as,  //
      2 * as, 1 + aa + ss, cs, 1 + ss,    //
      ac, cs, 1 + cc + ss, 2 * cs,        //
      as, 1 + ss, 2 * cs, 1 + cc + ss;
  // The eigenvalues of the product are none below zero: the eighth root of the sum of their eighth powers is a bound.
  Eigen::Matrix4d power = energy * motion / 4;
  power = Eigen::Matrix4d(power * power);
  power = Eigen::Matrix4d(power * power);
  return std::sqrt(std::sqrt(std::sqrt(power.cwiseProduct(power.transpose()).sum())));
}

}  // namespace gapcheck::solver
