#include "solver/element/solid.hpp"

#include <cmath>
#include <utility>

namespace gapcheck::solver {

Matrix update_solid_stress(const Material& material, const Matrix& gradient, double dt, PointState& point) {
  const Vector spin(gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0), gradient(1, 0) - gradient(0, 1));
  Matrix rotation = spin_rotation(dt / 2 * spin);
  if (material.erosion) {
    const Symmetric increment = rotated(to_symmetric(gradient), spin_rotation(dt / 4 * spin));
    point.strain = rotated(point.strain, rotation);
    for (std::size_t i = 0; i < 6; ++i) point.strain[i] += dt * increment[i];
  }
  if (material.has_stress() && material.kind != MaterialKind::rubber) {
    point.stress = rotated(point.stress, rotation);
    if (material.has_back_stress()) point.back_stress = rotated(point.back_stress, rotation);
    Symmetric increment = to_symmetric(gradient);
    for (double& value : increment) value *= dt;
    // The strain belongs to the middle of the step, the stress is in the axes of its end: half of the turn.
    update_stress(material, rotated(increment, spin_rotation(dt / 4 * spin)), dt, point);
  }
  return rotation;
}

BulkViscosity bulk_viscosity(const SolidProperties& properties, double density, double speed, double length,
                             double volume_rate) {
  const double total =
      properties.quadratic_viscosity * length * std::abs(volume_rate) + properties.linear_viscosity * speed;
  const auto& hydro = properties.material.hydro;
  const double of_shear = hydro ? 2 * hydro->viscosity / (density * length) : 0;  // damps like it
  return {volume_rate < 0 ? density * length * -volume_rate * total : 0, total + of_shear,
          properties.material.damping * density * length * speed};
}

double viscous_work(double pressure, double volume_change, SolidState& state) {
  const double before = std::exchange(state.viscous_pressure, pressure);
  return -(before + pressure) / 2 * volume_change;
}

namespace {

/// What the nodal mean stresses of a tetrahedron store more than their mean, per volume.
double spread_energy(const SolidProperties& properties, const SolidState& state) {
  const std::array<double, 4>& all = state.mean_stress;
  const double mean = (all[0] + all[1] + all[2] + all[3]) / 4;
  double sum = 0;
  for (const double one : all) sum += (one - mean) * (one - mean) / 4;
  return sum > 0 ? sum / (2 * properties.material.bulk()) : 0;
}

}  // namespace

double stored_energy(const SolidProperties& properties, const SolidState& state, double volume,
                     const PointState& point) {
  const bool rubber = properties.material.kind == MaterialKind::rubber;
  double energy = rubber ? state.strain_energy : volume * elastic_energy(properties.material, point);
  if (properties.material.hydro) energy = fluid_energy(properties.material, state);
  if (properties.rules.tetrahedron == SolidRule::nodal_pressure) energy += volume * spread_energy(properties, state);
  if (state.reference && state.reference->stiffness > 0)
    for (const Vector& stress : state.hourglass) energy += stress.squaredNorm() / (2 * state.reference->stiffness);
  if (state.reference && state.reference->assumed) energy += state.reference->assumed->energy(state.hourglass);
  return energy;
}

RubberBounds update_rubber(const Material& material, const Matrix& axes, double volume, const Matrix& gradient,
                           double dt, SolidState& state, PointState& point) {
  const Matrix f = axes * *state.undeformed;
  const double growth = f.determinant();
  if (material.finite) {
    FiniteHistory& history = state.finite[0];
    const double lost = history.lost;
    const FinitePoint now = update_finite(*material.finite, f, gradient, dt, history);
    point.stress = now.stress;
    point.plastic_work += (history.lost - lost) / growth;
    state.strain_energy = volume / growth * now.energy;
    return {now.bound / growth, now.viscosity / growth};
  }
  point.stress = rubber_stress(material.rubber, f);
  state.strain_energy = volume / growth * rubber_energy(material.rubber, f);
  return {rubber_stiffness_bound(material.rubber, f) / growth, 0};
}

void set_time_steps(double density, double length, double squared_gradient, double corners,
                    const BulkViscosity& viscosity, const SolidStiffness& stiffness, SolidForces& forces) {
  const double speed = std::sqrt(stiffness.wave / density), q = viscosity.step_speed;
  forces.manual_step = length / (q + std::sqrt(q * q + speed * speed));
  // The strain energy is at most max(3 K, 2 G) |∇u|² / 2; each corner has 1 / corners of the mass. Damping at the
  // fraction ξ of the critical shortens the step by √(1 + ξ²) − ξ. The viscosity gives ρ l Q per volume rate where the
  // stiffness gives at least K per volume strain, so that ξ is at most ω ρ l Q / (2 K).
  // The damping of foams, and stresses by the rate, have the viscosity η for each strain rate where the bound is the
  // stiffness: ω η / (2 bound).
  const double squared_frequency = stiffness.bound / density * corners * squared_gradient;
  double fraction =
      stiffness.volume > 0 ? std::sqrt(squared_frequency) * density * length * q / (2 * stiffness.volume) : 0;
  if (stiffness.bound > 0)
    fraction += std::sqrt(squared_frequency) * (viscosity.damping + stiffness.viscosity) / (2 * stiffness.bound);
  forces.stable_step = 2 / std::sqrt(squared_frequency) * (std::sqrt(1 + fraction * fraction) - fraction);
}

}  // namespace gapcheck::solver
