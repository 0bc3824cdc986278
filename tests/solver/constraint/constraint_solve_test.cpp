#include "solver/constraint/constraint_solve.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace gapcheck::solver::constraint_solve_test {
namespace {

struct Scene {
  std::vector<SurfaceConstraint> constraints;
  NodeResponse response;
};

/// `count` nodes over a few segments that share nodes; some nodes held along an axis.
Scene random_scene(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> unit(0, 1), both(-1, 1);
  constexpr std::size_t corners = 6;
  Scene scene;
  scene.response.give.resize(corners + count);
  scene.response.moved.assign(corners + count, Vector::Zero());
  for (Vector& give : scene.response.give) give.setConstant(0.1 + unit(random));
  scene.response.give[0].setZero();
  scene.response.give[corners][1] = 0;
  for (std::size_t i = 0; i < count; ++i) {
    SurfaceConstraint& c = scene.constraints.emplace_back();
    c.node = NodeIndex{static_cast<std::uint32_t>(corners + i)};
    const std::uint32_t first = static_cast<std::uint32_t>(2 * unit(random));
    double sum = 0;
    for (std::uint32_t k = 0; k < 4; ++k) {
      c.segment.nodes[k] = NodeIndex{first + k};
      sum += c.segment.weights[k] = unit(random);
    }
    for (double& weight : c.segment.weights) weight /= sum;
    c.normal = Vector(both(random), both(random), 1 + unit(random)).normalized();
    c.depth = both(random);
  }
  return scene;
}

/// Row of the Jacobian: relative displacement along the normal by nodal displacements.
Eigen::MatrixXd jacobian(const Scene& scene) {
  const auto count = static_cast<Eigen::Index>(scene.constraints.size());
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(count, static_cast<Eigen::Index>(3 * scene.response.give.size()));
  for (Eigen::Index i = 0; i < count; ++i) {
    const SurfaceConstraint& c = scene.constraints[static_cast<std::size_t>(i)];
    rows.block<1, 3>(i, 3 * static_cast<Eigen::Index>(c.node.value)) += c.normal.transpose();
    for (std::size_t k = 0; k < 4; ++k)
      rows.block<1, 3>(i, 3 * static_cast<Eigen::Index>(c.segment.nodes[k].value)) -=
          c.segment.weights[k] * c.normal.transpose();
  }
  return rows;
}

// Twin: all active sets are tried, each by a dense solve; the one without pulling and without open constraint counts.
TEST(ConstraintSolve, AgreesWithDenseSolvesOfAllActiveSets) {
  std::mt19937 random(17);
  int some_active = 0;
  for (int round = 0; round < 60; ++round) {
    Scene scene = random_scene(random, 1 + static_cast<std::size_t>(round % 7));
    const Eigen::MatrixXd rows = jacobian(scene);
    Eigen::VectorXd give(rows.cols()), depth(rows.rows());
    for (std::size_t n = 0; n < scene.response.give.size(); ++n)
      give.segment<3>(3 * static_cast<Eigen::Index>(n)) = scene.response.give[n];
    for (Eigen::Index i = 0; i < depth.size(); ++i) depth[i] = scene.constraints[static_cast<std::size_t>(i)].depth;
    const Eigen::MatrixXd delassus = rows * give.asDiagonal() * rows.transpose();
    Eigen::VectorXd push;
    int solutions = 0;
    for (unsigned set = 0; set < 1u << depth.size(); ++set) {
      std::vector<Eigen::Index> active;
      for (Eigen::Index i = 0; i < depth.size(); ++i)
        if ((set >> i & 1u) != 0) active.push_back(i);
      Eigen::VectorXd trial = Eigen::VectorXd::Zero(depth.size());
      if (!active.empty()) {
        const Eigen::VectorXd part = delassus(active, active).fullPivLu().solve(depth(active));
        if (part.minCoeff() < 0) continue;
        trial(active) = part;
      }
      if ((delassus * trial - depth).minCoeff() < -1e-10) continue;
      push = trial;
      ++solutions;
    }
    ASSERT_EQ(solutions, 1);
    const ConstraintSolution solution = solve_constraints(scene.constraints, scene.response);
    EXPECT_LT(solution.sweeps, 2000u);
    const Eigen::VectorXd moved = give.asDiagonal() * rows.transpose() * push;
    for (Eigen::Index i = 0; i < push.size(); ++i) {
      EXPECT_NEAR(scene.constraints[static_cast<std::size_t>(i)].push, push[i], 1e-9);
      some_active += push[i] > 0;
    }
    for (std::size_t n = 0; n < scene.response.moved.size(); ++n)
      EXPECT_LT((scene.response.moved[n] - moved.segment<3>(3 * static_cast<Eigen::Index>(n))).norm(), 1e-9);
  }
  EXPECT_GT(some_active, 60);
}

// Forces are opposite whatever the solution: what free nodes move, by their masses, adds up to nothing.
TEST(ConstraintSolve, MomentumIsKept) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    Scene scene = random_scene(random, 7);
    for (Vector& give : scene.response.give) give.setConstant(give.maxCoeff() + 0.1);
    for (SurfaceConstraint& c : scene.constraints) {
      c.friction = 0.4;
      c.slip = Vector(0.3, -0.2, 0.1);
    }
    static_cast<void>(solve_constraints(scene.constraints, scene.response));
    Vector sum = Vector::Zero();
    double size = 0;
    for (std::size_t n = 0; n < scene.response.moved.size(); ++n) {
      sum += scene.response.moved[n].cwiseQuotient(scene.response.give[n]);
      size += scene.response.moved[n].norm();
    }
    EXPECT_GT(size, 0.1);
    EXPECT_LT(sum.norm(), 1e-12);
  }
}

TEST(ConstraintSolve, FrictionSticksOrSlides) {
  for (const double friction : {0.1, 10.0}) {
    SurfaceConstraint c;
    c.node = NodeIndex{0};
    c.segment = {{NodeIndex{1}}, {1}};
    c.depth = 0.2;
    c.slip = Vector(0.5, 0, -0.2);
    c.friction = friction;
    NodeResponse response{{Vector::Constant(2), Vector::Zero()}, {Vector::Zero(), Vector::Zero()}};
    static_cast<void>(solve_constraints({&c, 1}, response));
    EXPECT_NEAR(c.push, 0.1, 1e-14);
    EXPECT_NEAR(c.shear.x(), -std::min(friction * 0.1, 0.25), 1e-14);
    EXPECT_NEAR(response.moved[0].x() + 0.5, friction < 1 ? 0.48 : 0, 1e-14);
  }
}

// Held on both sides, numbers that are none: nothing happens, and it ends.
TEST(ConstraintSolve, HostileInput) {
  SurfaceConstraint c;
  c.node = NodeIndex{0};
  c.segment = {{NodeIndex{1}}, {1}};
  c.depth = 1;
  NodeResponse response{{Vector::Zero(), Vector::Zero()}, {Vector::Zero(), Vector::Zero()}};
  EXPECT_EQ(solve_constraints({&c, 1}, response).sweeps, 1u);
  EXPECT_EQ(c.push, 0);
  response.give[0].setConstant(1);
  for (const double depth : {std::nan(""), 1e300, -1e300}) {
    c.depth = depth;
    EXPECT_LE(solve_constraints({&c, 1}, response).sweeps, 2000u);
    c.push = 0;
  }
}

}  // namespace
}  // namespace gapcheck::solver::constraint_solve_test
