#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "solver/element/solid.hpp"

namespace gapcheck::solver {
namespace {

BrickModes back_by(const BrickModes& x, double dt, const BrickModes& v) {
  return {x.linear - dt * v.linear, x.pairs - dt * v.pairs, x.all - dt * v.all};
}

void add(BrickModes& sum, double factor, const BrickModes& other) {
  sum.linear += factor * other.linear;
  sum.pairs += factor * other.pairs;
  sum.all += factor * other.all;
}

/// Adds `trace` / 3 to the diagonals in place of the own traces.
void set_trace(EightMatrices& m, double trace) {
  const Eight change = (trace - (m(0, 0) + m(1, 1) + m(2, 2))) / 3;
  for (int i = 0; i < 3; ++i) m(i, i) += change;
}

struct PointWorks {
  double plastic = 0;
  double deviatoric = 0;  ///< with an equation of state
};

EightSymmetric gathered(std::span<const PointState, 8> points, Symmetric PointState::*tensor) {
  EightSymmetric all;
  for (std::size_t p = 0; p < 8; ++p)
    for (std::size_t c = 0; c < 6; ++c) all[c][static_cast<Eigen::Index>(p)] = (points[p].*tensor)[c];
  return all;
}

Symmetric at_point(const EightSymmetric& all, std::size_t point) {
  Symmetric one;
  for (std::size_t c = 0; c < 6; ++c) one[c] = all[c][static_cast<Eigen::Index>(point)];
  return one;
}

/// Turns the stresses with their spins and returns the strains of the step, turned by half: what update_solid_stress()
/// does before the law, at all points at once.
EightSymmetric turn_stresses(const EightMatrices& gradients, double dt, bool shift, std::span<PointState, 8> points) {
  const auto& g = gradients;
  const std::array<Eight, 3> spin{g(2, 1) - g(1, 2), g(0, 2) - g(2, 0), g(1, 0) - g(0, 1)};
  const auto share = [&](double of) { return std::array<Eight, 3>{of * spin[0], of * spin[1], of * spin[2]}; };
  const EightMatrices whole = spin_rotation(share(dt / 2));
  const auto turn = [&](Symmetric PointState::*tensor) {
    const EightSymmetric turned = rotated(gathered(points, tensor), whole);
    for (std::size_t p = 0; p < 8; ++p) points[p].*tensor = at_point(turned, p);
  };
  turn(&PointState::stress);
  if (shift) turn(&PointState::back_stress);
  const double half = dt / 2;
  const EightSymmetric strain{dt * g(0, 0),
                              dt * g(1, 1),
                              dt * g(2, 2),
                              half * (g(0, 1) + g(1, 0)),
                              half * (g(1, 2) + g(2, 1)),
                              half * (g(2, 0) + g(0, 2))};
  return rotated(strain, spin_rotation(share(dt / 4)));
}

/// Whether turn_stresses() and update_stress() are all that update_solid_stress() does.
bool is_plain(const Material& material) {
  return !material.erosion && (material.kind == MaterialKind::elastic || material.kind == MaterialKind::plastic);
}

/// Updates all stresses over the step; returns the works.
PointWorks update_points(const SolidProperties& properties, const BrickMap& middle, const BrickModes& v,
                         double volume_rate, double dt, std::span<PointState, 8> points) {
  EightMatrices gradients = brick_gradients(middle, v);
  set_trace(gradients, volume_rate);
  const bool plain = is_plain(properties.material);
  EightSymmetric strains;
  if (plain) strains = turn_stresses(gradients, dt, properties.material.has_back_stress(), points);
  PointWorks works;
  for (std::size_t p = 0; p < 8; ++p) {
    const double before = points[p].plastic_work, deviatoric = deviatoric_energy(properties.material, points[p]);
    if (plain)
      update_stress(properties.material, at_point(strains, p), dt, points[p]);
    else
      update_solid_stress(properties.material, gradients.at(p), dt, points[p]);
    works.plastic += middle.volume[p] * (points[p].plastic_work - before);
    works.deviatoric += middle.volume[p] * (deviatoric_energy(properties.material, points[p]) - deviatoric);
  }
  return works;
}

/// The forces of the points' stresses with their mean pressure, and of the viscous one.
BrickModes forces_of(const BrickMap& map, double viscous_pressure, std::span<const PointState, 8> points) {
  EightMatrices stresses;
  double mean_trace = 0;
  for (std::size_t p = 0; p < 8; ++p) {
    mean_trace += map.volume[p] / map.total * trace(points[p].stress);
    stresses.set(p, to_matrix(points[p].stress));
  }
  set_trace(stresses, mean_trace - 3 * viscous_pressure);
  return brick_stress_forces(map, stresses);
}

struct RubberForces {
  BrickModes forces;
  RubberBounds bounds;  ///< the stiffness per squared gradient
  double lost = 0;      ///< dissipated in the step by a FiniteLaw
  bool good = true;
};

void raise(RubberBounds& bounds, double stiffness, double viscosity) {
  bounds.stiffness = std::max(bounds.stiffness, stiffness);
  bounds.viscosity = std::max(bounds.viscosity, viscosity);
}

/// Of a point with a FiniteLaw: its stress and bound; adds its energies.
FinitePoint update_finite_point(const Material& material, const Matrix& f, const Matrix& gradient, double dt,
                                double volume, FiniteHistory& history, SolidState& state, double& lost) {
  const double before = history.lost;
  const FinitePoint now = update_finite(*material.finite, f, gradient, dt, history);
  state.strain_energy += volume * now.energy;
  lost += volume * (history.lost - before);
  return now;
}

/// The velocity in the middle of the step.
struct PointRates {
  EightMatrices gradients;
  double dt = 0;
};

/// Stresses, energy and forces of compressible foam: the slopes of Σ V W(F), V of the undeformed points.
RubberForces foam_forces(const Material& material, const BrickModes& x, const PointRates& rates, SolidState& state,
                         std::span<PointState, 8> points) {
  const BrickMap& start = *state.undeformed_brick;
  const EightMatrices all = brick_gradients(start, x);
  RubberForces result;
  EightMatrices nominal;
  state.strain_energy = 0;
  for (std::size_t p = 0; p < 8; ++p) {
    const Matrix gradient = all.at(p);
    const double own = gradient.determinant();
    if (!(own > 0)) {
      result.good = false;
      return result;
    }
    const FinitePoint now = update_finite_point(material, gradient, rates.gradients.at(p), rates.dt, start.volume[p],
                                                state.finite[p], state, result.lost);
    points[p].stress = now.stress;
    nominal.set(p, own * to_matrix(now.stress) * gradient.inverse().transpose());
    raise(result.bounds, now.bound / own, now.viscosity / own);
  }
  result.forces = brick_stress_forces(start, nominal);
  return result;
}

/// Stresses, energy and forces of rubber: the slopes of Σ V W(F̄), V of the undeformed points, F̄ = (J̄ / J)^⅓ F with the
/// volume ratio J̄ of the whole brick.
RubberForces rubber_forces(const Material& material, const BrickMap& now, const BrickModes& x, const PointRates& rates,
                           SolidState& state, std::span<PointState, 8> points) {
  const BrickMap& start = *state.undeformed_brick;
  const EightMatrices all = brick_gradients(start, x);
  const double growth = now.total / start.total;
  RubberForces result;
  EightMatrices nominal;
  double mean_trace = 0;
  state.strain_energy = 0;
  for (std::size_t p = 0; p < 8; ++p) {
    const Matrix gradient = all.at(p);
    const double own = gradient.determinant();
    if (!(own > 0)) {
      result.good = false;
      return result;
    }
    const Matrix f = std::cbrt(growth / own) * gradient;
    double bound = 0, viscosity = 0;
    if (material.finite) {
      const FinitePoint present = update_finite_point(material, f, rates.gradients.at(p), rates.dt, start.volume[p],
                                                      state.finite[p], state, result.lost);
      points[p].stress = present.stress;
      bound = present.bound;
      viscosity = present.viscosity;
    } else {
      points[p].stress = rubber_stress(material.rubber, f);
      state.strain_energy += start.volume[p] * rubber_energy(material.rubber, f);
      bound = rubber_stiffness_bound(material.rubber, f);
    }
    mean_trace += start.volume[p] / start.total * trace(points[p].stress);
    nominal.set(p, growth * to_matrix(deviator(points[p].stress)) * gradient.inverse().transpose());
    const double spread = std::max(1.0, growth * start.volume[p] / now.volume[p]);
    raise(result.bounds, spread * bound / growth, spread * viscosity / growth);
  }
  result.forces = brick_stress_forces(start, nominal);
  add(result.forces, mean_trace / 3, now.slope);
  return result;
}

/// The forces of DAMP of foams; adds its work.
BrickModes damping_forces(const BrickMap& map, double viscosity, const PointRates& rates, double& work) {
  EightMatrices stresses;
  for (std::size_t p = 0; p < 8; ++p) {
    const Symmetric rate = to_symmetric(rates.gradients.at(p));
    stresses.set(p, viscosity * to_matrix(rate));
    work += map.volume[p] * rates.dt * viscosity * contract(rate, rate);
  }
  return brick_stress_forces(map, stresses);
}

/// The sixth of a wedge halved is the least share of a corner; all others have an eighth.
double least_share(SolidRule rule) { return rule == SolidRule::wedge ? 12 : 8; }

}  // namespace

double eight_point_energy(const SolidProperties& properties, const SolidState& state, const std::array<Vector, 8>& x,
                          std::span<const PointState, 8> points) {
  if (properties.material.kind == MaterialKind::rubber) return state.strain_energy;
  if (properties.material.hydro) return fluid_energy(properties.material, state);
  const BrickMap map = brick_map(SolidRule::eight_points, brick_modes(x));
  double energy = 0;
  for (std::size_t p = 0; p < 8; ++p) energy += map.volume[p] * elastic_energy(properties.material, points[p]);
  return energy;
}

SolidForces eight_point_forces(const SolidProperties& properties, SolidRule rule, const SolidCorners& corners,
                               double dt, SolidState& state, std::span<PointState, 8> points) {
  SolidForces out;
  out.force.fill(Vector::Zero());
  const Material& material = properties.material;
  const BrickModes x = brick_modes(corners.x), v = brick_modes(corners.v);
  const BrickMap middle = brick_map(rule, back_by(x, dt / 2, v)), end = brick_map(rule, x);
  out.volume = end.total;
  if (!middle.good || !end.good) return out;
  const double volume_rate = mean_gradient(middle, v).trace();
  const bool rubber = material.kind == MaterialKind::rubber;
  RubberForces of_rubber;
  PointWorks works;
  PointRates rates{{}, dt};
  if (material.finite || material.damping > 0) rates.gradients = brick_gradients(middle, v);
  if (material.finite && material.finite->compressible)
    of_rubber = foam_forces(material, x, rates, state, points);
  else if (rubber)
    of_rubber = rubber_forces(material, end, x, rates, state, points);
  else
    works = update_points(properties, middle, v, volume_rate, dt, points);
  for (std::size_t p = 0; p < 8 && state.imposed != nullptr; ++p)
    points[p].stress = state.imposed->on(points[p].stress);
  if (!of_rubber.good) return out;

  const double density = state.mass / out.volume, length = out.volume / largest_face_area(corners.x);
  const double speed = std::sqrt(solid_stiffness(material, state).wave / density);
  const BulkViscosity viscosity = bulk_viscosity(properties, density, speed, length, volume_rate);
  out.viscous_work = viscous_work(viscosity.pressure, dt * middle.total * volume_rate, state);
  out.dissipated = material.hydro ? 0 : works.plastic + of_rubber.lost + out.viscous_work;
  update_pressure(material, out.volume, works.deviatoric + out.viscous_work, state, points);
  for (PointState& point : points) erode(material, dt, point);
  const SolidStiffness stiffness = solid_stiffness(material, state, of_rubber.bounds);
  const double shear = rubber || !(stiffness.bound > 0) ? 1 : 2 * material.shear() / stiffness.bound;
  set_time_steps(density, length, gradient_bound(end, x, 1, shear) / out.volume, least_share(rule), viscosity,
                 stiffness, out);
  out.manual_step = length / std::sqrt(stiffness.wave / density);

  if (rubber)
    add(of_rubber.forces, -viscosity.pressure, end.slope);
  else
    of_rubber.forces = forces_of(end, viscosity.pressure, points);
  if (viscosity.damping > 0) add(of_rubber.forces, 1, damping_forces(end, viscosity.damping, rates, out.dissipated));
  out.force = corner_forces(of_rubber.forces);
  out.good = std::isfinite(out.force[0].sum() + out.force[6].sum());
  return out;
}

}  // namespace gapcheck::solver
