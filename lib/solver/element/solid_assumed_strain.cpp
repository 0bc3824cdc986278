#include "solver/element/solid_assumed_strain.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

/// The strains that are linear in direction k, by the two other directions i and j.
struct PlateStrain {
  Eigen::Index i, j;
  double along_i = 0, along_j = 0, twist = 0;
};

PlateStrain plate_strain(const Vector& s, const BrickModeAmplitudes& q, Eigen::Index k) {
  const Eigen::Index i = (k + 1) % 3, j = (k + 2) % 3;
  const auto mode = [&](Eigen::Index m) -> const Vector& { return q[static_cast<std::size_t>(m)]; };
  // Mode m is the product of the two directions other than m.
  return {i, j, mode(j)[i] / s[i], mode(i)[j] / s[j], mode(i)[i] / s[j] + mode(j)[j] / s[i]};
}

}  // namespace

double AssumedStrain::energy(const BrickModeAmplitudes& q) const {
  double sum = single * q[3].cwiseQuotient(half_side).squaredNorm();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const PlateStrain e = plate_strain(half_side, q, k);
    sum += bending * (e.along_i * e.along_i + e.along_j * e.along_j + 2 * poisson * e.along_i * e.along_j) +
           twisting * e.twist * e.twist;
  }
  return sum / 2;
}

BrickModeAmplitudes AssumedStrain::forces(const BrickModeAmplitudes& q) const {
  BrickModeAmplitudes f;
  f.fill(Vector::Zero());
  const Vector& s = half_side;
  f[3] = single * q[3].cwiseQuotient(s).cwiseQuotient(s);
  for (Eigen::Index k = 0; k < 3; ++k) {
    const PlateStrain e = plate_strain(s, q, k);
    Vector &of_i = f[static_cast<std::size_t>(e.i)], &of_j = f[static_cast<std::size_t>(e.j)];
    of_j[e.i] += bending * (e.along_i + poisson * e.along_j) / s[e.i];
    of_i[e.j] += bending * (e.along_j + poisson * e.along_i) / s[e.j];
    of_i[e.i] += twisting * e.twist / s[e.j];
    of_j[e.j] += twisting * e.twist / s[e.i];
  }
  return f;
}

double AssumedStrain::bound() const {
  const Vector inverse = half_side.cwiseInverse();
  const double largest = inverse.maxCoeff(), squared = largest * largest;
  return std::max({bending * (1 + std::abs(poisson)) * squared, single * squared, 4 * twisting * squared});
}

AssumedStrain assumed_strain(double coefficient, double shear, double bulk, double volume, const Vector& half_side) {
  AssumedStrain result;
  result.half_side = half_side;
  if (!(shear > 0 && bulk > 0)) return result;
  const double young = 9 * bulk * shear / (3 * bulk + shear), part = coefficient * volume;
  result.poisson = (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
  result.bending = young / (1 - result.poisson * result.poisson) * part / 3;
  result.twisting = shear * part / 3;
  result.single = young * part / 9;
  return result;
}

Matrix polar_rotation(const Matrix& a) {
  // Newton's method (Higham 1986) with his scaling.
  Matrix r = a;
  for (int pass = 0; pass < 20; ++pass) {
    const Matrix inverse = r.inverse().transpose();
    const double scale = std::sqrt(inverse.norm() / r.norm());
    const Matrix next = (scale * r + inverse / scale) / 2;
    const double change = (next - r).squaredNorm();
    r = next;
    if (!(change > 1e-28)) break;
  }
  return r;
}

Matrix polar_turn(const Matrix& a, const Matrix& r, const Vector& m) {
  // With the turn θ in the axes r: (tr S − S) θ is the vector of Rᵀ δa − δaᵀ R.
  const Matrix s = r.transpose() * a;
  const Matrix k = s.trace() * Matrix::Identity() - (s + s.transpose()) / 2;
  const Vector g = k.inverse() * Vector(r.transpose() * m);
  return r * cross_matrix(g);
}

}  // namespace gapcheck::solver
