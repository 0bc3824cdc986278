#include "contact/tie/ties.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "contact/scene.hpp"

namespace gapcheck::contact::ties_test {
namespace {

TEST(Ties, DistanceByTheFormulas) {
  EXPECT_DOUBLE_EQ(tie_distance(1, 2, 10, false, false), 0.6 * 3);
  EXPECT_DOUBLE_EQ(tie_distance(1, 2, 100, false, false), 5);
  EXPECT_DOUBLE_EQ(tie_distance(1, 2, 10, true, false), 0.5);
  EXPECT_DOUBLE_EQ(tie_distance(1, 2, 100, true, true), 0.6 * 3);
}

std::vector<JudgedNode> untied_nodes(const InitialState& state) {
  std::vector<JudgedNode> list;
  for (const JudgedNode& node : state.judged)
    if (!node.tied()) list.push_back(node);
  return list;
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
  for (auto& c : scene.model.contacts) set_name("CONTACT_TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET", c);
  state = scene.run();
  EXPECT_EQ(state.contacts[0].ties, 1U);
  EXPECT_EQ(state.contacts[1].ties, 0U);
  const auto untied = untied_nodes(state);
  ASSERT_EQ(untied.size(), 1U);
  EXPECT_EQ(untied[0].contact, ContactIndex{1});
  EXPECT_EQ(untied[0].reason, TieReason::conflict);
  EXPECT_EQ(untied[0].holder, ContactIndex{0});
  // The penalty copy of IPBACK takes it.
  scene.model.contacts[1].ipback = 1;
  EXPECT_EQ(scene.run().contacts[1].ties, 1U);
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
  const auto untied = untied_nodes(state);
  std::vector<TieReason> reasons;
  for (const JudgedNode& node : untied) reasons.push_back(*node.reason);
  EXPECT_EQ(reasons, (std::vector{TieReason::too_far, TieReason::not_found, TieReason::rigslav, TieReason::rigmast}));
  EXPECT_DOUBLE_EQ(untied[0].distance, 3);
  EXPECT_TRUE(untied[0].by_node_set);
  EXPECT_EQ(untied[2].rigid.kind, RigidOwner::Kind::group);
  EXPECT_EQ(untied[3].rigid.kind, RigidOwner::Kind::part);
  EXPECT_EQ(untied[3].rigid.index, 1U);
  // The penalty form takes rigid bodies.
  set_name("CONTACT_TIED_NODES_TO_SURFACE_OFFSET", scene.model.contacts[0]);
  EXPECT_EQ(scene.run().contacts[0].ties, 3U);
}

// Beside the edge of a near plate and right over a far one: the segment that the node is on says why it does not tie.
TEST(Ties, ASegmentUnderTheNodeSaysMoreThanANearerOneBesideIt) {
  for (const bool far_first : {false, true}) {
    Scene scene;
    const PartIndex part = scene.part(1, 1);
    const Vector near_corner(0, 0, 0), far_corner(10.5, 0, -2);
    scene.plate(part, far_first ? far_corner : near_corner, {10, 0, 0}, {0, 10, 0}, 1, 1);
    scene.plate(part, far_first ? near_corner : far_corner, {10, 0, 0}, {0, 10, 0}, 1, 1);
    scene.model.sets.nodes[5].members = {scene.node({11, 5, 0})};
    auto& c = scene.contact("TIED_NODES_TO_SURFACE_OFFSET");
    c.a = {5, 4, 0, true};
    c.b = {1, 3, 0, true};
    const InitialState state = scene.run();
    ASSERT_EQ(state.judged.size(), 1U);
    EXPECT_EQ(state.judged[0].reason, TieReason::too_far);
    EXPECT_EQ(state.judged[0].segment, (SegmentIndex{far_first ? 0U : 1U}));
    EXPECT_DOUBLE_EQ(state.judged[0].distance, 2);
  }
}

TEST(Ties, OfPartsOnlyNodesNearTheSurfaceAreJudged) {
  // A plate 0.9 above another (allowed 1.2, they tie), one 2 above (within twice the distance), one 5 above (not
  // meant).
  for (const auto& [gap, ties, untied] : {std::tuple(0.9, 4U, 0U), std::tuple(2.0, 0U, 4U), std::tuple(5.0, 0U, 0U)}) {
    Scene scene;
    scene.plate(scene.part(1, 1), {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 3, 3);
    scene.plate(scene.part(2, 1), {5, 5, gap}, {10, 0, 0}, {0, 10, 0}, 1, 1);
    auto& c = scene.contact("TIED_SURFACE_TO_SURFACE_OFFSET");
    c.a = {2, 3, 0, true};
    c.b = {1, 3, 0, true};
    const InitialState state = scene.run();
    EXPECT_EQ(state.contacts[0].ties, ties);
    EXPECT_EQ(untied_nodes(state).size(), untied);
    for (const JudgedNode& node : state.judged) EXPECT_FALSE(node.by_node_set);
    EXPECT_EQ(state.contacts[0].out_of_reach, 4 - ties - untied);
  }
}

TEST(Ties, AgreeWithTheFormulaOnRandomNodesOverAFlatPlate) {
  // On a flat plate of unit-thickness shells the distance is |z| and the projection lies inside.
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> inside(0.1, 19.9), height(-1.5, 1.5);
  std::vector<Vector> at;
  std::size_t expected = 0;
  const double limit = std::max(0.6 * (0 + 1), 0.05 * std::sqrt(200.0));
  for (int i = 0; i < 500; ++i) {
    at.emplace_back(inside(random), inside(random), height(random));
    expected += std::abs(at.back().z()) <= limit ? 1 : 0;
  }
  EXPECT_EQ(plate_and_nodes(at, "TIED_NODES_TO_SURFACE_OFFSET").run().contacts[0].ties, expected);
}

/// The one node judged by a contact of this type, `height` above the plate of 10 × 10 shells of thickness 1.
std::optional<TieReason> reason_at(double height, const std::string& type, std::int64_t tiedprj = 0) {
  Scene scene = plate_and_nodes({{3, 4, height}}, type);
  scene.model.controls.tiedprj = tiedprj;
  const InitialState state = scene.run();
  EXPECT_EQ(state.judged.size(), 1U);
  EXPECT_EQ(state.contacts[0].ties, 1U);
  return state.judged.at(0).reason;
}

TEST(Ties, SeparationsAreToldWhereTheyAreClosedOrLost) {
  for (const char* type :
       {"TIED_SURFACE_TO_SURFACE", "TIED_NODES_TO_SURFACE", "TIED_SHELL_EDGE_TO_SURFACE", "SPOTWELD"}) {
    EXPECT_EQ(reason_at(0.15, type), TieReason::sep);
    EXPECT_EQ(reason_at(0.15, type, 1), TieReason::offset);
    EXPECT_EQ(reason_at(0.14, type), std::nullopt);  // 0.01 · 14.142
  }
  EXPECT_EQ(reason_at(0.15, "TIED_SHELL_EDGE_TO_SURFACE_OFFSET"), TieReason::offset);
  EXPECT_EQ(reason_at(0.14, "TIED_SHELL_EDGE_TO_SURFACE_OFFSET"), std::nullopt);
  for (const char* type : {"TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET",
                           "TIEBREAK_NODES_TO_SURFACE", "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK"})
    EXPECT_EQ(reason_at(0.6, type), std::nullopt) << type;
}

TEST(Ties, TiebreaksOfAutomaticTypesTieBeforeAnythingElse) {
  for (const char* type : {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK",
                           "AUTOMATIC_NODES_TO_SURFACE_TIEBREAK", "TIEBREAK_SURFACE_TO_SURFACE"}) {
    Scene scene;
    scene.plate(scene.part(1, 1), {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 3, 3);
    scene.plate(scene.part(2, 1), {5, 5, 1}, {10, 0, 0}, {0, 10, 0}, 1, 1);
    auto& c = scene.contact(type);
    c.a = {2, 3, 0, true};
    c.b = {1, 3, 0, true};
    const InitialState state = scene.run();
    EXPECT_EQ(state.contacts[0].ties, 4U) << type;
    EXPECT_EQ(state.contacts[0].not_checked, "");
    EXPECT_TRUE(state.contacts[0].ties_judged);
    EXPECT_EQ(state.x, scene.model.mesh.nodes.x);
  }
}

TEST(Ties, ASingleSurfaceTiebreakTiesOnlyOverItsRing) {
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 6, 6);
  scene.plate(scene.part(2, 1), {2.5, 2.5, 1.1}, {1, 0, 0}, {0, 1, 0}, 1, 1);
  auto& c = scene.contact("AUTOMATIC_SINGLE_SURFACE_TIEBREAK");
  c.a = {0, 5, 0, true};
  const InitialState state = scene.run();
  // The four nodes of the small plate, and the one node of the large plate below it: elements of the same plate are
  // nearer than 1.2 as well, but no projection falls on them.
  EXPECT_EQ(state.contacts[0].ties, 5U);
  EXPECT_EQ(state.contacts[0].untied, 0U);
}

TEST(Ties, NodesOfTheReferenceSurfaceAreJoinedAlready) {
  Scene scene = plate_and_nodes({}, "TIED_NODES_TO_SURFACE");
  scene.model.sets.nodes[5].members = {NodeIndex{0}, NodeIndex{4}};
  const InitialState state = scene.run();
  EXPECT_TRUE(state.judged.empty());
  EXPECT_EQ(state.contacts[0].out_of_reach, 0U);
}

/// A beam from (5, 5, low) to (5, 5, high) over one 100 × 100 shell, d2 = 7.07, both ends in the node set.
InitialState beam_over_plate(double low, double high) {
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, {100, 0, 0}, {0, 100, 0}, 1, 1);
  const NodeIndex a = scene.node({5, 5, low}), b = scene.node({5, 5, high});
  auto& beams = scene.model.mesh.beams;
  beams.id = {1};
  beams.nodes = {{a, b}};
  beams.part = {none<PartIndex>};
  beams.line = {0};
  scene.model.sets.nodes[5].members = {a, b};
  auto& c = scene.contact("SPOTWELD");
  c.a = {5, 4, 0, true};
  c.b = {1, 3, 0, true};
  return scene.run();
}

TEST(Ties, ABeamIsNotShortened) {
  // Both ends would come to lie on the plate: the one that moves farther stays.
  const InitialState both = beam_over_plate(2, 5);
  EXPECT_EQ(both.contacts[0].ties, 1U);
  ASSERT_EQ(both.judged.size(), 2U);
  EXPECT_EQ(both.judged[0].reason, TieReason::sep);
  EXPECT_EQ(both.judged[1].reason, TieReason::too_short);
  EXPECT_LT((both.x[4] - Vector(5, 5, 0)).norm(), 1e-12);
  EXPECT_EQ(both.x[5], Vector(5, 5, 5));
  EXPECT_EQ(beam_over_plate(3, 1).judged[0].reason, TieReason::too_short);
  // One end on either side: the plate is in the middle of the beam, and tying both would make it a point.
  EXPECT_EQ(beam_over_plate(-1, 1).contacts[0].ties, 1U);
  // The far end does not tie, and the beam grows.
  EXPECT_EQ(beam_over_plate(5, 30).contacts[0].ties, 1U);
  // Nor does the far end here, below the plate, and 8 of 15 are left.
  EXPECT_EQ(beam_over_plate(7, -8).contacts[0].ties, 1U);
}

TEST(Ties, HostileNumbersHurtNobodyElse) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Scene scene = plate_and_nodes({{nan, 4, 0}, {1e300, 4, 0}, {3, 4, 0.5}, {-1e308, nan, 1e308}}, "SPOTWELD");
  for (const double odd : {1e300, nan, -1e300}) {
    scene.model.contacts[0].parmax = scene.model.contacts[0].maxpar = odd;
    const InitialState state = scene.run();
    EXPECT_EQ(state.contacts[0].ties, 1U);
    EXPECT_EQ(state.judged.size(), 4U);
  }
  scene.model.contacts[0].sst = scene.model.contacts[0].mst = -1e300;
  EXPECT_EQ(scene.run().judged.size(), 4U);
  scene.model.sections[0].thickness.fill(nan);
  EXPECT_EQ(scene.run().judged.size(), 4U);
}

}  // namespace
}  // namespace gapcheck::contact::ties_test
