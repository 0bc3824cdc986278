#include "contact/pair/hit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "contact/pair/side_scene.hpp"
#include "contact/scene.hpp"

namespace gapcheck::contact::hit_test {
namespace {

const Vector ex{1, 0, 0}, ey{0, 1, 0};

/// A row of bricks, whose faces have a front, and a plate above, whose segments have none in automatic contact.
Scene bricks_and_plate(const char* keyword) {
  Scene scene;
  const PartIndex bricks = scene.part(1, 0), plate = scene.part(2, 1);
  scene.model.sections[0].kind = model::SectionKind::solid;
  for (int i = 0; i < 4; ++i) scene.brick(bricks, Vector(2.0 * i, 0, 0), Vector(1, 1, 1));
  scene.plate(plate, {0, 0, 1.2}, ex, ey, 6, 2);
  scene.contact(keyword);
  return scene;
}

// Whatever pairs a node has, and in whatever portions they come, the choice is that of all of them.
TEST(Hit, DroppingFartherOnesDoesNotChangeTheChoice) {
  std::mt19937_64 random(17);
  for (const char* keyword : {"AUTOMATIC_SINGLE_SURFACE", "SINGLE_SURFACE"}) {
    Scene scene = bricks_and_plate(keyword);
    SurfaceStore surfaces(scene.model);
    const ContactIndex contact{0};
    const SideScene side(scene.model, contact, surfaces.at(contact), false, scene.model.mesh.nodes.x);
    const PairScene& pairs = side.scene();
    const auto segments = static_cast<std::uint32_t>(pairs.segments.size());
    ASSERT_GT(segments, 30U);
    std::size_t dropped = 0, chosen = 0;
    for (int round = 0; round < 4000; ++round) {
      const SlotIndex slot{static_cast<std::uint32_t>(random() % pairs.nodes.size())};
      std::vector<std::uint32_t> order(segments);
      for (std::uint32_t i = 0; i < segments; ++i) order[i] = i;
      std::shuffle(order.begin(), order.end(), random);
      order.resize(1 + random() % 25);
      std::vector<Hit> hits, measured, kept;
      for (const std::uint32_t s : order) {
        // Few different distances, so that many are equal, some but for their last digits.
        const double distance =
            0.25 * static_cast<double>(random() % 5) * (1 + 4e-10 * static_cast<double>(random() % 4));
        Hit hit{slot, SegmentIndex{s}, distance, random() % 3 == 0};
        const bool oriented = pairs.oriented(hit.segment);
        if (oriented && random() % 2 == 0) hit.distance = -hit.distance;
        const bool penetrates = !oriented || random() % 2 == 0;
        (penetrates ? hits : measured).push_back(hit);
        if (penetrates) kept.push_back(hit);
        if (random() % 4 == 0) drop_farther(pairs, kept);
      }
      drop_farther(pairs, kept);
      dropped += hits.size() - kept.size();
      if (hits.empty()) {
        EXPECT_TRUE(kept.empty());
        continue;
      }
      ASSERT_FALSE(kept.empty());
      const auto all = choose_hit(pairs, hits, measured), few = choose_hit(pairs, kept, measured);
      ASSERT_EQ(all.has_value(), few.has_value()) << keyword << " round " << round;
      if (!all) continue;
      ++chosen;
      EXPECT_EQ(all->segment, few->segment) << keyword << " round " << round;
      EXPECT_EQ(all->distance, few->distance);
      EXPECT_EQ(all->in_band, few->in_band);
    }
    EXPECT_GT(dropped, 4000U) << keyword;
    EXPECT_GT(chosen, 2000U) << keyword;
  }
}

}  // namespace
}  // namespace gapcheck::contact::hit_test
