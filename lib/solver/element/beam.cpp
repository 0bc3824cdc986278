#include "solver/element/beam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapcheck::solver {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Stiffness of one bending plane: M = first * own rotation + second * that of the other end.
struct Bending {
  double first, second;
  double shear_ratio;  ///< 12 E I / (G A_s L²)
};

Bending bending(const BeamProperties& properties, double moment_of_area, double length) {
  const double stiffness = properties.material.young * moment_of_area / length;
  const double shear = properties.material.shear() * properties.section.shear_area;
  const double ratio = shear > 0 ? 12 * stiffness / (shear * length) : 0;
  return {stiffness * (4 + ratio) / (1 + ratio), stiffness * (2 - ratio) / (1 + ratio), ratio};
}

/// The moments at both ends in one plane. A hinge turns so that it has none.
std::array<double, 2> end_moments(const Bending& plane, const std::array<double, 2>& turn,
                                  const std::array<bool, 2>& released) {
  if (released[0] && released[1]) return {0, 0};
  const double hinged = plane.first - plane.second * plane.second / plane.first;
  if (released[0]) return {0, hinged * turn[1]};
  if (released[1]) return {hinged * turn[0], 0};
  return {plane.first * turn[0] + plane.second * turn[1], plane.first * turn[1] + plane.second * turn[0]};
}

double axial_step(const BeamProperties& properties, double length) {
  const Material& material = properties.material;
  return material.has_stress() && material.young > 0 ? length / std::sqrt(material.young / material.density) : no_limit;
}

/// 2 / ω of the highest of the beam's uncoupled modes: stretching, twisting, bending of one sign and of two.
double bending_step(const BeamProperties& properties, double length, double start_length) {
  const Material& material = properties.material;
  const model::BeamSection& section = properties.section;
  const double mass = beam_mass(properties, start_length) / 2;
  const double inertia = mass * beam_inertia(properties, start_length);
  double squared_frequency = 2 * material.young * section.area / (start_length * mass);
  squared_frequency = std::max(squared_frequency, 2 * material.shear() * section.torsion / (start_length * inertia));
  for (const double area : {section.iss, section.itt}) {
    const double stiffness = material.young * area / start_length;
    const double ratio = bending(properties, area, start_length).shear_ratio;
    squared_frequency = std::max({squared_frequency, 2 * stiffness / inertia,
                                  6 * stiffness / (1 + ratio) * (1 / inertia + 4 / (mass * length * length))});
  }
  return 2 / std::sqrt(squared_frequency);
}

/// The axial stress after a strain increment.
void update_axial_stress(const Material& material, double increment, double dt, BeamState& state) {
  const double start = state.stress;
  state.stress += material.young * increment;
  if (material.kind != MaterialKind::plastic) return;
  const StepYield yield(material, dt > 0 ? std::abs(increment) / dt : 0, dt);
  const double relative = state.stress - state.back_stress, size = std::abs(relative);
  if (!(size > yield.stress(state.plastic_strain))) return;
  const double kinematic = material.kinematic_slope;
  const double plastic = yield.solve(size, material.young + kinematic, state.plastic_strain).increment;
  const double sign = relative > 0 ? 1 : -1;
  state.stress -= sign * material.young * plastic;
  state.back_stress += sign * kinematic * plastic;
  state.plastic_strain += plastic;
  state.plastic_work += sign * plastic * (start + state.stress) / 2;
}

/// Turns the axes and adds up the rotations of the ends relative to them.
void turn_beam(const BeamEnds& ends, const Vector& way, const Vector& along, double dt, BeamState& state) {
  const BeamTurn turn = turn_axes(ends, way, along, dt, state.axis);
  state.twist += turn.twist;
  for (std::size_t end = 0; end < 2; ++end) {
    state.turn_s[end] += turn.turn_s[end];
    state.turn_t[end] += turn.turn_t[end];
  }
}

}  // namespace

BeamTurn turn_axes(const BeamEnds& ends, const Vector& way, const Vector& along, double dt, Vector& axis) {
  BeamTurn sum;
  const Vector rate = ends.v[1] - ends.v[0];
  const Vector middle = way - dt / 2 * rate;
  const double squared_length = middle.squaredNorm();
  if (!(squared_length > 0)) return sum;
  const Vector r = middle / std::sqrt(squared_length);
  const Vector spin = middle.cross(rate) / squared_length + r.dot(ends.w[0] + ends.w[1]) / 2 * r;
  const Vector turned = spin_rotation(spin * dt) * axis;
  const Vector mean = axis + turned, s = (mean - mean.dot(r) * r).normalized(), t = r.cross(s);
  sum.twist = dt * r.dot(ends.w[1] - ends.w[0]);
  for (std::size_t end = 0; end < 2; ++end) {
    const Vector turn = dt * (ends.w[end] - spin);
    sum.turn_s[end] = turn.dot(s);
    sum.turn_t[end] = turn.dot(t);
  }
  axis = (turned - turned.dot(along) * along).normalized();
  return sum;
}

double stored_energy(const BeamProperties& properties, const BeamState& state, double length) {
  const Material& material = properties.material;
  const model::BeamSection& section = properties.section;
  if (!material.has_stress()) return 0;
  if (properties.truss) return section.area * length * state.stress * state.stress / (2 * material.young);
  const double elongation = length - state.length;
  const double stretch = state.released.axial ? 0 : elongation, twist = state.released.twist ? 0 : state.twist;
  double energy =
      (material.young * section.area * stretch * stretch + material.shear() * section.torsion * twist * twist) /
      (2 * state.length);
  const auto add = [&](double moment_of_area, const std::array<double, 2>& turn, const std::array<bool, 2>& released) {
    const Bending plane = bending(properties, moment_of_area, state.length);
    if (released[0] || released[1]) {
      const std::array<double, 2> moment = end_moments(plane, turn, released);
      energy += (moment[0] * turn[0] + moment[1] * turn[1]) / 2;
      return;
    }
    energy += plane.first / 2 * (turn[0] * turn[0] + turn[1] * turn[1]) + plane.second * turn[0] * turn[1];
  };
  add(section.iss, state.turn_s, state.released.turn_s);
  add(section.itt, state.turn_t, state.released.turn_t);
  return energy;
}

double beam_mass(const BeamProperties& properties, double length) {
  return length * (properties.material.density * properties.section.area + properties.section.line_mass);
}

double beam_inertia(const BeamProperties& properties, double length) {
  const model::BeamSection& section = properties.section;
  if (properties.truss) return 0;
  const double least = std::max(length * length / 12, (section.iss + section.itt) / section.area);
  if (!properties.integrated()) return least;
  constexpr double stiffest_shear = 0.9;  // of an absurd SHRF
  const double ratio =
      std::min(properties.shear_factor * properties.material.shear() / properties.material.young, stiffest_shear);
  return std::max(least, length * length / 4 * ratio / (1 - ratio));
}

BeamForces truss_forces(const BeamProperties& properties, const BeamEnds& ends, double dt, BeamState& state) {
  BeamForces forces;
  const Vector way = ends.x[1] - ends.x[0];
  const double length = way.norm(), before = (way - dt * (ends.v[1] - ends.v[0])).norm();
  if (!(length > 0) || !std::isfinite(length) || !(before > 0)) return forces;
  forces.good = true;
  forces.manual_step = forces.stable_step = axial_step(properties, length);
  const Material& material = properties.material;
  if (!material.has_stress()) return forces;
  const double flowed = state.plastic_work;
  update_axial_stress(material, 2 * (length - before) / (length + before), dt, state);
  forces.dissipated = properties.section.area * (length + before) / 2 * (state.plastic_work - flowed);
  const double area = properties.section.area, half_mass = beam_mass(properties, state.length) / 2;
  forces.axial = state.stress * area;
  forces.force[1] = forces.axial / length * way;
  forces.force[0] = -forces.force[1];
  // The geometric stiffness of a taut truss acts across, the material's along.
  const double stiffness = std::max(material.young * area / length, std::abs(forces.axial) / length);
  forces.stable_step = 2 / std::sqrt(2 * stiffness / half_mass);
  return forces;
}

BeamForces resultant_beam_forces(const BeamProperties& properties, const BeamEnds& ends, double dt, BeamState& state) {
  BeamForces forces;
  const Vector way = ends.x[1] - ends.x[0];
  const double length = way.norm();
  if (!(length > 0) || !std::isfinite(length)) return forces;
  const Vector r = way / length;
  if (dt > 0) turn_beam(ends, way, r, dt, state);
  forces.good = state.axis.allFinite();
  forces.manual_step = axial_step(properties, length);
  forces.stable_step = no_limit;
  const Material& material = properties.material;
  if (!material.has_stress()) return forces;
  const model::BeamSection& section = properties.section;
  const Vector &s = state.axis, t = r.cross(s);
  const Bending about_s = bending(properties, section.iss, state.length);
  const Bending about_t = bending(properties, section.itt, state.length);
  const BeamReleases& released = state.released;
  forces.axial = released.axial ? 0 : material.young * section.area * (length - state.length) / state.length;
  const double torsion = released.twist ? 0 : material.shear() * section.torsion / state.length * state.twist;
  const std::array<double, 2> moment_s = end_moments(about_s, state.turn_s, released.turn_s),
                              moment_t = end_moments(about_t, state.turn_t, released.turn_t);
  for (std::size_t end = 0; end < 2; ++end)
    forces.moment[end] = (end == 0 ? -torsion : torsion) * r + moment_s[end] * s + moment_t[end] * t;
  // Shear from the balance of moments.
  forces.force[1] =
      forces.axial * r + (moment_s[0] + moment_s[1]) / length * t - (moment_t[0] + moment_t[1]) / length * s;
  forces.force[0] = -forces.force[1];
  forces.stable_step = bending_step(properties, length, state.length);
  return forces;
}

}  // namespace gapcheck::solver
