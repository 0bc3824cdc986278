#include "audit/untangle/flood.hpp"

#include <random>

#include "audit/untangle/surfaces.hpp"

namespace gapcheck::audit_test::flood_test {
namespace {

const Plate plate{.id = 1, .nx = 9, .ny = 5};

/// Edges of the plate's mesh between columns `i` and `i + 1`.
std::set<std::pair<NodeIndex, NodeIndex>> column_cut(const ContactScene& scene, int i, int rows) {
  std::set<std::pair<NodeIndex, NodeIndex>> cut;
  for (int j = 0; j < rows; ++j) cut.insert({scene.node(plate.node(i, j)), scene.node(plate.node(i + 1, j))});
  return cut;
}

std::vector<NodeIndex> ends(const std::set<std::pair<NodeIndex, NodeIndex>>& cut) {
  std::set<NodeIndex> list;
  for (const auto& [a, b] : cut) list.insert({a, b});
  return {list.begin(), list.end()};
}

TEST(Flood, TheSmallerPartIsKnownTheOtherStaysOpen) {
  const ContactScene scene(plates_deck(plate));
  const auto cut = column_cut(scene, 2, 6);
  std::uint64_t work = 1'000'000;
  const auto flood = audit::Flood::over(scene.surface->segments(), scene.surface->neighbours(), ends(cut), cut, {},
                                        audit::Flood::Until::one_left, work);
  ASSERT_TRUE(flood);
  EXPECT_LT(work, 1'000'000u);
  const std::uint32_t left = flood->region(scene.node(plate.node(0, 0)));
  const std::uint32_t right = flood->region(scene.node(plate.node(3, 4)));
  EXPECT_NE(left, right);
  EXPECT_TRUE(flood->open(right));
  EXPECT_FALSE(flood->open(left));
  EXPECT_EQ(flood->largest(), right);
  EXPECT_EQ(flood->nodes(left).size(), 18u);
  const auto whole = audit::Flood::over(scene.surface->segments(), scene.surface->neighbours(), ends(cut), cut, {},
                                        audit::Flood::Until::all_known, work);
  ASSERT_TRUE(whole);
  EXPECT_FALSE(whole->open(whole->largest()));
  EXPECT_EQ(whole->nodes(whole->largest()).size(), 42u);
}

TEST(Flood, ACutThatEndsInsideDoesNotDivide) {
  const ContactScene scene(plates_deck(plate));
  const auto cut = column_cut(scene, 2, 4);
  std::uint64_t work = 1'000'000;
  const auto flood = audit::Flood::over(scene.surface->segments(), scene.surface->neighbours(), ends(cut), cut, {},
                                        audit::Flood::Until::one_left, work);
  ASSERT_TRUE(flood);
  for (const auto& [a, b] : cut) EXPECT_EQ(flood->region(a), flood->region(b));
}

TEST(Flood, OnlyAllowedNodesCount) {
  const ContactScene scene(plates_deck(plate));
  const auto cut = column_cut(scene, 2, 4);
  std::uint64_t work = 1'000'000;
  const auto flood = audit::Flood::over(
      scene.surface->segments(), scene.surface->neighbours(), ends(cut), cut,
      [&](NodeIndex n) { return scene.model->mesh.nodes.x[n.value].y() < 16; }, audit::Flood::Until::one_left, work);
  ASSERT_TRUE(flood);
  EXPECT_EQ(flood->nodes(flood->region(scene.node(plate.node(0, 0)))).size(), 12u);
  EXPECT_EQ(flood->region(scene.node(plate.node(0, 4))), no_position);
}

TEST(Flood, GivesUpWhenItsWorkIsDone) {
  const ContactScene scene(plates_deck(plate));
  const auto cut = column_cut(scene, 2, 6);
  std::uint64_t work = 5;
  EXPECT_FALSE(audit::Flood::over(scene.surface->segments(), scene.surface->neighbours(), ends(cut), cut, {},
                                  audit::Flood::Until::one_left, work));
  EXPECT_EQ(work, 0u);
}

/// Regions by painting the whole graph again and again until nothing changes.
std::vector<std::uint32_t> paint(const ContactScene& scene, const std::set<std::pair<NodeIndex, NodeIndex>>& cut) {
  std::vector<std::uint32_t> colour(scene.model->mesh.nodes.size());
  for (std::uint32_t i = 0; i < colour.size(); ++i) colour[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& n : scene.model->mesh.shells.nodes)
      for (std::size_t k = 0; k < 4; ++k) {
        const NodeIndex a = std::min(n[k], n[(k + 1) % 4]), b = std::max(n[k], n[(k + 1) % 4]);
        if (cut.contains({a, b}) || colour[a.value] == colour[b.value]) continue;
        colour[a.value] = colour[b.value] = std::min(colour[a.value], colour[b.value]);
        changed = true;
      }
  }
  return colour;
}

TEST(Flood, RandomCutsAgreeWithPainting) {
  const ContactScene scene(plates_deck(plate));
  std::mt19937_64 random(7);
  std::size_t several = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::set<std::pair<NodeIndex, NodeIndex>> cut;
    for (const auto& n : scene.model->mesh.shells.nodes)
      for (std::size_t k = 0; k < 4; ++k)
        if (random() % 100 < 45) cut.insert({std::min(n[k], n[(k + 1) % 4]), std::max(n[k], n[(k + 1) % 4])});
    std::uint64_t work = 1'000'000;
    const auto from = ends(cut);
    const auto flood = audit::Flood::over(scene.surface->segments(), scene.surface->neighbours(), from, cut, {},
                                          audit::Flood::Until::one_left, work);
    ASSERT_TRUE(flood);
    const auto colour = paint(scene, cut);
    std::set<std::uint32_t> regions;
    for (const NodeIndex a : from) {
      regions.insert(flood->region(a));
      for (const NodeIndex b : from)
        ASSERT_EQ(flood->region(a) == flood->region(b), colour[a.value] == colour[b.value]) << trial;
    }
    for (const std::uint32_t region : regions) {
      if (flood->open(region)) continue;
      const auto nodes = flood->nodes(region);
      ASSERT_EQ(nodes.size(),
                static_cast<std::size_t>(std::count(colour.begin(), colour.end(), colour[nodes[0].value])));
    }
    several += regions.size() > 2 ? 1 : 0;
  }
  EXPECT_GT(several, 20u);
}

}  // namespace
}  // namespace gapcheck::audit_test::flood_test
