#include <Eigen/Core>

#include "solver/element/plate_roots.hpp"
#include "solver/element/shell.hpp"
#include "solver/element/triangle_frame.hpp"

namespace gapcheck::solver {
namespace {

/// Area coordinates of the three points, each nearer to one corner; their weights are equal.
constexpr double near_corner = 2.0 / 3, far_corner = 1.0 / 6;

/// κxx, κyy and 2κxy.
using Curvature = Eigen::Vector3d;

/// With m = ω × n, the slopes of the normal, s = Δw + m·side of each side vanishes in plates without shear whose m is
/// linear. Batoz' m is linear along the normals of the sides and quadratic along them, and has no shear in their
/// middles and at the corners. As a field: m = Σ L m(corner) − Σ 6 L L' side s / side².
struct KirchhoffBending {
  /// Curvature of a unit of m along x and y at each corner, and of a unit of s of each side at each point.
  std::array<Curvature, 3> by_x, by_y;
  std::array<std::array<Curvature, 3>, 3> by_side;

  explicit KirchhoffBending(const TriangleFrame& frame) {
    for (std::size_t i = 0; i < 3; ++i) {
      by_x[i] = {frame.bx[i], 0, frame.by[i]};
      by_y[i] = {0, frame.by[i], frame.bx[i]};
      const std::size_t next = (i + 1) % 3;
      const double factor = -6 / frame.squared_side(i), x = factor * frame.side_x[i], y = factor * frame.side_y[i];
      for (std::size_t point = 0; point < 3; ++point) {
        const double here = point == i ? near_corner : far_corner, there = point == next ? near_corner : far_corner;
        const double gx = here * frame.bx[next] + there * frame.bx[i], gy = here * frame.by[next] + there * frame.by[i];
        by_side[point][i] = {x * gx, y * gy, x * gy + y * gx};
      }
    }
  }
  /// At the points.
  [[nodiscard]] std::array<Curvature, 3> rates(const TriangleFrame& frame, const std::array<Vector, 3>& v,
                                               const std::array<Vector, 3>& w) const {
    Curvature even = Curvature::Zero();
    for (std::size_t i = 0; i < 3; ++i) even += w[i].y() * by_x[i] - w[i].x() * by_y[i];
    std::array<Curvature, 3> all{even, even, even};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      const Vector mean = (w[i] + w[next]) / 2;
      const double s = v[next].z() - v[i].z() + mean.y() * frame.side_x[i] - mean.x() * frame.side_y[i];
      for (std::size_t point = 0; point < 3; ++point) all[point] += s * by_side[point][i];
    }
    return all;
  }
  /// The transpose: forces along z, and moments, of the moments at the points times their areas.
  void spread(const TriangleFrame& frame, const std::array<Curvature, 3>& moments, std::array<Vector, 3>& force,
              std::array<Vector, 3>& moment) const {
    const Curvature whole = moments[0] + moments[1] + moments[2];
    for (std::size_t i = 0; i < 3; ++i) moment[i] += Vector(-by_y[i].dot(whole), by_x[i].dot(whole), 0);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      double pull = 0;
      for (std::size_t point = 0; point < 3; ++point) pull += by_side[point][i].dot(moments[point]);
      const Vector twist(-pull / 2 * frame.side_y[i], pull / 2 * frame.side_x[i], 0);
      force[next].z() += pull;
      force[i].z() -= pull;
      moment[i] += twist;
      moment[next] += twist;
    }
  }
  /// Upper bound of the squared frequency of bending: the eighth root of the sum of the eighth powers of the six
  /// eigenvalues that are not zero, each at most 25 % of it.
  [[nodiscard]] double squared_frequency(const TriangleFrame& frame, const PlateRoots& roots, double thickness,
                                         double inertia) const {
    using Square = Eigen::Matrix<double, 9, 9>;
    Square strain;
    const double turn = 1 / std::sqrt(inertia);
    for (std::size_t column = 0; column < 9; ++column) {
      std::array<Vector, 3> v, w;
      v.fill(Vector::Zero());
      w.fill(Vector::Zero());
      if (column < 3)
        v[column].z() = 1;
      else
        w[column % 3][column < 6 ? 0 : 1] = turn;
      const std::array<Curvature, 3> at = rates(frame, v, w);
      for (std::size_t point = 0; point < 3; ++point) {
        const Curvature& k = at[point];
        strain.block<3, 1>(3 * static_cast<Eigen::Index>(point), static_cast<Eigen::Index>(column)) =
            Curvature(roots.sum * (k[0] + k[1]), roots.difference * (k[0] - k[1]), roots.difference * k[2]);
      }
    }
    Square power = strain.transpose() * strain;
    const double trace = power.trace();
    if (!(trace > 0)) return 0;
    power /= trace;
    for (int squaring = 0; squaring < 2; ++squaring) power = Square(power * power);
    return thickness * thickness / 12 * trace * std::pow(power.squaredNorm(), 1.0 / 8);
  }
};

/// Membrane strain of the step.
ShellStrain membrane_strain(const TriangleFrame& frame, const std::array<Vector, 3>& v, double dt) {
  ShellStrain strain;
  for (std::size_t i = 0; i < 3; ++i) {
    strain.xx += dt * frame.bx[i] * v[i].x();
    strain.yy += dt * frame.by[i] * v[i].y();
    strain.xy += dt / 2 * (frame.bx[i] * v[i].y() + frame.by[i] * v[i].x());
  }
  return strain;
}

void set_kirchhoff_steps(const ShellProperties& properties, const TriangleFrame& frame, const KirchhoffBending& bending,
                         double thickness, ShellForces& out) {
  Gram gradient;
  double squared_side = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    gradient.add(frame.bx[i], frame.by[i]);
    squared_side = std::max(squared_side, frame.squared_side(i));
  }
  const ShellShape shape{3, frame.area, thickness, 4 * frame.area * frame.area / squared_side, gradient.largest(), 0};
  const PlateRoots roots(properties);
  const double largest = std::max(roots.sum * roots.sum, roots.difference * roots.difference);
  const double stretch = 3 * 2 * largest * shape.gradient;
  const double bend = bending.squared_frequency(frame, roots, thickness, properties.inertia(frame.area, thickness));
  double squared = std::max(stretch, bend);
  // Bending stretches a mid-surface that is off the nodes.
  if (properties.reference != 0) {
    const double root = std::sqrt(stretch) + std::sqrt(3 * bend) * std::abs(properties.reference);
    squared = root * root + bend;
  }
  set_time_steps(properties, shape, squared, out);
}

/// Updates all layers of all points, and the thickness; moments times the points' areas.
ShellResultants integrate_kirchhoff(const ShellProperties& properties, ShellStrain strain, double area, double dt,
                                    const std::array<Curvature, 3>& curvature, ShellState& state,
                                    std::span<PointState> points, std::array<Curvature, 3>& moments,
                                    double& dissipated) {
  ShellResultants mean;
  const std::size_t layers = properties.layers.size();
  double thickness = 0;
  for (std::size_t point = 0; point < 3; ++point) {
    const Curvature& k = curvature[point];
    strain.bend_xx = dt * k[0];
    strain.bend_yy = dt * k[1];
    strain.bend_xy = dt / 2 * k[2];
    double own = state.thickness;
    const ShellResultants n = integrate_layers(properties, strain, dt, own, points.subspan(point * layers, layers));
    thickness += own / 3;
    mean.xx += n.xx / 3;
    mean.yy += n.yy / 3;
    mean.xy += n.xy / 3;
    moments[point] = Curvature(n.bend_xx, n.bend_yy, n.bend_xy) / 3;
    dissipated += area / 3 * n.plastic_work;
  }
  if (properties.thins) state.thickness = thickness;
  return mean;
}

}  // namespace

ShellForces kirchhoff_forces(const ShellProperties& properties, const ShellCorners& corners, double dt,
                             ShellState& state, std::span<PointState> points) {
  ShellForces out;
  const std::array<Vector, 4> middle_x = half_step_ago(corners.x, corners.v, dt);
  const TriangleFrame middle = make_triangle_frame(middle_x), end = make_triangle_frame(corners.x);
  const std::array<Vector, 3> v = middle.local(corners.v), w = middle.local(corners.w);
  const std::array<Curvature, 3> curvature = KirchhoffBending(middle).rates(middle, v, w);
  const ShellStrain strain = membrane_strain(middle, v, dt);
  std::array<Curvature, 3> moments;
  ShellResultants n =
      integrate_kirchhoff(properties, strain, middle.area, dt, curvature, state, points, moments, out.dissipated);
  if (properties.viscosity.on()) add_bulk_viscosity(properties, middle.area, strain.xx + strain.yy, dt, state, n, out);
  for (Curvature& moment : moments) moment *= end.area;
  const KirchhoffBending bending(end);
  std::array<Vector, 3> force, moment;
  for (std::size_t i = 0; i < 3; ++i) {
    const double bx = end.area * end.bx[i], by = end.area * end.by[i];
    force[i] = {bx * n.xx + by * n.xy, by * n.yy + bx * n.xy, 0};
    moment[i] = Vector::Zero();
  }
  bending.spread(end, moments, force, moment);
  for (std::size_t i = 0; i < 3; ++i) {
    out.force[i] = end.global(force[i]);
    out.moment[i] = end.global(moment[i]);
  }
  out.force[3] = out.moment[3] = Vector::Zero();
  set_kirchhoff_steps(properties, end, bending, state.thickness, out);
  out.good = end.area > 0 && std::isfinite(out.force[0].sum() + out.force[1].sum() + out.moment[0].sum());
  return out;
}

double kirchhoff_stored_energy(const ShellProperties& properties, const ShellState& state, double area,
                               std::span<const PointState> points) {
  const std::size_t layers = properties.layers.size();
  double energy = 0;
  for (std::size_t point = 0; point < 3; ++point)
    energy += stored_energy(properties, state, area / 3, points.subspan(point * layers, layers));
  return energy;
}

}  // namespace gapcheck::solver
