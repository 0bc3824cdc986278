#include "contact/mesh/faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "contact/scene.hpp"

namespace gapcheck::contact::faces_test {
namespace {

std::vector<std::uint32_t> all(std::size_t n) {
  std::vector<std::uint32_t> list(n);
  std::iota(list.begin(), list.end(), 0U);
  return list;
}

Vector normal(const Face& f, const std::vector<Vector>& x) {
  return (x[f.nodes[2].value] - x[f.nodes[0].value]).cross(x[f.nodes[3].value] - x[f.nodes[1].value]);
}

TEST(Faces, BrickHasSixOutwardFacesWhateverItsNumbering) {
  Scene scene;
  const PartIndex p = scene.part(1, 0);
  scene.brick(p, {0, 0, 0}, {1, 2, 3});
  scene.brick(p, {5, 0, 0}, {1, 2, -3});  // inverted
  const auto& x = scene.model.mesh.nodes.x;
  for (std::uint32_t e = 0; e < 2; ++e) {
    const auto& nodes = scene.model.mesh.solids.nodes[e];
    EXPECT_DOUBLE_EQ(volume(nodes, x), 6);
    Vector centre = Vector::Zero();
    for (const NodeIndex n : nodes) centre += x[n.value] / 8;
    const auto faces = faces_of(nodes, e, x);
    ASSERT_EQ(faces.size(), 6U);
    double surface = 0;
    for (const Face& f : faces) {
      EXPECT_GT(normal(f, x).dot(x[f.nodes[0].value] - centre), 0);
      surface += area(f.nodes, x);
    }
    EXPECT_DOUBLE_EQ(surface, 22);
  }
}

TEST(Faces, CollapsedForms) {
  const std::vector<Vector> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0.5, 0.5, 1}};
  const auto at = [](std::initializer_list<std::uint32_t> list) {
    std::array<NodeIndex, 8> n{};
    std::transform(list.begin(), list.end(), n.begin(), [](std::uint32_t i) { return NodeIndex{i}; });
    return n;
  };
  const auto tet = at({0, 1, 2, 3, 3, 3, 3, 3});
  EXPECT_TRUE(is_tetrahedron(tet));
  EXPECT_EQ(faces_of(tet, 0, x).size(), 4U);
  EXPECT_NEAR(volume(tet, x), 1.0 / 6, 1e-15);
  const auto pyramid = at({0, 1, 4, 2, 5, 5, 5, 5});
  EXPECT_EQ(faces_of(pyramid, 0, x).size(), 5U);
  EXPECT_NEAR(volume(pyramid, x), 1.0 / 3, 1e-15);
  const std::vector<Vector> w{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0, 1}, {0.5, 1, 1}};
  const auto wedge = at({0, 1, 2, 3, 4, 4, 5, 5});
  EXPECT_EQ(faces_of(wedge, 0, w).size(), 5U);
  EXPECT_NEAR(volume(wedge, w), 0.5, 1e-15);
}

TEST(Faces, FreeFacesAreThoseCountedOnce) {
  // A 3 × 3 × 3 block with shared nodes: 54 of its 162 faces are free. The obvious twin counts sorted node lists.
  Scene scene;
  const PartIndex p = scene.part(1, 0);
  std::vector<NodeIndex> grid;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) grid.push_back(scene.node(Vector(i, j, k)));
  const auto g = [&](std::size_t i, std::size_t j, std::size_t k) { return grid[16 * k + 4 * j + i]; };
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i)
        scene.solid(p, {g(i, j, k), g(i + 1, j, k), g(i + 1, j + 1, k), g(i, j + 1, k), g(i, j, k + 1),
                        g(i + 1, j, k + 1), g(i + 1, j + 1, k + 1), g(i, j + 1, k + 1)});
  const auto& mesh = scene.model.mesh;
  std::map<std::multiset<std::uint32_t>, int> times;
  for (std::uint32_t e = 0; e < mesh.solids.size(); ++e)
    for (const Face& f : faces_of(mesh.solids.nodes[e], e, mesh.nodes.x)) {
      std::multiset<std::uint32_t> key;
      for (const NodeIndex n : f.nodes) key.insert(n.value);
      ++times[key];
    }
  const auto once = std::count_if(times.begin(), times.end(), [](const auto& t) { return t.second == 1; });
  EXPECT_EQ(once, 54);
  EXPECT_EQ(free_faces(mesh.solids, all(27), mesh.nodes.x).size(), 54U);
  EXPECT_EQ(free_faces(mesh.solids, std::vector<std::uint32_t>{0, 1}, mesh.nodes.x).size(), 10U);
}

}  // namespace
}  // namespace gapcheck::contact::faces_test
