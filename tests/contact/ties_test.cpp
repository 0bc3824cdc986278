#include "contact/ties.hpp"

#include <gtest/gtest.h>

#include <random>

#include "scene.hpp"

namespace gapcheck::contact {
namespace {

TEST(Ties, DistanceByTheFormulas) {
  EXPECT_DOUBLE_EQ(tie_distance(1, 2, 10, false, false), 0.6 * 3);
  EXPECT_DOUBLE_EQ(tie_distance(1, 2, 100, false, false), 5);
  EXPECT_DOUBLE_EQ(tie_distance(1, 2, 10, true, false), 0.5);
  EXPECT_DOUBLE_EQ(tie_distance(1, 2, 100, true, true), 0.6 * 3);
}

/// A plate of four 10 × 10 shells, thickness 1, and free nodes.
Scene plate_and_nodes(const std::vector<Vector>& at, const std::string& type) {
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 2, 2);
  for (const Vector& x : at) scene.model.sets.nodes[5].members.push_back(scene.node(x));
  auto& c = scene.contact(type);
  c.a = {5, 4, 0, true};
  c.b = {1, 3, 0, true};
  return scene;
}

TEST(Ties, NodesWithinTheDistanceTieAndMove) {
  // max(0.6 · (0 + 1), 0.05 · 14.142) = 0.7071: the third node is too far, the fourth beside the plate.
  const std::vector<Vector> at{{3, 4, 0.5}, {13, 4, -0.7}, {3, 14, 0.72}, {25, 5, 0}};
  Scene scene = plate_and_nodes(at, "TIED_NODES_TO_SURFACE");
  const InitialState state = scene.run();
  EXPECT_EQ(state.contacts[0].ties, 2U);
  EXPECT_EQ(state.x[9], Vector(3, 4, 0));
  EXPECT_EQ(state.x[10], Vector(13, 4, 0));
  EXPECT_EQ(state.x[11], at[2]);
  Scene offset = plate_and_nodes(at, "TIED_NODES_TO_SURFACE_OFFSET");
  const InitialState kept = offset.run();
  EXPECT_EQ(kept.contacts[0].ties, 2U);
  EXPECT_EQ(kept.x[9], at[0]);
}

TEST(Ties, NegativeThicknessReplacesBothDistances) {
  Scene scene = plate_and_nodes({{3, 4, 0.5}, {13, 4, -0.7}}, "TIED_NODES_TO_SURFACE_OFFSET");
  scene.model.contacts[0].sst = -0.1;
  scene.model.contacts[0].mst = -0.9;
  EXPECT_EQ(scene.run().contacts[0].ties, 1U);  // 0.6 · (0 + 0.9) = 0.54: a node without shells has no thickness
}

TEST(Ties, FirstContactInTheDeckKeepsTheNode) {
  Scene scene = plate_and_nodes({{3, 4, 0.5}}, "TIED_NODES_TO_SURFACE_OFFSET");
  const model::Contact first = scene.model.contacts[0];
  auto& second = scene.contact("TIED_NODES_TO_SURFACE_OFFSET");
  second.a = first.a;
  second.b = first.b;
  InitialState state = scene.run();
  EXPECT_EQ(state.contacts[0].ties, 1U);
  EXPECT_EQ(state.contacts[1].ties, 1U);  // penalty forms do not exclude each other
  for (auto& c : scene.model.contacts) c.keyword = "CONTACT_TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET";
  state = scene.run();
  EXPECT_EQ(state.contacts[0].ties, 1U);
  EXPECT_EQ(state.contacts[1].ties, 0U);
  ASSERT_EQ(state.untied.size(), 1U);
  EXPECT_EQ(state.untied[0].contact, 1U);
  EXPECT_EQ(state.untied[0].reason, TieReason::conflict);
}

TEST(Ties, EachReasonIsTold) {
  // Far above a segment, beside the plate, rigid node, over a rigid part.
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 1, 1);
  scene.plate(scene.part(2, 1), {30, 0, 0}, {10, 0, 0}, {0, 10, 0}, 1, 1);
  model::Material rigid;
  rigid.rigid = true;
  scene.model.materials.push_back(rigid);
  scene.model.parts[1].material = 0;
  auto& members = scene.model.sets.nodes[5].members;
  for (const Vector& x : {Vector(5, 5, 3), Vector(5, 18, 0), Vector(4, 4, 0.1), Vector(35, 5, 0.1), Vector(6, 6, 0.1)})
    members.push_back(scene.node(x));
  model::RigidGroup group;
  group.kind = model::RigidGroup::Kind::nodal_rigid_body;
  group.nodes = {members[2]};
  scene.model.rigid_groups.push_back(group);
  auto& c = scene.contact("TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET");
  c.a = {5, 4, 0, true};
  c.b = {0, 5, 0, true};
  InitialState state = scene.run();
  EXPECT_EQ(state.contacts[0].ties, 1U);
  std::vector<TieReason> reasons;
  for (const TieFailure& failure : state.untied) reasons.push_back(failure.reason);
  EXPECT_EQ(reasons, (std::vector{TieReason::too_far, TieReason::not_found, TieReason::rigslav, TieReason::rigmast}));
  EXPECT_DOUBLE_EQ(state.untied[0].distance, 3);
  EXPECT_TRUE(state.untied[0].by_node_set);
  // The penalty form takes rigid bodies.
  scene.model.contacts[0].keyword = "CONTACT_TIED_NODES_TO_SURFACE_OFFSET";
  EXPECT_EQ(scene.run().contacts[0].ties, 3U);
}

TEST(Ties, OfPartsOnlyNodesNearTheSurfaceAreJudged) {
  // A plate 0.9 above another (allowed 1.2, they tie), one 2 above (within twice the distance), one 5 above (not meant).
  for (const auto& [gap, ties, untied] : {std::tuple(0.9, 4U, 0U), std::tuple(2.0, 0U, 4U), std::tuple(5.0, 0U, 0U)}) {
    Scene scene;
    scene.plate(scene.part(1, 1), {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 3, 3);
    scene.plate(scene.part(2, 1), {5, 5, gap}, {10, 0, 0}, {0, 10, 0}, 1, 1);
    auto& c = scene.contact("TIED_SURFACE_TO_SURFACE_OFFSET");
    c.a = {2, 3, 0, true};
    c.b = {1, 3, 0, true};
    const InitialState state = scene.run();
    EXPECT_EQ(state.contacts[0].ties, ties);
    EXPECT_EQ(state.untied.size(), untied);
    for (const TieFailure& failure : state.untied) EXPECT_FALSE(failure.by_node_set);
  }
}

TEST(Ties, AgreeWithTheFormulaOnRandomNodesOverAFlatPlate) {
  // On a flat plate of unit-thickness shells the distance is |z| and the projection lies inside.
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> inside(0.1, 19.9), height(-1.5, 1.5);
  std::vector<Vector> at;
  std::size_t expected = 0;
  const double limit = tie_distance(0, 1, std::sqrt(200.0), false, false);
  for (int i = 0; i < 500; ++i) {
    at.emplace_back(inside(random), inside(random), height(random));
    expected += std::abs(at.back().z()) <= limit ? 1 : 0;
  }
  EXPECT_EQ(plate_and_nodes(at, "TIED_NODES_TO_SURFACE_OFFSET").run().contacts[0].ties, expected);
}

}  // namespace
}  // namespace gapcheck::contact
