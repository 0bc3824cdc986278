// Random scenes: a correction never makes it worse, and no element is turned inside out.
#include "audit/random_scene.hpp"

#include <fmt/format.h>

#include <cmath>

#include "audit/fix/run_fix.hpp"
#include "audit/run.hpp"
#include "contact/surface/segment_quality.hpp"

namespace gapcheck::audit_test::random_scene_test {
namespace {

constexpr std::uint64_t scenes = 100;

std::uint64_t found(const FixReport& report, bool after) {
  std::uint64_t count = 0;
  for (const FixContact& c : report.contacts) {
    const FixContact::State& state = after ? c.after : c.before;
    count += state.penetrations + state.released;
  }
  return count;
}

Vector normal(const model::SegmentNodes& n, const std::vector<Vector>& x) {
  return (x[n[2].value] - x[n[0].value]).cross(x[n[3].value] - x[n[1].value]);
}

void expect_upright(const model::Model& before, const model::Model& after, std::uint64_t seed) {
  for (std::size_t i = 0; i < before.mesh.shells.size(); ++i) {
    const auto& n = before.mesh.shells.nodes[i];
    EXPECT_GT(normal(n, before.mesh.nodes.x).dot(normal(n, after.mesh.nodes.x)), 0) << "seed " << seed;
    if (contact::segment_quality(n, before.mesh.nodes.x).fault == contact::SegmentFault::none) {
      EXPECT_EQ(contact::segment_quality(n, after.mesh.nodes.x).fault, contact::SegmentFault::none) << "seed " << seed;
    }
  }
  for (std::size_t i = 0; i < before.mesh.solids.size(); ++i) {
    const auto& n = before.mesh.solids.nodes[i];
    if (contact::solid_quality(n, before.mesh.nodes.x).worst_corner > 0) {
      EXPECT_GT(contact::solid_quality(n, after.mesh.nodes.x).worst_corner, 0) << "seed " << seed;
    }
  }
}

TEST(FixRandomScene, NeverWorseAndNothingInverted) {
  std::uint64_t before = 0, after = 0, complete_scenes = 0;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    const std::string text = random_scene(seed).text();
    const FixRun run = fix_text(text);
    ASSERT_EQ(run.errors, 0u) << "seed " << seed;
    EXPECT_LE(found(run.report(), true), found(run.report(), false)) << "seed " << seed;
    EXPECT_LE(run.report().crossings_after, run.report().crossings_before) << "seed " << seed;
    const model::Model old = model_of(text), now = model_of(run.text);
    expect_upright(old, now, seed);
    // What the report says of the written deck is what another reading of it finds.
    EXPECT_EQ(found(fix_text(run.text).report(), false), found(run.report(), true)) << "seed " << seed;
    for (const MovedNode& m : run.report().moved)
      EXPECT_EQ(now.mesh.nodes.x[*now.mesh.nodes.lookup.find(m.node)], m.to) << "seed " << seed;
    before += found(run.report(), false);
    after += found(run.report(), true);
    complete_scenes += complete(run.report()) ? 1 : 0;
  }
  RecordProperty("before", std::to_string(before));
  RecordProperty("after", std::to_string(after));
  RecordProperty("free_scenes", std::to_string(complete_scenes));
  // Many of these bodies run deep into each other: no small movement parts them.
  EXPECT_LT(2 * after, before);
}

TEST(FixRandomScene, JoinedNodesMoveAlike) {
  std::uint64_t moved = 0, followers = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Scene scene = random_scene(seed);
    // Every fifth node is welded to one somewhere else.
    std::vector<std::pair<std::int64_t, std::int64_t>> welds;
    std::string text = scene.text(), cards = "*CONSTRAINED_SPOTWELD\n";
    for (std::size_t i = 0; i < scene.nodes.size(); i += 5) {
      const auto& a = scene.nodes[i];
      const auto& b = scene.nodes[(7 * i + 13 * seed) % scene.nodes.size()];
      if (a.id == b.id) continue;
      welds.emplace_back(a.id, b.id);
      cards += fmt::format("{:10}{:10}\n", a.id, b.id);
    }
    text.insert(text.find("*END"), cards);
    const FixRun run = fix_text(text);
    ASSERT_EQ(run.errors, 0u) << "seed " << seed;
    EXPECT_LE(found(run.report(), true), found(run.report(), false)) << "seed " << seed;
    expect_upright(model_of(text), model_of(run.text), seed);
    for (const auto& [a, b] : welds) {
      EXPECT_LT((run.move(a) - run.move(b)).norm(), 1e-9) << "seed " << seed << ", nodes " << a << " and " << b;
      followers += run.moved(a) != nullptr ? 1 : 0;
    }
    moved += run.report().moved.size();
  }
  EXPECT_GT(followers, 10u);
  EXPECT_GT(moved, followers);
}

}  // namespace
}  // namespace gapcheck::audit_test::random_scene_test
