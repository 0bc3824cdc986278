#include <algorithm>
#include <cmath>

#include "solver/material/material.hpp"

namespace gapcheck::solver {
namespace {

/// A tensor in the plane in axes that are turned by `angle`; transverse components turn as a vector.
Symmetric turned_in_plane(const Symmetric& a, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * c * a[xx] + s * s * a[yy] + 2 * c * s * a[xy],
          s * s * a[xx] + c * c * a[yy] - 2 * c * s * a[xy],
          a[zz],
          (c * c - s * s) * a[xy] + c * s * (a[yy] - a[xx]),
          c * a[yz] - s * a[zx],
          c * a[zx] + s * a[yz]};
}

/// Without the principal stresses in the plane that are below zero.
Symmetric tension_of(const Symmetric& stress) {
  const double mean = (stress[xx] + stress[yy]) / 2, half = (stress[xx] - stress[yy]) / 2;
  const double radius = std::hypot(half, stress[xy]), high = mean + radius, low = mean - radius;
  if (low >= 0) return stress;
  if (high <= 0) return {0, 0, 0, 0, stress[yz], stress[zx]};
  // high · n n, n n = (1 + (σ − mean) / radius) / 2.
  const double share = high / 2;
  return {
      share * (1 + half / radius), share * (1 - half / radius), 0, share * stress[xy] / radius, stress[yz], stress[zx]};
}

}  // namespace

double update_orthotropic_plane(const Material& material, const Symmetric& increment, PointState& point) {
  const OrthotropicPlane& law = *material.orthotropic;
  const Symmetric strain = turned_in_plane(increment, point.axis);
  const double poisson_ab = law.poisson_ba * law.ea / law.eb, determinant = 1 - poisson_ab * law.poisson_ba;
  Symmetric stress{};
  stress[xx] = law.ea / determinant * (strain[xx] + law.poisson_ba * strain[yy]);
  stress[yy] = law.eb / determinant * (strain[yy] + poisson_ab * strain[xx]);
  stress[xy] = 2 * law.gab * strain[xy];
  stress[yz] = 2 * law.gbc * strain[yz];
  stress[zx] = 2 * law.gca * strain[zx];
  const double through = -law.thinning_a * stress[xx] - law.thinning_b * stress[yy];
  const Symmetric growth = turned_in_plane(stress, -point.axis);
  Symmetric& whole = law.only_tension ? point.back_stress : point.stress;
  for (std::size_t i = 0; i < 6; ++i) whole[i] += growth[i];
  if (law.only_tension) point.stress = tension_of(point.back_stress);
  return through;
}

double orthotropic_energy(const OrthotropicPlane& law, const PointState& point) {
  const Symmetric stress = turned_in_plane(point.stress, point.axis);
  const auto part = [](double value, double modulus) { return modulus > 0 ? value * value / modulus : 0; };
  return (part(stress[xx], law.ea) + part(stress[yy], law.eb) - 2 * law.poisson_ba / law.eb * stress[xx] * stress[yy] +
          part(stress[xy], law.gab) + part(stress[yz], law.gbc) + part(stress[zx], law.gca)) /
         2;
}

}  // namespace gapcheck::solver
