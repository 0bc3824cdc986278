// Numbers at the eight points of a brick: all at once against one after the other.
#include "solver/quadrature/eight_points.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "solver/element/solid_stiffness.hpp"

namespace gapcheck::solver::eight_points_test {
namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double number() { return distribution_(engine_); }
  Matrix matrix() {
    return Matrix::NullaryExpr([&] { return number(); });
  }
  Symmetric symmetric() { return to_symmetric(matrix()); }

 private:
  std::mt19937 engine_;
  std::uniform_real_distribution<double> distribution_{-1, 1};
};

TEST(EightPoints, MatricesAreThoseOfOnePointAfterTheOther) {
  Random random(1);
  std::array<Matrix, 8> one, other;
  EightMatrices a, b;
  for (std::size_t p = 0; p < 8; ++p) {
    a.set(p, one[p] = random.matrix());
    b.set(p, other[p] = random.matrix());
  }
  const Matrix left = random.matrix();
  const EightMatrices cofactors = cofactor(a);
  const Eight determinants = determinant(a, cofactors);
  const EightMatrices product = a * b, transposed = times_transposed(a, b), from_left = left * a,
                      inverses = inverse(cofactors, determinants);
  for (std::size_t p = 0; p < 8; ++p) {
    EXPECT_LT((product.at(p) - one[p] * other[p]).norm(), 1e-14);
    EXPECT_LT((transposed.at(p) - one[p] * other[p].transpose()).norm(), 1e-14);
    EXPECT_LT((from_left.at(p) - left * one[p]).norm(), 1e-14);
    EXPECT_NEAR(determinants[static_cast<Eigen::Index>(p)], one[p].determinant(), 1e-14);
    EXPECT_LT((inverses.at(p) * one[p] - Matrix::Identity()).norm(), 1e-11);
  }
}

TEST(EightPoints, TurnsAreThoseOfOnePointAfterTheOther) {
  Random random(2);
  std::array<Symmetric, 8> tensors;
  std::array<Vector, 8> axes;
  EightSymmetric all;
  std::array<Eight, 3> w;
  for (std::size_t p = 0; p < 8; ++p) {
    tensors[p] = random.symmetric();
    axes[p] = Vector(random.number(), random.number(), random.number());
    const auto place = static_cast<Eigen::Index>(p);
    for (std::size_t c = 0; c < 6; ++c) all[c][place] = tensors[p][c];
    for (std::size_t i = 0; i < 3; ++i) w[i][place] = axes[p][static_cast<int>(i)];
  }
  const EightMatrices turns = spin_rotation(w);
  const EightSymmetric turned = rotated(all, turns);
  for (std::size_t p = 0; p < 8; ++p) {
    const Matrix turn = spin_rotation(axes[p]);
    EXPECT_LT((turns.at(p) - turn).norm(), 1e-15);
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(turned[c][static_cast<Eigen::Index>(p)], rotated(tensors[p], turn)[c], 1e-14);
  }
}

// A step with large turns of a yielding brick, part of whose hardening is a shift: each point's stress, shift and
// plastic strain against the update of single points.
TEST(EightPoints, StressesAreThoseOfSinglePoints) {
  Random random(3);
  SolidProperties properties = elastic_eight(1000, 0.3);
  properties.material = plastic_kinematic(1, 1000, 0.3, 10, 100, 0.4);
  for (const SolidRule rule : {SolidRule::eight_points, SolidRule::efficient, SolidRule::accurate}) {
    Bricks x = brick_of_unit_size, v;
    for (std::size_t a = 0; a < 8; ++a) {
      x[a] += 0.1 * Vector(random.number(), random.number(), random.number());
      v[a] = 0.3 * Vector(random.number(), random.number(), random.number());
    }
    EightPoints solid(properties, rule, x);
    for (PointState& point : solid.points)
      point.stress = random.symmetric(), point.back_stress = deviator(random.symmetric());
    std::array<PointState, 8> single = solid.points;
    const double dt = 1;
    (void)solid.step(x, v, dt);
    Bricks middle;
    for (std::size_t a = 0; a < 8; ++a) middle[a] = x[a] - dt / 2 * v[a];
    const BrickMap map = brick_map(rule, brick_modes(middle));
    const EightMatrices gradients = brick_gradients(map, brick_modes(v));
    const double volume_rate = mean_gradient(map, brick_modes(v)).trace();
    for (std::size_t p = 0; p < 8; ++p) {
      Matrix gradient = gradients.at(p);
      gradient.diagonal().array() += (volume_rate - gradient.trace()) / 3;
      update_solid_stress(properties.material, gradient, dt, single[p]);
      EXPECT_GT(single[p].plastic_strain, 0);
      EXPECT_NEAR(solid.points[p].plastic_strain, single[p].plastic_strain, 1e-13);
      for (std::size_t c = 0; c < 6; ++c) {
        EXPECT_NEAR(solid.points[p].stress[c], single[p].stress[c], 1e-11);
        EXPECT_NEAR(solid.points[p].back_stress[c], single[p].back_stress[c], 1e-11);
      }
    }
  }
}

}  // namespace
}  // namespace gapcheck::solver::eight_points_test
