// Batches of quads against quad_forces(), one quad at a time: every bit is the same.
#include "solver/element/quad_batch.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <map>
#include <random>
#include <string>

namespace gapcheck::solver::quad_batch_test {
namespace {

class Numbers {
 public:
  double number(double size) { return std::uniform_real_distribution<double>(-size, size)(engine_); }
  Vector vector(double size) { return {number(size), number(size), number(size)}; }

 private:
  std::mt19937 engine_{3};
};

struct Quad {
  ShellCorners corners;
  ShellState state;
  std::vector<PointState> points;
};

ShellProperties plastic(HourglassKind hourglass) {
  ShellProperties properties;
  properties.material = plastic_kinematic(7.8e-9, 210000, 0.3, 250, 1000, 0.5);
  properties.hourglass.kind = hourglass;
  properties.hourglass.coefficient = 0.09;
  properties.hourglass.bending = 0.11;
  properties.hourglass.warping = 0.13;
  properties.shear_factor = 5.0 / 6;
  properties.thins = true;
  return properties;
}

Quad make_quad(Numbers& numbers, const ShellProperties& properties, double size, double shape) {
  Quad quad;
  const std::array<Vector, 4> square{Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0)};
  const Matrix turn = Eigen::Quaterniond(numbers.number(1), numbers.number(1), numbers.number(1), numbers.number(1))
                          .normalized()
                          .toRotationMatrix();
  for (std::size_t k = 0; k < 4; ++k) quad.corners.x[k] = size * (turn * (square[k] + numbers.vector(shape)));
  quad.state.thickness = size * (0.1 + numbers.number(0.08));
  quad.state.stiffness = hourglass_stiffness(properties, quad.corners.x, quad.state.thickness);
  quad.points.resize(properties.layers.size());
  return quad;
}

void move(Numbers& numbers, Quad& quad, double speed, double dt) {
  for (std::size_t k = 0; k < 4; ++k) {
    quad.corners.v[k] = numbers.vector(speed);
    quad.corners.w[k] = numbers.vector(speed);
    quad.corners.x[k] += dt * quad.corners.v[k];
  }
}

std::uint64_t bits(double number) { return std::bit_cast<std::uint64_t>(number); }

void expect_same(const ShellForces& a, const ShellForces& b, const std::string& where) {
  for (std::size_t k = 0; k < 4; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(bits(a.force[k][axis]), bits(b.force[k][axis])) << where << " force " << k << axis;
      ASSERT_EQ(bits(a.moment[k][axis]), bits(b.moment[k][axis])) << where << " moment " << k << axis;
    }
  ASSERT_EQ(bits(a.hourglass_work), bits(b.hourglass_work)) << where;
  ASSERT_EQ(bits(a.dissipated), bits(b.dissipated)) << where;
  ASSERT_EQ(bits(a.viscous_work), bits(b.viscous_work)) << where;
  ASSERT_EQ(bits(a.manual_step), bits(b.manual_step)) << where;
  ASSERT_EQ(bits(a.stable_step), bits(b.stable_step)) << where;
  ASSERT_EQ(a.good, b.good) << where;
}

void expect_same(const ShellState& a, const ShellState& b, const std::string& where) {
  ASSERT_EQ(bits(a.thickness), bits(b.thickness)) << where;
  for (std::size_t k = 0; k < 5; ++k) ASSERT_EQ(bits(a.hourglass[k]), bits(b.hourglass[k])) << where;
}

std::vector<Lanes> all_lanes() {
  std::vector<Lanes> all{Lanes::two};
  for (const Lanes lanes : {Lanes::four, Lanes::eight})
    if (lanes <= lanes_of_processor()) all.push_back(lanes);
  return all;
}

/// What ShellElements does with a batch.
std::vector<ShellForces> run_batch(const ShellProperties& properties, std::vector<Quad>& quads, double dt,
                                   Lanes lanes) {
  QuadBatch batch;
  State state;
  for (const Quad& quad : quads) {
    const auto first = static_cast<std::uint32_t>(state.x.size());
    state.x.insert(state.x.end(), quad.corners.x.begin(), quad.corners.x.end());
    state.v.insert(state.v.end(), quad.corners.v.begin(), quad.corners.v.end());
    state.w.insert(state.w.end(), quad.corners.w.begin(), quad.corners.w.end());
    batch.add({NodeIndex{first}, NodeIndex{first + 1}, NodeIndex{first + 2}, NodeIndex{first + 3}}, state, quad.state);
  }
  batch.begin(properties, dt, lanes);
  std::vector<double> work;
  for (std::size_t i = 0; i < quads.size(); ++i)
    work.push_back(batch.integrate(i, properties, dt, quads[i].state, quads[i].points));
  batch.end(properties, lanes);
  std::vector<ShellForces> forces;
  for (std::size_t i = 0; i < quads.size(); ++i) {
    ShellForces& now = forces.emplace_back(batch.rest_of(i, properties, work[i]));
    now.force.fill(Vector(1, 2, 3));
    now.moment.fill(Vector(4, 5, 6));
    double expected = 0;
    const ShellForces before = now;
    const double exchanged = batch.exchange(i, dt, now.force, now.moment);
    for (std::size_t k = 0; k < 4; ++k)
      expected += dt / 2 *
                  ((before.force[k] + now.force[k]).dot(quads[i].corners.v[k]) +
                   (before.moment[k] + now.moment[k]).dot(quads[i].corners.w[k]));
    if (now.good) {
      EXPECT_EQ(exchanged, expected);
    }
  }
  return forces;
}

class Kinds : public testing::TestWithParam<HourglassKind> {};

TEST_P(Kinds, AreThoseOfSingleQuads) {
  Numbers numbers;
  std::size_t flowed = 0;
  for (int trial = 0; trial < 300; ++trial) {
    ShellProperties properties = plastic(GetParam());
    if (trial % 5 == 0) properties.material.kind = MaterialKind::elastic;
    if (trial % 7 == 0) properties.membrane = true;
    if (trial % 3 == 0) properties.layers = gauss_rule(3);
    ASSERT_TRUE(QuadBatch::takes(properties));
    const double size = std::pow(10, numbers.number(2)), shape = trial % 4 == 0 ? 0 : 0.3;
    std::vector<Quad> single;
    for (int i = 0; i <= trial % 16; ++i) single.push_back(make_quad(numbers, properties, size, shape));
    std::map<Lanes, std::vector<Quad>> batches;
    for (const Lanes lanes : all_lanes()) batches[lanes] = single;
    for (int cycle = 0; cycle < 6; ++cycle) {
      const double dt = cycle == 3 ? 0 : 1e-7 * size;
      const Numbers same = numbers;
      std::vector<ShellForces> expected;
      for (Quad& quad : single) {
        move(numbers, quad, 3e4, dt);
        expected.push_back(quad_forces(properties, quad.corners, dt, quad.state, quad.points));
      }
      for (auto& [lanes, quads] : batches) {
        Numbers again = same;
        for (Quad& quad : quads) move(again, quad, 3e4, dt);
        const std::vector<ShellForces> forces = run_batch(properties, quads, dt, lanes);
        for (std::size_t i = 0; i < single.size(); ++i) {
          const std::string where = "trial " + std::to_string(trial) + " cycle " + std::to_string(cycle) + " quad " +
                                    std::to_string(i) + " of " + std::to_string(single.size()) + " lanes " +
                                    std::to_string(static_cast<int>(lanes));
          expect_same(expected[i], forces[i], where);
          expect_same(single[i].state, quads[i].state, where);
          if (HasFatalFailure()) return;
          flowed += single[i].points[0].plastic_strain > 0;
        }
      }
    }
  }
  EXPECT_GT(flowed, 500U);
}

INSTANTIATE_TEST_SUITE_P(All, Kinds,
                         testing::Values(HourglassKind::none, HourglassKind::viscous, HourglassKind::stiffness),
                         [](const auto& kind) {
                           return std::string(kind.param == HourglassKind::none      ? "none"
                                              : kind.param == HourglassKind::viscous ? "viscous"
                                                                                     : "stiffness");
                         });

// Corners 1 and 2 in one place give no direction; without an area nothing is good.
TEST(QuadBatch, BadShapesAreThoseOfSingleQuads) {
  Numbers numbers;
  const ShellProperties properties = plastic(HourglassKind::viscous);
  std::vector<Quad> quads;
  for (int i = 0; i < 16; ++i) quads.push_back(make_quad(numbers, properties, 1, 0.2));
  quads[3].corners.x[1] = quads[3].corners.x[0];
  for (Vector& x : quads[5].corners.x) x = quads[5].corners.x[0];
  quads[7].corners.x[2].x() = std::numeric_limits<double>::quiet_NaN();
  for (Quad& quad : quads)
    for (std::size_t k = 0; k < 4; ++k) quad.corners.v[k] = quad.corners.w[k] = Vector::Zero();
  std::vector<Quad> single = quads;
  const std::vector<ShellForces> forces = run_batch(properties, quads, 0, lanes_of_processor());
  for (std::size_t i = 0; i < quads.size(); ++i) {
    const ShellForces expected = quad_forces(properties, single[i].corners, 0, single[i].state, single[i].points);
    EXPECT_EQ(forces[i].good, expected.good) << i;
    EXPECT_EQ(forces[i].good, i != 5 && i != 7) << i;
    if (expected.good) expect_same(expected, forces[i], std::to_string(i));
  }
}

TEST(QuadBatch, TakesFlatQuadsOnly) {
  const auto takes = [](auto change) {
    ShellProperties properties = plastic(HourglassKind::viscous);
    change(properties);
    return QuadBatch::takes(properties);
  };
  EXPECT_TRUE(takes([](ShellProperties&) {}));
  EXPECT_FALSE(takes([](ShellProperties& p) { p.form = ShellForm::full; }));
  EXPECT_FALSE(takes([](ShellProperties& p) { p.projection = ShellProjection::drill; }));
  EXPECT_FALSE(takes([](ShellProperties& p) { p.axes = ShellAxes::invariant; }));
  EXPECT_FALSE(takes([](ShellProperties& p) { p.reference = 1; }));
  EXPECT_FALSE(takes([](ShellProperties& p) { p.viscosity.linear = 0.06; }));
  EXPECT_FALSE(takes([](ShellProperties& p) { p.layer_materials = {p.material, p.material}; }));
}

}  // namespace
}  // namespace gapcheck::solver::quad_batch_test
