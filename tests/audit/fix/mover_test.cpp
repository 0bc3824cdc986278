#include "audit/fix/mover.hpp"

#include <algorithm>
#include <string>

#include "audit/fix/plates.hpp"
#include "audit/fix/run_fix.hpp"
#include "contact/surface/segment_quality.hpp"

namespace gapcheck::audit_test::mover_test {
namespace {

TEST(Mover, ANodeBetweenTwoLockedPlatesIsReported) {
  const Plate lower{.id = 1}, upper{.id = 2, .z = 1.2}, between{.id = 3, .z = 0.6, .x = 2, .y = 2, .nx = 1, .ny = 1};
  audit::FixOptions options;
  options.locks = {{false, 1, 2}};
  const FixRun run = fix_text(plates_deck(lower, upper, between), options);
  EXPECT_FALSE(complete(run.report()));
  EXPECT_LE(run.report().rounds, 40u);
  ASSERT_FALSE(run.report().unfixed.empty());
  for (const UnfixedNode& node : run.report().unfixed) {
    const bool own = between.id == node.node / 1000;
    EXPECT_EQ(node.reason, own ? HoldReason::conflict : HoldReason::locked) << node.node << " " << name(node.reason);
  }
  std::uint64_t after = 0, before = 0;
  for (const FixContact& c : run.report().contacts) {
    before += c.before.penetrations + c.before.released;
    after += c.after.penetrations + c.after.released;
  }
  EXPECT_LE(after, before);
}

TEST(Mover, UnlockedPlatesMakeRoom) {
  const Plate lower{.id = 1}, upper{.id = 2, .z = 1.2}, between{.id = 3, .z = 0.6, .x = 2, .y = 2, .nx = 1, .ny = 1};
  const FixRun run = fix_text(plates_deck(lower, upper, between));
  EXPECT_TRUE(complete(run.report()));
  EXPECT_LT(run.move(lower.node(1, 1)).z(), 0);
  EXPECT_GT(run.move(upper.node(1, 1)).z(), 0);
}

TEST(Mover, EverythingLockedStays) {
  audit::FixOptions options;
  options.locks = {{true, 1, 999999}};
  const FixRun run = fix_text(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7}), options);
  EXPECT_TRUE(run.report().moved.empty());
  ASSERT_EQ(run.report().unfixed.size(), 32u);
  EXPECT_EQ(run.report().unfixed[0].reason, HoldReason::locked);
}

TEST(Mover, ShapeGoesBeforeFreedom) {
  // The nodes of a small plate can only be freed by warping the shells below them.
  const auto largest_warp = [](const FixRun& run) {
    Diagnostics diagnostics;
    const auto deck = keyword::read_deck_text(run.text, "deck.k", {}, diagnostics);
    const auto model = model::read_model(deck.value(), diagnostics);
    double largest = 0;
    for (const auto& n : model.value().mesh.shells.nodes)
      largest = std::max(largest, contact::warp_degrees(contact::segment_quality(n, model.value().mesh.nodes.x)));
    return largest;
  };
  const std::string text = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.5, .x = 1.7, .y = 2.3, .nx = 1, .ny = 1});
  audit::FixOptions options;
  const FixRun free = fix_text(text, options);
  EXPECT_TRUE(complete(free.report()));
  EXPECT_GT(largest_warp(free), 0.5);
  options.limits.warp = 0.5;
  const FixRun run = fix_text(text, options);
  EXPECT_LE(largest_warp(run), 0.5 + 1e-6);
  for (const UnfixedNode& node : run.report().unfixed) EXPECT_EQ(node.reason, HoldReason::shape);
}

}  // namespace
}  // namespace gapcheck::audit_test::mover_test
