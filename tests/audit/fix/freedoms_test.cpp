#include "audit/fix/freedoms.hpp"

#include <ctime>

#include "audit/fix/plates.hpp"
#include "audit/fix/run_fix.hpp"
#include "model/read/links.hpp"

namespace gapcheck::audit_test::freedoms_test {
namespace {

model::Model read(const std::string& more) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(
      "*KEYWORD\n" + elastic_steel + Plate{.id = 1}.deck() + Plate{.id = 2, .z = 5}.deck() + more + "*END\n", "deck.k",
      {}, diagnostics);
  auto model = model::read_model(deck.value(), diagnostics);
  EXPECT_TRUE(model.ok() && !diagnostics.has_errors());
  return std::move(model).value();
}

TEST(Freedoms, WeightsAreAreas) {
  const audit::Freedoms f = audit::find_freedoms(read(""), {}, {{2, 4.0}});
  EXPECT_NEAR(f.mobility[0].x(), 4.0 / 25, 1e-12);  // a corner
  EXPECT_NEAR(f.mobility[1].y(), 2.0 / 25, 1e-12);  // an edge
  EXPECT_NEAR(f.mobility[5].z(), 1.0 / 25, 1e-12);
  EXPECT_NEAR(f.mobility[16 + 5].z(), 0.25 / 25, 1e-12);
}

TEST(Freedoms, LocksHold) {
  const audit::Freedoms f = audit::find_freedoms(read(""), {{false, 2, 7}, {true, 1002, 1003}, {false, 99, 99}}, {});
  for (std::uint32_t i = 0; i < 32; ++i) EXPECT_EQ(f.held(NodeIndex{i}), i == 1 || i == 2 || i >= 16) << i;
  EXPECT_EQ(f.reason[1], HoldReason::locked);
}

TEST(Freedoms, BoundariesHoldTheirDirections) {
  const audit::Freedoms f =
      audit::find_freedoms(read("*BOUNDARY_SPC_NODE\n      1001         0         0         1         0         1\n"
                                "      1002         0         0         0         0         1\n"),
                           {}, {});
  EXPECT_EQ(f.mobility[0].y(), 0);
  EXPECT_GT(f.mobility[0].x(), 0);
  EXPECT_FALSE(f.held(NodeIndex{0}));
  EXPECT_EQ(f.reason[0], HoldReason::constrained);
  EXPECT_EQ(f.reason[1], HoldReason::none);
}

TEST(Freedoms, RigidBodiesAreHeld) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(
      "*KEYWORD\n*MAT_RIGID\n         1   7.85e-9  210000.       0.3\n" + Plate{.id = 1}.deck() + "*END\n", "deck.k",
      {}, diagnostics);
  const auto model = model::read_model(deck.value(), diagnostics);
  const audit::Freedoms f = audit::find_freedoms(model.value(), {}, {});
  for (std::uint32_t i = 0; i < 16; ++i) EXPECT_TRUE(f.held(NodeIndex{i}));
  EXPECT_EQ(f.reason[3], HoldReason::rigid);
}

// The work grows with the model, not with the square of a node set: here 3e10 steps.
TEST(Freedoms, ALargeNodeSetIsHeldOnce) {
  constexpr int n = 300;
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text("*KEYWORD\n" + elastic_steel + Plate{.id = 1, .nx = n, .ny = n}.deck() +
                                                "*SET_NODE_LIST_GENERATE\n         1\n         1  99999999\n"
                                                "*CONSTRAINED_NODE_SET\n         1         1\n*END\n",
                                            "deck.k", {}, diagnostics);
  const auto model = model::read_model(deck.value(), diagnostics);
  ASSERT_TRUE(model.ok() && !diagnostics.has_errors());
  const model::Links links = model::read_links(deck.value(), model.value(), diagnostics);
  const std::clock_t start = std::clock();
  const audit::Freedoms f = audit::find_freedoms(model.value(), {{false, 1, 1}}, {}, {}, {model.value(), links.joined});
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 10);
  for (std::uint32_t i = 0; i < (n + 1) * (n + 1); ++i) {
    ASSERT_TRUE(f.held(NodeIndex{i}));
    ASSERT_EQ(f.reason[i], HoldReason::locked);
  }
}

}  // namespace
}  // namespace gapcheck::audit_test::freedoms_test
