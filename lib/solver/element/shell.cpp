#include "solver/element/shell.hpp"

namespace gapcheck::solver {

ShellResultants integrate_layers(const ShellProperties& properties, const ShellStrain& strain, double dt,
                                 double& thickness, std::span<PointState> points) {
  ShellResultants sum;
  const double half = thickness / 2;
  double through = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [place, weight] = properties.layers[i];
    const double z = half * place;
    if (dt > 0) {
      const Symmetric increment{strain.xx + z * strain.bend_xx,
                                strain.yy + z * strain.bend_yy,
                                0,
                                strain.xy + z * strain.bend_xy,
                                strain.yz,
                                strain.zx};
      const double before = points[i].plastic_work;
      through += weight / 2 * update_plane_stress(properties.material, increment, dt, points[i]);
      sum.plastic_work += half * weight * (points[i].plastic_work - before);
    }
    const Symmetric& stress = points[i].stress;
    const double share = half * weight, lever = share * z;
    sum.xx += share * stress[xx];
    sum.yy += share * stress[yy];
    sum.xy += share * stress[xy];
    sum.bend_xx += lever * stress[xx];
    sum.bend_yy += lever * stress[yy];
    sum.bend_xy += lever * stress[xy];
    sum.yz += share * stress[yz];
    sum.zx += share * stress[zx];
  }
  // Mid-step rule for ṫ = t ε̇zz.
  if (properties.thins) thickness *= (1 + through / 2) / (1 - through / 2);
  sum.yz *= properties.shear_factor;
  sum.zx *= properties.shear_factor;
  return sum;
}

double stored_energy(const ShellProperties& properties, const ShellState& state, double area,
                     std::span<const PointState> points) {
  double energy = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Symmetric stress = points[i].stress;
    for (const std::size_t transverse : {yz, zx}) stress[transverse] *= std::sqrt(properties.shear_factor);
    energy += area * state.thickness / 2 * properties.layers[i].weight * elastic_energy(properties.material, stress);
  }
  for (std::size_t i = 0; i < state.hourglass.size(); ++i)
    if (state.stiffness[i] > 0) energy += state.hourglass[i] * state.hourglass[i] / (2 * state.stiffness[i]);
  return energy;
}

namespace {

/// Upper bound of the squared frequency: the larger eigenvalue of what motion in the plane and across it do together,
/// from the squares that they have alone and those that the warp adds to each.
double coupled(double membrane, double across, double by_plane, double by_deflection) {
  if (!(by_plane + by_deflection > 0)) return std::max(membrane, across);
  const double link = std::sqrt(membrane * by_deflection) + std::sqrt(across * by_plane);
  const double a = membrane + by_plane, b = across + by_deflection, half = (a - b) / 2;
  return (a + b) / 2 + std::sqrt(half * half + link * link);
}

}  // namespace

void set_time_steps(const ShellProperties& properties, const ShellShape& shape, ShellForces& forces) {
  const Material& material = properties.material;
  const double squared_speed = material.plate_modulus() / material.density;
  forces.manual_step = std::sqrt(shape.squared_length / squared_speed);
  // The strain energy is at most plate (1 + |ν|) |∇u|²; each corner has 1 / corners of the mass. Bending and transverse
  // shear share the rotations, so their bounds add up.
  const double membrane = squared_speed * (1 + std::abs(material.poisson)) * shape.gradient;
  const double bending =
      membrane * shape.thickness * shape.thickness / 12 / rotational_inertia(shape.area, shape.thickness);
  const double transverse = properties.shear_factor * material.shear() / material.density * shape.shear;
  const WarpShape& warp = shape.warp;
  const double squared_curvature = warp.curvature * warp.curvature * shape.thickness * shape.thickness / 12;
  const double by_plane = membrane * squared_curvature + properties.shear_factor * material.shear() / material.density *
                                                             shape.gradient * warp.tilt * warp.tilt;
  const double by_deflection = membrane * warp.slope * warp.slope;
  forces.stable_step = 2 / std::sqrt(shape.corners * coupled(membrane, bending + transverse, by_plane, by_deflection));
}

}  // namespace gapcheck::solver
