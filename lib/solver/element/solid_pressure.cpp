#include <algorithm>
#include <cmath>

#include "solver/element/solid.hpp"
#include "solver/material/erosion.hpp"

namespace gapcheck::solver {
namespace {

/// Bounds the modulus from below where an equation of state has no slope, as a share of that at rest.
constexpr double least_modulus_share = 1e-3;

void set_pressure(double pressure, bool keep_deviator, std::span<PointState> points) {
  for (PointState& point : points) {
    if (point.failed) continue;
    point.stress = keep_deviator ? deviator(point.stress) : Symmetric{};
    for (const std::size_t i : {xx, yy, zz}) point.stress[i] -= pressure;
  }
}

/// The material has spalled at this pressure.
bool spalls(const Hydrodynamic& hydro, double pressure, std::span<const PointState> points) {
  if (hydro.spall == Spall::pressure) return pressure < hydro.cutoff;
  if (hydro.spall != Spall::principal) return false;
  return std::any_of(points.begin(), points.end(), [&](const PointState& point) {
    return greatest_principal_value(deviator(point.stress)) - pressure >= -hydro.cutoff;
  });
}

}  // namespace

SolidStiffness solid_stiffness(const Material& material, const SolidState& state, const RubberBounds& rubber) {
  if (rubber.stiffness > 0) return {material.wave_modulus(), rubber.stiffness, rubber.stiffness / 3, rubber.viscosity};
  if (!material.hydro)
    return {material.wave_modulus(), std::max(3 * material.bulk(), 2 * material.shear()), material.bulk()};
  const FluidState& fluid = state.fluid;
  const EquationOfState& law = material.hydro->state;
  const double least = least_modulus_share * material.bulk(), shear = material.shear();
  const double bulk = std::max(law.bulk(fluid.volume, fluid.energy), least);
  const double bound = std::max(law.bulk_bound(fluid.volume, fluid.energy), bulk);
  return {bulk + 4.0 / 3 * shear, std::max(3 * bound, 2 * shear), bound};
}

double deviatoric_energy(const Material& material, const PointState& point) {
  return material.hydro ? elastic_energy(material, point.stress) + point.plastic_work : 0;
}

double fluid_energy(const Material& material, const SolidState& state) {
  return state.fluid.reference_volume * (state.fluid.energy - material.hydro->state.initial_energy);
}

void update_pressure(const Material& material, double volume, double work, SolidState& state,
                     std::span<PointState> points) {
  if (!material.hydro) return;
  const Hydrodynamic& hydro = *material.hydro;
  FluidState& fluid = state.fluid;
  const double relative = volume / fluid.reference_volume, growth = relative - fluid.volume;
  const PressureLine line = hydro.state.at(relative);
  const double known = fluid.energy - growth / 2 * fluid.pressure + work / fluid.reference_volume;
  double pressure = line.pressure(known) / (1 + line.thermal * growth / 2);
  if (!fluid.spalled && spalls(hydro, pressure, points)) fluid.spalled = true;
  pressure = std::max(pressure, fluid.spalled ? 0 : hydro.cutoff);
  fluid.energy = known - growth / 2 * pressure;
  fluid.pressure = pressure;
  fluid.volume = relative;
  set_pressure(pressure, !fluid.spalled, points);
  if (relative > hydro.least_volume && relative < hydro.largest_volume) return;
  for (PointState& point : points) {
    point.failed = true;
    point.stress = {};
  }
}

}  // namespace gapcheck::solver
