// Stress updates of materials 006 and 063.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "solver/material/material.hpp"

namespace gapcheck::solver {
namespace {

Symmetric without(Symmetric a, const Symmetric& b) {
  for (std::size_t i = 0; i < 6; ++i) a[i] -= b[i];
  return a;
}

/// Twice the energy of a part of the deviator with shear modulus G.
double shear_energy(const Symmetric& deviatoric, double shear) {
  return shear > 0 ? contract(deviatoric, deviatoric) / (4 * shear) : 0;
}

/// (1 − exp(−β dt)) / (β dt)
double relaxing_share(const Viscoelastic& law, double dt) {
  const double passed = law.decay * dt;
  return passed > 0 ? -std::expm1(-passed) / passed : 1;
}

}  // namespace

double CrushableFoam::yield(double compression) const {
  if (compression <= points.front()[0]) return points.front()[1];
  const auto above = std::upper_bound(points.begin() + 1, points.end() - 1, compression,
                                      [](double e, const std::array<double, 2>& point) { return e < point[0]; });
  const auto& [a0, o0] = *(above - 1);
  const auto& [a1, o1] = *above;
  return std::max(o0 + (o1 - o0) * (compression - a0) / (a1 - a0), 0.0);
}

void update_crushable(const Material& material, const Symmetric& increment, PointState& point) {
  const CrushableFoam& law = *material.crushable;
  const Symmetric start = point.stress;
  const double two_shear = 2 * material.shear(), lame = material.bulk() - two_shear / 3;
  for (std::size_t i = 0; i < 6; ++i)
    point.stress[i] += two_shear * increment[i] + (i < 3 ? lame * trace(increment) : 0);
  point.plastic_strain += trace(increment);
  const double yield = law.yield(-std::expm1(point.plastic_strain));
  const Eigen::SelfAdjointEigenSolver<Matrix> trial(to_matrix(point.stress));
  const Vector values = trial.eigenvalues(), limited = values.cwiseMin(law.cutoff).cwiseMax(-yield);
  if (values == limited) return;
  const Matrix& axes = trial.eigenvectors();
  const Symmetric stress = to_symmetric(axes * limited.asDiagonal() * axes.transpose());
  // What Hooke's law does not explain of the step has flowed; the mean stress has done work on it.
  const Symmetric removed = without(point.stress, stress);
  const double mean = trace(removed) / 3, lateral = mean / (3 * material.bulk());
  Symmetric flow = deviator(removed);
  for (std::size_t i = 0; i < 6; ++i) flow[i] = flow[i] / two_shear + (i < 3 ? lateral : 0);
  point.plastic_work += (contract(start, flow) + contract(stress, flow)) / 2;
  point.stress = stress;
}

void update_viscoelastic(const Material& material, const Symmetric& increment, double dt, PointState& point) {
  const Viscoelastic& law = *material.viscoelastic;
  const Symmetric shape = deviator(increment), before = point.back_stress;
  const double kept = std::exp(-law.decay * dt), gain = 2 * law.relaxing_shear * relaxing_share(law, dt);
  Symmetric mean = before;
  for (std::size_t i = 0; i < 6; ++i) {
    point.back_stress[i] = kept * before[i] + gain * shape[i];
    point.stress[i] +=
        point.back_stress[i] - before[i] + 2 * law.long_shear * shape[i] + (i < 3 ? law.bulk * trace(increment) : 0);
    mean[i] = (before[i] + point.back_stress[i]) / 2;
  }
  point.plastic_work += contract(mean, shape) - shear_energy(point.back_stress, law.relaxing_shear) +
                        shear_energy(before, law.relaxing_shear);
}

double update_viscoelastic_plane(const Material& material, Symmetric increment, double dt, PointState& point) {
  const Viscoelastic& law = *material.viscoelastic;
  increment[zz] = 0;
  PointState trial = point;
  update_viscoelastic(material, increment, dt, trial);
  const double shear = law.long_shear + law.relaxing_shear * relaxing_share(law, dt);
  increment[zz] = -trial.stress[zz] / (law.bulk + 4.0 / 3 * shear);
  update_viscoelastic(material, increment, dt, point);
  point.stress[zz] = 0;
  return increment[zz];
}

double elastic_energy(const Material& material, const PointState& point) {
  if (material.orthotropic) return orthotropic_energy(*material.orthotropic, point);
  if (material.rupture > 0) return point.damage < 1 ? elastic_energy(material, point.stress) / (1 - point.damage) : 0;
  if (!material.viscoelastic) return elastic_energy(material, point.stress);
  const Viscoelastic& law = *material.viscoelastic;
  const double mean = trace(point.stress) / 3;
  return mean * mean / (2 * law.bulk) +
         shear_energy(without(deviator(point.stress), point.back_stress), law.long_shear) +
         shear_energy(point.back_stress, law.relaxing_shear);
}

}  // namespace gapcheck::solver
