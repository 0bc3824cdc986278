#include "audit/fix/least_movement.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace gapcheck::audit::least_movement_test {
namespace {

MoveCondition between(std::uint32_t a, std::uint32_t b, double bound, bool equal = false) {
  MoveCondition c;
  c.add(a, 1);
  c.add(b, -1);
  c.direction = Vector::UnitZ();
  c.bound = bound;
  c.equal = equal;
  return c;
}

const Vector one = Vector::Ones();

TEST(LeastMovement, SharesByMobility) {
  std::vector<MoveCondition> conditions{between(0, 1, 0.3)};
  std::vector<Vector> moves(2);
  least_movement(conditions, std::vector<Vector>{one, one}, moves, 1e-12, 100);
  EXPECT_NEAR(moves[0].z(), 0.15, 1e-12);
  EXPECT_NEAR(moves[1].z(), -0.15, 1e-12);
  EXPECT_EQ(moves[0].x(), 0);
  least_movement(conditions, std::vector<Vector>{one, Vector(3 * one)}, moves, 1e-12, 100);
  EXPECT_NEAR(moves[0].z(), 0.075, 1e-12);
  EXPECT_NEAR(moves[1].z(), -0.225, 1e-12);
}

// One condition alone is met at once, whatever its coefficients.
TEST(LeastMovement, OneConditionTakesOneStep) {
  MoveCondition c;
  c.add(0, 1);
  for (const std::uint32_t n : {1u, 2u}) c.add(n, -0.5);
  c.direction = Vector::UnitZ();
  c.bound = 0.3;
  EXPECT_DOUBLE_EQ(compliance(c, std::vector<Vector>{one, one, Vector(4 * one)}), 1 + 0.25 + 1);
  std::vector<MoveCondition> conditions{c};
  std::vector<Vector> moves(3);
  const MovementResult result = least_movement(conditions, std::vector<Vector>{one, one, one}, moves, 1e-12, 100);
  EXPECT_LE(result.sweeps, 1u);
  EXPECT_NEAR(moves[0].z(), 0.2, 1e-15);
  EXPECT_NEAR(moves[1].z(), -0.1, 1e-15);
  EXPECT_NEAR(moves[2].z(), -0.1, 1e-15);
}

TEST(LeastMovement, HeldNodesStay) {
  std::vector<MoveCondition> conditions{between(0, 1, 0.3)};
  std::vector<Vector> moves(2);
  least_movement(conditions, std::vector<Vector>{one, Vector(1, 1, 0)}, moves, 1e-12, 100);
  EXPECT_NEAR(moves[0].z(), 0.3, 1e-12);
  EXPECT_EQ(moves[1].norm(), 0);
  const MovementResult none =
      least_movement(conditions, std::vector<Vector>{Vector::Zero(), Vector::Zero()}, moves, 1e-12, 100);
  EXPECT_EQ(none.worst, 0);
  EXPECT_EQ(moves[0].norm(), 0);
}

TEST(LeastMovement, TakesBackWhatIsNotNeeded) {
  // The third condition alone does the work of the first two.
  std::vector<MoveCondition> conditions{between(0, 1, 0.1), between(0, 1, 0.2), between(0, 1, 0.5)};
  std::vector<Vector> moves(2);
  least_movement(conditions, std::vector<Vector>{one, one}, moves, 1e-12, 100);
  EXPECT_NEAR(moves[0].z(), 0.25, 1e-12);
  EXPECT_NEAR(conditions[0].multiplier, 0, 1e-12);
}

TEST(LeastMovement, ContradictionsEnd) {
  std::vector<MoveCondition> conditions{between(0, 1, 0.3), between(1, 0, 0.3)};
  std::vector<Vector> moves(2);
  const MovementResult result = least_movement(conditions, std::vector<Vector>{one, one}, moves, 1e-12, 200);
  EXPECT_EQ(result.sweeps, 200u);
  // Both are violated by 0.6 together, however the nodes move.
  EXPECT_GE(result.worst, 0.3 - 1e-12);
  EXPECT_LE(result.worst, 0.6 + 1e-12);
  EXPECT_NEAR(violation(conditions[0], moves) + violation(conditions[1], moves), 0.6, 1e-12);
}

TEST(LeastMovement, EquationsHold) {
  std::vector<MoveCondition> conditions{between(0, 1, 0.3), between(1, 2, 0, true)};
  std::vector<Vector> moves(3);
  least_movement(conditions, std::vector<Vector>{one, one, one}, moves, 1e-13, 1000);
  EXPECT_NEAR(moves[0].z(), 0.2, 1e-11);
  EXPECT_NEAR(moves[1].z(), -0.1, 1e-11);
  EXPECT_NEAR(moves[2].z(), -0.1, 1e-11);
}

/// The moves must be a combination of the conditions' directions with multipliers that are never negative and vanish
/// where there is room to spare: that, and no violation, is what makes them the least (Karush, Kuhn, Tucker).
TEST(LeastMovement, IsOptimalOnRandomProblems) {
  std::mt19937_64 random(3);
  const auto uniform = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int problem = 0; problem < 50; ++problem) {
    std::vector<Vector> mobility(30), moves(30);
    for (Vector& m : mobility) m = Vector::Constant(uniform(0.2, 5));
    std::vector<MoveCondition> conditions(20);
    for (MoveCondition& c : conditions) {
      c.add(static_cast<std::uint32_t>(random() % 15), 1);
      for (int i = 0; i < 4; ++i) c.add(15 + static_cast<std::uint32_t>(random() % 15), -0.25);
      c.direction = (Vector::UnitZ() + 0.3 * Vector(uniform(-1, 1), uniform(-1, 1), 0)).normalized();
      c.bound = uniform(-0.5, 1);
    }
    const MovementResult result = least_movement(conditions, mobility, moves, 1e-11, 100000);
    ASSERT_LT(result.sweeps, 100000u);
    std::vector<Vector> expected(30, Vector::Zero());
    for (const MoveCondition& c : conditions) {
      EXPECT_GE(c.multiplier, 0);
      double missing = c.bound;
      for (std::size_t i = 0; i < c.count; ++i)
        missing -= c.terms[i].coefficient * c.direction.dot(moves[c.terms[i].node]);
      EXPECT_NEAR(violation(c, moves), missing, 1e-14);
      EXPECT_LT(missing, 1e-9);
      EXPECT_LT(c.multiplier * std::abs(missing), 1e-8);
      for (std::size_t i = 0; i < c.count; ++i)
        expected[c.terms[i].node] +=
            c.multiplier * c.terms[i].coefficient * mobility[c.terms[i].node].x() * c.direction;
    }
    for (std::size_t i = 0; i < moves.size(); ++i) EXPECT_LT((moves[i] - expected[i]).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace gapcheck::audit::least_movement_test
