#include "solver/element/quad_batch.hpp"

#include <algorithm>
#include <cmath>

#include "base/triple.hpp"
#include "solver/state/batch_rows.hpp"

namespace gapcheck::solver {
namespace {

using Row = QuadBatch::Row;
using Rows = QuadBatch::Rows;

struct Frame {
  Triple e1, e2, e3;
  double area, bx1, bx2, by1, by2, shape_x, shape_y, warp;
};

/// The part of a frame that does not need the other one.
struct Diagonals {
  Triple d31, d42, side, shape, normal, along;
  double inverse_square, twice_area, squared_along;

  GAPCHECK_INLINE Diagonals(Triple p0, Triple p1, Triple p2, Triple p3)
      : d31(p2 - p0), d42(p3 - p1), side(p1 - p0), shape((p0 - p1) - (p3 - p2)), normal(cross(d31, d42)) {
    const double square = dot(normal, normal);
    inverse_square = 1 / square;
    twice_area = std::sqrt(square);
    along = side - (dot(side, normal) * inverse_square) * normal;
    squared_along = dot(along, along);
  }
  /// `directed`: false if corners 1 and 2 coincide in one of the two frames, so that the side has no direction.
  GAPCHECK_INLINE Frame frame(bool directed) const {
    const Triple first{directed ? along.x : d31.x, directed ? along.y : d31.y, directed ? along.z : d31.z};
    const double inverse = twice_area * inverse_square;
    Frame f;
    f.e3 = inverse * normal;
    f.e1 = (1 / std::sqrt(dot(first, first))) * first;
    f.e2 = cross(f.e3, f.e1);
    f.bx1 = -dot(d42, f.e2) * inverse;
    f.bx2 = dot(d31, f.e2) * inverse;
    f.by1 = dot(d42, f.e1) * inverse;
    f.by2 = -dot(d31, f.e1) * inverse;
    f.shape_x = dot(shape, f.e1);
    f.shape_y = dot(shape, f.e2);
    f.warp = dot(shape, f.e3);
    f.area = twice_area / 2;
    return f;
  }
};

struct Field {
  Triple dx, dy, hourglass;
};

GAPCHECK_INLINE Field field_of(const Frame& f, Triple v0, Triple v1, Triple v2, Triple v3) {
  const Triple a = v0 - v2, b = v1 - v3, c = v0 - v1 + v2 - v3;
  const Triple v13{dot(a, f.e1), dot(a, f.e2), dot(a, f.e3)}, v24{dot(b, f.e1), dot(b, f.e2), dot(b, f.e3)};
  const Triple shape{dot(c, f.e1), dot(c, f.e2), dot(c, f.e3)};
  Field field;
  field.dx = f.bx1 * v13 + f.bx2 * v24;
  field.dy = f.by1 * v13 + f.by2 * v24;
  field.hourglass = shape - f.shape_x * field.dx - f.shape_y * field.dy;
  return field;
}

/// What all quads of a batch share.
struct Constants {
  double density, plate, stiffest, shear_modulus, shear_factor, poisson, speed;
  double of_membrane, of_deflection, of_bending;  ///< hourglass coefficients
  bool viscous, controlled;

  explicit Constants(const ShellProperties& p)
      : density(p.material.density),
        plate(p.material.plate_modulus()),
        stiffest(p.stiffest),
        shear_modulus(p.material.shear()),
        shear_factor(p.shear_factor),
        poisson(p.material.poisson),
        speed(std::sqrt(plate / density)),
        of_membrane(p.hourglass.coefficient),
        of_deflection(p.membrane ? 0 : p.hourglass.warping),
        of_bending(p.membrane ? 0 : p.hourglass.bending),
        viscous(p.hourglass.kind == HourglassKind::viscous),
        controlled(p.hourglass.kind != HourglassKind::none) {}
};

/// Of the membrane, the deflection and the rotations.
struct Viscosity {
  double membrane, deflection, bending;
};

GAPCHECK_INLINE Viscosity viscosity_of(const Constants& c, double area, double thickness) {
  const double squared_thickness = thickness * thickness;
  const double common = c.density * c.speed * thickness * std::sqrt(area) / 4;
  const double ratio = squared_thickness / area;
  return {c.of_membrane * common, c.of_deflection * common * (ratio < 1 ? ratio : 1.0),
          c.of_bending * common * squared_thickness / 12};
}

template <bool viscous>
GAPCHECK_INLINE double next_stress(double modulus, double rate, double before, double dt) {
  return viscous ? modulus * rate : before + modulus * rate * dt;
}

/// `active`: hourglass stresses follow the motion.
template <bool active, bool viscous>
GAPCHECK_INLINE void strain_all(QuadBatch& q, const Constants c, double dt) {
  const double half_step = dt / 2;
  for (std::size_t i = 0; i < QuadBatch::capacity; ++i) {
    const Triple x0 = load(q.x[0], i), x1 = load(q.x[1], i), x2 = load(q.x[2], i), x3 = load(q.x[3], i);
    const Triple v0 = load(q.v[0], i), v1 = load(q.v[1], i), v2 = load(q.v[2], i), v3 = load(q.v[3], i);
    const Diagonals of_middle(x0 - half_step * v0, x1 - half_step * v1, x2 - half_step * v2, x3 - half_step * v3);
    const Diagonals of_end(x0, x1, x2, x3);
    const bool directed = (of_middle.squared_along > 0) & (of_end.squared_along > 0);
    const Frame f = of_middle.frame(directed), end = of_end.frame(directed);
    store(q.e1, i, end.e1);
    store(q.e2, i, end.e2);
    store(q.e3, i, end.e3);
    q.area[i] = end.area;
    q.bx1[i] = end.bx1;
    q.bx2[i] = end.bx2;
    q.by1[i] = end.by1;
    q.by2[i] = end.by2;
    q.shape_x[i] = end.shape_x;
    q.shape_y[i] = end.shape_y;
    q.warp[i] = end.warp;
    q.middle_area[i] = f.area;
    const Triple w0 = load(q.w[0], i), w1 = load(q.w[1], i), w2 = load(q.w[2], i), w3 = load(q.w[3], i);
    const Field v = field_of(f, v0, v1, v2, v3), w = field_of(f, w0, w1, w2, w3);
    if constexpr (active) {
      const double r0 = v.hourglass.x + f.warp * v.dx.z, r1 = v.hourglass.y + f.warp * v.dy.z, r2 = v.hourglass.z,
                   r3 = w.hourglass.x, r4 = w.hourglass.y;
      double m0 = q.stiffness[0][i], m1 = q.stiffness[1][i], m2 = q.stiffness[2][i], m3 = q.stiffness[3][i],
             m4 = q.stiffness[4][i];
      if constexpr (viscous) {
        const Viscosity viscosity = viscosity_of(c, f.area, q.thickness[i]);
        m0 = m1 = viscosity.membrane;
        m2 = viscosity.deflection;
        m3 = m4 = viscosity.bending;
      }
      const double b0 = q.hourglass[0][i], b1 = q.hourglass[1][i], b2 = q.hourglass[2][i], b3 = q.hourglass[3][i],
                   b4 = q.hourglass[4][i];
      const double h0 = next_stress<viscous>(m0, r0, b0, dt), h1 = next_stress<viscous>(m1, r1, b1, dt),
                   h2 = next_stress<viscous>(m2, r2, b2, dt), h3 = next_stress<viscous>(m3, r3, b3, dt),
                   h4 = next_stress<viscous>(m4, r4, b4, dt);
      q.hourglass[0][i] = h0;
      q.hourglass[1][i] = h1;
      q.hourglass[2][i] = h2;
      q.hourglass[3][i] = h3;
      q.hourglass[4][i] = h4;
      q.hourglass_work[i] = 0 + dt * r0 * (b0 + h0) / 2 + dt * r1 * (b1 + h1) / 2 + dt * r2 * (b2 + h2) / 2 +
                            dt * r3 * (b3 + h3) / 2 + dt * r4 * (b4 + h4) / 2;
    } else {
      q.hourglass_work[i] = 0;
    }
    const Triple sum = w0 + w1 + w2 + w3, mean{sum.x / 4, sum.y / 4, sum.z / 4};
    q.strain[0][i] = dt * v.dx.x;
    q.strain[1][i] = dt * v.dy.y;
    q.strain[2][i] = half_step * (v.dx.y + v.dy.x);
    q.strain[3][i] = dt * w.dx.y;
    q.strain[4][i] = -dt * w.dy.x;
    q.strain[5][i] = half_step * (w.dy.y - w.dx.x);
    q.strain[6][i] = half_step * (v.dy.z - dot(mean, f.e1));
    q.strain[7][i] = half_step * (v.dx.z + dot(mean, f.e2));
  }
}

GAPCHECK_INLINE void begin_batch(QuadBatch& q, const Constants& c, double dt) {
  if (!c.controlled || dt <= 0)
    strain_all<false, false>(q, c, dt);
  else if (c.viscous)
    strain_all<true, true>(q, c, dt);
  else
    strain_all<true, false>(q, c, dt);
}

struct Axes {
  Triple e1, e2, e3;
  GAPCHECK_INLINE Triple global(double x, double y, double z) const { return x * e1 + y * e2 + z * e3; }
};

GAPCHECK_INLINE void spread_all(QuadBatch& q) {
  for (std::size_t i = 0; i < QuadBatch::capacity; ++i) {
    const Axes axes{load(q.e1, i), load(q.e2, i), load(q.e3, i)};
    const double area = q.area[i], bx1 = q.bx1[i], bx2 = q.bx2[i], by1 = q.by1[i], by2 = q.by2[i];
    const double xx = q.resultant[0][i], yy = q.resultant[1][i], xy = q.resultant[2][i], bend_xx = q.resultant[3][i],
                 bend_yy = q.resultant[4][i], bend_xy = q.resultant[5][i], yz = q.resultant[6][i],
                 zx = q.resultant[7][i];
    const Triple force1 =
        axes.global(area * (bx1 * xx + by1 * xy), area * (by1 * yy + bx1 * xy), area * (bx1 * zx + by1 * yz));
    const Triple force2 =
        axes.global(area * (bx2 * xx + by2 * xy), area * (by2 * yy + bx2 * xy), area * (bx2 * zx + by2 * yz));
    const Triple moment1 =
        axes.global(-area * (by1 * bend_yy + bx1 * bend_xy), area * (bx1 * bend_xx + by1 * bend_xy), 0);
    const Triple moment2 =
        axes.global(-area * (by2 * bend_yy + bx2 * bend_xy), area * (bx2 * bend_xx + by2 * bend_xy), 0);
    const Triple shear = axes.global(-area / 4 * yz, area / 4 * zx, 0);
    const double h0 = q.hourglass[0][i], h1 = q.hourglass[1][i], warp = q.warp[i], shape_x = q.shape_x[i],
                 shape_y = q.shape_y[i];
    const double lift_x = warp * h0, lift_y = warp * h1;
    const Triple mode_force = axes.global(h0, h1, q.hourglass[2][i]);
    const Triple mode_moment = axes.global(q.hourglass[3][i], q.hourglass[4][i], 0);
    const double g1 = -shape_x * bx1 - shape_y * by1, g2 = -shape_x * bx2 - shape_y * by2;
    const Triple lift1 = (bx1 * lift_x + by1 * lift_y) * axes.e3, lift2 = (bx2 * lift_x + by2 * lift_y) * axes.e3;
    store(q.force[0], i, force1 + lift1 + (1 + g1) * mode_force);
    store(q.force[1], i, force2 + lift2 + (-1 + g2) * mode_force);
    store(q.force[2], i, -force1 - lift1 + (1 - g1) * mode_force);
    store(q.force[3], i, -force2 - lift2 + (-1 - g2) * mode_force);
    store(q.moment[0], i, moment1 + shear + (1 + g1) * mode_moment);
    store(q.moment[1], i, moment2 + shear + (-1 + g2) * mode_moment);
    store(q.moment[2], i, -moment1 + shear + (1 - g1) * mode_moment);
    store(q.moment[3], i, -moment2 + shear + (-1 - g2) * mode_moment);
  }
}

GAPCHECK_INLINE double larger_eigenvalue(double x1, double y1, double x2, double y2) {
  const double xx = x1 * x1 + x2 * x2, xy = x1 * y1 + x2 * y2, yy = y1 * y1 + y2 * y2, half = (xx - yy) / 2;
  return (xx + yy) / 2 + std::sqrt(half * half + xy * xy);
}

/// The steps of set_time_steps() for flat quads without offsets.
GAPCHECK_INLINE void step_all(QuadBatch& q, const Constants c) {
  const double root = std::sqrt(2), squared_speed = c.plate / c.density;
  const double of_membrane = c.stiffest * squared_speed * (1 + std::abs(c.poisson));
  const double of_shear = c.stiffest * c.shear_factor * c.shear_modulus / c.density;
  for (std::size_t i = 0; i < QuadBatch::capacity; ++i) {
    const Triple x0 = load(q.x[0], i), x1 = load(q.x[1], i), x2 = load(q.x[2], i), x3 = load(q.x[3], i);
    const Triple a = x1 - x0, b = x2 - x1, d = x3 - x2, e = x0 - x3;
    const double squared_side = larger(larger(dot(a, a), dot(b, b)), larger(dot(d, d), dot(e, e)));
    const double area = q.area[i], thickness = q.thickness[i], squared_thickness = thickness * thickness;
    const double gradient = larger_eigenvalue(root * q.bx1[i], root * q.by1[i], root * q.bx2[i], root * q.by2[i]);
    const double inertia = larger(squared_thickness / 12, area / 8);
    const double membrane = of_membrane * gradient, bending = membrane * squared_thickness / 12 / inertia;
    const double across = bending + of_shear * (gradient + 0.25 / inertia);
    q.gradient[i] = gradient;
    q.manual_step[i] = std::sqrt(area * area / squared_side * c.density / c.plate);
    q.stable_step[i] = 2 / std::sqrt(4 * larger(membrane, across));
  }
}

/// count_hourglass() of quad_forces().
template <bool viscous>
GAPCHECK_INLINE void count_hourglass(QuadBatch& q, const Constants c) {
  for (std::size_t i = 0; i < QuadBatch::capacity; ++i) {
    const double area = q.area[i], thickness = q.thickness[i];
    const double inertia = larger(thickness * thickness / 12, area / 8);
    double m0 = q.stiffness[0][i], m2 = q.stiffness[2][i], m3 = q.stiffness[3][i];
    if constexpr (viscous) {
      const Viscosity viscosity = viscosity_of(c, area, thickness);
      m0 = viscosity.membrane;
      m2 = viscosity.deflection;
      m3 = viscosity.bending;
    }
    const double modulus = larger(larger(m0, m2), m3 / inertia);
    const double linear1 = q.shape_x[i] * q.bx1[i] + q.shape_y[i] * q.by1[i];
    const double linear2 = q.shape_x[i] * q.bx2[i] + q.shape_y[i] * q.by2[i];
    const double linear =
        std::sqrt(2 * (linear1 * linear1 + linear2 * linear2)) + std::abs(q.warp[i]) * std::sqrt(q.gradient[i]);
    const double size = 4 + linear * linear, mass = c.density * area * thickness / 4;
    const double dt = q.stable_step[i], part = size * modulus / mass * (viscous ? 2 * dt : dt * dt);
    const double half = (4 - part) / 2;
    const double whole = 4 + (std::sqrt(half * half + 4 * part * (linear * linear / size)) - half);
    q.stable_step[i] = dt * (viscous ? 4 / whole : std::sqrt(4 / whole));
  }
}

GAPCHECK_INLINE void end_batch(QuadBatch& q, const Constants& c) {
  spread_all(q);
  step_all(q, c);
  if (!c.controlled) return;
  if (c.viscous)
    count_hourglass<true>(q, c);
  else
    count_hourglass<false>(q, c);
}

#if GAPCHECK_WIDE_VECTORS
GAPCHECK_FOUR_LANES void begin_four(QuadBatch& q, const Constants& c, double dt) { begin_batch(q, c, dt); }
GAPCHECK_FOUR_LANES void end_four(QuadBatch& q, const Constants& c) { end_batch(q, c); }
GAPCHECK_EIGHT_LANES void begin_eight(QuadBatch& q, const Constants& c, double dt) { begin_batch(q, c, dt); }
GAPCHECK_EIGHT_LANES void end_eight(QuadBatch& q, const Constants& c) { end_batch(q, c); }
#endif

}  // namespace

bool QuadBatch::takes(const ShellProperties& properties) {
  return properties.form == ShellForm::one_point && properties.projection == ShellProjection::none &&
         properties.axes == ShellAxes::side && properties.reference == 0 && properties.layer_materials.empty() &&
         !properties.viscosity.on();
}

void QuadBatch::add(const std::array<NodeIndex, 4>& nodes, const State& motion, const ShellState& state) {
  const std::size_t i = size++;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::uint32_t node = nodes[k].value;
    put(x[k], i, motion.x[node]);
    put(v[k], i, motion.v[node]);
    put(w[k], i, motion.w[node]);
  }
  thickness[i] = state.thickness;
  for (std::size_t k = 0; k < 5; ++k) {
    hourglass[k][i] = state.hourglass[k];
    stiffness[k][i] = state.stiffness[k];
  }
}

double QuadBatch::integrate(std::size_t i, const ShellProperties& properties, double dt, ShellState& state,
                            std::span<PointState> points) {
  const ShellStrain of_step{strain[0][i], strain[1][i], strain[2][i], strain[3][i],
                            strain[4][i], strain[5][i], strain[6][i], strain[7][i]};
  const ShellResultants n = integrate_layers(properties, of_step, dt, state.thickness, points);
  const std::array<double, 8> all{n.xx, n.yy, n.xy, n.bend_xx, n.bend_yy, n.bend_xy, n.yz, n.zx};
  for (std::size_t k = 0; k < 8; ++k) resultant[k][i] = all[k];
  for (std::size_t k = 0; k < 5; ++k) state.hourglass[k] = hourglass[k][i];
  thickness[i] = state.thickness;
  return n.plastic_work;
}

double QuadBatch::exchange(std::size_t i, double dt, std::span<Vector, 4> forces, std::span<Vector, 4> moments) const {
  double work = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector new_force = get(force[k], i), new_moment = get(moment[k], i);
    work += dt / 2 * ((forces[k] + new_force).dot(get(v[k], i)) + (moments[k] + new_moment).dot(get(w[k], i)));
    forces[k] = new_force;
    moments[k] = new_moment;
  }
  return work;
}

ShellForces QuadBatch::rest_of(std::size_t i, const ShellProperties& properties, double plastic_work) const {
  ShellForces out;
  out.hourglass_work = hourglass_work[i];
  out.dissipated = middle_area[i] * plastic_work;
  if (properties.hourglass.kind == HourglassKind::viscous) out.dissipated += out.hourglass_work;
  out.manual_step = manual_step[i];
  out.stable_step = stable_step[i];
  const auto sum = [&](const Rows& rows) { return rows[0][i] + rows[1][i] + rows[2][i]; };
  out.good = area[i] > 0 && std::isfinite(sum(force[0]) + sum(force[1]) + sum(moment[0]));
  return out;
}

void QuadBatch::pad_corners() {
  if (size == 0 || size == capacity) return;
  for (std::array<Rows, 4>* const field : {&x, &v, &w})
    for (Rows& rows : *field) pad(rows, size);
  pad(hourglass, size);
  pad(stiffness, size);
  pad(thickness, size);
}

void QuadBatch::pad_resultants() {
  if (size == 0 || size == capacity) return;
  pad(resultant, size);
  pad(thickness, size);
}

void QuadBatch::begin(const ShellProperties& properties, double dt, [[maybe_unused]] Lanes lanes) {
  pad_corners();
#if GAPCHECK_WIDE_VECTORS
  if (lanes == Lanes::eight) return begin_eight(*this, Constants(properties), dt);
  if (lanes == Lanes::four) return begin_four(*this, Constants(properties), dt);
#endif
  begin_batch(*this, Constants(properties), dt);
}

void QuadBatch::end(const ShellProperties& properties, [[maybe_unused]] Lanes lanes) {
  pad_resultants();
#if GAPCHECK_WIDE_VECTORS
  if (lanes == Lanes::eight) return end_eight(*this, Constants(properties));
  if (lanes == Lanes::four) return end_four(*this, Constants(properties));
#endif
  end_batch(*this, Constants(properties));
}

}  // namespace gapcheck::solver
