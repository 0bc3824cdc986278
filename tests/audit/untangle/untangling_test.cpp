#include "audit/untangle/untangling.hpp"

#include "audit/untangle/surfaces.hpp"

namespace gapcheck::audit_test::untangling_test {
namespace {

const Plate ground{.id = 1, .thickness = 2, .nx = 8, .ny = 6};

audit::Untangling untangle(ContactScene& scene, const std::set<audit::ElementPair>& left_alone = {}) {
  std::uint64_t work = 1'000'000;
  const auto& x = scene.model->mesh.nodes.x;
  const auto crossings = audit::contact_crossings(*scene.model, *scene.store, x);
  return {*scene.model, *scene.store, x, crossings, left_alone, work};
}

TEST(Untangling, SidesWithTheContactDistance) {
  // Nodes of the upright plate at z = -2 and 3; both plates have the ground's section, 2 thick.
  ContactScene scene(upright_deck(ground, 17.0, 6.0, -2.0, 3, 2));
  const audit::Untangling untangling = untangle(scene);
  ASSERT_EQ(untangling.places().size(), 1u);
  EXPECT_TRUE(untangling.places()[0].divided);
  EXPECT_EQ(untangling.places()[0].too_deep, 0);
  EXPECT_EQ(scene.ids(untangling.places()[0].nodes), (std::vector<std::int64_t>{2001, 2002, 2003, 2004}));
  // The upper row is 3 above and far enough away.
  ASSERT_EQ(untangling.sides().size(), 4u);
  for (const audit::KnownSide& known : untangling.sides()) {
    EXPECT_EQ(known.side, 1);
    EXPECT_EQ(known.distance, 2);
    EXPECT_DOUBLE_EQ(known.depth, 4);
  }
}

TEST(Untangling, NodesAtTheCrossing) {
  ContactScene scene(upright_deck(ground, 17.0, 6.0, -2.0, 3, 2));
  const audit::Untangling untangling = untangle(scene);
  const auto corners = [&](std::int64_t id) { return scene.model->mesh.shells.nodes[scene.shell(id).second]; };
  EXPECT_TRUE(untangling.at_crossing(scene.node(2001), corners(1012)));
  EXPECT_TRUE(untangling.at_crossing(scene.node(ground.node(3, 2)), corners(2001)));
  EXPECT_FALSE(untangling.at_crossing(scene.node(2009), corners(1012)));  // the upper edge
  EXPECT_FALSE(untangling.at_crossing(scene.node(2001), corners(1001)));  // a far corner of the ground
  EXPECT_FALSE(untangling.at_crossing(scene.node(2001), corners(2001)));
}

TEST(Untangling, TooDeepIsLeftAlone) {
  // From z = -61 to 59: more than three diagonals of 5 x 5 to either side.
  ContactScene scene(upright_deck(ground, 17.0, 6.0, -61.0, 3, 24));
  const audit::Untangling untangling = untangle(scene);
  ASSERT_EQ(untangling.places().size(), 1u);
  EXPECT_TRUE(untangling.places()[0].divided);
  EXPECT_DOUBLE_EQ(untangling.places()[0].too_deep, 59);
  EXPECT_TRUE(untangling.sides().empty());
}

TEST(Untangling, LeftAlone) {
  ContactScene scene(upright_deck(ground, 17.0, 6.0, -2.0, 3, 2));
  const auto crossings = scene.crossings();
  const audit::Untangling untangling = untangle(scene, {crossings.back()});
  ASSERT_EQ(untangling.places().size(), 1u);
  EXPECT_FALSE(untangling.places()[0].divided);
  EXPECT_TRUE(untangling.sides().empty());
}

}  // namespace
}  // namespace gapcheck::audit_test::untangling_test
