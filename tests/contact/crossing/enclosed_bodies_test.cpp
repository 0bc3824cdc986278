#include "contact/crossing/enclosed_bodies.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>

#include "contact/scene.hpp"

namespace gapcheck::contact::enclosed_bodies_test {
namespace {

std::vector<EnclosedBody> enclosed(const Scene& scene, const CrossingOptions& options = {}) {
  CrossingCounters counters;
  return find_enclosed_bodies(
      scene.model, [](PartIndex, PartIndex) { return ContactIndex{0}; }, options, counters);
}

/// An L of three bricks with common nodes: [0, 2] x [0, 2] x [0, 1] without the quarter x > 1, y > 1.
void add_l(Scene& scene, PartIndex part) {
  std::array<NodeIndex, 18> n{};
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i)
        n[9 * k + 3 * j + i] =
            scene.node(Vector(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)));
  for (const std::size_t a : {0, 1, 3})
    scene.solid(part, {n[a], n[a + 1], n[a + 4], n[a + 3], n[a + 9], n[a + 10], n[a + 13], n[a + 12]});
}

TEST(EnclosedBodies, InTheNotchOfAnLIsOutside) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr double size = 0.125;
  int inside = 0, outside = 0;
  for (int i = 0; i < 200; ++i) {
    Scene scene;
    const PartIndex l = scene.part(1, 1), small = scene.part(2, 1);
    add_l(scene, l);
    const Vector low(1.875 * unit(random), 1.875 * unit(random), 0.875 * unit(random));
    scene.brick(small, low, Vector::Constant(size));
    const bool in_notch = low.x() + size > 1 && low.y() + size > 1;
    const std::vector<EnclosedBody> found = enclosed(scene);
    ASSERT_EQ(found.size(), in_notch ? 0U : 1U) << low.transpose();
    EXPECT_EQ(enclosed(scene, {geometry::Mode::exact, BoxSearch::brute_force}).size(), found.size());
    (in_notch ? outside : inside) += 1;
    if (in_notch) continue;
    EXPECT_EQ(found[0].inner, small);
    EXPECT_EQ(found[0].outer, l);
    EXPECT_EQ(found[0].first_solid, 3U);
    EXPECT_EQ(found[0].solids, 1U);
  }
  EXPECT_GT(inside, 50);
  EXPECT_GT(outside, 20);
}

TEST(EnclosedBodies, OneOfTwoNestedInAThird) {
  // A Russian doll: the smallest is in both others.
  Scene scene;
  for (int i = 0; i < 3; ++i) scene.brick(scene.part(i + 1, 1), Vector::Constant(i), Vector::Constant(10 - 2 * i));
  std::set<std::pair<std::uint32_t, std::uint32_t>> nested;  // inner, outer
  for (const EnclosedBody& body : enclosed(scene)) {
    EXPECT_TRUE(nested.emplace(body.inner.value, body.outer.value).second);
    EXPECT_EQ(body.first_solid, body.inner.value);
    EXPECT_EQ(body.solids, 1U);
  }
  EXPECT_EQ(nested, (std::set<std::pair<std::uint32_t, std::uint32_t>>{{1, 0}, {2, 0}, {2, 1}}));
}

TEST(EnclosedBodies, OfOnePartOrWithACommonNodeTheyDoNotCount) {
  Scene one;
  const PartIndex part = one.part(1, 1);
  one.brick(part, Vector::Zero(), Vector::Constant(10));
  one.brick(part, Vector::Constant(4), Vector::Constant(1));
  EXPECT_TRUE(enclosed(one).empty());
  Scene joined;
  joined.brick(joined.part(1, 1), Vector::Zero(), Vector::Constant(10));
  joined.brick(joined.part(2, 1), Vector::Constant(4), Vector::Constant(1));
  EXPECT_EQ(enclosed(joined).size(), 1U);
  joined.model.mesh.solids.nodes[1][0] = joined.model.mesh.solids.nodes[0][0];
  EXPECT_TRUE(enclosed(joined).empty());
}

TEST(EnclosedBodies, FluidsSurroundWhatTheyLike) {
  Scene scene;
  scene.brick(scene.part(1, 1), Vector::Zero(), Vector::Constant(10));
  scene.brick(scene.part(2, 1), Vector::Constant(4), Vector::Constant(1));
  scene.model.sections[0].elform = 11;
  EXPECT_TRUE(enclosed(scene).empty());
}

}  // namespace
}  // namespace gapcheck::contact::enclosed_bodies_test
