#include "solver/element/brick_batch.hpp"

#include <algorithm>
#include <cmath>

#include "solver/quadrature/brick_lanes.hpp"
#include "solver/state/batch_rows.hpp"
#include "solver/state/tensor_lanes.hpp"

namespace gapcheck::solver {
namespace {

using Row = BrickBatch::Row;
using Rows = BrickBatch::Rows;
using lanes::Eight;
using lanes::load;
using lanes::Nine;
using lanes::store;
using lanes::Tensor;

/// What all bricks of a batch share.
struct Constants {
  double two_shear, pressure_part, wave, bound, bulk, quadratic_viscosity, linear_viscosity, damping, coefficient;
  bool exact, viscous, orthogonal, linear;

  explicit Constants(const SolidProperties& p)
      : two_shear(2 * p.material.shear()),
        pressure_part(p.material.bulk() - two_shear / 3),
        quadratic_viscosity(p.quadratic_viscosity),
        linear_viscosity(p.linear_viscosity),
        damping(p.material.damping),
        coefficient(p.hourglass.coefficient),
        exact(p.hourglass.exact_volume),
        viscous(p.hourglass.kind == HourglassKind::viscous),
        orthogonal(!p.hourglass.plain_shapes),
        linear(p.material.linear()) {
    static const SolidState none;
    const SolidStiffness stiffness = solid_stiffness(p.material, none);
    wave = stiffness.wave;
    bound = stiffness.bound;
    bulk = stiffness.volume;
  }
};

template <bool exact>
GAPCHECK_INLINE void move_all(BrickBatch& q, double dt) {
  const double half_step = dt / 2;
  for (std::size_t i = 0; i < BrickBatch::capacity; ++i) {
    const Eight x = load(q.x, i), v = load(q.v, i);
    const Eight middle{{x.at[0] - half_step * v.at[0], x.at[1] - half_step * v.at[1], x.at[2] - half_step * v.at[2],
                        x.at[3] - half_step * v.at[3], x.at[4] - half_step * v.at[4], x.at[5] - half_step * v.at[5],
                        x.at[6] - half_step * v.at[6], x.at[7] - half_step * v.at[7]}};
    const Eight slope = exact ? lanes::mean_slopes(middle) : lanes::centre_slopes(middle);
    const double volume = lanes::volume_of(middle, slope);
    q.middle_volume[i] = volume;
    const Nine sum = lanes::outer_sum(v, slope);
    store(q.rate, i, {sum.r0 / volume, sum.r1 / volume, sum.r2 / volume});
    store(q.middle_sum[0], i, lanes::shape_sum<0>(middle));
    store(q.middle_sum[1], i, lanes::shape_sum<1>(middle));
    store(q.middle_sum[2], i, lanes::shape_sum<2>(middle));
    store(q.middle_sum[3], i, lanes::shape_sum<3>(middle));
  }
}

/// The shape at the end of the step and what follows from it alone.
template <bool exact>
GAPCHECK_INLINE void shape_all(BrickBatch& q, const Constants c, double dt) {
  for (std::size_t i = 0; i < BrickBatch::capacity; ++i) {
    const Eight x = load(q.x, i), slope = exact ? lanes::mean_slopes(x) : lanes::centre_slopes(x);
    store(q.slope, i, slope);
    const double volume = lanes::volume_of(x, slope), squared_volume = volume * volume;
    q.volume[i] = volume;
    const Nine gram = lanes::outer_sum(slope, slope);
    const double squared_gradient =
        lanes::row_bound({gram.r0 / squared_volume, gram.r1 / squared_volume, gram.r2 / squared_volume});
    const double density = q.mass[i] / volume, length = volume / lanes::largest_face(x),
                 speed = std::sqrt(c.wave / density);
    // bulk_viscosity()
    const double rate = lanes::trace(load(q.rate, i));
    const double total = c.quadratic_viscosity * length * std::abs(rate) + c.linear_viscosity * speed;
    const double pressure = rate < 0 ? density * length * -rate * total : 0.0;
    const double damping = c.damping * density * length * speed;
    q.damping[i] = damping;
    q.viscous_work[i] = -(q.viscous_pressure[i] + pressure) / 2 * (dt * q.middle_volume[i] * rate);
    q.viscous_pressure[i] = pressure;
    // set_time_steps()
    q.manual_step[i] = length / (total + std::sqrt(total * total + speed * speed));
    const double squared_frequency = c.bound / density * 8 * squared_gradient, frequency = std::sqrt(squared_frequency);
    const double of_volume = frequency * density * length * total / (2 * c.bulk);
    const double fraction = of_volume + frequency * (damping + 0) / (2 * c.bound);
    q.stable_step[i] = 2 / frequency * (std::sqrt(1 + fraction * fraction) - fraction);
  }
}

template <bool linear>
GAPCHECK_INLINE void strain_all(BrickBatch& q, const Constants c, double dt) {
  const double half_step = dt / 2, quarter_step = dt / 4;
  for (std::size_t i = 0; i < BrickBatch::capacity; ++i) {
    const Nine rate = load(q.rate, i);
    const Triple spin{rate.r2.y - rate.r1.z, rate.r0.z - rate.r2.x, rate.r1.x - rate.r0.y};
    const Nine rotation = lanes::rotation_of(half_step * spin);
    store(q.rotation, i, rotation);
    const Tensor of_rate = lanes::symmetric(rate);
    const Tensor strain = lanes::turned(
        {of_rate.xx * dt, of_rate.yy * dt, of_rate.zz * dt, of_rate.xy * dt, of_rate.yz * dt, of_rate.zx * dt},
        lanes::rotation_of(quarter_step * spin));
    Tensor stress = lanes::turned(load(q.stress, i), rotation);
    if constexpr (linear) {  // Hooke's law
      const double pressure = c.pressure_part * (strain.xx + strain.yy + strain.zz);
      stress.xx += c.two_shear * strain.xx + pressure;
      stress.yy += c.two_shear * strain.yy + pressure;
      stress.zz += c.two_shear * strain.zz + pressure;
      stress.xy += c.two_shear * strain.xy + 0;
      stress.yz += c.two_shear * strain.yz + 0;
      stress.zx += c.two_shear * strain.zx + 0;
    } else {
      store(q.strain, i, strain);
    }
    store(q.stress, i, stress);
  }
}

/// Updates one viscous hourglass stress; returns its work.
GAPCHECK_INLINE double next_hourglass(Rows& rows, std::size_t i, const Nine& rotation, double factor, Triple rate,
                                      double half_step) {
  const Triple before = rotation * load(rows, i), now = factor * rate;
  store(rows, i, now);
  return half_step * dot(rate, before + now);
}

template <bool orthogonal>
GAPCHECK_INLINE void hold_all(BrickBatch& q, const Constants c, double dt) {
  const double half_step = dt / 2, quarter = c.coefficient / 4;
  for (std::size_t i = 0; i < BrickBatch::capacity; ++i) {
    const Eight v = load(q.v, i);
    Triple r0 = lanes::shape_sum<0>(v), r1 = lanes::shape_sum<1>(v), r2 = lanes::shape_sum<2>(v),
           r3 = lanes::shape_sum<3>(v);
    if constexpr (orthogonal) {
      const Nine rate = load(q.rate, i);
      r0 = r0 - rate * load(q.middle_sum[0], i);
      r1 = r1 - rate * load(q.middle_sum[1], i);
      r2 = r2 - rate * load(q.middle_sum[2], i);
      r3 = r3 - rate * load(q.middle_sum[3], i);
    }
    const double density = q.mass[i] / q.volume[i], factor = quarter * std::sqrt(density * c.wave) * q.root[i];
    const Nine rotation = load(q.rotation, i);
    double work = 0 + next_hourglass(q.hourglass[0], i, rotation, factor, r0, half_step);
    work += next_hourglass(q.hourglass[1], i, rotation, factor, r1, half_step);
    work += next_hourglass(q.hourglass[2], i, rotation, factor, r2, half_step);
    work += next_hourglass(q.hourglass[3], i, rotation, factor, r3, half_step);
    q.hourglass_work[i] = work;
  }
}

GAPCHECK_INLINE void begin_batch(BrickBatch& q, const Constants& c, double dt) {
  if (c.exact) {
    move_all<true>(q, dt);
    shape_all<true>(q, c, dt);
  } else {
    move_all<false>(q, dt);
    shape_all<false>(q, c, dt);
  }
  c.linear ? strain_all<true>(q, c, dt) : strain_all<false>(q, c, dt);
  if (!c.viscous || dt <= 0) {
    q.hourglass_work.fill(0);
    return;
  }
  for (std::size_t i = 0; i < q.size; ++i) q.root[i] = std::pow(std::cbrt(q.volume[i]), 2);
  std::fill(q.root.begin() + static_cast<std::ptrdiff_t>(q.size), q.root.end(), 1.0);
  c.orthogonal ? hold_all<true>(q, c, dt) : hold_all<false>(q, c, dt);
}

/// σ − Q (shape · x) / V
GAPCHECK_INLINE void take_linear_part(Nine& stress, Triple hourglass, Triple shape, double volume) {
  stress.r0 = stress.r0 - (hourglass.x * shape) / volume;
  stress.r1 = stress.r1 - (hourglass.y * shape) / volume;
  stress.r2 = stress.r2 - (hourglass.z * shape) / volume;
}

template <std::size_t a, bool viscous>
GAPCHECK_INLINE void pull(BrickBatch& q, std::size_t i, const Nine& stress, Triple h0, Triple h1, Triple h2,
                          Triple h3) {
  Triple force = stress * load(q.slope[a], i);
  if constexpr (viscous)
    force = force + lanes::shapes[0][a] * h0 + lanes::shapes[1][a] * h1 + lanes::shapes[2][a] * h2 +
            lanes::shapes[3][a] * h3;
  store(q.force[a], i, force);
}

template <bool viscous, bool orthogonal>
GAPCHECK_INLINE void pull_all(BrickBatch& q) {
  for (std::size_t i = 0; i < BrickBatch::capacity; ++i) {
    const Nine point = lanes::matrix(load(q.stress, i));
    const Nine rate = lanes::matrix(lanes::symmetric(load(q.rate, i)));
    const double p = q.viscous_pressure[i], none = p * 0, damping = q.damping[i];
    Nine stress{point.r0 - Triple{p, none, none} + damping * rate.r0,
                point.r1 - Triple{none, p, none} + damping * rate.r1,
                point.r2 - Triple{none, none, p} + damping * rate.r2};
    const Triple h0 = load(q.hourglass[0], i), h1 = load(q.hourglass[1], i), h2 = load(q.hourglass[2], i),
                 h3 = load(q.hourglass[3], i);
    if constexpr (viscous && orthogonal) {
      const Eight x = load(q.x, i);
      const double volume = q.volume[i];
      take_linear_part(stress, h0, lanes::shape_sum<0>(x), volume);
      take_linear_part(stress, h1, lanes::shape_sum<1>(x), volume);
      take_linear_part(stress, h2, lanes::shape_sum<2>(x), volume);
      take_linear_part(stress, h3, lanes::shape_sum<3>(x), volume);
    }
    pull<0, viscous>(q, i, stress, h0, h1, h2, h3);
    pull<1, viscous>(q, i, stress, h0, h1, h2, h3);
    pull<2, viscous>(q, i, stress, h0, h1, h2, h3);
    pull<3, viscous>(q, i, stress, h0, h1, h2, h3);
    pull<4, viscous>(q, i, stress, h0, h1, h2, h3);
    pull<5, viscous>(q, i, stress, h0, h1, h2, h3);
    pull<6, viscous>(q, i, stress, h0, h1, h2, h3);
    pull<7, viscous>(q, i, stress, h0, h1, h2, h3);
  }
}

GAPCHECK_INLINE void end_batch(BrickBatch& q, const Constants& c) {
  if (!c.viscous)
    pull_all<false, false>(q);
  else if (c.orthogonal)
    pull_all<true, true>(q);
  else
    pull_all<true, false>(q);
}

#if GAPCHECK_WIDE_VECTORS
GAPCHECK_FOUR_LANES void begin_four(BrickBatch& q, const Constants& c, double dt) { begin_batch(q, c, dt); }
GAPCHECK_FOUR_LANES void end_four(BrickBatch& q, const Constants& c) { end_batch(q, c); }
GAPCHECK_EIGHT_LANES void begin_eight(BrickBatch& q, const Constants& c, double dt) { begin_batch(q, c, dt); }
GAPCHECK_EIGHT_LANES void end_eight(BrickBatch& q, const Constants& c) { end_batch(q, c); }
#endif

Symmetric get(const BrickBatch::Six& rows, std::size_t i) {
  return {rows[0][i], rows[1][i], rows[2][i], rows[3][i], rows[4][i], rows[5][i]};
}

}  // namespace

bool BrickBatch::takes(const SolidProperties& properties) {
  const Material& material = properties.material;
  const HourglassKind control = properties.hourglass.kind;
  return material.has_stress() && material.kind != MaterialKind::rubber && !material.hydro && !material.erosion &&
         !properties.weld.exist() && (control == HourglassKind::none || control == HourglassKind::viscous);
}

void BrickBatch::add(const std::array<NodeIndex, 8>& nodes, const State& motion, const SolidState& state,
                     const PointState& point) {
  const std::size_t i = size++;
  for (std::size_t k = 0; k < 8; ++k) {
    const std::uint32_t node = nodes[k].value;
    put(x[k], i, motion.x[node]);
    put(v[k], i, motion.v[node]);
  }
  mass[i] = state.mass;
  viscous_pressure[i] = state.viscous_pressure;
  for (std::size_t m = 0; m < 4; ++m) put(hourglass[m], i, state.hourglass[m]);
  for (std::size_t k = 0; k < 6; ++k) stress[k][i] = point.stress[k];
}

double BrickBatch::integrate(std::size_t i, const SolidProperties& properties, double dt, SolidState& state,
                             PointState& point) {
  if (!whole(i)) return 0;
  state.viscous_pressure = viscous_pressure[i];
  for (std::size_t m = 0; m < 4; ++m) state.hourglass[m] = get(hourglass[m], i);
  point.stress = get(stress, i);
  const Material& material = properties.material;
  if (material.linear()) return 0;
  const double before = point.plastic_work;
  if (material.has_back_stress()) {
    Matrix turn;
    for (Eigen::Index k = 0; k < 3; ++k) turn.row(k) = get(rotation[static_cast<std::size_t>(k)], i).transpose();
    point.back_stress = rotated(point.back_stress, turn);
  }
  update_stress(material, get(strain, i), dt, point);
  for (std::size_t k = 0; k < 6; ++k) stress[k][i] = point.stress[k];
  return point.plastic_work - before;
}

SolidForces BrickBatch::forces(std::size_t i, double dt, double plastic_work) const {
  SolidForces out;
  out.volume = volume[i];
  if (!whole(i)) {
    for (Vector& each : out.force) each.setZero();
    return out;
  }
  out.hourglass_work = hourglass_work[i];
  out.viscous_work = viscous_work[i];
  out.dissipated = middle_volume[i] * plastic_work + out.hourglass_work + out.viscous_work;
  Matrix gradient;
  for (Eigen::Index k = 0; k < 3; ++k) gradient.row(k) = get(rate[static_cast<std::size_t>(k)], i).transpose();
  const Symmetric velocity_strain = to_symmetric(gradient);
  out.dissipated += middle_volume[i] * dt * damping[i] * contract(velocity_strain, velocity_strain);
  out.manual_step = manual_step[i];
  out.stable_step = stable_step[i];
  for (std::size_t k = 0; k < 8; ++k) out.force[k] = get(force[k], i);
  out.good = std::isfinite(out.force[0].sum() + out.force[6].sum());
  return out;
}

void BrickBatch::begin(const SolidProperties& properties, double dt, [[maybe_unused]] Lanes width) {
  if (size > 0 && size < capacity) {
    pad(x, size);
    pad(v, size);
    pad(hourglass, size);
    pad(stress, size);
    pad(mass, size);
    pad(viscous_pressure, size);
  }
#if GAPCHECK_WIDE_VECTORS
  if (width == Lanes::eight) return begin_eight(*this, Constants(properties), dt);
  if (width == Lanes::four) return begin_four(*this, Constants(properties), dt);
#endif
  begin_batch(*this, Constants(properties), dt);
}

void BrickBatch::end(const SolidProperties& properties, [[maybe_unused]] Lanes width) {
  if (size > 0 && size < capacity) pad(stress, size);
#if GAPCHECK_WIDE_VECTORS
  if (width == Lanes::eight) return end_eight(*this, Constants(properties));
  if (width == Lanes::four) return end_four(*this, Constants(properties));
#endif
  end_batch(*this, Constants(properties));
}

}  // namespace gapcheck::solver
