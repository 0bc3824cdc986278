#include <algorithm>
#include <cmath>

#include "solver/element/solid.hpp"

namespace gapcheck::solver {
namespace {

using Corners = std::array<Vector, 8>;

/// ∂V/∂x of the four corners: a third of the opposite face's area vector, inward.
std::array<Vector, 4> tetrahedron_volume_gradient(const Corners& x) {
  const Vector a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
  std::array<Vector, 4> gradient{Vector::Zero(), b.cross(c) / 6, c.cross(a) / 6, a.cross(b) / 6};
  gradient[0] = -(gradient[1] + gradient[2] + gradient[3]);
  return gradient;
}

}  // namespace

double tetrahedron_volume(const std::array<Vector, 8>& x) {
  return (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]) / 6;
}

Matrix tetrahedron_axes(const std::array<Vector, 8>& x) {
  Matrix axes;
  axes << x[1] - x[0], x[2] - x[0], x[3] - x[0];
  return axes;
}

NodalAverage::Share tetrahedron_share(const SolidCorners& corners, double dt) {
  Corners middle;
  for (std::size_t a = 0; a < 4; ++a) middle[a] = corners.x[a] - dt / 2 * corners.v[a];
  const double volume = tetrahedron_volume(middle);
  if (!(volume > 0)) return {};
  const std::array<Vector, 4> gradient = tetrahedron_volume_gradient(middle);
  double rate = 0;
  for (std::size_t a = 0; a < 4; ++a) rate += gradient[a].dot(corners.v[a]);
  return {volume, dt * rate};
}

SolidForces tetrahedron_forces(const SolidProperties& properties, const SolidCorners& corners, double dt,
                               SolidState& state, PointState& point) {
  SolidForces out;
  for (Vector& force : out.force) force.setZero();
  Corners middle_x;
  for (std::size_t a = 0; a < 4; ++a) middle_x[a] = corners.x[a] - dt / 2 * corners.v[a];
  const double middle_volume = tetrahedron_volume(middle_x);
  out.volume = tetrahedron_volume(corners.x);
  if (!(middle_volume > 0 && out.volume > 0)) return out;
  const std::array<Vector, 4> middle = tetrahedron_volume_gradient(middle_x),
                              end = tetrahedron_volume_gradient(corners.x);
  Matrix gradient = Matrix::Zero(), gram = Matrix::Zero();
  double squared_face = 0;
  for (std::size_t a = 0; a < 4; ++a) {
    gradient += corners.v[a] * middle[a].transpose() / middle_volume;
    gram += end[a] * end[a].transpose() / (out.volume * out.volume);
    squared_face = std::max(squared_face, 9 * end[a].squaredNorm());
  }
  const Material& material = properties.material;
  const double growth = dt * middle_volume * gradient.trace();
  if (corners.volume_strains != nullptr && dt > 0) {
    const std::array<double, 4>& strains = *corners.volume_strains;
    for (std::size_t a = 0; a < 4; ++a) state.mean_stress[a] += material.bulk() * strains[a];
    const double mean = (strains[0] + strains[1] + strains[2] + strains[3]) / 4;
    gradient.diagonal().array() += (mean / dt - gradient.trace()) / 3;
  }
  const double flowed = point.plastic_work, deviatoric = deviatoric_energy(material, point);
  update_solid_stress(material, gradient, dt, point);
  if (state.imposed != nullptr) point.stress = state.imposed->on(point.stress);
  const RubberBounds rubber =
      material.kind == MaterialKind::rubber
          ? update_rubber(material, tetrahedron_axes(corners.x), out.volume, gradient, dt, state, point)
          : RubberBounds();
  const double density = state.mass / out.volume;
  const double length = 3 * out.volume / std::sqrt(squared_face);  // the shortest height
  const double speed = std::sqrt(solid_stiffness(material, state).wave / density);
  const BulkViscosity viscosity = bulk_viscosity(properties, density, speed, length, gradient.trace());
  out.viscous_work = viscous_work(viscosity.pressure, growth, state);
  const double work = middle_volume * (deviatoric_energy(material, point) - deviatoric) + out.viscous_work;
  update_pressure(material, out.volume, work, state, {&point, 1});
  erode(material, dt, point);
  out.dissipated = material.hydro ? 0 : middle_volume * (point.plastic_work - flowed) + out.viscous_work;
  const Symmetric rate = to_symmetric(gradient);
  out.dissipated += middle_volume * dt * viscosity.damping * contract(rate, rate);
  set_time_steps(density, length, gram.cwiseAbs().rowwise().sum().maxCoeff(), 4, viscosity,
                 solid_stiffness(material, state, rubber), out);
  const Matrix stress =
      to_matrix(point.stress) - viscosity.pressure * Matrix::Identity() + viscosity.damping * to_matrix(rate);
  for (std::size_t a = 0; a < 4; ++a) out.force[a] = stress * end[a];
  out.good = std::isfinite(out.force[0].sum() + out.force[1].sum() + out.force[2].sum());
  return out;
}

}  // namespace gapcheck::solver
