#include <optional>
#include <utility>

#include "solver/element/shell.hpp"
#include "solver/element/shell_warping.hpp"

namespace gapcheck::solver {
namespace {

/// Axes of the element, half diagonals and hourglass shape of its corners in them. With e3 normal to both diagonals
/// the corners lie at ± warp / 4 from the mean plane.
struct QuadFrame {
  Vector e1, e2, e3;
  double area;
  double bx1, bx2, by1, by2;      ///< ∂N/∂x of corners 1 and 2; 3 and 4 have the opposite
  double shape_x, shape_y, warp;  ///< x₁ − x₂ + x₃ − x₄ in the three axes
};

/// Two numbers treated alike: roots and divisions of both cost as much as of one.
using Both = Eigen::Array2d;

struct BothVectors {
  Both x, y, z;
  BothVectors(Both along_x, Both along_y, Both along_z)
      : x(std::move(along_x)), y(std::move(along_y)), z(std::move(along_z)) {}
  BothVectors(const Vector& a, const Vector& b) : x(a.x(), b.x()), y(a.y(), b.y()), z(a.z(), b.z()) {}
  [[nodiscard]] Both dot(const BothVectors& o) const { return x * o.x + y * o.y + z * o.z; }
  [[nodiscard]] BothVectors cross(const BothVectors& o) const {
    return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x};
  }
  [[nodiscard]] Vector at(int i) const { return {x[i], y[i], z[i]}; }
};

BothVectors operator-(const BothVectors& a, const BothVectors& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
BothVectors operator+(const BothVectors& a, const BothVectors& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
BothVectors operator*(const Both& f, const BothVectors& a) { return {f * a.x, f * a.y, f * a.z}; }

BothVectors unit_of(const BothVectors& a) { return Both(1 / a.dot(a).sqrt()) * a; }

/// The frames in the middle and at the end of the step.
std::array<QuadFrame, 2> make_frames(const std::array<Vector, 4>& middle, const std::array<Vector, 4>& end,
                                     ShellAxes axes) {
  const auto difference = [&](std::size_t i, std::size_t j) {
    return BothVectors(middle[i] - middle[j], end[i] - end[j]);
  };
  const BothVectors d31 = difference(2, 0), d42 = difference(3, 1), side = difference(1, 0);
  const BothVectors normal = d31.cross(d42);
  // Roots and divisions independent of one another: this is the slowest part of the element.
  const Both square = normal.dot(normal), inverse_square = 1 / square, twice_area = square.sqrt();
  BothVectors along = side - Both(side.dot(normal) * inverse_square) * normal;
  // Coincident corners 1 and 2 give no direction: the diagonal does.
  if (!(along.dot(along) > 0).all()) along = d31;
  if (axes == ShellAxes::invariant) along = invariant_direction(d31 - d42, d31 + d42);
  const Both inverse = twice_area * inverse_square;
  const BothVectors e3 = inverse * normal, e1 = Both(1 / along.dot(along).sqrt()) * along, e2 = e3.cross(e1);
  const Both bx1 = -d42.dot(e2) * inverse, bx2 = d31.dot(e2) * inverse;
  const Both by1 = d42.dot(e1) * inverse, by2 = -d31.dot(e1) * inverse;
  const BothVectors shape = difference(0, 1) - difference(3, 2);
  const Both shape_x = shape.dot(e1), shape_y = shape.dot(e2), warp = shape.dot(e3);
  const auto frame = [&](int i) {
    return QuadFrame{e1.at(i), e2.at(i), e3.at(i),   twice_area[i] / 2, bx1[i], bx2[i],
                     by1[i],   by2[i],   shape_x[i], shape_y[i],        warp[i]};
  };
  return {frame(0), frame(1)};
}

/// A field of vectors at the corners, seen in the frame: derivatives in the plane, hourglass part, mean.
struct Field {
  Vector dx, dy, hourglass;
};

Field field_of(const QuadFrame& frame, const std::array<Vector, 4>& v) {
  const auto local = [&](const Vector& a) { return Vector(a.dot(frame.e1), a.dot(frame.e2), a.dot(frame.e3)); };
  const Vector v13 = local(v[0] - v[2]), v24 = local(v[1] - v[3]), shape = local(v[0] - v[1] + v[2] - v[3]);
  Field field;
  field.dx = frame.bx1 * v13 + frame.bx2 * v24;
  field.dy = frame.by1 * v13 + frame.by2 * v24;
  field.hourglass = shape - frame.shape_x * field.dx - frame.shape_y * field.dy;
  return field;
}

/// Rates of the five hourglass modes. The corners of a warped quad move out of step in x and y when it only rotates
/// about y and x; that part is not hourglassing.
HourglassModes hourglass_rates(const QuadFrame& frame, const Field& v, const Field& w) {
  return {v.hourglass.x() + frame.warp * v.dx.z(), v.hourglass.y() + frame.warp * v.dy.z(), v.hourglass.z(),
          w.hourglass.x(), w.hourglass.y()};
}

/// Viscosity of the modes.
HourglassModes hourglass_viscosity(const ShellProperties& properties, double area, double thickness) {
  const Material& material = properties.material;
  const Hourglass& control = properties.hourglass;
  const double squared_thickness = thickness * thickness;
  const double speed = std::sqrt(material.plate_modulus() / material.density);
  const double common = material.density * speed * thickness * std::sqrt(area) / 4;
  const double membrane = control.coefficient * common, bending = control.bending * common * squared_thickness / 12;
  if (properties.membrane) return {membrane, membrane, 0, 0, 0};
  const double deflection = control.warping * common * std::min(1.0, squared_thickness / area);
  return {membrane, membrane, deflection, bending, bending};
}

/// Updates the hourglass stresses to the end of the step; returns the work.
double update_hourglass(const ShellProperties& properties, const QuadFrame& middle, const HourglassModes& rates,
                        double dt, ShellState& state) {
  if (properties.hourglass.kind == HourglassKind::none || dt <= 0) return 0;
  const bool viscous = properties.hourglass.kind == HourglassKind::viscous;
  const HourglassModes moduli =
      viscous ? hourglass_viscosity(properties, middle.area, state.thickness) : state.stiffness;
  double work = 0;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const double before = state.hourglass[i];
    state.hourglass[i] = viscous ? moduli[i] * rates[i] : before + moduli[i] * rates[i] * dt;
    work += dt * rates[i] * (before + state.hourglass[i]) / 2;
  }
  return work;
}

ShellStrain strain_of(const QuadFrame& frame, const Field& v, const Field& w, const std::array<Vector, 4>& all_w,
                      double dt) {
  const Vector mean = (all_w[0] + all_w[1] + all_w[2] + all_w[3]) / 4;
  ShellStrain strain;
  strain.xx = dt * v.dx.x();
  strain.yy = dt * v.dy.y();
  strain.xy = dt / 2 * (v.dx.y() + v.dy.x());
  strain.bend_xx = dt * w.dx.y();
  strain.bend_yy = -dt * w.dy.x();
  strain.bend_xy = dt / 2 * (w.dy.y() - w.dx.x());
  strain.zx = dt / 2 * (v.dx.z() + mean.dot(frame.e2));
  strain.yz = dt / 2 * (v.dy.z() - mean.dot(frame.e1));
  return strain;
}

/// Motion in the plane bends a warped quad.
void add_warping(const ShellWarping& warping, const QuadFrame& frame, const std::array<Vector, 4>& v, double dt,
                 ShellStrain& strain) {
  const Vector v13 = v[0] - v[2], v24 = v[1] - v[3];
  const double x13 = v13.dot(frame.e1), y13 = v13.dot(frame.e2), x24 = v24.dot(frame.e1), y24 = v24.dot(frame.e2);
  strain.bend_xx += dt * (warping.cx1 * x13 + warping.cx2 * x24);
  strain.bend_yy += dt * (warping.cy1 * y13 + warping.cy2 * y24);
  strain.bend_xy += dt / 2 * (warping.cx1 * y13 + warping.cx2 * y24 + warping.cy1 * x13 + warping.cy2 * x24);
}

/// The transpose of add_warping.
void spread_warping(const ShellWarping& warping, const QuadFrame& frame, const ShellResultants& n, ShellForces& out) {
  const auto force = [&](double cx, double cy) {
    return Vector(frame.area * (cx * n.bend_xx + cy * n.bend_xy) * frame.e1 +
                  frame.area * (cy * n.bend_yy + cx * n.bend_xy) * frame.e2);
  };
  const Vector force1 = force(warping.cx1, warping.cy1), force2 = force(warping.cx2, warping.cy2);
  out.force[0] += force1;
  out.force[1] += force2;
  out.force[2] -= force1;
  out.force[3] -= force2;
}

/// Transverse shear from the sides, which no bending of the quad strains: the rotation across each side is the mean
/// of its ends' and its slope, a corner's that of the two sides that meet there, the quad's the mean of its corners'.
struct SidesShear {
  std::array<double, 4> x, y;              ///< components of the sides
  std::array<double, 4> share_x, share_y;  ///< of each side's shear times its length in that of the quad

  SidesShear(const std::array<Vector, 4>& corners, const QuadFrame& frame) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector along = corners[(i + 1) % 4] - corners[i];
      x[i] = along.dot(frame.e1);
      y[i] = along.dot(frame.e2);
      const double square = x[i] * x[i] + y[i] * y[i], half = square > 0 ? 0.5 / square : 0;
      share_x[i] = half * x[i];
      share_y[i] = half * y[i];
    }
  }
  void set(const QuadFrame& frame, const std::array<Vector, 4>& v, const std::array<Vector, 4>& w, double dt,
           ShellStrain& strain) const {
    strain.zx = strain.yz = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t next = (i + 1) % 4;
      const Vector mean = (w[i] + w[next]) / 2;
      const double shear = (v[next] - v[i]).dot(frame.e3) + mean.dot(frame.e2) * x[i] - mean.dot(frame.e1) * y[i];
      strain.zx += dt / 2 * share_x[i] * shear;
      strain.yz += dt / 2 * share_y[i] * shear;
    }
  }
  void spread(const QuadFrame& frame, const ShellResultants& n, ShellForces& out) const {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t next = (i + 1) % 4;
      const double pull = frame.area * (share_x[i] * n.zx + share_y[i] * n.yz);
      const Vector twist = pull / 2 * (x[i] * frame.e2 - y[i] * frame.e1);
      out.force[next] += pull * frame.e3;
      out.force[i] -= pull * frame.e3;
      out.moment[i] += twist;
      out.moment[next] += twist;
    }
  }
  /// Larger eigenvalue of its Gram matrix, rotations over the root of their inertia per mass.
  [[nodiscard]] double gram(double inertia) const {
    Gram sum;
    const double half = 0.5 / std::sqrt(inertia);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t last = (i + 3) % 4;
      sum.add(share_x[last] - share_x[i], share_y[last] - share_y[i]);
      for (const std::array<double, 4>& side : {x, y})
        sum.add(half * (share_x[i] * side[i] + share_x[last] * side[last]),
                half * (share_y[i] * side[i] + share_y[last] * side[last]));
    }
    return sum.largest();
  }
};

/// Spreads resultants and hourglass stresses to the corners; the transpose of the strain operators.
void spread(const QuadFrame& frame, const ShellResultants& n, const HourglassModes& hourglass, ShellForces& out) {
  const double area = frame.area;
  const auto global = [&](double x, double y, double z) { return Vector(x * frame.e1 + y * frame.e2 + z * frame.e3); };
  const auto force = [&](double bx, double by) {
    return global(area * (bx * n.xx + by * n.xy), area * (by * n.yy + bx * n.xy), area * (bx * n.zx + by * n.yz));
  };
  const auto moment = [&](double bx, double by) {
    return global(-area * (by * n.bend_yy + bx * n.bend_xy), area * (bx * n.bend_xx + by * n.bend_xy), 0);
  };
  const Vector force1 = force(frame.bx1, frame.by1), force2 = force(frame.bx2, frame.by2);
  const Vector moment1 = moment(frame.bx1, frame.by1), moment2 = moment(frame.bx2, frame.by2);
  const Vector shear = global(-area / 4 * n.yz, area / 4 * n.zx, 0);
  const double lift_x = frame.warp * hourglass[0], lift_y = frame.warp * hourglass[1];
  const Vector mode_force = global(hourglass[0], hourglass[1], hourglass[2]);
  const Vector mode_moment = global(hourglass[3], hourglass[4], 0);
  const double g1 = -frame.shape_x * frame.bx1 - frame.shape_y * frame.by1;
  const double g2 = -frame.shape_x * frame.bx2 - frame.shape_y * frame.by2;
  const std::array<double, 4> gamma{1 + g1, -1 + g2, 1 - g1, -1 - g2};
  const Vector lift1 = (frame.bx1 * lift_x + frame.by1 * lift_y) * frame.e3;
  const Vector lift2 = (frame.bx2 * lift_x + frame.by2 * lift_y) * frame.e3;
  out.force[0] = force1 + lift1 + gamma[0] * mode_force;
  out.force[1] = force2 + lift2 + gamma[1] * mode_force;
  out.force[2] = -force1 - lift1 + gamma[2] * mode_force;
  out.force[3] = -force2 - lift2 + gamma[3] * mode_force;
  out.moment[0] = moment1 + shear + gamma[0] * mode_moment;
  out.moment[1] = moment2 + shear + gamma[1] * mode_moment;
  out.moment[2] = -moment1 + shear + gamma[2] * mode_moment;
  out.moment[3] = -moment2 + shear + gamma[3] * mode_moment;
}

/// By how much the largest eigenvalue of a P + b Q may exceed a, for projections P and Q onto spaces between whose
/// directions cos² is at most `overlap`, and b below a.
double excess(double a, double b, double overlap) {
  const double half = (a - b) / 2;
  return std::sqrt(half * half + a * b * overlap) - half;
}

/// Shortens the stable step where hourglass modes take part in the element's own: in skewed and warped quads.
void count_hourglass(const ShellProperties& properties, const QuadFrame& frame, double gradient,
                     const ShellState& state, ShellForces& out) {
  if (properties.hourglass.kind == HourglassKind::none) return;
  const bool viscous = properties.hourglass.kind == HourglassKind::viscous;
  const HourglassModes moduli =
      viscous ? hourglass_viscosity(properties, frame.area, state.thickness) : state.stiffness;
  const double inertia = properties.inertia(frame.area, state.thickness);
  const double modulus = std::max({moduli[0], moduli[2], moduli[3] / inertia});
  // The modes are (1, −1, 1, −1), which no linear motion has a part in, minus linear ones of at most this length.
  const double linear1 = frame.shape_x * frame.bx1 + frame.shape_y * frame.by1;
  const double linear2 = frame.shape_x * frame.bx2 + frame.shape_y * frame.by2;
  const double linear =
      std::sqrt(2 * (linear1 * linear1 + linear2 * linear2)) + std::abs(frame.warp) * std::sqrt(gradient);
  const double size = 4 + linear * linear, mass = properties.material.density * frame.area * state.thickness / 4;
  // Stable: ω² dt² ≤ 4 for a stiffness, 2 c dt ≤ 4 for a viscosity, since velocities lag by half a step.
  const double dt = out.stable_step, part = size * modulus / mass * (viscous ? 2 * dt : dt * dt);
  const double whole = 4 + excess(4, part, linear * linear / size);
  out.stable_step *= viscous ? 4 / whole : std::sqrt(4 / whole);
}

void set_steps(const ShellProperties& properties, const std::array<Vector, 4>& x, const QuadFrame& frame,
               const ShellState& state, const ShellWarping* warping, ShellForces& out) {
  const double thickness = state.thickness;
  const double squared_side = std::max(std::max((x[1] - x[0]).squaredNorm(), (x[2] - x[1]).squaredNorm()),
                                       std::max((x[3] - x[2]).squaredNorm(), (x[0] - x[3]).squaredNorm()));
  Gram gradient;
  gradient.add(std::sqrt(2) * frame.bx1, std::sqrt(2) * frame.by1);
  gradient.add(std::sqrt(2) * frame.bx2, std::sqrt(2) * frame.by2);
  const double largest = gradient.largest();
  // Four times (1/4)² over the inertia, the same in all directions.
  const double rotation = 0.25 / properties.inertia(frame.area, thickness);
  ShellShape shape{4, frame.area, thickness, frame.area * frame.area / squared_side, largest, largest + rotation};
  if (warping != nullptr) {
    Gram change;
    change.add(std::sqrt(2) * warping->cx1, std::sqrt(2) * warping->cy1);
    change.add(std::sqrt(2) * warping->cx2, std::sqrt(2) * warping->cy2);
    shape.warp.curvature = std::sqrt(change.largest() / largest);
    shape.warp.tilt = warping->squared_tilt(frame.e3);
    if (properties.sides_shear) shape.shear = SidesShear(x, frame).gram(properties.inertia(frame.area, thickness));
  }
  set_time_steps(properties, shape, out);
  count_hourglass(properties, frame, largest, state, out);
}

/// Forces, work and time steps of the resultants.
void finish(const ShellProperties& properties, const std::array<Vector, 4>& x, const QuadFrame& middle,
            const QuadFrame& end, const ShellResultants& resultants, const ShellState& state,
            const ShellWarping* warping, ShellForces& out) {
  out.dissipated += middle.area * resultants.plastic_work;
  if (properties.hourglass.kind == HourglassKind::viscous) out.dissipated += out.hourglass_work;
  if (warping == nullptr) {
    spread(end, resultants, state.hourglass, out);
  } else {
    ShellResultants of_centre = resultants;
    if (properties.sides_shear) of_centre.zx = of_centre.yz = 0;
    spread(end, of_centre, state.hourglass, out);
    if (properties.sides_shear) SidesShear(x, end).spread(end, resultants, out);
    spread_warping(*warping, end, resultants, out);
    warping->transpose(out.force, out.moment);
  }
  set_steps(properties, x, end, state, warping, out);
  out.good = end.area > 0 && std::isfinite(out.force[0].sum() + out.force[1].sum() + out.moment[0].sum());
}

}  // namespace

Matrix quad_axes(const std::array<Vector, 4>& x, ShellAxes axes) {
  const QuadFrame frame = make_frames(x, x, axes)[0];
  Matrix columns;
  columns << frame.e1, frame.e2, frame.e3;
  return columns;
}

HourglassModes hourglass_stiffness(const ShellProperties& properties, const std::array<Vector, 4>& x,
                                   double thickness) {
  if (properties.hourglass.kind != HourglassKind::stiffness) return {};
  const QuadFrame frame = make_frames(x, x, properties.axes)[0];
  const Material& material = properties.material;
  const double squared_gradient =
      2 * (frame.bx1 * frame.bx1 + frame.bx2 * frame.bx2 + frame.by1 * frame.by1 + frame.by2 * frame.by2);
  const Hourglass& control = properties.hourglass;
  const double squared_thickness = thickness * thickness, of_gradient = thickness * squared_gradient;
  const double membrane = control.coefficient * of_gradient * frame.area * material.young / 8;
  const double deflection =
      control.warping * of_gradient * squared_thickness * properties.shear_factor * material.shear() / 12;
  const double bending = control.bending * of_gradient * frame.area * material.young * squared_thickness / 192;
  if (properties.membrane) return {membrane, membrane, 0, 0, 0};
  return {membrane, membrane, deflection, bending, bending};
}

ShellForces quad_forces(const ShellProperties& properties, const ShellCorners& corners, double dt, ShellState& state,
                        std::span<PointState> points) {
  ShellForces out;
  const std::array<Vector, 4> middle_x = half_step_ago(corners.x, corners.v, dt);
  const auto [middle, end] = make_frames(middle_x, corners.x, properties.axes);
  const Field v = field_of(middle, corners.v), w = field_of(middle, corners.w);
  out.hourglass_work = update_hourglass(properties, middle, hourglass_rates(middle, v, w), dt, state);
  const ShellStrain strain = strain_of(middle, v, w, corners.w, dt);
  ShellResultants resultants = integrate_layers(properties, strain, dt, state.thickness, points);
  if (properties.viscosity.on())
    add_bulk_viscosity(properties, middle.area, strain.xx + strain.yy, dt, state, resultants, out);
  finish(properties, corners.x, middle, end, resultants, state, nullptr, out);
  return out;
}

ShellForces warped_quad_forces(const ShellProperties& properties, const ShellCorners& corners, double dt,
                               ShellState& state, std::span<PointState> points) {
  ShellForces out;
  const std::array<Vector, 4> middle_x = half_step_ago(corners.x, corners.v, dt);
  const auto [middle, end] = make_frames(middle_x, corners.x, properties.axes);
  const bool full = properties.projection == ShellProjection::full;
  const ShellWarping before(middle_x, middle.e1, middle.e2, middle.area, full),
      after(corners.x, end.e1, end.e2, end.area, full);
  std::array<Vector, 4> all_v = corners.v, all_w = corners.w;
  before.project(all_v, all_w);
  const Field v = field_of(middle, all_v), w = field_of(middle, all_w);
  out.hourglass_work = update_hourglass(properties, middle, hourglass_rates(middle, v, w), dt, state);
  ShellStrain strain = strain_of(middle, v, w, all_w, dt);
  add_warping(before, middle, all_v, dt, strain);
  if (properties.sides_shear) SidesShear(middle_x, middle).set(middle, all_v, all_w, dt, strain);
  ShellResultants resultants = integrate_layers(properties, strain, dt, state.thickness, points);
  if (properties.viscosity.on())
    add_bulk_viscosity(properties, middle.area, strain.xx + strain.yy, dt, state, resultants, out);
  finish(properties, corners.x, middle, end, resultants, state, &after, out);
  return out;
}

}  // namespace gapcheck::solver
