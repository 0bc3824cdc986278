// Batches of bricks against brick_forces(), one brick at a time: every bit is the same.
#include "solver/element/brick_batch.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <map>
#include <random>
#include <string>

#include "base/parallel.hpp"
#include "solver/element/solid_elements.hpp"

namespace gapcheck::solver::brick_batch_test {
namespace {

class Numbers {
 public:
  double number(double size) { return std::uniform_real_distribution<double>(-size, size)(engine_); }
  Vector vector(double size) { return {number(size), number(size), number(size)}; }

 private:
  std::mt19937 engine_{5};
};

struct Brick {
  SolidCorners corners;
  SolidState state;
  PointState point;
};

constexpr double density = 7.8e-9;

SolidProperties elastic(HourglassKind control) {
  SolidProperties properties;
  properties.material.density = density;
  properties.material.young = 210000;
  properties.material.poisson = 0.3;
  properties.hourglass.kind = control;
  properties.hourglass.coefficient = 0.09;
  return properties;
}

constexpr std::array<std::array<double, 3>, 8> cube{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

/// `shape` 0: a cube with sides along the axes, which has many zeros.
Brick make_brick(Numbers& numbers, double size, double shape) {
  Brick brick;
  Matrix turn = Matrix::Identity();
  if (shape > 0)
    turn = Eigen::Quaterniond(numbers.number(1), numbers.number(1), numbers.number(1), numbers.number(1))
               .normalized()
               .toRotationMatrix();
  for (std::size_t k = 0; k < 8; ++k)
    brick.corners.x[k] = size * (turn * (Vector(cube[k][0], cube[k][1], cube[k][2]) + numbers.vector(shape)));
  brick.state.mass = density * one_point_volume(brick.corners.x);
  return brick;
}

void move(Numbers& numbers, Brick& brick, double speed, double dt) {
  for (std::size_t k = 0; k < 8; ++k) {
    brick.corners.v[k] = numbers.vector(speed);
    brick.corners.x[k] += dt * brick.corners.v[k];
  }
}

std::uint64_t bits(double number) { return std::bit_cast<std::uint64_t>(number); }

void expect_same(const Vector& a, const Vector& b, const std::string& where) {
  for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(bits(a[axis]), bits(b[axis])) << where << " axis " << axis;
}
void expect_same(const Symmetric& a, const Symmetric& b, const std::string& where) {
  for (std::size_t k = 0; k < 6; ++k) ASSERT_EQ(bits(a[k]), bits(b[k])) << where << " component " << k;
}

void expect_same(const SolidForces& a, const SolidForces& b, const std::string& where) {
  for (std::size_t k = 0; k < 8; ++k) expect_same(a.force[k], b.force[k], where + " force " + std::to_string(k));
  ASSERT_EQ(bits(a.volume), bits(b.volume)) << where;
  ASSERT_EQ(bits(a.hourglass_work), bits(b.hourglass_work)) << where;
  ASSERT_EQ(bits(a.viscous_work), bits(b.viscous_work)) << where;
  ASSERT_EQ(bits(a.dissipated), bits(b.dissipated)) << where;
  ASSERT_EQ(bits(a.manual_step), bits(b.manual_step)) << where;
  ASSERT_EQ(bits(a.stable_step), bits(b.stable_step)) << where;
  ASSERT_EQ(a.good, b.good) << where;
}

void expect_same(const Brick& a, const Brick& b, const std::string& where) {
  expect_same(a.point.stress, b.point.stress, where + " stress");
  expect_same(a.point.back_stress, b.point.back_stress, where + " back stress");
  ASSERT_EQ(bits(a.point.plastic_strain), bits(b.point.plastic_strain)) << where;
  ASSERT_EQ(bits(a.point.plastic_work), bits(b.point.plastic_work)) << where;
  ASSERT_EQ(bits(a.state.viscous_pressure), bits(b.state.viscous_pressure)) << where;
  for (std::size_t m = 0; m < 4; ++m)
    expect_same(a.state.hourglass[m], b.state.hourglass[m], where + " hourglass " + std::to_string(m));
}

std::vector<Lanes> all_lanes() {
  std::vector<Lanes> all{Lanes::two};
  for (const Lanes lanes : {Lanes::four, Lanes::eight})
    if (lanes <= lanes_of_processor()) all.push_back(lanes);
  return all;
}

/// What SolidElements does with a batch.
std::vector<SolidForces> run_batch(const SolidProperties& properties, std::vector<Brick>& bricks, double dt,
                                   Lanes lanes) {
  BrickBatch batch;
  State state;
  for (const Brick& brick : bricks) {
    std::array<NodeIndex, 8> nodes;
    for (NodeIndex& node : nodes) {
      const std::size_t k = static_cast<std::size_t>(&node - nodes.data());
      node.value = static_cast<std::uint32_t>(state.x.size());
      state.x.push_back(brick.corners.x[k]);
      state.v.push_back(brick.corners.v[k]);
    }
    batch.add(nodes, state, brick.state, brick.point);
  }
  batch.begin(properties, dt, lanes);
  std::vector<double> work;
  for (std::size_t i = 0; i < bricks.size(); ++i)
    work.push_back(batch.integrate(i, properties, dt, bricks[i].state, bricks[i].point));
  batch.end(properties, lanes);
  std::vector<SolidForces> forces;
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    forces.push_back(batch.forces(i, dt, work[i]));
    for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(batch.velocity(i, k), bricks[i].corners.v[k]);
  }
  return forces;
}

struct Case {
  const char* name;
  SolidProperties properties;
};

std::vector<Case> cases() {
  std::vector<Case> all{{"viscous", elastic(HourglassKind::viscous)}, {"none", elastic(HourglassKind::none)}};
  SolidProperties more = elastic(HourglassKind::viscous);
  more.hourglass.exact_volume = true;
  all.push_back({"exact", more});
  more = elastic(HourglassKind::viscous);
  more.hourglass.plain_shapes = true;
  all.push_back({"plain", more});
  more = elastic(HourglassKind::viscous);
  more.material = plastic_kinematic(density, 210000, 0.3, 250, 1000, 0.5);
  all.push_back({"plastic", more});
  more.material.failure_strain = 0.05;
  all.push_back({"failing", more});
  more = elastic(HourglassKind::viscous);
  more.quadratic_viscosity = more.linear_viscosity = 0;
  more.material.damping = 0.2;
  all.push_back({"damped", more});
  more = elastic(HourglassKind::viscous);
  more.material.kind = MaterialKind::viscoelastic;
  more.material.viscoelastic = Viscoelastic{170000, 30000, 50000, 1e6};
  all.push_back({"viscoelastic", more});
  return all;
}

class BrickKinds : public testing::TestWithParam<Case> {};

TEST_P(BrickKinds, AreThoseOfSingleBricks) {
  const SolidProperties& properties = GetParam().properties;
  ASSERT_TRUE(BrickBatch::takes(properties));
  Numbers numbers;
  std::size_t compressed = 0, stressed = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const double size = std::pow(10, numbers.number(2)), shape = trial % 4 == 0 ? 0 : 0.2;
    const double speed = trial % 8 == 0 ? 0 : 3e4;
    std::vector<Brick> single;
    for (int i = 0; i <= trial % 16; ++i) single.push_back(make_brick(numbers, size, shape));
    std::map<Lanes, std::vector<Brick>> batches;
    for (const Lanes lanes : all_lanes()) batches[lanes] = single;
    for (int cycle = 0; cycle < 6; ++cycle) {
      const double dt = cycle == 3 ? 0 : 3e-7 * size;
      const Numbers same = numbers;
      std::vector<SolidForces> expected;
      for (Brick& brick : single) {
        move(numbers, brick, speed, dt);
        expected.push_back(brick_forces(properties, brick.corners, dt, brick.state, brick.point));
        ASSERT_TRUE(expected.back().good);
        compressed += brick.state.viscous_pressure > 0;
        stressed += brick.point.stress[xy] != 0 && brick.state.hourglass[2].y() != 0;
      }
      for (auto& [lanes, bricks] : batches) {
        Numbers again = same;
        for (Brick& brick : bricks) move(again, brick, speed, dt);
        const std::vector<SolidForces> forces = run_batch(properties, bricks, dt, lanes);
        for (std::size_t i = 0; i < single.size(); ++i) {
          const std::string where = "trial " + std::to_string(trial) + " cycle " + std::to_string(cycle) + " brick " +
                                    std::to_string(i) + " of " + std::to_string(single.size()) + " lanes " +
                                    std::to_string(static_cast<int>(lanes));
          expect_same(expected[i], forces[i], where);
          expect_same(single[i], bricks[i], where);
          if (HasFatalFailure()) return;
        }
      }
    }
  }
  if (properties.linear_viscosity > 0) {
    EXPECT_GT(compressed, 500U);
  }
  if (properties.hourglass.kind == HourglassKind::viscous) {
    EXPECT_GT(stressed, 500U);
  }
}

INSTANTIATE_TEST_SUITE_P(All, BrickKinds, testing::ValuesIn(cases()),
                         [](const auto& kind) { return std::string(kind.param.name); });

// What has no volume keeps its state, and its neighbours do not notice.
TEST(BrickBatch, BadShapesAreThoseOfSingleBricks) {
  for (const bool exact : {false, true})
    for (const Lanes lanes : all_lanes()) {
      Numbers numbers;
      SolidProperties properties = elastic(HourglassKind::viscous);
      properties.hourglass.exact_volume = exact;
      std::vector<Brick> bricks;
      for (int i = 0; i < 16; ++i) bricks.push_back(make_brick(numbers, 1, 0.2));
      for (std::size_t k = 0; k < 4; ++k) std::swap(bricks[3].corners.x[k], bricks[3].corners.x[k + 4]);
      bricks[7].corners.x[6].x() = std::numeric_limits<double>::quiet_NaN();
      for (Brick& brick : bricks) {
        move(numbers, brick, 3e4, 1e-7);
        brick.point.stress = {1, 2, 3, 4, 5, 6};
        brick.state.viscous_pressure = 7;
      }
      bricks[5].corners.x.fill(bricks[5].corners.x[0]);
      std::vector<Brick> single = bricks;
      const std::vector<SolidForces> forces = run_batch(properties, bricks, 1e-7, lanes);
      for (std::size_t i = 0; i < bricks.size(); ++i) {
        const std::string where = std::to_string(i) + (exact ? " exact" : "");
        const SolidForces expected =
            brick_forces(properties, single[i].corners, 1e-7, single[i].state, single[i].point);
        EXPECT_EQ(forces[i].good, i != 3 && i != 5 && i != 7) << where;
        if (i == 7) {  // a NaN has no bits to compare
          EXPECT_TRUE(std::isnan(forces[i].volume));
          EXPECT_EQ(forces[i].good, expected.good);
          EXPECT_EQ(forces[i].force[0], expected.force[0]);
        } else {
          expect_same(expected, forces[i], where);
        }
        expect_same(single[i], bricks[i], where);
        EXPECT_EQ(bricks[i].state.viscous_pressure == 7, !expected.good) << where;
      }
    }
}

TEST(BrickBatch, TakesOnePointBricksWithoutHistoryOfTheWholeBrickOnly) {
  const auto takes = [](auto change) {
    SolidProperties properties = elastic(HourglassKind::viscous);
    change(properties);
    return BrickBatch::takes(properties);
  };
  EXPECT_TRUE(takes([](SolidProperties&) {}));
  EXPECT_FALSE(takes([](SolidProperties& p) { p.material.kind = MaterialKind::rubber; }));
  EXPECT_FALSE(takes([](SolidProperties& p) { p.material.kind = MaterialKind::null; }));
  EXPECT_FALSE(takes([](SolidProperties& p) { p.material.hydro = std::make_shared<const Hydrodynamic>(); }));
  EXPECT_FALSE(takes([](SolidProperties& p) { p.material.erosion = Erosion{}; }));
  EXPECT_FALSE(takes([](SolidProperties& p) { p.hourglass.kind = HourglassKind::stiffness; }));
  EXPECT_FALSE(takes([](SolidProperties& p) { p.hourglass.kind = HourglassKind::assumed_strain; }));
}

/// A block of n x n x n bricks with distorted inner nodes, some of them failing, in two parts that alternate in places.
struct Block {
  SolidElements solids;
  State state;

  explicit Block(int n) {
    Numbers numbers;
    SolidProperties plastic = elastic(HourglassKind::viscous);
    plastic.material = plastic_kinematic(density, 210000, 0.3, 250, 1000, 0.5);
    plastic.material.failure_strain = 0.03;
    solids.add_properties(elastic(HourglassKind::viscous));
    solids.add_properties(plastic);
    const int row = n + 1;
    for (int k = 0; k <= n; ++k)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) state.x.push_back(Vector(i, j, k) + numbers.vector(0.1));
    state.v.resize(state.x.size());
    state.mass.resize(state.x.size(), 0);
    std::uint32_t count = 0;
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          const auto a = static_cast<std::uint32_t>((k * row + j) * row + i), b = a + row, c = a + row * row,
                     d = c + row;
          std::array<NodeIndex, 8> nodes{NodeIndex{a}, NodeIndex{a + 1}, NodeIndex{b + 1}, NodeIndex{b},
                                         NodeIndex{c}, NodeIndex{c + 1}, NodeIndex{d + 1}, NodeIndex{d}};
          if (count % 97 == 5) nodes[7] = nodes[6] = nodes[5] = nodes[4];  // a pyramid
          solids.add(nodes, j % 3 == 1 || count % 41 == 0 ? 1 : 0, count, state);
          ++count;
        }
    solids.finish(state.x.size());
  }
};

/// Everything that a few steps with random velocities leave.
std::vector<std::uint64_t> after_steps(std::size_t jobs) {
  const JobLimit limit(jobs);
  Block block(14);
  Numbers numbers;
  std::vector<std::uint64_t> all;
  for (int step = 0; step < 8; ++step) {
    block.state.dt = 1e-7;
    for (std::size_t i = 0; i < block.state.x.size(); ++i) {
      block.state.v[i] = numbers.vector(6e4);
      block.state.x[i] += block.state.dt * block.state.v[i];
    }
    const Summary sum = block.solids.update(block.state);
    for (const double number : {sum.manual_step, sum.stable_step, sum.work, sum.hourglass_work, sum.viscous_work})
      all.push_back(bits(number));
    for (const std::uint64_t number : {sum.failed, std::uint64_t{sum.bad}, std::uint64_t{sum.manual_at}})
      all.push_back(number);
  }
  for (std::size_t i = 0; i < block.solids.size(); ++i) {
    for (std::size_t k = 0; k < 8; ++k)
      for (const double number : block.solids.corner_force(i, k)) all.push_back(bits(number));
    for (const double number : block.solids.point(i).stress) all.push_back(bits(number));
    const ElementEnergy& energy = block.solids.energy(i);
    for (const double number : {energy.internal, energy.hourglass, energy.viscous, energy.dissipated})
      all.push_back(bits(number));
    all.push_back(block.solids.failed(i) ? 1 : 0);
  }
  return all;
}

/// The same by brick_forces(), one solid after the other.
std::vector<std::uint64_t> forces_one_by_one() {
  Block block(14);
  Numbers numbers;
  std::vector<SolidState> states(block.solids.size());
  std::vector<PointState> points(block.solids.size());
  std::vector<std::uint64_t> all;
  State start = Block(14).state;
  for (std::size_t i = 0; i < block.solids.size(); ++i) {
    std::array<Vector, 8> x;
    for (std::size_t k = 0; k < 8; ++k) x[k] = start.x[block.solids.nodes(i)[k].value];
    states[i].mass = density * one_point_volume(x);
  }
  std::vector<SolidForces> last(block.solids.size());
  for (int step = 0; step < 8; ++step) {
    for (std::size_t i = 0; i < start.x.size(); ++i) {
      start.v[i] = numbers.vector(6e4);
      start.x[i] += 1e-7 * start.v[i];
    }
    for (std::size_t i = 0; i < block.solids.size(); ++i) {
      if (points[i].failed) continue;
      SolidCorners corners;
      for (std::size_t k = 0; k < 8; ++k) {
        corners.x[k] = start.x[block.solids.nodes(i)[k].value];
        corners.v[k] = start.v[block.solids.nodes(i)[k].value];
      }
      last[i] = brick_forces(block.solids.properties(i), corners, 1e-7, states[i], points[i]);
      if (points[i].failed) last[i].force.fill(Vector::Zero());
    }
  }
  for (std::size_t i = 0; i < block.solids.size(); ++i) {
    for (const Vector& force : last[i].force)
      for (const double number : force) all.push_back(bits(number));
    for (const double number : points[i].stress) all.push_back(bits(number));
    all.push_back(points[i].failed ? 1 : 0);
  }
  return all;
}

TEST(BrickBatch, BlocksHaveTheForcesOfSingleBricksWithAnyNumberOfThreads) {
  const std::vector<std::uint64_t> one = after_steps(1);
  EXPECT_EQ(one, after_steps(2));
  EXPECT_EQ(one, after_steps(7));
  const std::vector<std::uint64_t> slow = forces_one_by_one();
  constexpr std::size_t head = 8 * 8, of_solid = 24 + 6 + 4 + 1, of_slow = 24 + 6 + 1;
  const std::size_t solids = slow.size() / of_slow;
  ASSERT_EQ(one.size(), head + of_solid * solids);
  std::size_t failed = 0;
  for (std::size_t i = 0; i < solids; ++i) {
    const std::uint64_t *fast = &one[head + of_solid * i], *single = &slow[of_slow * i];
    for (std::size_t k = 0; k < 30; ++k) ASSERT_EQ(fast[k], single[k]) << "solid " << i << " number " << k;
    ASSERT_EQ(fast[34], single[30]) << "solid " << i;
    failed += fast[34];
  }
  EXPECT_GT(failed, 10U);
  EXPECT_LT(failed, solids / 2);
}

}  // namespace
}  // namespace gapcheck::solver::brick_batch_test
