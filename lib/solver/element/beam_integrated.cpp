#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/element/beam.hpp"

namespace gapcheck::solver {
namespace {

/// Strains of a step that are the same all over the cross-section, and curvatures.
struct BeamStrain {
  double stretch = 0, shear_s = 0, shear_t = 0;
  double twist = 0, curve_s = 0, curve_t = 0;

  [[nodiscard]] BeamTensor at(const Fiber& fiber) const {
    return {stretch + curve_s * fiber.t - curve_t * fiber.s, shear_s - twist * fiber.t, shear_t + twist * fiber.s};
  }
};

BeamStrain step_strain(const BeamProperties& properties, const BeamTurn& turn, double before, double length) {
  const double mean = (length + before) / 2, root = std::sqrt(properties.shear_factor);
  BeamStrain strain;
  strain.stretch = (length - before) / mean;
  strain.curve_s = (turn.turn_s[1] - turn.turn_s[0]) / mean;
  strain.curve_t = (turn.turn_t[1] - turn.turn_t[0]) / mean;
  strain.shear_s = -root * (turn.turn_t[0] + turn.turn_t[1]) / 2;
  strain.shear_t = root * (turn.turn_s[0] + turn.turn_s[1]) / 2;
  if (!properties.torsion_free) strain.twist = turn.twist / mean;
  return strain;
}

WeldResultants section_resultants(const BeamProperties& properties, std::span<const BeamPoint> points) {
  const double root = std::sqrt(properties.shear_factor);
  WeldResultants sum{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Fiber& fiber = properties.fibers[i];
    const auto& [axial, shear_s, shear_t] = points[i].stress;
    sum[0] += fiber.area * axial;
    sum[1] += fiber.area * root * shear_s;
    sum[2] += fiber.area * root * shear_t;
    if (!properties.torsion_free) sum[3] += fiber.area * (fiber.s * shear_t - fiber.t * shear_s);
    sum[4] += fiber.area * fiber.t * axial;
    sum[5] -= fiber.area * fiber.s * axial;
  }
  return sum;
}

/// The points carry `imposed` and what is left of bending, elastically.
void impose(const BeamProperties& properties, const BeamStrain& strain, const ImposedStress& imposed,
            std::span<BeamPoint> points) {
  const Material& material = properties.material;
  double mean = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const BeamTensor increment = strain.at(properties.fibers[i]);
    BeamTensor& stress = points[i].stress;
    stress[0] += material.young * increment[0];
    stress[1] += material.shear() * increment[1];
    stress[2] += material.shear() * increment[2];
    mean += properties.fibers[i].area / properties.section.area * stress[0];
  }
  for (BeamPoint& point : points) point.stress[0] = imposed.axial + (imposed.bending ? point.stress[0] - mean : 0);
}

double plastic_work(const BeamProperties& properties, std::span<const BeamPoint> points) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) sum += properties.fibers[i].area * points[i].plastic_work;
  return sum;
}

/// 2 / ω of the highest of the beam's modes: stretching, twisting, bending and transverse shear, which are independent
/// of each other as the points lie symmetrically. The axial force adds its geometric stiffness across.
double integrated_step(const BeamProperties& properties, double length, double start_length, double axial) {
  const Material& material = properties.material;
  const model::BeamSection& section = properties.section;
  const double mass = beam_mass(properties, start_length) / 2;
  const double inertia = mass * beam_inertia(properties, start_length);
  const double bending = material.young * std::max(section.iss, section.itt);
  const double across = material.shear() * section.shear_area * (2 / (length * mass) + length / (2 * inertia)) +
                        2 * std::abs(axial) / (length * mass);
  const double squared =
      std::max({2 * material.young * section.area / (length * mass), across,
                2 * material.shear() * section.torsion / (length * inertia), 2 * bending / (length * inertia)});
  return 2 / std::sqrt(squared);
}

}  // namespace

BeamForces integrated_beam_forces(const BeamProperties& properties, const BeamEnds& ends, double dt,
                                  const ImposedStress* imposed, BeamState& state, std::span<BeamPoint> points) {
  BeamForces forces;
  const Vector way = ends.x[1] - ends.x[0];
  const double length = way.norm(), before = (way - dt * (ends.v[1] - ends.v[0])).norm();
  if (!(length > 0) || !std::isfinite(length) || !(before > 0)) return forces;
  const Vector r = way / length;
  BeamStrain strain;
  if (dt > 0) strain = step_strain(properties, turn_axes(ends, way, r, dt, state.axis), before, length);
  forces.good = state.axis.allFinite();
  const double flowed = plastic_work(properties, points);
  if (imposed != nullptr)
    impose(properties, strain, *imposed, points);
  else
    for (std::size_t i = 0; i < points.size(); ++i)
      update_beam_stress(properties.material, strain.at(properties.fibers[i]), dt, points[i]);
  forces.dissipated = (length + before) / 2 * (plastic_work(properties, points) - flowed);
  const Vector &s = state.axis, t = r.cross(s);
  forces.resultants = section_resultants(properties, points);
  const auto& [axial, shear_s, shear_t, torsion, moment_s, moment_t] = forces.resultants;
  forces.axial = axial;
  forces.force[1] = axial * r + shear_s * s + shear_t * t;
  forces.force[0] = -forces.force[1];
  const Vector moment = torsion * r + moment_s * s + moment_t * t;
  const Vector of_shear = length / 2 * (shear_t * s - shear_s * t);
  forces.moment = {of_shear - moment, of_shear + moment};
  forces.manual_step = length / std::sqrt(properties.material.young / properties.material.density);
  forces.stable_step = integrated_step(properties, length, state.length, axial);
  return forces;
}

double stored_energy(const BeamProperties& properties, std::span<const BeamPoint> points, double length) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += length * properties.fibers[i].area * elastic_energy(properties.material, points[i].stress);
  return sum;
}

}  // namespace gapcheck::solver
