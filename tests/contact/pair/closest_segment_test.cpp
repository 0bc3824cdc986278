#include "contact/pair/closest_segment.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <random>
#include <vector>

#include "base/parallel.hpp"
#include "contact/pair/hidden_faces.hpp"
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

/// Three blocks of rough bricks, of which each sinks into the one below and hangs over its side, and a plate of shells
/// that lies on the first two. Where `sunk` is large, the third one reaches the first.
Scene blocks(std::mt19937_64& random, double rough, double sunk) {
  Scene scene;
  const PartIndex part[] = {scene.part(1, 0), scene.part(2, 0), scene.part(4, 0), scene.part(3, 0.2)};
  for (std::size_t i = 0; i < 3; ++i) scene.model.sections[i].kind = model::SectionKind::solid;
  for (int block = 0; block < 3; ++block) {
    const Vector place(1.3 * block, 0.4 * block, (1.6 - sunk) * block);
    std::vector<NodeIndex> n;
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 5; ++i) n.push_back(scene.node(place + Vector(i, 0.9 * j, 0.8 * k)));
    const auto at = [&](int i, int j, int k) { return n[static_cast<std::size_t>(i + 5 * j + 20 * k)]; };
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 4; ++i)
          scene.solid(part[block], {at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k), at(i, j, k + 1),
                                    at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)});
  }
  scene.plate(part[3], {-1, 0.2, 1.65}, {0.8, 0, 0}, {0, 0.7, 0}, 4, 4);
  for (Vector& x : scene.model.mesh.nodes.x)
    for (int i = 0; i < 3; ++i) x[i] += rough * (static_cast<double>(random() % 2001) / 1000 - 1);
  return scene;
}

/// Decides every pair, and chooses among all hits, with all pairs of oriented segments in sight.
std::vector<Hit> with_all_pairs_measured(const PairScene& scene, const CandidateSearch& search,
                                         const PairFilter& filter) {
  std::vector<Hit> hits, measured;
  for (const SlotIndex slot : positions<SlotIndex>(scene.nodes.size()))
    for (const SegmentIndex s : positions<SegmentIndex>(scene.segments.size())) {
      if (is_corner(scene.segments.nodes[s.value], scene.nodes.node[slot.value]) || !filter(slot, s, true)) continue;
      const PairResult pair = decide_pair(scene, slot, s);
      if (!pair.penetrates && !scene.oriented(s)) continue;
      (pair.penetrates ? hits : measured).push_back({slot, s, pair.distance, pair.in_band});
    }
  drop_outside(scene, search, hits);
  std::vector<Hit> chosen;
  for (const SlotIndex slot : positions<SlotIndex>(scene.nodes.size())) {
    const auto of_slot = [&](const std::vector<Hit>& all) {
      std::vector<Hit> some;
      for (const Hit& hit : all)
        if (hit.slot == slot) some.push_back(hit);
      return some;
    };
    const std::vector<Hit> own = of_slot(hits);
    if (own.empty()) continue;
    if (const auto hit = choose_hit(scene, own, of_slot(measured))) chosen.push_back(*hit);
  }
  return chosen;
}

// Neither the filter of nodes beside faces nor leaving pairs out that are farther than a hit changes what is found.
TEST(ClosestSegments, OfSolidsAreThoseChosenAmongAllPairs) {
  // Among these scenes is one in which a hit is behind the face of another body that is nearer and does not count.
  std::mt19937_64 random(55);
  const auto search = make_bucket_grid();
  std::size_t behind = 0, in_front = 0;
  for (int round = 0; round < 60; ++round) {
    Scene scene = blocks(random, 0.05 * (round % 5), 0.14 * (round % 7));
    scene.contact(round % 3 == 0 ? "AUTOMATIC_SINGLE_SURFACE" : "AUTOMATIC_SURFACE_TO_SURFACE");
    SurfaceStore surfaces(scene.model);
    const SideScene side(scene.model, ContactIndex{0}, surfaces.at(ContactIndex{0}), false, scene.model.mesh.nodes.x);
    const PairScene& pairs = side.scene();
    const PairFilter filter{[&](SlotIndex slot, SegmentIndex segment, bool) {
                              return !pairs.neighbours.in_ring(pairs.nodes.node[slot.value], segment);
                            },
                            false};
    const std::vector<Hit> expected = with_all_pairs_measured(pairs, *search, filter);
    SweepCounters counters;
    geometry::DecisionCounters decisions;
    const std::vector<Hit> found = closest_segments(pairs, *search, filter, counters, decisions);
    EXPECT_EQ(decisions.filter + decisions.interval + decisions.exact, counters.candidate_pairs);
    ASSERT_EQ(found.size(), expected.size()) << "round " << round;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].slot, expected[i].slot) << "round " << round;
      EXPECT_EQ(found[i].segment, expected[i].segment) << "round " << round << " slot " << found[i].slot.value;
      EXPECT_NEAR(found[i].distance, expected[i].distance, 1e-14);
      ++(std::signbit(found[i].distance) ? behind : in_front);
    }
  }
  EXPECT_GT(behind, 300U);
  EXPECT_GT(in_front, 100U);
}

}  // namespace
}  // namespace gapcheck::contact::closest_segment_test
