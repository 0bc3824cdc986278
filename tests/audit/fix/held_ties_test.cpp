#include "audit/fix/held_ties.hpp"

#include "audit/fix/plates.hpp"
#include "audit/fix/run_fix.hpp"

namespace gapcheck::audit_test::held_ties_test {
namespace {

audit::HeldTie tie(std::uint32_t node, std::uint32_t corner) {
  audit::HeldTie t;
  t.node = NodeIndex{node};
  t.corners.fill(NodeIndex{corner});
  return t;
}

TEST(HeldTies, FollowsChains) {
  std::vector<std::uint8_t> moving(10);
  moving[0] = 1;
  const auto ties = audit::ties_of({tie(3, 2), tie(2, 1), tie(1, 0), tie(8, 7)}, moving);
  EXPECT_EQ(ties.size(), 3u);
  EXPECT_EQ(moving[3], 1);
  EXPECT_EQ(moving[7], 0);
}

/// A plate tied to another one; `keyword` with the offset or without.
std::string tied(const std::string& keyword, double z, const std::string& more = "") {
  const Plate lower{.id = 1}, upper{.id = 2, .z = z, .x = 2, .y = 2, .nx = 1, .ny = 1};
  return "*KEYWORD\n" + elastic_steel + lower.deck() + upper.deck() + more + "*CONTACT_" + keyword +
         "_ID\n         1\n         2         1         3         3\n\n\n*END\n";
}

TEST(HeldTies, NodesGoOntoTheirSegments) {
  const FixRun run = fix_text(tied("TIED_NODES_TO_SURFACE", 0.7));
  EXPECT_EQ(run.report().separated_ties_before, 4u);
  EXPECT_EQ(run.report().separated_ties_after, 0u);
  EXPECT_EQ(run.report().moved.size(), 4u);
  for (const MovedNode& m : run.report().moved) {
    EXPECT_NEAR(m.to.z(), 0, 1e-12);
    EXPECT_TRUE(m.onto_tie);
  }
  EXPECT_TRUE(fix_text(run.text).report().moved.empty());
}

TEST(HeldTies, OffsetFormsKeepTheirOffset) {
  EXPECT_TRUE(fix_text(tied("TIED_NODES_TO_SURFACE_OFFSET", 0.7)).report().moved.empty());
}

TEST(HeldTies, TiedNodesGoWithTheirSegments) {
  const Plate lower{.id = 1}, upper{.id = 2, .z = 0.6, .x = 1, .y = 1},
      patch{.id = 3, .z = -0.8, .x = 2, .y = 2, .nx = 1, .ny = 1};
  const std::string deck =
      "*KEYWORD\n" + elastic_steel + lower.deck() + upper.deck() + patch.deck() +
      "*CONTACT_TIED_NODES_TO_SURFACE_OFFSET_ID\n         1\n         3         1         3         3\n\n\n"
      "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n         2\n         1         2         3         3\n\n\n*END\n";
  const FixRun run = fix_text(deck);
  EXPECT_TRUE(complete(run.report()));
  // The patch is tied to the lower plate, which goes down.
  EXPECT_LT(run.move(patch.node(0, 0)).z(), -0.1);
  // Each of its nodes goes as the point above it on the lower plate, by the shape functions of the shell there.
  for (int j = 0; j <= 1; ++j)
    for (int i = 0; i <= 1; ++i) {
      Vector with = Vector::Zero();
      for (int b = 0; b <= 1; ++b)
        for (int a = 0; a <= 1; ++a)
          with += (a == 0 ? 0.6 : 0.4) * (b == 0 ? 0.6 : 0.4) * run.move(lower.node(i + a, j + b));
      EXPECT_LT((run.move(patch.node(i, j)) - with).norm(), 1e-6) << i << " " << j;
    }
  EXPECT_EQ(run.report().contacts[1].after.penetrations, 0u);
}

}  // namespace
}  // namespace gapcheck::audit_test::held_ties_test
