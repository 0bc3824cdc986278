#include "solver/element/shell.hpp"
#include "solver/element/triangle_frame.hpp"

namespace gapcheck::solver {

TriangleFrame make_triangle_frame(const std::array<Vector, 4>& x) {
  TriangleFrame frame;
  const Vector normal = (x[1] - x[0]).cross(x[2] - x[0]);
  const double twice_area = normal.norm();
  frame.area = twice_area / 2;
  frame.e3 = normal / twice_area;
  frame.e1 = (x[1] - x[0]).normalized();
  frame.e2 = frame.e3.cross(frame.e1);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector side = x[(i + 1) % 3] - x[i];
    frame.side_x[i] = side.dot(frame.e1);
    frame.side_y[i] = side.dot(frame.e2);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
    frame.bx[i] = -frame.side_y[next] / twice_area;
    frame.by[i] = frame.side_x[next] / twice_area;
    // At a corner the shear follows from the two sides that meet there; the element takes the mean of its corners.
    frame.shear_x[i] = (frame.side_y[next] - frame.side_y[last]) / (3 * twice_area);
    frame.shear_y[i] = -(frame.side_x[next] - frame.side_x[last]) / (3 * twice_area);
  }
  return frame;
}

namespace {

ShellStrain strain_of(const TriangleFrame& frame, const ShellCorners& corners, double dt) {
  const std::array<Vector, 3> v = frame.local(corners.v), w = frame.local(corners.w);
  ShellStrain strain;
  for (std::size_t i = 0; i < 3; ++i) {
    const double bx = dt * frame.bx[i], by = dt * frame.by[i];
    strain.xx += bx * v[i].x();
    strain.yy += by * v[i].y();
    strain.xy += (bx * v[i].y() + by * v[i].x()) / 2;
    strain.bend_xx += bx * w[i].y();
    strain.bend_yy -= by * w[i].x();
    strain.bend_xy += (by * w[i].y() - bx * w[i].x()) / 2;
    const std::size_t next = (i + 1) % 3;
    const Vector mean = (w[i] + w[next]) / 2;
    const double along = v[next].z() - v[i].z() + mean.y() * frame.side_x[i] - mean.x() * frame.side_y[i];
    strain.zx += dt / 2 * frame.shear_x[i] * along;
    strain.yz += dt / 2 * frame.shear_y[i] * along;
  }
  return strain;
}

/// The transpose of the strain operators.
void spread(const TriangleFrame& frame, const ShellResultants& n, ShellForces& out) {
  std::array<Vector, 3> force, moment;
  for (std::size_t i = 0; i < 3; ++i) {
    const double bx = frame.area * frame.bx[i], by = frame.area * frame.by[i];
    force[i] = {bx * n.xx + by * n.xy, by * n.yy + bx * n.xy, 0};
    moment[i] = {-by * n.bend_yy - bx * n.bend_xy, bx * n.bend_xx + by * n.bend_xy, 0};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const double pull = frame.area * (frame.shear_x[i] * n.zx + frame.shear_y[i] * n.yz);
    const Vector twist(-pull / 2 * frame.side_y[i], pull / 2 * frame.side_x[i], 0);
    force[next].z() += pull;
    force[i].z() -= pull;
    moment[i] += twist;
    moment[next] += twist;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    out.force[i] = frame.global(force[i]);
    out.moment[i] = frame.global(moment[i]);
  }
  out.force[3] = out.moment[3] = Vector::Zero();
}

void set_steps(const ShellProperties& properties, const TriangleFrame& frame, double thickness, ShellForces& out) {
  Gram gradient, shear;
  const double inertia = properties.inertia(frame.area, thickness);
  double squared_side = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t last = (i + 2) % 3;
    gradient.add(frame.bx[i], frame.by[i]);
    // Corner i: its deflection, then its two rotations, through the sides that meet there.
    shear.add(frame.shear_x[last] - frame.shear_x[i], frame.shear_y[last] - frame.shear_y[i]);
    for (const std::array<double, 3>& side : {frame.side_x, frame.side_y}) {
      const double half = 0.5 / std::sqrt(inertia);
      shear.add(half * (frame.shear_x[i] * side[i] + frame.shear_x[last] * side[last]),
                half * (frame.shear_y[i] * side[i] + frame.shear_y[last] * side[last]));
    }
    squared_side = std::max(squared_side, frame.squared_side(i));
  }
  const double squared_length = 4 * frame.area * frame.area / squared_side;
  set_time_steps(properties, {3, frame.area, thickness, squared_length, gradient.largest(), shear.largest()}, out);
}

}  // namespace

Matrix triangle_axes(const std::array<Vector, 4>& x) {
  const TriangleFrame frame = make_triangle_frame(x);
  Matrix axes;
  axes << frame.e1, frame.e2, frame.e3;
  return axes;
}

ShellForces triangle_forces(const ShellProperties& properties, const ShellCorners& corners, double dt,
                            ShellState& state, std::span<PointState> points) {
  ShellForces out;
  const std::array<Vector, 4> middle_x = half_step_ago(corners.x, corners.v, dt);
  const TriangleFrame middle = make_triangle_frame(middle_x), end = make_triangle_frame(corners.x);
  const ShellStrain strain = strain_of(middle, corners, dt);
  ShellResultants resultants = integrate_layers(properties, strain, dt, state.thickness, points);
  if (properties.viscosity.on())
    add_bulk_viscosity(properties, middle.area, strain.xx + strain.yy, dt, state, resultants, out);
  out.dissipated += middle.area * resultants.plastic_work;
  spread(end, resultants, out);
  set_steps(properties, end, state.thickness, out);
  out.good = end.area > 0 && std::isfinite(out.force[0].sum() + out.force[1].sum() + out.moment[0].sum());
  return out;
}

}  // namespace gapcheck::solver
