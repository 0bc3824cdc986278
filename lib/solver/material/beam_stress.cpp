#include "solver/material/beam_stress.hpp"

#include <cmath>

#include "solver/material/falling_root.hpp"

namespace gapcheck::solver {
namespace {

/// The trial stress relative to the centre of the yield surface; its parts shrink by 1 / (1 + stiffness m), m = Δε̄/q.
struct BeamTrial {
  double axial, squared_shear;
  double axial_stiffness, shear_stiffness;

  [[nodiscard]] double size(double m) const {
    const double a = axial / (1 + axial_stiffness * m), s = 1 + shear_stiffness * m;
    return std::sqrt(a * a + 3 * squared_shear / (s * s));
  }
};

/// Δε̄/q. q falls with m and m q rises, so there is one solution where the yield stress does not fall.
double return_ratio(const BeamTrial& trial, const StepYield& yield, double plastic_strain) {
  const double size = trial.size(0);
  if (trial.squared_shear == 0 || trial.axial == 0) {
    const double stiffness = trial.axial == 0 ? trial.shear_stiffness : trial.axial_stiffness;
    const double increment = yield.solve(size, stiffness, plastic_strain).increment;
    return increment / (size - stiffness * increment);
  }
  const auto excess = [&](double m) {
    const double left = trial.size(m);
    return left - yield.after(plastic_strain, m * left);
  };
  return falling_root(excess, 0, 1e-3 / trial.axial_stiffness, 1e-15 * size);
}

void flow(const Material& material, const StepYield& yield, const BeamTensor& start, BeamPoint& point) {
  BeamTensor relative;
  for (std::size_t i = 0; i < 3; ++i) relative[i] = point.stress[i] - point.back_stress[i];
  const double shear = material.shear(), kinematic = material.kinematic_slope;
  const BeamTrial trial{relative[0], relative[1] * relative[1] + relative[2] * relative[2], material.young + kinematic,
                        3 * shear + kinematic};
  if (!(trial.size(0) > yield.stress(point.plastic_strain))) return;
  const double m = return_ratio(trial, yield, point.plastic_strain);
  for (std::size_t i = 0; i < 3; ++i) {
    const double left = relative[i] / (1 + (i == 0 ? trial.axial_stiffness : trial.shear_stiffness) * m);
    const double plastic = (i == 0 ? 1 : 3) * m * left;  // engineering shear
    point.stress[i] -= (i == 0 ? material.young : shear) * plastic;
    point.back_stress[i] += kinematic * m * left;
    point.plastic_work += plastic * (start[i] + point.stress[i]) / 2;
  }
  point.plastic_strain += m * trial.size(m);
}

}  // namespace

void update_beam_stress(const Material& material, const BeamTensor& increment, double dt, BeamPoint& point) {
  if (!material.has_stress() || point.failed) return;
  const BeamTensor start = point.stress;
  const double shear = material.shear();
  for (std::size_t i = 0; i < 3; ++i) point.stress[i] += (i == 0 ? material.young : shear) * increment[i];
  if (material.kind != MaterialKind::plastic) return;
  const double squared = increment[0] * increment[0] + (increment[1] * increment[1] + increment[2] * increment[2]) / 2;
  flow(material, StepYield(material, dt > 0 ? std::sqrt(squared) / dt : 0, dt), start, point);
  if (!(material.failure_strain > 0) || !(point.plastic_strain >= material.failure_strain)) return;
  point.failed = true;
  point.stress = point.back_stress = {};
}

double elastic_energy(const Material& material, const BeamTensor& stress) {
  if (!material.has_stress()) return 0;
  return stress[0] * stress[0] / (2 * material.young) +
         (stress[1] * stress[1] + stress[2] * stress[2]) / (2 * material.shear());
}

}  // namespace gapcheck::solver
