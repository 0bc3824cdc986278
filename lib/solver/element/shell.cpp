#include "solver/element/shell.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/quad.hpp"

namespace gapcheck::solver {

ShellForces ShellForces::none() {
  ShellForces none;
  none.good = true;
  none.manual_step = none.stable_step = std::numeric_limits<double>::infinity();
  none.force.fill(Vector::Zero());
  none.moment.fill(Vector::Zero());
  return none;
}

bool is_folded(const std::array<Vector, 4>& x) {
  if (x[2] == x[3]) return false;
  const Vector normal = quad_normal(x);
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector next = x[(k + 1) % 4] - x[k], last = x[(k + 3) % 4] - x[k];
    if (!(next.cross(last).dot(normal) > 0)) return true;
  }
  return false;
}

namespace {

/// The part of a step's plastic work that transverse shear did: its work less what it stores more than before.
double transverse_plastic_work(const Material& material, const Symmetric& increment, const PointState& before,
                               const PointState& after) {
  const auto stored = [&](PointState point) {
    for (const std::size_t in_plane : {xx, yy, zz, xy}) point.stress[in_plane] = point.back_stress[in_plane] = 0;
    return elastic_energy(material, point);
  };
  double work = 0;
  for (const std::size_t c : {yz, zx}) work += (before.stress[c] + after.stress[c]) * increment[c];
  return work - (stored(after) - stored(before));
}

/// Updates a point; returns its strain through the thickness. `plastic_work`: gets that of the step with the shear
/// factor on transverse shear, which the resultants have too.
double update_layer(const Material& material, const Symmetric& increment, double dt, double shear_factor,
                    PointState& point, double& plastic_work) {
  const double worked = point.plastic_work, damage = point.damage;
  const Symmetric stress = point.stress, back_stress = point.back_stress;
  const double through = update_plane_stress(material, increment, dt, point);
  plastic_work = point.plastic_work - worked;
  if (shear_factor == 1 || plastic_work == 0 || point.failed) return through;
  PointState before = point;
  before.stress = stress;
  before.back_stress = back_stress;
  before.damage = damage;
  plastic_work -= (1 - shear_factor) * transverse_plastic_work(material, increment, before, point);
  return through;
}

}  // namespace

namespace {

/// Adds the stresses of a layer at height z with this share of the thickness.
void add_layer(const Symmetric& stress, double share, double z, ShellResultants& sum) {
  const double lever = share * z;
  sum.xx += share * stress[xx];
  sum.yy += share * stress[yy];
  sum.xy += share * stress[xy];
  sum.bend_xx += lever * stress[xx];
  sum.bend_yy += lever * stress[yy];
  sum.bend_xy += lever * stress[xy];
  sum.yz += share * stress[yz];
  sum.zx += share * stress[zx];
}

Symmetric increment_at(const ShellStrain& strain, double z) {
  return {strain.xx + z * strain.bend_xx,
          strain.yy + z * strain.bend_yy,
          0,
          strain.xy + z * strain.bend_xy,
          strain.yz,
          strain.zx};
}

/// Shells whose points follow Hooke's law alone. Returns the mean strain through the thickness.
double integrate_linear(const ShellProperties& properties, const ShellStrain& strain, double thickness,
                        std::span<PointState> points, ShellResultants& sum) {
  const PlaneModuli moduli(properties.material);
  const double half = thickness / 2, shift = half * properties.reference;
  double through = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [place, weight] = properties.layers[i];
    const double z = half * place - shift;
    through += weight / 2 * moduli.add(increment_at(strain, z), points[i].stress);
    add_layer(points[i].stress, half * weight, z, sum);
  }
  return through;
}

/// All other shells. dt = 0: sums the stresses up.
double integrate_points(const ShellProperties& properties, const ShellStrain& strain, double dt, double thickness,
                        std::span<PointState> points, ShellResultants& sum) {
  const double half = thickness / 2, shift = half * properties.reference;
  const bool composite = !properties.layer_materials.empty();
  double through = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [place, weight] = properties.layers[i];
    const double z = half * place - shift;
    const Material& material = composite ? properties.layer_materials[i] : properties.material;
    if (dt > 0) {
      const double mean = points[i].stress[xx] + points[i].stress[yy];
      double flowed = 0;
      double across = update_layer(material, increment_at(strain, z), dt, properties.shear_factor, points[i], flowed);
      if (properties.thins_by_flow)  // without the elastic strain −ν/E (σxx + σyy)
        across += material.poisson / material.young * (points[i].stress[xx] + points[i].stress[yy] - mean);
      through += weight / 2 * across;
      sum.plastic_work += half * weight * flowed;
    }
    add_layer(points[i].stress, half * weight, z, sum);
  }
  return through;
}

}  // namespace

ShellResultants integrate_layers(const ShellProperties& properties, const ShellStrain& whole, double dt,
                                 double& thickness, std::span<PointState> points) {
  ShellResultants sum;
  const ShellStrain strain = properties.membrane ? ShellStrain{.xx = whole.xx, .yy = whole.yy, .xy = whole.xy} : whole;
  const bool linear =
      dt > 0 && properties.layer_materials.empty() && properties.material.linear() && !properties.thins_by_flow;
  const double through = linear ? integrate_linear(properties, strain, thickness, points, sum)
                                : integrate_points(properties, strain, dt, thickness, points, sum);
  // Mid-step rule for ṫ = t ε̇zz.
  if (properties.thins) thickness *= (1 + through / 2) / (1 - through / 2);
  sum.yz *= properties.shear_factor;
  sum.zx *= properties.shear_factor;
  if (properties.membrane) sum.bend_xx = sum.bend_yy = sum.bend_xy = 0;
  return sum;
}

bool fails(const ShellProperties& properties, std::span<const PointState> own, double time) {
  // Points of other materials are not looked at: that costs as much as their stresses.
  if (own.empty() || (properties.layer_materials.empty() && !properties.material.can_fail())) return false;
  if (std::all_of(own.begin(), own.end(), [](const PointState& p) { return p.failed; })) return true;
  const std::optional<Erosion>& erosion = properties.material.erosion;
  if (!erosion) return false;
  if (past_time(erosion, time)) return true;
  const auto eroded = [](const PointState& p) { return p.eroded; };
  if (erosion->points > 0) return static_cast<double>(std::count_if(own.begin(), own.end(), eroded)) >= erosion->points;
  // A layer counts with the first of its points in the plane.
  const std::size_t layers = properties.layers.size();
  std::size_t gone = 0;
  for (std::size_t layer = 0; layer < layers; ++layer)
    for (std::size_t point = layer; point < own.size(); point += layers)
      if (own[point].eroded) {
        ++gone;
        break;
      }
  return static_cast<double>(gone) >= -erosion->points / 100 * static_cast<double>(layers);
}

double stored_energy(const ShellProperties& properties, const ShellState& state, double area,
                     std::span<const PointState> points) {
  double energy = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    PointState point = points[i];
    for (const std::size_t transverse : {yz, zx}) {
      point.stress[transverse] *= std::sqrt(properties.shear_factor);
      point.back_stress[transverse] *= std::sqrt(properties.shear_factor);
    }
    const Material& material = properties.layer_materials.empty() ? properties.material : properties.layer_materials[i];
    energy += area * state.thickness / 2 * properties.layers[i].weight * elastic_energy(material, point);
  }
  for (std::size_t i = 0; i < state.hourglass.size(); ++i)
    if (state.stiffness[i] > 0) energy += state.hourglass[i] * state.hourglass[i] / (2 * state.stiffness[i]);
  return energy;
}

void add_bulk_viscosity(const ShellProperties& properties, double area, double strain, double dt, ShellState& state,
                        ShellResultants& resultants, ShellForces& out) {
  const ShellViscosity& viscosity = properties.viscosity;
  if (!(area > 0)) return;
  const Material& material = properties.material;
  const double length = std::sqrt(area), rate = dt > 0 ? strain / dt : 0;
  out.damping_speed = viscosity.quadratic * length * std::abs(rate) +
                      viscosity.linear * std::sqrt(material.plate_modulus() / material.density);
  const double pressure = rate < 0 ? material.density * length * -rate * out.damping_speed : 0;
  const double before = std::exchange(state.viscous_pressure, pressure);
  const double work = -area * state.thickness * strain * (before + pressure) / 2;
  out.dissipated += work;
  if (!viscosity.in_energy) out.viscous_work += work;
  resultants.xx -= state.thickness * pressure;
  resultants.yy -= state.thickness * pressure;
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

ShellFrequency squared_frequency(const ShellProperties& properties, const ShellShape& shape) {
  const Material& material = properties.material;
  const double squared_speed = material.plate_modulus() / material.density;
  // The strain energy is at most plate (1 + |ν|) |∇u|²; each corner has 1 / corners of the mass. Bending and transverse
  // shear share the rotations, so their bounds add up.
  const double membrane = properties.stiffest * squared_speed * (1 + std::abs(material.poisson)) * shape.gradient;
  const double squared_thickness = shape.thickness * shape.thickness, reference = properties.reference;
  const double inertia = properties.inertia(shape.area, shape.thickness);
  // Of membranes too, whose step is then shorter than need be where they are thick.
  const double bending = membrane * squared_thickness / 12 / inertia;
  const double transverse =
      properties.stiffest * properties.shear_factor * material.shear() / material.density * shape.shear;
  const WarpShape& warp = shape.warp;
  const double squared_curvature = warp.curvature * warp.curvature * squared_thickness / 12;
  const double by_plane = membrane * squared_curvature + properties.shear_factor * material.shear() / material.density *
                                                             shape.gradient * warp.tilt * warp.tilt;
  const double by_deflection = membrane * warp.slope * warp.slope;
  // Where the mid-surface is off the nodes, or the layers differ, bending and stretching are coupled: their sum bounds
  // both.
  double in_plane = membrane, across = bending + transverse;
  if (reference != 0 || !properties.layer_materials.empty()) {
    in_plane = membrane * (1 + squared_thickness * reference * reference / 4 / inertia) + bending;
    across = in_plane + transverse;
  }
  return {shape.corners * coupled(in_plane, across, by_plane, by_deflection),
          shape.corners * std::max({membrane, bending, transverse})};
}

void set_time_steps(const ShellProperties& properties, const ShellShape& shape, double squared_frequency,
                    ShellForces& forces) {
  const Material& material = properties.material;
  forces.manual_step = std::sqrt(shape.squared_length * material.density / material.plate_modulus());
  forces.stable_step = 2 / std::sqrt(squared_frequency);
  if (forces.damping_speed > 0) {
    // As in solids: ρ l Q per rate of the area where the stiffness gives E / 2 (1 − ν) per strain of it.
    const double stiffness = material.plate_modulus() * (1 + material.poisson) / 2;
    const double fraction =
        material.density * std::sqrt(shape.area) * forces.damping_speed / (stiffness * forces.stable_step);
    forces.stable_step *= std::sqrt(1 + fraction * fraction) - fraction;
  }
}

void set_time_steps(const ShellProperties& properties, const ShellShape& shape, ShellForces& forces) {
  set_time_steps(properties, shape, squared_frequency(properties, shape).bound, forces);
}

}  // namespace gapcheck::solver
