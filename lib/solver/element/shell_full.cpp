#include "solver/element/full/shell_full_strains.hpp"
#include "solver/element/full/shell_gram.hpp"
#include "solver/element/shell.hpp"

namespace gapcheck::solver {
namespace {

/// The corners' share in what works on the coefficients of a field.
std::array<Vector, 4> at_corners(const Bilinear& f) {
  const Vector mean = f.mean / 4, xi = f.xi / 4, eta = f.eta / 4, both = f.both / 4;
  return {mean - xi - eta + both, mean + xi - eta - both, mean + xi + eta + both, mean - xi + eta - both};
}

/// The strains of the step at one point.
ShellStrain strain_at(const FullStrains& rates, Eigen::Index i, double dt) {
  ShellStrain strain;
  strain.xx = dt * rates.membrane.xx[i];
  strain.yy = dt * rates.membrane.yy[i];
  strain.xy = dt / 2 * rates.membrane.xy[i];
  strain.bend_xx = dt * rates.bending.xx[i];
  strain.bend_yy = dt * rates.bending.yy[i];
  strain.bend_xy = dt / 2 * rates.bending.xy[i];
  strain.zx = dt / 2 * rates.zx[i];
  strain.yz = dt / 2 * rates.yz[i];
  return strain;
}

/// Updates all layers of all points and the thickness, which is one for the element: the mean over its area.
FullStrains integrate_points(const ShellProperties& properties, const FullFrame& middle, const FullStrains& rates,
                             double dt, ShellState& state, std::span<PointState> points, double& dissipated) {
  FullStrains sum;
  const std::size_t layers = properties.layers.size();
  double thickness = 0;
  for (Eigen::Index i = 0; i < 4; ++i) {
    double own = state.thickness;
    const ShellResultants n = integrate_layers(properties, strain_at(rates, i, dt), dt, own,
                                               points.subspan(static_cast<std::size_t>(i) * layers, layers));
    thickness += own * middle.determinant[i] / middle.area;
    dissipated += middle.determinant[i] * n.plastic_work;
    sum.membrane.xx[i] = n.xx;
    sum.membrane.yy[i] = n.yy;
    sum.membrane.xy[i] = n.xy;
    sum.bending.xx[i] = n.bend_xx;
    sum.bending.yy[i] = n.bend_yy;
    sum.bending.xy[i] = n.bend_xy;
    sum.zx[i] = n.zx;
    sum.yz[i] = n.yz;
  }
  if (properties.thins) state.thickness = thickness;
  return sum;
}

/// The bulk viscosity of the whole shell, by the mean rate of its area.
void add_viscosity(const ShellProperties& properties, const FullFrame& middle, const FullStrains& rates, double dt,
                   ShellState& state, FullStrains& resultants, ShellForces& out) {
  const double rate = (middle.determinant * (rates.membrane.xx + rates.membrane.yy)).sum() / middle.area;
  ShellResultants added;
  add_bulk_viscosity(properties, middle.area, dt * rate, dt, state, added, out);
  resultants.membrane.xx += added.xx;
  resultants.membrane.yy += added.yy;
}

WarpShape warp_of(const FullFrame& frame) {
  WarpShape warp;
  const double z = frame.x.both.z();
  const Four slope_x = z * (frame.xi_x * point_eta + frame.eta_x * point_xi),
             slope_y = z * (frame.xi_y * point_eta + frame.eta_y * point_xi);
  warp.slope = std::sqrt((slope_x * slope_x + slope_y * slope_y).maxCoeff());
  for (const Vector& normal : frame.normal) warp.tilt = std::max(warp.tilt, 2 * normal.head<2>().norm());
  const Four lines =
      frame.xi_x * frame.xi_x + frame.xi_y * frame.xi_y + frame.eta_x * frame.eta_x + frame.eta_y * frame.eta_y;
  warp.curvature = std::sqrt(lines.maxCoeff() * 2 *
                             (frame.n.xi.squaredNorm() + frame.n.eta.squaredNorm() + frame.n.both.squaredNorm()));
  return warp;
}

/// Of a triangle: the larger eigenvalue of Σ b bᵀ with the gradients b of its corners, whose length is that of the side
/// across over twice the area.
double linear_gradient(const std::array<Vector, 4>& x) {
  const Vector a = x[1] - x[0], b = x[2] - x[0];
  const Vector along = a.normalized();
  const double base = a.norm(), foot = b.dot(along), height = (b - foot * along).norm(), area = base * height;
  Gram gram;
  gram.add(-height / area, (foot - base) / area);
  gram.add(height / area, -foot / area);
  gram.add(0, base / area);
  return gram.largest();
}

/// That of set_time_steps(), and a sharper one where the warp costs much of the step and the shell may limit that of
/// the run: one that allows 5 % more than the last step does not.
double squared_frequency(const ShellProperties& properties, const ShellShape& shape, const FullFrame& frame, double dt,
                         WarpedFrequency& warped) {
  constexpr double least_slope = 0.01, much = 1.05, longer = 1.05;
  const ShellFrequency cheap = squared_frequency(properties, shape);
  if (!(shape.warp.slope > least_slope && cheap.bound > much * much * cheap.largest)) return cheap.bound;
  const double least = longer * dt;
  if (dt > 0 && !properties.viscosity.on() && least * least * cheap.bound < 4) return cheap.bound;
  return std::min(cheap.bound, warped.squared(properties, frame, shape.thickness));
}

void set_full_steps(const ShellProperties& properties, const std::array<Vector, 4>& x, const FullFrame& frame,
                    double dt, ShellState& state, ShellForces& out) {
  const double thickness = state.thickness;
  double squared_side = 0;
  for (std::size_t i = 0; i < 4; ++i) squared_side = std::max(squared_side, (x[(i + 1) % 4] - x[i]).squaredNorm());
  const bool collapsed = x[2] == x[3];
  const double length = (collapsed ? 2 : 1) * frame.area;
  const QuadGram gram{frame.determinant * (frame.xi_x * frame.xi_x + frame.xi_y * frame.xi_y),
                      frame.determinant * (frame.eta_x * frame.eta_x + frame.eta_y * frame.eta_y),
                      frame.determinant * (frame.xi_x * frame.eta_x + frame.xi_y * frame.eta_y)};
  ShellShape shape{4, frame.area, thickness, length * length / squared_side, gram.gradient() / frame.area, 0};
  shape.shear =
      gram.shear(frame.x.xi, frame.x.eta, frame.x.both, properties.inertia(frame.area, thickness)) / frame.area;
  if (collapsed) {
    // Its fields are linear. A collapsed corner counts twice in the sums over four corners, but has one of three shares
    // of the mass: twice the bound of the shear.
    shape.corners = 3;
    shape.gradient = linear_gradient(x);
    shape.shear *= 2;
  }
  shape.warp = warp_of(frame);
  set_time_steps(properties, shape, squared_frequency(properties, shape, frame, dt, state.warped), out);
}

}  // namespace

Matrix full_axes(const std::array<Vector, 4>& x, ShellAxes axes) {
  const FullFrame frame = make_full_frame(x, axes);
  Matrix columns;
  columns << frame.e1, frame.e2, frame.e3;
  return columns;
}

ShellForces full_forces(const ShellProperties& properties, const ShellCorners& corners, double dt, ShellState& state,
                        std::span<PointState> points) {
  ShellForces out;
  const std::array<Vector, 4> middle_x = half_step_ago(corners.x, corners.v, dt);
  const double poisson = properties.material.poisson;
  const FullFrame middle = make_full_frame(middle_x, properties.axes),
                  end = make_full_frame(corners.x, properties.axes);
  std::array<Vector, 4> turns;
  for (std::size_t i = 0; i < 4; ++i) turns[i] = middle.local(corners.w[i]).cross(middle.normal[i]);
  const FullStrains rates =
      full_rates(middle, MembraneModes(middle, poisson), middle.local(bilinear(corners.v)), bilinear(turns));
  FullStrains resultants = integrate_points(properties, middle, rates, dt, state, points, out.dissipated);
  if (properties.viscosity.on()) add_viscosity(properties, middle, rates, dt, state, resultants, out);
  Bilinear on_v{Vector::Zero(), Vector::Zero(), Vector::Zero(), Vector::Zero()}, on_m = on_v;
  pull(end, MembraneModes(end, poisson), resultants, on_v, on_m);
  const std::array<Vector, 4> force = at_corners(on_v), turning = at_corners(on_m);
  for (std::size_t i = 0; i < 4; ++i) {
    out.force[i] = end.global(force[i]);
    out.moment[i] = end.global(end.normal[i].cross(turning[i]));
  }
  set_full_steps(properties, corners.x, end, dt, state, out);
  out.good = (end.determinant > 0).all() && (middle.determinant > 0).all() &&
             std::isfinite(out.force[0].sum() + out.force[1].sum() + out.moment[0].sum() + out.moment[1].sum());
  return out;
}

double full_stored_energy(const ShellProperties& properties, const ShellState& state, const std::array<Vector, 4>& x,
                          std::span<const PointState> points) {
  const FullFrame frame = make_full_frame(x);
  const std::size_t layers = properties.layers.size();
  double energy = 0;
  for (std::size_t i = 0; i < 4; ++i)
    energy += stored_energy(properties, state, frame.determinant[static_cast<Eigen::Index>(i)],
                            points.subspan(i * layers, layers));
  return energy;
}

}  // namespace gapcheck::solver
