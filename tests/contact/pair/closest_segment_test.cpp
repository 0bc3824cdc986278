#include "contact/pair/closest_segment.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <random>
#include <vector>

#include "base/parallel.hpp"
#include "contact/pair/side_scene.hpp"
#include "contact/scene.hpp"

namespace gapcheck::contact::closest_segment_test {
namespace {

/// Layers of cloth so near to each other that every node penetrates several. Every other layer lies aside, so nodes lie
/// over the faces of the next layer and over the corners of the one after that. `rough`: by how much nodes are out of
/// place.
Scene layers(double rough) {
  Scene scene;
  const PartIndex part = scene.part(1, 1.0);
  for (int layer = 0; layer < 7; ++layer) {
    const double aside = layer % 2;
    scene.plate(part, {0.3 * aside, 0.4 * aside, 0.21 * layer}, {1, 0, 0}, {0, 1, 0}, 6, 5);
  }
  std::mt19937_64 random(5);
  for (Vector& x : scene.model.mesh.nodes.x)
    for (int i = 0; i < 3; ++i) x[i] += rough * (static_cast<double>(random() % 2001) / 1000 - 1);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  return scene;
}

/// Decides every pair and chooses among all hits. `asked`: how many pairs penetrate.
std::vector<Hit> by_brute_force(const PairScene& scene, const PairFilter& filter, std::uint64_t& asked) {
  std::vector<Hit> chosen;
  for (const SlotIndex slot : positions<SlotIndex>(scene.nodes.size())) {
    std::vector<Hit> hits;
    for (const SegmentIndex s : positions<SegmentIndex>(scene.segments.size())) {
      if (is_corner(scene.segments.nodes[s.value], scene.nodes.node[slot.value])) continue;
      const PairResult pair = decide_pair(scene, slot, s);
      if (!pair.penetrates) continue;
      ++asked;
      if (filter(slot, s, true)) hits.push_back({slot, s, pair.distance, pair.in_band});
    }
    if (const auto hit = choose_hit(scene, hits, {}); !hits.empty() && hit) chosen.push_back(*hit);
  }
  return chosen;
}

TEST(ClosestSegments, AreThoseChosenAmongAllPairs) {
  for (const double rough : {0.0, 0.1}) {
    Scene scene = layers(rough);
    SurfaceStore surfaces(scene.model);
    const SideScene side(scene.model, ContactIndex{0}, surfaces.at(ContactIndex{0}), false, scene.model.mesh.nodes.x);
    const PairScene& pairs = side.scene();
    const auto search = make_bucket_grid();
    for (const bool tallies : {false, true}) {
      std::atomic<std::uint64_t> calls{0};
      const PairFilter filter{[&](SlotIndex slot, SegmentIndex segment, bool penetrates) {
                                calls += penetrates ? 1 : 0;
                                return !pairs.neighbours.in_ring(pairs.nodes.node[slot.value], segment);
                              },
                              tallies};
      std::uint64_t penetrating = 0;
      const std::vector<Hit> expected = by_brute_force(pairs, filter, penetrating);
      ASSERT_GT(expected.size(), pairs.nodes.size() / 2);
      for (const std::size_t jobs : {1U, 4U}) {
        const JobLimit limit(jobs);
        calls = 0;
        SweepCounters counters;
        geometry::DecisionCounters decisions;
        const std::vector<Hit> found = closest_segments(pairs, *search, filter, counters, decisions);
        EXPECT_EQ(decisions.filter + decisions.interval + decisions.exact, counters.candidate_pairs);
        EXPECT_EQ(calls == penetrating, tallies);
        EXPECT_LE(calls, penetrating);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
          EXPECT_EQ(found[i].slot, expected[i].slot);
          EXPECT_EQ(found[i].segment, expected[i].segment) << "rough " << rough << " slot " << i;
          EXPECT_NEAR(found[i].distance, expected[i].distance, 1e-14);
          EXPECT_EQ(found[i].in_band, expected[i].in_band);
        }
      }
    }
  }
}

}  // namespace
}  // namespace gapcheck::contact::closest_segment_test
