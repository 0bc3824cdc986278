#include "contact/tie/tie_candidates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/scene.hpp"
#include "contact/tie/ties.hpp"
#include "reference/tie_reference.hpp"

namespace gapcheck::contact::tie_candidates_test {
namespace {

using Random = std::mt19937_64;

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A graded, warped plate of quads and triangles, thickness 0.8, far from the origin; and node set 5 on its nodes.
Scene warped_plate(Random& random, std::uint32_t n) {
  Scene scene;
  const PartIndex part = scene.part(1, 0.8);
  std::vector<NodeIndex> nodes;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) {
      const double x = 10 * std::pow(1.15, i), y = 10 * std::pow(1.1, j);  // elements of 1 to 40
      const double h = 0.15 * std::min(x, y) / 10;
      nodes.push_back(
          scene.node({100 + x + between(random, -h, h), y + between(random, -h, h), between(random, -2 * h, 2 * h)}));
    }
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i;
      const NodeIndex p = nodes[a], q = nodes[a + 1], r = nodes[a + n + 2], s = nodes[a + n + 1];
      if (between(random, 0, 1) < 0.3) {
        scene.shell(part, {p, q, r, r});
        scene.shell(part, {p, r, s, s});
      } else {
        scene.shell(part, {p, q, r, s});
      }
    }
  auto& c = scene.contact("TIED_NODES_TO_SURFACE_OFFSET");
  c.a = {5, 4, 0, true};
  c.b = {1, 3, 0, true};
  return scene;
}

std::vector<reference::TieSegment> segments_of(const Scene& scene) {
  std::vector<reference::TieSegment> segments;
  const auto& x = scene.model.mesh.nodes.x;
  for (const auto& n : scene.model.mesh.shells.nodes)
    segments.push_back({{x[n[0].value], x[n[1].value], x[n[2].value], x[n[3].value]}, n[2] == n[3], 0.8});
  return segments;
}

/// Somewhere above, below, beside a segment; half of them within 1e-8 of its tie distance or of the tolerance's end.
Vector some_node(Random& random, const reference::TieSegment& segment) {
  const geometry::Facet facet{segment.corners, segment.triangle};
  const double s = between(random, -1.1, 1.1), t = between(random, -1.1, 1.1);
  const auto& x = facet.x;
  const Vector at = 0.25 * ((1 - s) * (1 - t) * x[0] + (1 + s) * (1 - t) * x[1] + (1 + s) * (1 + t) * x[2] +
                            (1 - s) * (1 + t) * x[3]);
  const Vector normal = (x[2] - x[0]).cross(x[3] - x[1]).normalized();
  const double diagonal = std::min((x[2] - x[0]).norm(), (x[3] - x[1]).norm());
  const double limit = tie_distance(0, segment.thickness, diagonal, false, false);
  const double side = between(random, 0, 1) < 0.5 ? -1 : 1;
  if (between(random, 0, 1) < 0.5) return at + side * between(random, 0, 2 * limit) * normal;
  const Vector near = at + side * limit * normal;
  const auto closest = geometry::closest_point(facet, near);
  const double wanted = limit * (1 + 1e-9 + between(random, -1, 1) * std::pow(10.0, between(random, -13, -8)));
  return closest.point + wanted * (near - closest.point).normalized();
}

TEST(TieCandidates, AgreeWithTheSlowRuleOnWarpedMeshes) {
  std::size_t judged = 0, ties = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    Scene scene = warped_plate(random, 14);
    const auto segments = segments_of(scene);
    std::vector<reference::TieVerdict> expected;
    for (int i = 0; i < 1000; ++i) {
      const Vector x = some_node(random, segments[random() % segments.size()]);
      scene.model.sets.nodes[5].members.push_back(scene.node(x));
      expected.push_back(reference::tie_verdict(segments, x, 0, 1.07));
    }
    const InitialState state = scene.run();
    ASSERT_EQ(state.judged.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (!expected[i].certain) continue;
      ++judged;
      ties += expected[i].ties ? 1 : 0;
      EXPECT_EQ(state.judged[i].tied(), expected[i].ties) << "seed " << seed << ", node " << i;
      if (expected[i].ties && state.judged[i].tied()) {
        EXPECT_NEAR(state.judged[i].distance, static_cast<double>(expected[i].nearest), 1e-9);
      }
    }
  }
  EXPECT_GT(judged, 9900U);  // the doubtful ones are few
  EXPECT_GT(ties, 3000U);
  EXPECT_LT(ties, 9000U);
}

TEST(TieCandidates, WithoutTheFilterTheyAreTheSame) {
  Random random(11);
  Scene scene = warped_plate(random, 8);
  const auto segments = segments_of(scene);
  for (int i = 0; i < 500; ++i)
    scene.model.sets.nodes[5].members.push_back(scene.node(some_node(random, segments[random() % segments.size()])));
  InitialOptions exact, brute;
  exact.mode = geometry::Mode::exact;
  brute.brute_force = true;
  const InitialState state = scene.run();
  for (const InitialState& other : {scene.run(exact), scene.run(brute)}) {
    ASSERT_EQ(state.judged.size(), other.judged.size());
    for (std::size_t i = 0; i < state.judged.size(); ++i) {
      EXPECT_EQ(state.judged[i].reason, other.judged[i].reason);
      EXPECT_EQ(state.judged[i].segment, other.judged[i].segment);
    }
  }
}

/// Whether a node ties to a plate of 2 x 2 shells of `size` and thickness `t` from `corner` on.
bool ties(const Vector& corner, double size, double t, const Vector& node, double parmax = 0,
          const std::string& options = "") {
  Scene scene;
  scene.plate(scene.part(1, t), corner, {size, 0, 0}, {0, size, 0}, 2, 2);
  scene.model.sets.nodes[5].members = {scene.node(node)};
  auto& c = scene.contact("TIED_NODES_TO_SURFACE_OFFSET");
  c.a = {5, 4, 0, true};
  c.b = {1, 3, 0, true};
  c.parmax = parmax;
  set_name(c.keyword + options, c);
  return scene.run().contacts[0].ties == 1;
}

TEST(TieCandidates, NodesExactlyAtTheDistanceTie) {
  // Decimal heights on decimal levels: their binary images are above or below the sum by rounding. Shells of 5 tie by
  // thickness (0.6 t > 0.354), at the inside, over an inner edge, the middle node, the free edge and the corner.
  for (const double level : {0.0, 0.1, 12.3, 1234.7, -98765.4})
    for (const double t : {0.7, 1.0, 1.3, 1.9})
      for (const Vector& at :
           {Vector(1.7, 2.3, 0), Vector(5, 2.3, 0), Vector(5, 5, 0), Vector(10, 2.3, 0), Vector(10, 10, 0)})
        for (const double side : {-1.0, 1.0}) {
          const Vector corner(0.1, 0.1, level), foot = corner + at;
          const double d1 = 0.6 * t;
          EXPECT_TRUE(ties(corner, 5, t, {foot.x(), foot.y(), level + side * d1})) << level << ' ' << t;
          EXPECT_FALSE(ties(corner, 5, t, {foot.x(), foot.y(), level + side * d1 * (1 + 1e-7)})) << level << ' ' << t;
        }
}

TEST(TieCandidates, NodesExactlyAtTheShareOfTheDiagonalTie) {
  for (const double level : {0.0, 0.1, 1234.7})
    for (const double size : {3.0, 10.0, 12.5}) {
      const double d2 = 0.05 * std::sqrt(2.0) * size;
      EXPECT_TRUE(ties({0.1, 0.1, level}, size, 0.1, {1.3, 1.1, level + d2}));
      EXPECT_FALSE(ties({0.1, 0.1, level}, size, 0.1, {1.3, 1.1, level + d2 * (1 + 1e-7)}));
    }
}

TEST(TieCandidates, ProjectionsExactlyAtParmaxCount) {
  // Half a shell is 5 long: MAXPAR 1.07 ends 0.35 beyond the free edge at 20, 1.1 ends 0.5 beyond.
  EXPECT_TRUE(ties({0, 0, 0}, 10, 1, {20.35, 3, 0.1}));
  EXPECT_TRUE(ties({0, 0, 0}, 10, 1, {20.35, 20.35, 0.1}));
  EXPECT_FALSE(ties({0, 0, 0}, 10, 1, {20.35001, 3, 0.1}));
  EXPECT_FALSE(ties({0, 0, 0}, 10, 1, {20.1, 20.35001, 0.1}));
  EXPECT_TRUE(ties({0, 0, 0}, 10, 1, {20.5, 3, 0.1}, 1.1));
  EXPECT_FALSE(ties({0, 0, 0}, 10, 1, {20.50001, 3, 0.1}, 1.1));
  // The MPP card's own default, where the keyword has that card: 0.175.
  EXPECT_TRUE(ties({0, 0, 0}, 10, 1, {20.175, 3, 0.1}, 0, "_MPP_ID"));
  EXPECT_FALSE(ties({0, 0, 0}, 10, 1, {20.17501, 3, 0.1}, 0, "_MPP"));
}

TEST(TieCandidates, OfTrianglesABarycentricBandOfHalfThatWidthCounts) {
  // A right triangle of legs 10: at the middle of a leg the barycentric coordinate falls by 1 over 10.
  const auto triangle = [](double y) {
    Scene scene;
    const PartIndex part = scene.part(1, 1);
    const NodeIndex a = scene.node({0, 0, 0}), b = scene.node({10, 0, 0}), c = scene.node({0, 10, 0});
    scene.shell(part, {a, b, c, c});
    scene.model.sets.nodes[5].members = {scene.node({5, y, 0})};
    auto& contact = scene.contact("TIED_NODES_TO_SURFACE_OFFSET");
    contact.a = {5, 4, 0, true};
    contact.b = {1, 3, 0, true};
    return scene.run().contacts[0].ties == 1;
  };
  EXPECT_TRUE(triangle(-0.35));
  EXPECT_FALSE(triangle(-0.35001));
}

TEST(TieCandidates, EquallyNearSegmentsGiveTheFirst) {
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 2, 2);
  scene.model.sets.nodes[5].members = {scene.node({10, 10, 0.3}), scene.node({10, 15, 0.3})};
  auto& c = scene.contact("TIED_NODES_TO_SURFACE_OFFSET");
  c.a = {5, 4, 0, true};
  c.b = {1, 3, 0, true};
  const InitialState state = scene.run();
  ASSERT_EQ(state.judged.size(), 2U);
  EXPECT_EQ(state.judged[0].segment, SegmentIndex{0});
  EXPECT_EQ(state.judged[1].segment, SegmentIndex{2});
}

}  // namespace
}  // namespace gapcheck::contact::tie_candidates_test
