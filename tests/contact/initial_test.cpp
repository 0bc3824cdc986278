#include "contact/initial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "contact/scene.hpp"

namespace gapcheck::contact::initial_test {
namespace {

const Vector ex{1, 0, 0}, ey{0, 1, 0}, ez{0, 0, 1};

/// Two 2 × 2 plates of 10 × 10 elements, thickness 1, `gap` apart.
Scene two_plates(double gap) {
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, 10 * ex, 10 * ey, 2, 2);
  scene.plate(scene.part(2, 1), {3, 4, gap}, 10 * ex, 10 * ey, 2, 2);
  return scene;
}

TEST(Initial, ParallelPlatesPenetrateByThicknessLessGap) {
  Scene scene = two_plates(0.7);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  const InitialState state = scene.run();
  // Upper plate's nodes with x <= 20 and y <= 20 lie over the lower plate: 2 × 2 of 9; the lower plate's likewise.
  ASSERT_EQ(state.contacts[0].penetrations, 8U);
  for (const Penetration& p : state.penetrations) {
    EXPECT_NEAR(p.depth, 0.3, 1e-12);
    EXPECT_DOUBLE_EQ(p.contact_distance, 1);
    EXPECT_EQ(p.outcome, Outcome::moved);
    EXPECT_NEAR(std::abs(p.moved_to.z() - p.original.z()), 1.002 * 0.3, 1e-12);
  }
}

// The list of a deck whose contacts all hold the same mesh is bounded; what is not listed is counted and said.
TEST(Initial, PenetrationsBeyondTheLimitAreCounted) {
  Scene scene = two_plates(0.7);
  for (int i = 0; i < 3; ++i) scene.contact("AUTOMATIC_SINGLE_SURFACE").ignore = 1;
  InitialOptions options;
  options.most_listed = 10;
  const InitialState state = scene.run(options);
  EXPECT_EQ(state.penetrations.size(), 10U);
  EXPECT_EQ(state.contacts[0].reported_penetrations, 0U);
  EXPECT_EQ(state.contacts[1].reported_penetrations, 8U);
  EXPECT_EQ(state.contacts[2].reported_penetrations, 8U);
  ASSERT_EQ(state.notes.size(), 2U);
  EXPECT_EQ(state.notes[0],
            "contact 2: of its 8 penetrations the 2 deepest are listed, since all contacts have more than 10; the "
            "others are counted");
  EXPECT_EQ(scene.run().penetrations.size(), 24U);
}

TEST(Initial, TouchingPlatesDoNotPenetrate) {
  Scene scene = two_plates(1.0);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  EXPECT_TRUE(scene.run().penetrations.empty());
}

TEST(Initial, SideAIsMovedBeforeSideBLooks) {
  // The upper plate lies wholly over the lower one, so all of it moves.
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, 10 * ex, 10 * ey, 4, 4);
  scene.plate(scene.part(2, 1), {8, 8, 0.7}, 10 * ex, 10 * ey, 1, 1);
  auto& c = scene.contact("AUTOMATIC_SURFACE_TO_SURFACE");
  c.a = {2, 3, 0, true};
  c.b = {1, 3, 0, true};
  const InitialState state = scene.run();
  ASSERT_EQ(state.penetrations.size(), 4U);
  for (const Penetration& p : state.penetrations) EXPECT_EQ(p.part, 2);
  // Kept where they are, both sides are listed.
  scene.model.contacts[0].ignore = 1;
  EXPECT_EQ(scene.run().penetrations.size(), 5U);  // one node of the lower plate lies under the upper one
}

TEST(Initial, NodesThatStayAreSeenFromBothSides) {
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, 10 * ex, 10 * ey, 4, 4);
  scene.plate(scene.part(2, 1), {8, 8, 0.7}, 10 * ex, 10 * ey, 1, 1);
  auto& c = scene.contact("AUTOMATIC_SURFACE_TO_SURFACE");
  c.a = {2, 3, 0, true};
  c.b = {1, 3, 0, true};
  InitialOptions options;
  options.nodes_stay = true;
  const InitialState state = scene.run(options);
  EXPECT_EQ(state.penetrations.size(), 5U);
  EXPECT_EQ(state.x, scene.model.mesh.nodes.x);
}

TEST(Initial, SurfacesWithAnotherThickness) {
  Scene scene = two_plates(0.7);
  scene.contact("AUTOMATIC_SINGLE_SURFACE").sst = 0.8;
  const auto found = [&](const ThicknessChange& change) {
    SurfaceStore surfaces(scene.model, {change});
    InitialCounters counters;
    return initialise_contacts(scene.model, surfaces, {}, counters).penetrations;
  };
  EXPECT_NEAR(found({}).at(0).depth, 0.1, 1e-12);
  EXPECT_NEAR(found({.own = true}).at(0).depth, 0.3, 1e-12);
  EXPECT_NEAR(found({.card = 2}).at(0).depth, 1.3, 1e-12);
  EXPECT_TRUE(found({.card = 0.7}).empty());
}

TEST(Initial, LaterContactsSeeMovedCoordinates) {
  Scene scene = two_plates(0.7);
  for (int i = 0; i < 2; ++i) {
    auto& c = scene.contact("AUTOMATIC_NODES_TO_SURFACE");
    c.a = {2, 3, 0, true};
    c.b = {1, 3, 0, true};
  }
  InitialState state = scene.run();
  EXPECT_EQ(state.contacts[0].penetrations, 4U);
  EXPECT_EQ(state.contacts[1].penetrations, 0U);
  scene.model.contacts[0].snlog = 1;
  state = scene.run();
  EXPECT_EQ(state.contacts[1].penetrations, 4U);
  EXPECT_EQ(state.penetrations[0].outcome, Outcome::forced);
}

TEST(Initial, TooDeepIsReleased) {
  Scene scene = two_plates(0.19);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  const InitialState state = scene.run();
  EXPECT_EQ(state.contacts[0].penetrations, 0U);
  EXPECT_EQ(state.contacts[0].released, 8U);
  EXPECT_EQ(state.penetrations[0].moved_to, state.penetrations[0].original);
}

TEST(Initial, BandBeyondTheEdge) {
  // One 10 × 10 segment and a node 2.4 (s = 1.48) or 2.6 (s = 1.52) beyond its edge, h = 3.
  for (const double beyond : {2.4, 2.6}) {
    Scene scene;
    scene.plate(scene.part(1, 6), {0, 0, 0}, 10 * ex, 10 * ey, 1, 1);
    scene.model.sets.nodes[5].members = {scene.node({10 + beyond, 5, 0})};
    auto& c = scene.contact("AUTOMATIC_NODES_TO_SURFACE");
    c.a = {5, 4, 0, true};
    c.b = {1, 3, 0, true};
    const InitialState state = scene.run();
    ASSERT_EQ(state.penetrations.size(), 1U);
    EXPECT_EQ(state.penetrations[0].kind, beyond < 2.5 ? PenetrationKind::initial : PenetrationKind::edge_zone);
    EXPECT_NEAR(state.penetrations[0].depth, 3 - beyond, 1e-12);
    EXPECT_EQ(state.penetrations[0].feature, Feature::edge);
  }
}

TEST(Initial, TJointWithThickShellsIsClean) {
  Scene scene;
  const PartIndex flange = scene.part(1, 8), web = scene.part(2, 8);
  const auto nodes = scene.plate(flange, {0, 0, 0}, 10 * ex, 10 * ey, 4, 2);
  // The web stands on the middle line of the flange and shares its nodes.
  std::vector<NodeIndex> top;
  for (int j = 0; j <= 2; ++j) top.push_back(scene.node({20, 10.0 * j, 10}));
  for (std::size_t j = 0; j < 2; ++j) scene.shell(web, {nodes[2 + 5 * j], nodes[7 + 5 * j], top[j + 1], top[j]});
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  scene.model.controls.ssthk = 1;
  EXPECT_TRUE(scene.run().penetrations.empty());
}

/// A sheet folded back onto itself: two legs of `rows` elements of 5, `gap` apart, joined by one row of elements; 1
/// thick. Or by a beam at the middle of the fold.
Scene hem(std::uint32_t rows, double gap, bool by_beam = false) {
  Scene scene;
  const PartIndex part = scene.part(1, 1);
  const auto low = scene.plate(part, {0, 0, 0}, 5 * ex, 5 * ey, rows, 2),
             high = scene.plate(part, {0, 0, gap}, 5 * ex, 5 * ey, rows, 2);
  const std::size_t row = rows + 1;
  for (std::size_t j = 0; j < 2 && !by_beam; ++j)
    scene.shell(part, {low[j * row], low[(j + 1) * row], high[(j + 1) * row], high[j * row]});
  if (by_beam) {
    const PartIndex rod = scene.part(2, 0);
    scene.model.sections.back().kind = model::SectionKind::beam;
    auto& beams = scene.model.mesh.beams;
    beams.id.push_back(1);
    beams.nodes.push_back({low[row], high[row]});
    beams.part.push_back(rod);
    beams.line.push_back(0);
  }
  return scene;
}

// Contact rules, section 1: every segment that the node does not belong to. At the fold these share a node with the
// node's own elements.
TEST(Initial, TheNodesOfAFoldPenetrateTheOtherLeg) {
  Scene scene = hem(3, 0.9);
  scene.contact("AUTOMATIC_SINGLE_SURFACE").ignore = 1;
  const InitialState state = scene.run();
  ASSERT_EQ(state.penetrations.size(), 2U * 4 * 3);
  for (const Penetration& p : state.penetrations) {
    EXPECT_EQ(p.kind, PenetrationKind::initial);
    EXPECT_NEAR(p.depth, 0.1, 1e-12) << p.node;
  }
  Scene apart = hem(3, 1.1);
  apart.contact("AUTOMATIC_SINGLE_SURFACE");
  EXPECT_TRUE(apart.run().penetrations.empty());
  // A beam holds the legs apart: its ends do not meet the segments at the other end.
  Scene held = hem(3, 0.9, true);
  held.contact("AUTOMATIC_SINGLE_SURFACE").ignore = 1;
  EXPECT_EQ(held.run().penetrations.size(), 2U * 4 * 3 - 2);
}

// A sheet thicker than its elements are long: the next but one lies within the contact distance, but not below.
TEST(Initial, ThickSheetsDoNotPenetrateThemselves) {
  Scene scene;
  scene.plate(scene.part(1, 12), {0, 0, 0}, 5 * ex, 5 * ey, 6, 6);
  scene.model.controls.ssthk = 1;
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  const InitialState state = scene.run();
  EXPECT_EQ(state.contacts[0].penetrations, 0U);
  ASSERT_EQ(state.contacts[0].edge_zone, 7U * 7);
  for (const Penetration& p : state.penetrations) EXPECT_NEAR(p.depth, 2, 1e-12) << "of the segments beyond the ring";
}

// Bent by a right angle, its nodes are within the contact distance of the other leg, and above it.
TEST(Initial, ThickSheetsPenetrateThemselvesInCorners) {
  Scene scene;
  const PartIndex part = scene.part(1, 3);
  const auto floor = scene.plate(part, {0, 0, 0}, 2 * ex, 2 * ey, 6, 6);
  std::array<NodeIndex, 7> below{};
  for (std::size_t j = 0; j < 7; ++j) below[j] = floor[7 * j];
  for (int k = 1; k < 6; ++k) {
    std::array<NodeIndex, 7> above{};
    for (std::size_t j = 0; j < 7; ++j) above[j] = scene.node({0, 2.0 * static_cast<double>(j), 2.0 * k});
    for (std::size_t j = 0; j < 6; ++j) scene.shell(part, {below[j], below[j + 1], above[j + 1], above[j]});
    below = above;
  }
  scene.model.controls.ssthk = 1;
  scene.contact("AUTOMATIC_SINGLE_SURFACE").ignore = 1;
  const InitialState state = scene.run();
  EXPECT_EQ(state.contacts[0].penetrations, 2U * 7) << "of the first row on either leg";
  EXPECT_NEAR(state.contacts[0].max_penetration, 1, 1e-12);
}

TEST(Initial, NodeInsideASolid) {
  for (const double inside : {0.3, 1.5}) {
    Scene scene;
    scene.brick(scene.part(1, 0), {0, 0, 0}, {10, 10, 10});
    scene.model.sets.nodes[5].members = {scene.node({5, 5, 10 - inside}), scene.node({5, 5, 10.1})};
    auto& c = scene.contact("ERODING_NODES_TO_SURFACE");
    c.a = {5, 4, 0, true};
    c.b = {1, 3, 0, true};
    const InitialState state = scene.run();
    ASSERT_EQ(state.penetrations.size(), 1U);
    EXPECT_NEAR(state.penetrations[0].depth, inside, 1e-12);
    EXPECT_NEAR(state.penetrations[0].moved_to.z(), 10 + 0.002 * inside, 1e-12);
  }
}

TEST(Initial, NodeBesideAConvexEdgeOfASolidIsOutside) {
  Scene scene;
  scene.brick(scene.part(1, 0), {0, 0, 0}, {10, 10, 10});
  // Below the top plane but beside the block; nearest to the edge from the top face's view.
  scene.model.sets.nodes[5].members = {scene.node({10.2, 5, 9.9}), scene.node({10.1, 5, 10.1})};
  auto& c = scene.contact("AUTOMATIC_NODES_TO_SURFACE");
  c.a = {5, 4, 0, true};
  c.b = {1, 3, 0, true};
  EXPECT_TRUE(scene.run().penetrations.empty());
}

// Contact rules, section 12: the closest segment. One block is 0.02 higher than the other and 0.1 deep in its side: a
// node above the top is outside, and one at the bottom is 0.02 deep.
TEST(Initial, BlocksThatAreNearlyFlushPenetrateTheClosestFace) {
  Scene scene;
  scene.brick(scene.part(1, 0), {0, 0, 0}, {10, 10, 10});
  scene.brick(scene.part(2, 0), {9.9, 2, 0.02}, {5, 5, 10});
  auto& c = scene.contact("AUTOMATIC_SURFACE_TO_SURFACE");
  c.a = {2, 3, 0, true};
  c.b = {1, 3, 0, true};
  c.ignore = 1;
  const InitialState state = scene.run();
  ASSERT_EQ(state.penetrations.size(), 2U);
  for (const Penetration& p : state.penetrations) {
    EXPECT_NEAR(p.depth, 0.02, 1e-12);
    EXPECT_NEAR(p.original.z(), 0.02, 1e-12);
  }
}

TEST(Initial, TiedNodesAreNotReportedAgainstTheirPart) {
  Scene scene = two_plates(0.7);
  auto& tie = scene.contact("TIED_NODES_TO_SURFACE_OFFSET");
  tie.a = {2, 3, 0, true};
  tie.b = {1, 3, 0, true};
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  const InitialState state = scene.run();
  EXPECT_EQ(state.contacts[0].ties, 4U);
  for (const Penetration& p : state.penetrations) EXPECT_EQ(p.part, 1);  // the lower plate's nodes are not tied
  EXPECT_EQ(state.contacts[1].penetrations, 4U);
}

TEST(Initial, ExcludedPartsDoNotMeet) {
  Scene scene = two_plates(0.7);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  model::ContactExclusion e;
  e.pairs.push_back({1, 2, 3, 3});
  scene.model.exclusions.push_back(e);
  EXPECT_TRUE(scene.run().penetrations.empty());
}

TEST(Initial, OrientedSurfaceTurnsTowardsTheOtherSide) {
  // Old type without thickness: the plate's normal points away from the nodes above it; one node has slipped through.
  Scene scene;
  const auto lower = scene.plate(scene.part(1, 1), {0, 0, 0}, 10 * ey, 10 * ex, 2, 2);
  std::vector<NodeIndex> nodes;
  for (const double z : {2.0, 3.0, 1.0, -0.25}) nodes.push_back(scene.node({7 + z, 8, z}));
  scene.model.sets.nodes[5].members = nodes;
  auto& c = scene.contact("NODES_TO_SURFACE");
  c.a = {5, 4, 0, true};
  c.b = {1, 3, 0, true};
  const InitialState state = scene.run();
  ASSERT_EQ(state.penetrations.size(), 1U);
  EXPECT_NEAR(state.penetrations[0].depth, 0.25, 1e-12);
  EXPECT_NEAR(state.penetrations[0].moved_to.z(), 0.25 * 0.002, 1e-12);
}

TEST(Initial, BandBeyondTheEndOfABeam) {
  // A beam of length 10 and a corner of a thin plate 2.4 (s = 1.48) or 2.6 (s = 1.52) beyond its end.
  for (const double beyond : {2.4, 2.6}) {
    Scene scene;
    const PartIndex p = scene.part(1, 0);
    scene.model.sections[0].beam_radius = 3;
    auto& beams = scene.model.mesh.beams;
    beams.id = {1};
    beams.nodes = {{scene.node({0, 0, 0}), scene.node({10, 0, 0})}};
    beams.part = {p};
    beams.line = {0};
    const auto corner = scene.plate(scene.part(2, 0.1), {10 + beyond, 0, 0}, 10 * ex, 10 * ey, 1, 1)[0];
    scene.contact("AUTOMATIC_GENERAL");
    int listed = 0;
    for (const Penetration& found : scene.run().penetrations) {
      if (found.node != corner.value + 1) continue;
      ++listed;
      EXPECT_EQ(found.kind, beyond < 2.5 ? PenetrationKind::initial : PenetrationKind::edge_zone) << beyond;
      EXPECT_NEAR(found.depth, 3.05 - beyond, 1e-12);
    }
    EXPECT_EQ(listed, 1) << beyond;
  }
}

// Of two segments that are equally near, the first one counts.
TEST(Initial, FirstOfEquallyNearSegments) {
  for (const double along : {10., 20., 30.}) {
    Scene scene;
    scene.plate(scene.part(1, 1), {0, 0, 0}, 10 * ex, 10 * ey, 4, 1);
    scene.model.sets.nodes[5].members = {scene.node({along, 5, 0.3})};
    auto& c = scene.contact("AUTOMATIC_NODES_TO_SURFACE");
    c.a = {5, 4, 0, true};
    c.b = {1, 3, 0, true};
    const InitialState state = scene.run();
    ASSERT_EQ(state.penetrations.size(), 1U);
    EXPECT_EQ(state.penetrations[0].element, std::lround(along / 10)) << along;
  }
}

/// Nodes on both sides of an old contact's plate, whose normals look down: three above, one below, without thickness.
InitialState nodes_around(std::int64_t orien, bool by_segments) {
  Scene scene;
  const PartIndex plate = scene.part(1, 1);
  scene.plate(plate, {0, 0, 0}, 10 * ey, 10 * ex, 2, 2);
  std::vector<NodeIndex> nodes;
  for (const double z : {2.0, 3.0, 1.0, -0.25}) nodes.push_back(scene.node({7 + z, 8, z}));
  scene.model.sets.nodes[5].members = nodes;
  scene.model.sets.segments[6].members = scene.model.mesh.shells.nodes;
  scene.model.controls.orien = orien;
  auto& c = scene.contact("NODES_TO_SURFACE");
  c.a = {5, 4, 0, true};
  if (by_segments)
    c.b = {6, 0, 0, true};
  else
    c.b = {1, 3, 0, true};
  return scene.run();
}

// ORIEN of *CONTROL_CONTACT: 1 turns surfaces given by parts, 2 also those of segments, 0 none.
TEST(Initial, SurfacesThatTheSolverTurns) {
  for (const auto& [orien, by_segments, turned] :
       {std::tuple{1, false, true}, std::tuple{1, true, false}, std::tuple{2, true, true}, std::tuple{2, false, true},
        std::tuple{0, false, false}, std::tuple{0, true, false}}) {
    const InitialState state = nodes_around(orien, by_segments);
    double deepest = 0;
    for (const Penetration& found : state.penetrations) deepest = std::max(deepest, found.depth);
    EXPECT_EQ(state.penetrations.size(), turned ? 1U : 3U) << orien << by_segments;
    EXPECT_NEAR(deepest, turned ? 0.25 : 3, 1e-12) << orien << by_segments;
  }
}

// An oriented shell sees nodes behind it up to half of its shorter diagonal.
TEST(Initial, DepthBehindOrientedShells) {
  const double limit = std::sqrt(200.) / 2;
  for (const double depth : {0.99 * limit, 1.01 * limit}) {
    Scene scene;
    scene.plate(scene.part(1, 1), {0, 0, 0}, 10 * ex, 10 * ey, 1, 1);
    std::vector<NodeIndex> nodes{scene.node({5, 5, -depth})};
    for (const double z : {1.0, 2.0, 3.0}) nodes.push_back(scene.node({5, 4, z}));
    scene.model.sets.nodes[5].members = nodes;
    auto& c = scene.contact("NODES_TO_SURFACE");
    c.a = {5, 4, 0, true};
    c.b = {1, 3, 0, true};
    EXPECT_EQ(scene.run().penetrations.size(), depth < limit ? 1U : 0U) << depth;
  }
}

TEST(Initial, SquareEdgesEndTheSurface) {
  Scene scene;
  const auto plate = scene.plate(scene.part(1, 6), {0, 0, 0}, 10 * ex, 10 * ey, 2, 1);
  // Beyond a free edge; over the inner edge; over the free edge itself.
  scene.model.sets.nodes[5].members = {scene.node({22, 5, 0}), scene.node({10, 5, 1}), scene.node({20, 5, 1})};
  auto& c = scene.contact("AUTOMATIC_NODES_TO_SURFACE");
  c.a = {5, 4, 0, true};
  c.b = {1, 3, 0, true};
  EXPECT_EQ(scene.run().penetrations.size(), 3U);
  // SHLEDG is read with SOFT = 2 alone.
  scene.model.contacts[0].shledg = 1;
  EXPECT_EQ(scene.run().penetrations.size(), 3U);
  for (const int srnde : {1, 2}) {
    scene.model.contacts[0].srnde = srnde;
    const InitialState state = scene.run();
    ASSERT_EQ(state.penetrations.size(), 2U) << srnde;
    for (const Penetration& p : state.penetrations) EXPECT_NEAR(p.depth, 2, 1e-12);
  }
}

TEST(Initial, SquareEdgesEndTheSurfaceAtCornersToo) {
  // The third triangle reaches the border y = 0 with one corner, beside which the node lies.
  Scene scene;
  const PartIndex part = scene.part(1, 6);
  const auto at = [&](double x, double y) { return scene.node({x, y, 0}); };
  const NodeIndex a = at(0, 0), b = at(10, 0), c = at(20, 0), d = at(20, 10), e = at(10, 10);
  scene.shell(part, {a, b, e, e});
  scene.shell(part, {b, c, d, d});
  scene.shell(part, {b, d, e, e});
  scene.model.sets.nodes[5].members = {at(10.2, -1)};
  auto& contact = scene.contact("AUTOMATIC_NODES_TO_SURFACE");
  contact.a = {5, 4, 0, true};
  contact.b = {1, 3, 0, true};
  EXPECT_EQ(scene.run().penetrations.size(), 1U);
  scene.model.contacts[0].srnde = 1;
  EXPECT_TRUE(scene.run().penetrations.empty());
}

TEST(Initial, BeforeTheNearestOrientedShellIsNotBehindAnother) {
  // The node is 1 above one plate and 2 behind another; a brick far away changes nothing.
  for (const bool brick : {false, true}) {
    Scene scene;
    const PartIndex part = scene.part(1, 1);
    scene.plate(part, {0, 0, 0}, 10 * ex, 10 * ey, 1, 1);
    scene.plate(part, {0, 0, 3}, 10 * ex, 10 * ey, 1, 1);
    auto& segments = scene.model.sets.segments[6].members;
    segments = scene.model.mesh.shells.nodes;
    if (brick) {
      scene.brick(scene.part(2, 0), {100, 0, 0}, {1, 1, 1});
      const auto& n = scene.model.mesh.solids.nodes[0];
      segments.push_back({n[4], n[5], n[6], n[7]});
    }
    scene.model.sets.nodes[5].members = {scene.node({5, 5, 1})};
    auto& c = scene.contact("NODES_TO_SURFACE");
    c.a = {5, 4, 0, true};
    c.b = {6, 0, 0, true};
    EXPECT_TRUE(scene.run().penetrations.empty()) << brick;
  }
}

TEST(Initial, OffsetMidSurfacesCountOnlyWhenAskedFor) {
  // NLOC = 1: the nodes are on top, the mid-surface half a thickness below.
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, 10 * ex, 10 * ey, 1, 1);
  scene.model.sections[0].nloc = 1;
  scene.model.sets.nodes[5].members = {scene.node({5, 5, 0.3}), scene.node({5, 6, -0.8})};
  auto& c = scene.contact("AUTOMATIC_NODES_TO_SURFACE");
  c.a = {5, 4, 0, true};
  c.b = {1, 3, 0, true};
  InitialState state = scene.run();
  ASSERT_EQ(state.penetrations.size(), 1U);
  EXPECT_NEAR(state.penetrations[0].depth, 0.2, 1e-12);
  scene.model.controls.cntco = 1;
  state = scene.run();
  ASSERT_EQ(state.penetrations.size(), 1U);
  EXPECT_EQ(state.penetrations[0].node, 6);
  EXPECT_NEAR(state.penetrations[0].depth, 0.5 - 0.3, 1e-12);
  EXPECT_NEAR(state.penetrations[0].moved_to.z(), -0.8 - 1.002 * 0.2, 1e-12);
}

/// A node set over part 1 by an automatic one-way contact.
InitialState nodes_to_part(Scene& scene, const std::vector<Vector>& at) {
  for (const Vector& x : at) scene.model.sets.nodes[5].members.push_back(scene.node(x));
  auto& c = scene.contact("AUTOMATIC_NODES_TO_SURFACE");
  c.a = {5, 4, 0, true};
  c.b = {0, 5, 0, true};
  return scene.run();
}

TEST(Initial, TetrahedraCountDownToTheirTip) {
  Scene scene;
  const auto n = [&](double x, double y, double z) { return scene.node({x, y, z}); };
  const NodeIndex a = n(0, 0, 0), b = n(9, 0, 0), c = n(0, 9, 0), d = n(0, 0, 9);
  scene.solid(scene.part(1, 0), {a, b, c, d, d, d, d, d});
  // 1.2 above the lower face, V / A = 3; nearest to that face.
  const InitialState state = nodes_to_part(scene, {{2, 2, 1.2}, {2, 2, -0.1}});
  ASSERT_EQ(state.penetrations.size(), 1U);
  EXPECT_NEAR(state.penetrations[0].depth, 1.2, 1e-12);
}

TEST(Initial, AboveATaperedBodyOfTwoGluedPartsIsOutside) {
  // A thick and a thin brick with shared nodes; the node is just above the thin one, near a side face of the thick one.
  Scene scene;
  scene.brick(scene.part(1, 0), {0, 0, 0}, {10, 10, 1});
  auto lower = scene.model.mesh.solids.nodes[0];
  const auto top = [&](double x, double y) { return scene.node({x, y, 1.2}); };
  scene.solid(scene.part(2, 0),
              {lower[4], lower[5], lower[6], lower[7], top(0, 0), top(10, 0), top(10, 10), top(0, 10)});
  EXPECT_TRUE(nodes_to_part(scene, {{0.5, 5, 1.24}}).penetrations.empty());
}

TEST(Initial, SkinsOfOneSolidLayerAreNeighbours) {
  Scene scene;
  const PartIndex solid = scene.part(1, 0), skin = scene.part(2, 1);
  scene.brick(solid, {0, 0, 0}, {10, 10, 0.5});
  const auto n = scene.model.mesh.solids.nodes[0];
  scene.shell(skin, {n[0], n[1], n[2], n[3]});
  scene.shell(skin, {n[4], n[5], n[6], n[7]});
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  EXPECT_TRUE(scene.run().penetrations.empty());
}

// In the middle of a layer no face of the solids is a segment.
TEST(Initial, SkinsOfAWideSolidLayerAreNeighbours) {
  Scene scene;
  const PartIndex solid = scene.part(1, 0), skin = scene.part(2, 1);
  constexpr std::uint32_t n = 4;
  const auto low = scene.plate(skin, {0, 0, 0}, 10 * ex, 10 * ey, n, n),
             high = scene.plate(skin, {0, 0, 0.5}, 10 * ex, 10 * ey, n, n);
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 2, d = a + n + 1;
      scene.solid(solid, {low[a], low[b], low[c], low[d], high[a], high[b], high[c], high[d]});
    }
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  EXPECT_TRUE(scene.run().penetrations.empty());
}

TEST(Initial, PenetrationReplacesANoteOnTheEdgeZone) {
  // Side A first sees the node beyond part 2's edge band, then side A's own part 3 has it in band.
  Scene scene;
  const auto own = scene.plate(scene.part(1, 1), {0, 0, 0.4}, 10 * ex, 10 * ey, 1, 1);
  scene.plate(scene.part(2, 20), {16, 0, 0.4}, 10 * ex, 10 * ey, 1, 1);
  scene.plate(scene.part(3, 1), {-5, -5, 0}, 20 * ex, 20 * ey, 1, 1);
  scene.model.sets.parts[1].members = {PartIndex{0}, PartIndex{2}};
  scene.model.sets.parts[2].members = {PartIndex{0}, PartIndex{1}};
  auto& c = scene.contact("AUTOMATIC_SURFACE_TO_SURFACE");
  c.a = {1, 2, 0, true};
  c.b = {2, 2, 0, true};
  c.ignore = 1;
  const InitialState state = scene.run();
  int listed = 0;
  for (const Penetration& p : state.penetrations) {
    if (p.node != own[1].value + 1) continue;
    ++listed;
    EXPECT_EQ(p.kind, PenetrationKind::initial);
    EXPECT_EQ(p.element_part, 3);
  }
  EXPECT_EQ(listed, 1);
}

TEST(Initial, BeamWithoutLengthMovesNoNodeToNowhere) {
  Scene scene;
  const PartIndex p = scene.part(1, 0);
  scene.model.sections[0].beam_radius = 1;
  const NodeIndex a = scene.node({5, 0, 0}), b = scene.node({5, 0, 0}), far = scene.node({5, 0, 0});
  auto& beams = scene.model.mesh.beams;
  beams.id = {1, 2};
  beams.nodes = {{a, b}, {far, scene.node({50, 0, 0})}};
  beams.part = {p, p};
  beams.line = {0, 0};
  scene.contact("AUTOMATIC_GENERAL");
  for (const Vector& x : scene.run().x) EXPECT_TRUE(x.allFinite());
}

// EDGEONLY: edges meet, nodes and segments do not.
TEST(Initial, EdgeOnlyListsNoNodes) {
  const auto found = [](const char* keyword, PenetrationKind kind) {
    Scene scene = two_plates(0.7);
    scene.contact(keyword);
    InitialOptions options;
    options.edges = true;
    const auto list = scene.run(options).penetrations;
    return std::count_if(list.begin(), list.end(), [&](const Penetration& p) { return p.kind == kind; });
  };
  EXPECT_GT(found("AUTOMATIC_GENERAL", PenetrationKind::initial), 0);
  EXPECT_EQ(found("AUTOMATIC_GENERAL_EDGEONLY", PenetrationKind::initial), 0);
  EXPECT_GT(found("AUTOMATIC_GENERAL", PenetrationKind::edge), 0);
  EXPECT_EQ(found("AUTOMATIC_GENERAL_EDGEONLY", PenetrationKind::edge),
            found("AUTOMATIC_GENERAL", PenetrationKind::edge));
}

TEST(Initial, ReferenceSideWithoutSegmentsIsNotChecked) {
  Scene scene = two_plates(0.7);
  scene.model.sets.nodes[5].members = {NodeIndex{0}};
  scene.contact("AUTOMATIC_SINGLE_SURFACE").a = {5, 4, 0, true};
  const InitialState state = scene.run();
  EXPECT_FALSE(state.contacts[0].not_checked.empty());
}

}  // namespace
}  // namespace gapcheck::contact::initial_test
