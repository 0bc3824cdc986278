#include "solver/thick/thick_shell.hpp"

#include <algorithm>
#include <cmath>

#include "base/quad.hpp"

namespace gapcheck::solver {
namespace {

/// Mid-surface and fibres of a thick shell in the axes of its mid-surface.
struct Fibres {
  Matrix axes;  ///< columns: in the plane, normal
  double area = 0;
  std::array<Vector, 4> middle;      ///< global
  std::array<Vector, 4> fibre;       ///< local
  std::array<double, 4> bx{}, by{};  ///< slopes at the centre by corner
  [[nodiscard]] bool good() const {
    return area > 0 && std::all_of(fibre.begin(), fibre.end(), [](const Vector& f) { return f.z() > 0; });
  }
};

Fibres fibres_of(const std::array<Vector, 8>& x) {
  Fibres fibres;
  fibres.middle = mid_surface(x);
  fibres.axes = quad_axes(fibres.middle);
  const Vector side02 = fibres.axes.transpose() * (fibres.middle[2] - fibres.middle[0]),
               side13 = fibres.axes.transpose() * (fibres.middle[3] - fibres.middle[1]);
  fibres.area = (side02.x() * side13.y() - side02.y() * side13.x()) / 2;
  const double twice = 2 * fibres.area;
  fibres.bx = {-side13.y() / twice, side02.y() / twice, side13.y() / twice, -side02.y() / twice};
  fibres.by = {side13.x() / twice, -side02.x() / twice, -side13.x() / twice, side02.x() / twice};
  for (std::size_t k = 0; k < 4; ++k) fibres.fibre[k] = fibres.axes.transpose() * (x[k + 4] - x[k]);
  return fibres;
}

/// Velocities of the mid-surface, and those of the fibres' ends without what the slope of the mid-surface gives them,
/// over the fibre's height: rotations about the axes in the plane, and the rate of the thickness.
struct FibreRates {
  std::array<Vector, 4> middle;  ///< global
  std::array<Vector, 4> turn;    ///< local: x and y of the shell's rotation, z: rate of the logarithm of the height
};

FibreRates rates_of(const Fibres& fibres, const std::array<Vector, 8>& v) {
  FibreRates rates;
  Vector along_x = Vector::Zero(), along_y = Vector::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    rates.middle[k] = (v[k] + v[k + 4]) / 2;
    const Vector local = fibres.axes.transpose() * rates.middle[k];
    along_x += fibres.bx[k] * local;
    along_y += fibres.by[k] * local;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector& f = fibres.fibre[k];
    const Vector own = (fibres.axes.transpose() * (v[k + 4] - v[k]) - f.x() * along_x - f.y() * along_y) / f.z();
    rates.turn[k] = Vector(-own.y(), own.x(), own.z());
  }
  return rates;
}

/// The transpose of rates_of(): forces on the mid-surface (global), moments and stretching forces (local).
std::array<Vector, 8> spread(const Fibres& fibres, const std::array<Vector, 4>& force,
                             const std::array<Vector, 4>& turn) {
  std::array<Vector, 8> out;
  Vector along_x = Vector::Zero(), along_y = Vector::Zero();
  std::array<Vector, 4> pair;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector& f = fibres.fibre[k];
    pair[k] = Vector(turn[k].y(), -turn[k].x(), turn[k].z()) / f.z();
    along_x += f.x() * pair[k];
    along_y += f.y() * pair[k];
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector middle = force[k] - fibres.axes * (fibres.bx[k] * along_x + fibres.by[k] * along_y);
    const Vector apart = fibres.axes * pair[k];
    out[k] = middle / 2 - apart;
    out[k + 4] = middle / 2 + apart;
  }
  return out;
}

/// The shell's stable step belongs to rotational inertias that thick shells do not have: each end of a fibre has an
/// eighth of the mass. Fibres that lean add the slopes of the mid-surface to their turns.
double stable_step(const ShellProperties& properties, const Fibres& fibres, const ThickShellState& state,
                   double shell_step) {
  double shortest = fibres.fibre[0].z(), lean = 0, gradient = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector& f = fibres.fibre[k];
    shortest = std::min(shortest, f.z());
    lean = std::max(lean, std::hypot(f.x(), f.y()) / f.z());
    gradient += fibres.bx[k] * fibres.bx[k] + fibres.by[k] * fibres.by[k];
  }
  const double assumed = rotational_inertia(fibres.area, state.shell.thickness);
  // Of the fibre per mass of the pair: 4 / height² of its ends, and what leaning adds.
  const double root = 2 / shortest + 2 * lean * std::sqrt(gradient);
  const double shell = 4 / (shell_step * shell_step) / state.mass_factor * std::max(1.0, assumed * root * root);
  const double mass = state.mass / 4;  // of a pair
  const double stretch = properties.material.young * fibres.area / 4 * state.shell.thickness * root * root / mass;
  return 2 / std::sqrt(shell + stretch);
}

}  // namespace

std::array<Vector, 4> mid_surface(const std::array<Vector, 8>& x) {
  std::array<Vector, 4> middle;
  for (std::size_t k = 0; k < 4; ++k) middle[k] = (x[k] + x[k + 4]) / 2;
  return middle;
}

double fibre_thickness(const std::array<Vector, 8>& x) {
  const Vector normal = quad_normal(mid_surface(x)).normalized();
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum += normal.dot(x[k + 4] - x[k]) / 4;
  return sum;
}

ThickShellState begin_thick_shell(const ShellProperties& properties, const std::array<Vector, 8>& x) {
  ThickShellState state;
  state.shell.thickness = fibre_thickness(x);
  state.shell.stiffness = hourglass_stiffness(properties, mid_surface(x), state.shell.thickness);
  state.mass = properties.material.density * one_point_volume(x);
  return state;
}

ThickShellForces thick_shell_forces(const ShellProperties& properties, const SolidCorners& corners, double dt,
                                    ThickShellState& state, std::span<PointState> points) {
  ThickShellForces out;
  out.force.fill(Vector::Zero());
  const std::array<Vector, 8> middle_x = half_step_ago(corners.x, corners.v, dt);
  const Fibres middle = fibres_of(middle_x), end = fibres_of(corners.x);
  if (!(middle.good() && end.good())) return out;
  const FibreRates rates = rates_of(middle, corners.v);
  ShellCorners shell;
  shell.x = end.middle;
  shell.v = rates.middle;
  for (std::size_t k = 0; k < 4; ++k) shell.w[k] = middle.axes.leftCols<2>() * rates.turn[k].head<2>();
  const double before = state.shell.thickness;
  const ShellForces forces = quad_forces(properties, shell, dt, state.shell, points);
  // The strain through the thickness that plane stress asks for.
  const double asked = std::log(state.shell.thickness / before), young = properties.material.young;
  std::array<Vector, 4> turn;
  for (std::size_t k = 0; k < 4; ++k) {
    if (properties.material.has_stress()) state.pressed[k] += young * (dt * rates.turn[k].z() - asked);
    turn[k] = end.axes.transpose() * forces.moment[k];
    turn[k].z() = state.pressed[k] * end.area / 4 * state.shell.thickness;
  }
  // In the plane that stress acts by Poisson's ratio, as in three dimensions: both are slopes of one energy.
  const double poisson = properties.material.poisson,
               membrane = (turn[0].z() + turn[1].z() + turn[2].z() + turn[3].z()) * poisson / (1 - poisson);
  std::array<Vector, 4> force = forces.force;
  for (std::size_t k = 0; k < 4; ++k)
    force[k] += membrane * (end.axes.leftCols<2>() * Eigen::Vector2d(end.bx[k], end.by[k]));
  out.force = spread(end, force, turn);
  out.hourglass_work = forces.hourglass_work;
  out.dissipated = forces.dissipated;
  const double density = state.mass / one_point_volume(corners.x);
  out.manual_step = one_point_volume(corners.x) / largest_face_area(corners.x) /
                    std::sqrt(properties.material.wave_modulus() / density);
  out.stable_step = stable_step(properties, end, state, forces.stable_step);
  out.good = forces.good && std::isfinite(out.force[0].sum() + out.force[6].sum());
  return out;
}

double stored_energy(const ShellProperties& properties, const ThickShellState& state, const std::array<Vector, 8>& x,
                     std::span<const PointState> points) {
  const double area = quad_normal(mid_surface(x)).norm() / 2;
  double energy = stored_energy(properties, state.shell, area, points);
  if (!properties.material.has_stress()) return energy;
  for (const double stress : state.pressed)
    energy += stress * stress / (2 * properties.material.young) * area / 4 * state.shell.thickness;
  return energy;
}

}  // namespace gapcheck::solver
