#include "model/entity/faces.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace gapcheck::model::faces_test {
namespace {

std::array<NodeIndex, 8> nodes(std::array<std::uint32_t, 8> numbers) {
  std::array<NodeIndex, 8> result;
  for (std::size_t i = 0; i < 8; ++i) result[i] = NodeIndex(numbers[i]);
  return result;
}

TEST(SolidFaces, CountsByShape) {
  EXPECT_EQ(SolidFaces(nodes({0, 1, 2, 3, 4, 5, 6, 7})).size(), 6u);
  EXPECT_EQ(SolidFaces(nodes({0, 1, 2, 3, 4, 4, 5, 5})).size(), 5u);  // wedge
  EXPECT_EQ(SolidFaces(nodes({0, 1, 2, 3, 4, 4, 4, 4})).size(), 5u);  // pyramid
  EXPECT_EQ(SolidFaces(nodes({0, 1, 2, 3, 3, 3, 3, 3})).size(), 4u);  // tetrahedron
  EXPECT_EQ(SolidFaces(nodes({0, 0, 0, 0, 0, 0, 0, 0})).size(), 0u);
}

TEST(SolidFaces, NormalsPointOutward) {
  const Vector corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const Vector middle(0.5, 0.5, 0.5);
  std::size_t faces = 0;
  for (const auto& shape : {nodes({0, 1, 2, 3, 4, 5, 6, 7}), nodes({0, 1, 2, 5, 5, 5, 5, 5})})
    for (const SegmentNodes& face : SolidFaces(shape)) {
      const Vector a = corners[face[0].value], b = corners[face[1].value], c = corners[face[2].value];
      const Vector u = b - a, v = c - b;
      const Vector normal(u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(), u.x() * v.y() - u.y() * v.x());
      Vector inner = Vector::Zero();
      std::set<std::uint32_t> used;
      for (const NodeIndex node : shape)
        if (used.insert(node.value).second) inner += corners[node.value];
      inner /= static_cast<double>(used.size());
      EXPECT_GT(normal.dot(a - inner), 0) << face[0].value << face[1].value << face[2].value;
      ++faces;
    }
  EXPECT_EQ(faces, 10u);
}

TEST(ExteriorFaces, AgreeWithCountingEveryFace) {
  // A block of 4 x 3 x 2 bricks, one of them cut into wedges.
  Elements<8> solids;
  const auto at = [](std::uint32_t i, std::uint32_t j, std::uint32_t k) { return i + 5 * (j + 4 * k); };
  std::vector<std::uint32_t> members;
  for (std::uint32_t k = 0; k < 2; ++k)
    for (std::uint32_t j = 0; j < 3; ++j)
      for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t a = at(i, j, k), b = at(i + 1, j, k), c = at(i + 1, j + 1, k), d = at(i, j + 1, k);
        const std::uint32_t e = a + 20, f = b + 20, g = c + 20, h = d + 20;
        if (i == 1 && j == 1) {
          solids.nodes.push_back(nodes({a, b, f, e, d, d, h, h}));
          solids.nodes.push_back(nodes({b, c, g, f, d, d, h, h}));
        } else {
          solids.nodes.push_back(nodes({a, b, c, d, e, f, g, h}));
        }
      }
  std::map<std::set<std::uint32_t>, int> counts;
  for (std::uint32_t i = 0; i < solids.nodes.size(); ++i) {
    members.push_back(i);
    for (const SegmentNodes& face : SolidFaces(solids.nodes[i]))
      ++counts[{face[0].value, face[1].value, face[2].value, face[3].value}];
  }
  std::size_t expected = 0;
  for (const auto& [face, count] : counts) expected += count == 1 ? 1 : 0;
  const auto exterior = exterior_faces(solids, members);
  EXPECT_EQ(exterior.size(), expected);
  EXPECT_EQ(exterior.size(), 2u * (12 + 6 + 8) + 2);  // the cut divides one face above and one below
  for (const auto& [face, element] : exterior)
    EXPECT_EQ((counts[{face[0].value, face[1].value, face[2].value, face[3].value}]), 1);
  EXPECT_EQ(exterior_faces(solids, {0}).size(), 6u);
  EXPECT_TRUE(exterior_faces(solids, {}).empty());
}

}  // namespace
}  // namespace gapcheck::model::faces_test
