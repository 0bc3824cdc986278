#include "solver/interpolation/motion_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gapcheck::solver::motion_fit_test {
namespace {

struct Cloud {
  std::vector<Vector> places;
  std::vector<Matrix> weights;
};

Cloud random_cloud(std::mt19937& random, std::size_t nodes) {
  std::uniform_real_distribution<double> any(-1, 1);
  Cloud cloud;
  for (std::size_t i = 0; i < nodes; ++i) {
    cloud.places.emplace_back(5 + any(random), any(random), any(random));
    const Matrix half = Matrix::NullaryExpr([&] { return any(random); });
    cloud.weights.emplace_back(half * half.transpose() + 0.01 * Matrix::Identity());
  }
  return cloud;
}

// A rigid motion of the nodes is that of the point, for any weights.
TEST(MotionFit, RigidMotionsComeOutExactly) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int round = 0; round < 200; ++round) {
    const Cloud cloud = random_cloud(random, 3 + static_cast<std::size_t>(round % 5));
    const MotionFit fit(cloud.weights, cloud.places);
    const Vector point(any(random), any(random), 3 * any(random));
    const Vector velocity(any(random), any(random), any(random)), spin(any(random), any(random), any(random));
    Twist found = Twist::Zero();
    for (std::size_t i = 0; i < cloud.places.size(); ++i)
      found += fit.share(i, point) * Vector(velocity + spin.cross(cloud.places[i] - point));
    EXPECT_NEAR((found.head<3>() - velocity).norm(), 0, 1e-10);
    EXPECT_NEAR((found.tail<3>() - spin).norm(), 0, 1e-10);
  }
}

// The same as the least squares of all equations, solved by an orthogonal decomposition about the point itself.
TEST(MotionFit, AgreesWithStackedLeastSquares) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int round = 0; round < 200; ++round) {
    const Cloud cloud = random_cloud(random, 3 + static_cast<std::size_t>(round % 6));
    const auto rows = static_cast<Eigen::Index>(3 * cloud.places.size());
    const Vector point(4 + any(random), any(random), any(random));
    const MotionFit fit(cloud.weights, cloud.places);
    Eigen::MatrixXd equations(rows, 6);
    Eigen::VectorXd right(rows);
    Twist found = Twist::Zero();
    for (std::size_t i = 0; i < cloud.places.size(); ++i) {
      const Vector velocity(any(random), any(random), any(random)), r = cloud.places[i] - point;
      const Matrix root = cloud.weights[i].llt().matrixU();
      Matrix cross;
      cross << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0;
      const auto row = static_cast<Eigen::Index>(3 * i);
      equations.block<3, 3>(row, 0) = root;
      equations.block<3, 3>(row, 3) = root * cross;
      right.segment<3>(row) = root * velocity;
      found += fit.share(i, point) * velocity;
    }
    const Twist expected = equations.colPivHouseholderQr().solve(right);
    EXPECT_NEAR((found - expected).norm(), 0, 1e-9 * (1 + expected.norm()));
  }
}

Twist unit(int k) { return Twist::Unit(k); }

TEST(MotionFit, TellsWhatNodesInLineDoNotGive) {
  const std::vector<Matrix> weights(3, Matrix::Identity());
  const std::vector<Vector> line{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
  const MotionFit fit(weights, line);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(fit.determines(unit(k), {7, 0, 0}), k != 3) << k;
  // Off the line the rotation about it moves the point across.
  EXPECT_TRUE(fit.determines(unit(0), {1, 2, 0}));
  EXPECT_TRUE(fit.determines(unit(1), {1, 2, 0}));
  EXPECT_FALSE(fit.determines(unit(2), {1, 2, 0}));
}

TEST(MotionFit, OneNodeGivesItsOwnVelocityOnly) {
  const std::vector<Matrix> weights{2 * Matrix::Identity()};
  const MotionFit fit(weights, std::vector<Vector>{{1, 2, 3}});
  for (int k = 0; k < 6; ++k) EXPECT_EQ(fit.determines(unit(k), {1, 2, 3}), k < 3) << k;
  EXPECT_FALSE(fit.determines(unit(0), {1, 3, 3}));
  EXPECT_NEAR((fit.share(0, {1, 2, 3}).topRows<3>() - Matrix::Identity()).norm(), 0, 1e-15);
}

// Weights in one direction alone say nothing of the others.
TEST(MotionFit, DirectionsWithoutWeight) {
  const std::vector<Matrix> weights(4, Vector(0, 0, 1).asDiagonal());
  const std::vector<Vector> places{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const MotionFit fit(weights, places);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(fit.determines(unit(k), {0.3, 0.2, 0}), k == 2 || k == 3 || k == 4) << k;
}

}  // namespace
}  // namespace gapcheck::solver::motion_fit_test
