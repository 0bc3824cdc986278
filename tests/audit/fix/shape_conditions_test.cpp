#include "audit/fix/shape_conditions.hpp"

#include <gtest/gtest.h>

namespace gapcheck::audit::shape_conditions_test {
namespace {

model::Mesh mesh_with(const model::SegmentNodes& nodes) {
  model::Mesh mesh;
  mesh.shells.id.push_back(1);
  mesh.shells.nodes.push_back(nodes);
  return mesh;
}

const ElementOfKind first_shell{model::ElementKind::shell, 0};
const model::SegmentNodes quad{NodeIndex{0}, NodeIndex{1}, NodeIndex{2}, NodeIndex{3}};
const std::vector<Vector> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

/// True if all conditions allow the moves.
bool allow(const std::vector<ShapeCondition>& list, const std::vector<Vector>& moves) {
  for (const ShapeCondition& c : list) {
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += c.coefficient[i] * c.direction.dot(moves[c.nodes[i].value]);
    if (sum < c.bound - 1e-12) return false;
  }
  return true;
}

TEST(ShapeConditions, LimitWarpAndShortening) {
  const auto list = shape_conditions(mesh_with(quad), square, first_shell, {});
  EXPECT_EQ(list.size(), 6u);
  std::vector<Vector> moves(4, Vector::Zero());
  EXPECT_TRUE(allow(list, moves));
  moves.assign(4, {3, 2, 1});  // all together
  EXPECT_TRUE(allow(list, moves));
  moves.assign(4, Vector::Zero());
  moves[0] = {0, 0, 0.1};
  EXPECT_TRUE(allow(list, moves));
  moves[0] = {0, 0, 0.3};
  EXPECT_FALSE(allow(list, moves));
  moves[0] = {0, 0, -0.3};
  EXPECT_FALSE(allow(list, moves));
  moves[1] = {0, 0, -0.3};  // its neighbour comes along
  EXPECT_TRUE(allow(list, moves));
  moves.assign(4, Vector::Zero());
  moves[0] = {0.45, 0, 0};
  EXPECT_FALSE(allow(list, moves));
}

// Edges may become shorter by 0.8 of half their length.
TEST(ShapeConditions, ShorterEdgesWithinTheLimit) {
  for (const double size : {1.0, 8.0}) {
    std::vector<Vector> x = square;
    for (Vector& corner : x) corner *= size;
    const auto list = shape_conditions(mesh_with(quad), x, first_shell, {});
    for (std::size_t corner = 0; corner < 4; ++corner) {
      std::vector<Vector> moves(4, Vector::Zero());
      const Vector inwards = (x[(corner + 1) % 4] - x[corner]) / size;
      moves[corner] = 0.39 * size * inwards;
      EXPECT_TRUE(allow(list, moves)) << size << " " << corner;
      moves[corner] = 0.41 * size * inwards;
      EXPECT_FALSE(allow(list, moves)) << size << " " << corner;
    }
  }
}

// The corners of a quadrilateral leave its middle plane, whose normal is at right angles to both diagonals.
TEST(ShapeConditions, WarpIsMeasuredAcrossTheDiagonals) {
  std::vector<Vector> x = square;
  x[2].z() = 0.5;
  const auto list = shape_conditions(mesh_with(quad), x, first_shell, {});
  ASSERT_EQ(list.size(), 6u);
  for (const std::size_t i : {0, 1}) {
    EXPECT_NEAR(list[i].direction.dot(x[2] - x[0]), 0, 1e-15);
    EXPECT_NEAR(list[i].direction.dot(x[3] - x[1]), 0, 1e-15);
    EXPECT_NEAR(list[i].direction.norm(), 1, 1e-15);
  }
}

TEST(ShapeConditions, AllowTheElementAsItIs) {
  std::vector<Vector> x = square;
  x[0].z() = 0.8;
  EXPECT_TRUE(allow(shape_conditions(mesh_with(quad), x, first_shell, {}), std::vector<Vector>(4, Vector::Zero())));
}

TEST(ShapeConditions, TrianglesAndWrecksHaveNoWarp) {
  EXPECT_EQ(shape_conditions(mesh_with({quad[0], quad[1], quad[2], quad[2]}), square, first_shell, {}).size(), 3u);
  EXPECT_TRUE(shape_conditions(mesh_with(quad), std::vector<Vector>(4, Vector::Zero()), first_shell, {}).empty());
  EXPECT_TRUE(shape_conditions(mesh_with(quad), square, {model::ElementKind::shell, 7}, {}).empty());
}

}  // namespace
}  // namespace gapcheck::audit::shape_conditions_test
