#include "audit/untangle/crossing_pairs.hpp"

#include <string>

#include "audit/fix/plates.hpp"
#include "audit/fix/run_fix.hpp"

namespace gapcheck::audit_test::crossing_pairs_test {
namespace {

TEST(CrossingPairs, FindsElementsThatPassThroughEachOther) {
  model::Model model =
      model_of(plates_deck(Plate{.id = 1, .nx = 1, .ny = 1}, Plate{.id = 2, .z = 1, .x = 2, .y = 2, .nx = 1, .ny = 1}));
  EXPECT_TRUE(audit::crossing_pairs(model).empty());
  model.mesh.nodes.x[4].z() = -1;  // the corner of the upper plate over the middle of the lower one
  const auto pairs = audit::crossing_pairs(model);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(audit::nodes_of(model.mesh, pairs.begin()->first).size(), 4u);
  EXPECT_EQ(audit::nodes_of(model.mesh, {model::ElementKind::shell, 99}).size(), 0u);
  EXPECT_EQ(audit::nodes_of(model.mesh, {model::ElementKind::mass, 0}).size(), 0u);
}

// A plate 0.01 above another one, but for a corner that has passed through it: both ways out of the plate would move
// nodes, and none of them may make more elements cross.
TEST(CrossingPairs, ACorrectionNeverAddsAny) {
  const Plate lower{.id = 1}, upper{.id = 2, .z = 0.01, .x = 1.3, .y = 0.9};
  const FixRun flat = fix_text(plates_deck(lower, upper));
  EXPECT_FALSE(flat.report().moved.empty());
  EXPECT_EQ(flat.report().crossings_before, 0u);
  EXPECT_EQ(flat.report().crossings_after, 0u);
  std::string text = plates_deck(lower, upper);
  const std::string corner = fmt::format("{:8}{:16}{:16}", upper.node(0, 0), 1.3, 0.9);
  text.replace(text.find(corner) + corner.size(), 16, fmt::format("{:16}", -0.4));
  const FixRun through = fix_text(text);
  // The shell leaves the plate along a curve over three shells.
  EXPECT_EQ(through.report().crossings_before, 3u);
  EXPECT_LE(through.report().crossings_after, 3u);
}

}  // namespace
}  // namespace gapcheck::audit_test::crossing_pairs_test
