#include "contact/pair/nearest_hits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <vector>

#include "contact/pair/side_scene.hpp"
#include "contact/scene.hpp"

namespace gapcheck::contact::nearest_hits_test {
namespace {

/// A row of bricks, whose faces have a front, and plates, whose segments have none in automatic contact.
Scene bricks_and_plates() {
  Scene scene;
  const PartIndex bricks = scene.part(1, 0), plate = scene.part(2, 1);
  scene.model.sections[0].kind = model::SectionKind::solid;
  for (int i = 0; i < 3; ++i) scene.brick(bricks, Vector(2.0 * i, 0, 0), Vector(1, 1, 1));
  for (int layer = 0; layer < 2; ++layer) scene.plate(plate, {0, 0, 1.2 + layer}, {1, 0, 0}, {0, 1, 0}, 6, 2);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  return scene;
}

// Whatever hits a node has, and in whatever order they come, those dropped on the way are not the one chosen among all.
TEST(NearestHits, DropNoneThatCounts) {
  std::mt19937_64 random(23);
  Scene scene = bricks_and_plates();
  SurfaceStore surfaces(scene.model);
  const SideScene side(scene.model, ContactIndex{0}, surfaces.at(ContactIndex{0}), false, scene.model.mesh.nodes.x);
  const PairScene& pairs = side.scene();
  const auto segments = static_cast<std::uint32_t>(pairs.segments.size());
  ASSERT_GT(segments, 30U);
  std::size_t dropped = 0, chosen = 0, with_front = 0;
  for (int round = 0; round < 4000; ++round) {
    NearestHits nearest(pairs);
    const SlotIndex slot{static_cast<std::uint32_t>(random() % pairs.nodes.size())};
    std::vector<std::uint32_t> order(segments);
    for (std::uint32_t i = 0; i < segments; ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    order.resize(1 + random() % 20);
    std::vector<Hit> hits, kept;
    for (const std::uint32_t s : order) {
      // Few different distances, so that many are equal, some but for their last digits.
      const double distance =
          0.25 * static_cast<double>(random() % 5) * (1 + 4e-10 * static_cast<double>(random() % 4));
      Hit hit{slot, SegmentIndex{s}, distance, random() % 3 > 0};
      if (pairs.oriented(hit.segment) && random() % 2 == 0) hit.distance = -hit.distance;
      hits.push_back(hit);
      if (nearest.add(hit)) kept.push_back(hit);
    }
    std::erase_if(kept, [&](const Hit& hit) { return !nearest.may_count(hit); });
    dropped += hits.size() - kept.size();
    ASSERT_FALSE(kept.empty());
    const auto all = choose_hit(pairs, hits, {}), few = choose_hit(pairs, kept, {});
    ASSERT_EQ(all.has_value(), few.has_value()) << round;
    if (!all) continue;
    ++chosen;
    with_front += pairs.oriented(all->segment) ? 1 : 0;
    EXPECT_EQ(all->segment, few->segment) << round;
    EXPECT_EQ(all->distance, few->distance) << round;
    EXPECT_EQ(all->in_band, few->in_band) << round;
  }
  EXPECT_GT(dropped, 4000U);
  EXPECT_GT(chosen, 3000U);
  EXPECT_GT(with_front, 300U);
}

TEST(NearestHits, LimitIsThatOfTheNearestInTheBand) {
  Scene scene = bricks_and_plates();
  SurfaceStore surfaces(scene.model);
  const SideScene side(scene.model, ContactIndex{0}, surfaces.at(ContactIndex{0}), false, scene.model.mesh.nodes.x);
  const PairScene& pairs = side.scene();
  std::optional<SegmentIndex> shell;
  for (const SegmentIndex s : positions<SegmentIndex>(pairs.segments.size()))
    if (!pairs.oriented(s)) shell = s;
  ASSERT_TRUE(shell);
  NearestHits nearest(pairs);
  const SlotIndex slot{3}, other{4};
  EXPECT_TRUE(nearest.add({slot, *shell, 0.1, false}));
  EXPECT_TRUE(nearest.may_count({slot, *shell, 0.2, false}));
  EXPECT_EQ(nearest.limit(slot), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(nearest.add({slot, *shell, 0.5, true}));
  EXPECT_FALSE(nearest.add({slot, *shell, 0.1, false}));
  EXPECT_TRUE(nearest.add({slot, *shell, 0.25, true}));
  EXPECT_FALSE(nearest.add({slot, *shell, 0.5, true}));
  EXPECT_FALSE(nearest.may_count({slot, *shell, 0.5, true}));
  EXPECT_NEAR(nearest.limit(slot), 0.25, 1e-9);
  EXPECT_GT(nearest.limit(slot), 0.25);
  EXPECT_TRUE(nearest.add({other, *shell, 0.5, false}));
}

}  // namespace
}  // namespace gapcheck::contact::nearest_hits_test
