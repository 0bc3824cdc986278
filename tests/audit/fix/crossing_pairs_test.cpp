#include "audit/fix/crossing_pairs.hpp"

#include "audit/fix/plates.hpp"
#include "audit/fix/run_fix.hpp"

namespace gapcheck::audit_test::crossing_pairs_test {
namespace {

model::Model model_of(const std::string& text) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(text, "deck.k", {}, diagnostics);
  auto model = model::read_model(deck.value(), diagnostics);
  EXPECT_TRUE(model.ok());
  return std::move(model).value();
}

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

// Both ways out of a plate that has been passed through would move nodes; none of them may make more elements cross.
TEST(CrossingPairs, ACorrectionNeverAddsAny) {
  const Plate lower{.id = 1}, upper{.id = 2, .z = 0.01, .x = 1.3, .y = 0.9};
  std::string text = plates_deck(lower, upper);
  const FixRun run = fix_text(text);
  EXPECT_LE(run.report().crossings_after, run.report().crossings_before);
}

}  // namespace
}  // namespace gapcheck::audit_test::crossing_pairs_test
