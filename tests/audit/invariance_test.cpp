// Moving, turning, scaling, renumbering or shuffling a model does not change what is found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <tuple>

#include "audit/random_scene.hpp"
#include "audit/run.hpp"

namespace gapcheck::audit_test::invariance_test {
namespace {

constexpr std::uint64_t scenes = 60;

struct Record {
  int kind = 0;
  Outcome outcome = Outcome::reported;
  double depth = 0, contact_distance = 0;
};
using Records = std::map<std::pair<std::int64_t, std::int64_t>, Record>;
using IdMap = std::function<std::int64_t(std::int64_t)>;

std::size_t compared = 0;  ///< penetrations, by for_all_scenes()

Records records_of(const Scene& scene, const IdMap& original_id) {
  const AuditRun run = run_text(scene.text());
  EXPECT_TRUE(clean(run));
  Records records;
  for (const auto& p : run.report.penetrations) {
    records[{run.report.contacts.at(p.contact).id, original_id(p.node)}] = {static_cast<int>(p.kind), p.outcome,
                                                                            p.depth, p.contact_distance};
  }
  return records;
}

/// `changed` is `scene` in another guise, with all lengths times `factor`.
void expect_same(
    const Scene& scene, const Scene& changed, double factor,
    const IdMap& original_id = [](std::int64_t id) { return id; }) {
  const Records before = records_of(scene, [](std::int64_t id) { return id; });
  const Records after = records_of(changed, original_id);
  compared += before.size();
  for (const auto& [key, record] : before) {
    SCOPED_TRACE("contact " + std::to_string(key.first) + " node " + std::to_string(key.second));
    const auto match = after.find(key);
    if (match == after.end()) {
      ADD_FAILURE() << "lost, depth " << record.depth << " of " << record.contact_distance;
      continue;
    }
    EXPECT_EQ(match->second.kind, record.kind);
    EXPECT_EQ(match->second.outcome, record.outcome);
    EXPECT_NEAR(match->second.depth, factor * record.depth, 1e-9 * factor);
    EXPECT_NEAR(match->second.contact_distance, factor * record.contact_distance, 1e-9 * factor);
  }
  for (const auto& [key, record] : after)
    EXPECT_TRUE(before.contains(key)) << "new: contact " << key.first << " node " << key.second << " depth "
                                      << record.depth;
}

void for_all_scenes(const std::function<void(const Scene&)>& check) {
  compared = 0;
  for (std::uint64_t seed = 1001; seed <= 1000 + scenes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    check(random_scene(seed));
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(compared, 1000u) << "the scenes must have something to compare";
}

TEST(Invariance, Translation) {
  for_all_scenes([](const Scene& scene) {
    Scene moved = scene;
    for (auto& node : moved.nodes) node.x += Vector(1024.0, -37.5, 0.0625);
    expect_same(scene, moved, 1);
  });
}

TEST(Invariance, QuarterTurns) {
  for_all_scenes([](const Scene& scene) {
    Scene turned = scene;
    for (auto& node : turned.nodes) node.x = Vector(-node.x.y(), node.x.x(), node.x.z());
    expect_same(scene, turned, 1);
    for (auto& node : turned.nodes) node.x = Vector(node.x.z(), node.x.x(), node.x.y());
    expect_same(scene, turned, 1);
  });
}

TEST(Invariance, ScalingByPowersOfTwo) {
  for_all_scenes([](const Scene& scene) {
    for (const double factor : {0x1p-10, 4.0, 0x1p20}) {
      Scene scaled = scene;
      for (auto& node : scaled.nodes) node.x *= factor;
      for (auto& part : scaled.parts) part.thickness *= factor;
      for (auto& contact : scaled.contacts) contact.sst *= factor, contact.mst *= factor;
      expect_same(scene, scaled, factor);
    }
  });
}

TEST(Invariance, NewNumbers) {
  for_all_scenes([](const Scene& scene) {
    // Reverses the order of the ids too.
    const auto renumber = [](std::int64_t id) { return 9000001 - 7 * id; };
    Scene renumbered = scene;
    for (auto& node : renumbered.nodes) node.id = renumber(node.id);
    for (auto& element : renumbered.elements) {
      element.id = 5000000 - 3 * element.id;
      for (auto& node : element.nodes) node = renumber(node);
    }
    expect_same(scene, renumbered, 1, [](std::int64_t id) { return (9000001 - id) / 7; });
  });
}

TEST(Invariance, AnotherOrderInTheDeck) {
  for_all_scenes([](const Scene& scene) {
    Scene shuffled = scene;
    std::mt19937_64 random(scene.nodes.size());
    std::shuffle(shuffled.nodes.begin(), shuffled.nodes.end(), random);
    std::shuffle(shuffled.elements.begin(), shuffled.elements.end(), random);
    std::shuffle(shuffled.parts.begin(), shuffled.parts.end(), random);
    expect_same(scene, shuffled, 1);
  });
}

TEST(Invariance, OtherCornersFirst) {
  for_all_scenes([](const Scene& scene) {
    Scene turned = scene;
    for (auto& element : turned.elements) {
      if (!element.solid()) std::rotate(element.nodes.begin(), element.nodes.begin() + 1, element.nodes.end());
    }
    expect_same(scene, turned, 1);
    for (auto& element : turned.elements) {
      if (!element.solid()) std::reverse(element.nodes.begin(), element.nodes.end());
    }
    expect_same(scene, turned, 1);
  });
}

}  // namespace
}  // namespace gapcheck::audit_test::invariance_test
