#include <algorithm>
#include <cmath>

#include "base/quad.hpp"
#include "solver/element/solid.hpp"

namespace gapcheck::solver {
namespace {

/// The four hourglass shapes ηζ, ζξ, ξη, ξηζ at the corners.
constexpr double shapes[4][8] = {{1, 1, -1, -1, -1, -1, 1, 1},
                                 {1, -1, -1, 1, -1, 1, 1, -1},
                                 {1, -1, 1, -1, 1, -1, 1, -1},
                                 {-1, 1, -1, 1, 1, -1, 1, -1}};

using Corners = std::array<Vector, 8>;

/// ξ, η, ζ of the corners.
constexpr double corner_signs[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                       {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

/// V ∂N/∂x at the centre of every corner's shape function N, where V = 8 det ∂x/∂ξ: the cofactor of the axes times the
/// corner's ξ.
Corners centre_gradient(const Corners& x) {
  const Matrix axes = brick_axes(x);
  const Vector a = axes.col(1).cross(axes.col(2)), b = axes.col(2).cross(axes.col(0)),
               c = axes.col(0).cross(axes.col(1));
  Corners gradient;
  for (std::size_t k = 0; k < 8; ++k)
    gradient[k] = corner_signs[k][0] * a + corner_signs[k][1] * b + corner_signs[k][2] * c;
  return gradient;
}

/// ∂V/∂x of every corner, where V is the volume between the bilinear faces; called B by Flanagan and Belytschko. It is
/// ∫ N n dA over the three faces that meet in the corner.
Corners mean_gradient(const Corners& x) {
  // Corner a, its three neighbours along the edges, and the three corners across the faces, in turning order.
  constexpr std::size_t edges[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                       {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  constexpr std::size_t faces[8][3] = {{2, 7, 5}, {3, 4, 6}, {0, 5, 7}, {1, 6, 4},
                                       {6, 1, 3}, {7, 2, 0}, {4, 3, 1}, {5, 0, 2}};
  Corners gradient;
  for (std::size_t a = 0; a < 8; ++a) {
    const Vector& origin = x[a];
    Vector sum = Vector::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector first = x[edges[a][k]] - origin, across = x[faces[a][k]] - origin,
                   second = x[edges[a][(k + 1) % 3]] - origin;
      // Twelve times the bilinear face's area vector, weighted with the corner's shape function; inward.
      sum += first.cross(second) + first.cross(across) + across.cross(second);
    }
    gradient[a] = -sum / 12;
  }
  return gradient;
}

bool is_exact(const SolidProperties& properties) {
  return properties.hourglass.exact_volume && properties.material.kind != MaterialKind::rubber;
}

Corners gradient_of(const SolidProperties& properties, const Corners& x) {
  return is_exact(properties) ? mean_gradient(x) : centre_gradient(x);
}

double volume_of(const Corners& x, const Corners& gradient) {
  double volume = 0;
  for (std::size_t a = 0; a < 8; ++a) volume += x[a].dot(gradient[a]);
  return volume / 3;
}

Matrix outer_sum(const Corners& v, const Corners& b) {
  Matrix sum = Matrix::Zero();
  for (std::size_t a = 0; a < 8; ++a) sum += v[a] * b[a].transpose();
  return sum;
}

/// Σ over corners of shape · v, for the four shapes.
std::array<Vector, 4> shape_sums(const Corners& v) {
  std::array<Vector, 4> sums;
  for (std::size_t m = 0; m < 4; ++m) {
    sums[m] = Vector::Zero();
    for (std::size_t a = 0; a < 8; ++a) sums[m] += shapes[m][a] * v[a];
  }
  return sums;
}

/// Largest eigenvalue of a symmetric matrix, from above: the largest row sum.
double eigenvalue_bound(const Matrix& m) { return m.cwiseAbs().rowwise().sum().maxCoeff(); }

/// Updates the hourglass stresses of viscous control to the end of the step; returns the work.
double update_viscous(const SolidProperties& properties, const std::array<Vector, 4>& rates, const Matrix& rotation,
                      double volume, double dt, SolidState& state) {
  if (properties.hourglass.kind != HourglassKind::viscous || dt <= 0) return 0;
  const double density = state.mass / volume;
  const double factor = properties.hourglass.coefficient / 4 * std::sqrt(density * properties.material.wave_modulus()) *
                        std::pow(std::cbrt(volume), 2);
  double work = 0;
  for (std::size_t m = 0; m < 4; ++m) {
    const Vector before = rotation * state.hourglass[m];
    state.hourglass[m] = factor * rates[m];
    work += dt / 2 * rates[m].dot(before + state.hourglass[m]);
  }
  return work;
}

/// The same for control by assumed strains: the slopes of its energy U(Rᵀ q), R the brick's axes. Where q and ∂U/∂q are
/// not parallel, the turn of the axes with the corners has a share in them.
double add_assumed_strain(const HourglassReference& reference, const Corners& x, SolidState& state, SolidForces& out) {
  const AssumedStrain& assumed = *reference.assumed;
  const Matrix axes = brick_axes(x), r = polar_rotation(axes);
  const double before = assumed.energy(state.hourglass);
  std::array<Vector, 4> amplitudes;
  for (std::size_t m = 0; m < 4; ++m) {
    amplitudes[m].setZero();
    for (std::size_t a = 0; a < 8; ++a) amplitudes[m] += reference.shapes[m][a] / 8 * x[a];
    state.hourglass[m] = r.transpose() * amplitudes[m];
  }
  const BrickModeAmplitudes local = assumed.forces(state.hourglass);
  Vector turning = Vector::Zero();
  for (std::size_t m = 0; m < 4; ++m) {
    const Vector force = r * local[m];
    turning += force.cross(amplitudes[m]);
    for (std::size_t a = 0; a < 8; ++a) out.force[a] += reference.shapes[m][a] / 8 * force;
  }
  const Matrix turn = polar_turn(axes, r, turning) / 8;
  for (std::size_t a = 0; a < 8; ++a)
    out.force[a] += turn * Vector(corner_signs[a][0], corner_signs[a][1], corner_signs[a][2]);
  out.stable_step = std::min(out.stable_step, 2 / std::sqrt(reference.squared_frequency));
  return assumed.energy(state.hourglass) - before;
}

/// The same for control by stiffness, and its forces.
double add_stiffness(const HourglassReference& reference, const Corners& x, SolidState& state, SolidForces& out) {
  if (reference.assumed) return add_assumed_strain(reference, x, state, out);
  if (!(reference.stiffness > 0)) return 0;
  double work = 0;
  for (std::size_t m = 0; m < 4; ++m) {
    Vector amplitude = Vector::Zero();
    for (std::size_t a = 0; a < 8; ++a) amplitude += reference.shapes[m][a] * x[a];
    const Vector stress = reference.stiffness * amplitude;
    work += (stress.squaredNorm() - state.hourglass[m].squaredNorm()) / (2 * reference.stiffness);
    state.hourglass[m] = stress;
    for (std::size_t a = 0; a < 8; ++a) out.force[a] += reference.shapes[m][a] * stress;
  }
  out.stable_step = std::min(out.stable_step, 2 / std::sqrt(reference.squared_frequency));
  return work;
}

}  // namespace

double largest_face_area(const std::array<Vector, 8>& x) {
  constexpr std::size_t faces[6][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                       {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  double squared = 0;
  for (const auto& f : faces)
    squared = std::max(squared, quad_normal(x[f[0]], x[f[1]], x[f[2]], x[f[3]]).squaredNorm());
  return std::sqrt(squared) / 2;
}

double brick_volume(const std::array<Vector, 8>& x) { return volume_of(x, mean_gradient(x)); }

double one_point_volume(const std::array<Vector, 8>& x) { return 8 * brick_axes(x).determinant(); }

double brick_volume(const SolidProperties& properties, const std::array<Vector, 8>& x) {
  return is_exact(properties) ? brick_volume(x) : one_point_volume(x);
}

Matrix brick_axes(const std::array<Vector, 8>& x) {
  const Vector low02 = x[2] - x[0], low13 = x[3] - x[1], high46 = x[6] - x[4], high57 = x[7] - x[5];
  Matrix axes;
  axes.col(0) = (low02 - low13 + high46 - high57) / 8;
  axes.col(1) = (low02 + low13 + high46 + high57) / 8;
  axes.col(2) = (x[4] - x[0] + x[5] - x[1] + x[6] - x[2] + x[7] - x[3]) / 8;
  return axes;
}

HourglassReference hourglass_reference(const SolidProperties& properties, const std::array<Vector, 8>& x, double mass) {
  HourglassReference reference;
  const Corners gradient = gradient_of(properties, x);
  const double volume = volume_of(x, gradient);
  const std::array<Vector, 4> sums = shape_sums(x);
  Eigen::Matrix4d products = Eigen::Matrix4d::Zero();
  for (std::size_t a = 0; a < 8; ++a) {
    Eigen::Vector4d at;
    for (std::size_t m = 0; m < 4; ++m) {
      reference.shapes[m][a] = shapes[m][a] - gradient[a].dot(sums[m]) / volume;
      at[static_cast<Eigen::Index>(m)] = reference.shapes[m][a];
    }
    products += at * at.transpose();
  }
  // Each corner has an eighth of the mass; the largest eigenvalue of the products is at most their largest row sum.
  const double per_stiffness = products.cwiseAbs().rowwise().sum().maxCoeff() / (mass / 8);
  if (properties.hourglass.kind == HourglassKind::assumed_strain) {
    const Matrix axes = brick_axes(x);
    const Vector half_side = (polar_rotation(axes).transpose() * axes).diagonal();
    reference.assumed = std::make_shared<const AssumedStrain>(
        assumed_strain(properties.hourglass.coefficient, properties.material.shear(), properties.material.bulk(),
                       one_point_volume(x), half_side));
    reference.squared_frequency = reference.assumed->bound() / 64 * per_stiffness;
    return reference;
  }
  const double squared_gradient = outer_sum(gradient, gradient).trace() / (volume * volume);
  reference.stiffness =
      properties.hourglass.coefficient / 24 * properties.material.wave_modulus() * volume * squared_gradient;
  reference.squared_frequency = reference.stiffness * per_stiffness;
  return reference;
}

SolidForces brick_forces(const SolidProperties& properties, const SolidCorners& corners, double dt, SolidState& state,
                         PointState& point) {
  SolidForces out;
  const Corners middle_x = half_step_ago(corners.x, corners.v, dt);
  const Corners middle = gradient_of(properties, middle_x), end = gradient_of(properties, corners.x);
  const double middle_volume = volume_of(middle_x, middle);
  out.volume = volume_of(corners.x, end);
  if (!(middle_volume > 0 && out.volume > 0)) {
    for (Vector& force : out.force) force.setZero();
    return out;
  }
  const Matrix gradient = outer_sum(corners.v, middle) / middle_volume;
  const Material& material = properties.material;
  const double flowed = point.plastic_work, deviatoric = deviatoric_energy(material, point);
  const Matrix rotation = update_solid_stress(material, gradient, dt, point);
  if (state.imposed != nullptr) point.stress = state.imposed->on(point.stress);
  const RubberBounds rubber =
      material.kind == MaterialKind::rubber
          ? update_rubber(material, brick_axes(corners.x), out.volume, gradient, dt, state, point)
          : RubberBounds();

  const Matrix gram = outer_sum(end, end) / (out.volume * out.volume);
  const double density = state.mass / out.volume, length = out.volume / largest_face_area(corners.x);
  const double speed = std::sqrt(solid_stiffness(material, state).wave / density);
  const BulkViscosity viscosity = bulk_viscosity(properties, density, speed, length, gradient.trace());
  out.viscous_work = viscous_work(viscosity.pressure, dt * middle_volume * gradient.trace(), state);
  const double work = middle_volume * (deviatoric_energy(material, point) - deviatoric) + out.viscous_work;
  update_pressure(material, out.volume, work, state, {&point, 1});
  erode(material, dt, point);
  set_time_steps(density, length, eigenvalue_bound(gram), 8, viscosity, solid_stiffness(material, state, rubber), out);

  const std::array<Vector, 4> middle_shapes = shape_sums(middle_x), v_shapes = shape_sums(corners.v),
                              end_shapes = shape_sums(corners.x);
  std::array<Vector, 4> rates;
  const bool orthogonal = !properties.hourglass.plain_shapes;
  for (std::size_t m = 0; m < 4; ++m) {
    rates[m] = v_shapes[m];
    if (orthogonal) rates[m] -= gradient * middle_shapes[m];
  }
  out.hourglass_work = update_viscous(properties, rates, rotation, out.volume, dt, state);
  out.dissipated = material.hydro
                       ? out.hourglass_work
                       : middle_volume * (point.plastic_work - flowed) + out.hourglass_work + out.viscous_work;
  const Symmetric rate = to_symmetric(gradient);
  out.dissipated += middle_volume * dt * viscosity.damping * contract(rate, rate);

  // f = σ b + Σ Q (shape − b · (shape · x) / V), Q of viscous control
  Matrix stress =
      to_matrix(point.stress) - viscosity.pressure * Matrix::Identity() + viscosity.damping * to_matrix(rate);
  const bool viscous = properties.hourglass.kind == HourglassKind::viscous;
  for (std::size_t m = 0; m < 4 && viscous && orthogonal; ++m)
    stress -= state.hourglass[m] * end_shapes[m].transpose() / out.volume;
  for (std::size_t a = 0; a < 8; ++a) {
    out.force[a] = stress * end[a];
    for (std::size_t m = 0; m < 4 && viscous; ++m) out.force[a] += shapes[m][a] * state.hourglass[m];
  }
  if (state.reference != nullptr) out.hourglass_work += add_stiffness(*state.reference, corners.x, state, out);
  out.good = std::isfinite(out.force[0].sum() + out.force[6].sum());
  return out;
}

}  // namespace gapcheck::solver
