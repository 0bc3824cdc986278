#include "contact/surface/surface.hpp"

#include <gtest/gtest.h>

#include "contact/scene.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "contact/surface/segment_elements.hpp"

namespace gapcheck::contact::surface_test {
namespace {

const ContactType single{.code = ContactCode::automatic_single,
                         .treatment = Treatment::single_surface,
                         .family = Family::automatic,
                         .not_checked = {}};
const ContactType one_way{.code = ContactCode::automatic_nodes,
                          .treatment = Treatment::one_way,
                          .family = Family::automatic,
                          .not_checked = {}};

Selection pick(const Scene& scene, std::int64_t id, std::int64_t type, const ContactType& contact = one_way) {
  MeshIndex index(scene.model);
  return select(scene.model, {id, type, 0, true}, contact, scene.model.mesh.nodes.x, index);
}

/// Part 1: a plate of two shells; part 2: a brick; part 3: a brick with a shell of part 1 on its top.
Scene mixed() {
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 2, 1);
  scene.brick(scene.part(2, 0), {50, 0, 0}, {10, 10, 10});
  scene.brick(scene.part(3, 0), {100, 0, 0}, {10, 10, 10});
  const auto n = scene.model.mesh.solids.nodes[1];
  scene.shell(scene.part(4, 2), {n[4], n[5], n[6], n[7]});
  return scene;
}

TEST(Surface, PartsGiveShellsAndFreeFaces) {
  const Scene scene = mixed();
  EXPECT_EQ(pick(scene, 1, 3).segments.size(), 2U);
  const Selection brick = pick(scene, 2, 3);
  EXPECT_EQ(brick.segments.size(), 6U);
  EXPECT_EQ(brick.segments.kind[0], SegmentKind::solid);
  EXPECT_TRUE(pick(scene, 9, 3).unknown_id);
}

TEST(Surface, ParticlesOfPartsAreNodesAndBeamsLines) {
  Scene scene = mixed();
  const PartIndex powder = scene.part(5, 0), rods = scene.part(6, 0);
  auto& particles = scene.model.mesh.particles;
  auto& beams = scene.model.mesh.beams;
  const NodeIndex a = scene.node({200, 0, 0}), b = scene.node({210, 0, 0}), c = scene.node({220, 0, 0});
  particles.id = {1, 2};
  particles.nodes = {{c}, {a}};
  particles.part = {powder, powder};
  particles.line = {0, 0};
  beams.id = {7};
  beams.nodes = {{a, b}};
  beams.part = {rods};
  beams.line = {0};
  const Selection grains = pick(scene, 5, 3);
  EXPECT_EQ(grains.nodes, (std::vector<NodeIndex>{c, a}));
  EXPECT_EQ(grains.segments.size(), 0U);
  EXPECT_EQ(grains.empty_reason, "");
  const Selection lines = pick(scene, 6, 3);
  ASSERT_EQ(lines.segments.size(), 1U);
  EXPECT_EQ(lines.segments.kind[0], SegmentKind::line);
  EXPECT_EQ(lines.segments.nodes[0], (model::SegmentNodes{a, b, b, b}));
  EXPECT_EQ(element_id(scene.model.mesh, lines.segments, 0), 7);
  EXPECT_TRUE(lines.nodes.empty());
  EXPECT_EQ(pick(scene, 0, 5, single).nodes.size(), 2U);
}

TEST(Surface, ShellsCoverTheFacesTheyLieOn) {
  Scene scene = mixed();
  scene.model.sets.parts[7].members = {PartIndex{2}, PartIndex{3}};
  const Selection s = pick(scene, 7, 2);
  EXPECT_EQ(s.segments.size(), 6U);  // the shell and five faces
  EXPECT_EQ(std::count(s.segments.kind.begin(), s.segments.kind.end(), SegmentKind::shell), 1);
}

TEST(Surface, ZeroMeansAllInSingleSurfaceTypesOnly) {
  const Scene scene = mixed();
  EXPECT_EQ(pick(scene, 0, 0, single).segments.size(), 2U + 6 + 5 + 1);
  EXPECT_FALSE(pick(scene, 0, 2).empty_reason.empty());
  EXPECT_EQ(pick(scene, 0, 5).segments.size(), 2U + 6 + 5 + 1);
}

TEST(Surface, ExemptedPartSetIsTheRest) {
  Scene scene = mixed();
  scene.model.sets.parts[7].members = {PartIndex{1}, PartIndex{2}, PartIndex{3}};
  EXPECT_EQ(pick(scene, 7, 6).segments.size(), 2U);
}

TEST(Surface, BranchIsItsParts) {
  Scene scene = mixed();
  scene.model.sets.branches[7].members = {PartIndex{0}, PartIndex{1}};
  scene.model.sets.parts[7].members = {PartIndex{2}};
  EXPECT_EQ(pick(scene, 7, 7).segments.size(), 2U + 6);
  EXPECT_EQ(pick(scene, 7, 7, single).segments.size(), 2U + 6);
  const Selection missing = pick(scene, 8, 7);
  EXPECT_TRUE(missing.unknown_id);
  EXPECT_EQ(missing.segments.size(), 0U);
}

TEST(Surface, SegmentSetFindsItsElements) {
  Scene scene = mixed();
  const auto shell = scene.model.mesh.shells.nodes[1];
  const auto solid = scene.model.mesh.solids.nodes[0];
  // The brick's bottom with its normal turned inward, and a segment of no element.
  scene.model.sets.segments[3].members = {{shell[2], shell[3], shell[0], shell[1]},
                                          {solid[0], solid[1], solid[2], solid[3]},
                                          {shell[0], solid[0], solid[1], solid[1]}};
  const Selection s = pick(scene, 3, 0);
  ASSERT_EQ(s.segments.size(), 3U);
  EXPECT_EQ(s.segments.element[0], 1U);
  EXPECT_EQ(s.segments.kind[1], SegmentKind::solid);
  EXPECT_EQ(s.segments.nodes[1][1], solid[3]);  // turned outward
  EXPECT_EQ(part_of(scene.model.mesh, s.segments, 2), none<PartIndex>);
  EXPECT_EQ(element_id(scene.model.mesh, s.segments, 2), 0);
}

TEST(Surface, BoxKeepsSegmentsWhollyInside) {
  Scene scene = mixed();
  model::Box box;
  box.low = Vector(-1, -1, -1);
  box.high = Vector(11, 11, 1);
  scene.model.boxes[4] = box;
  MeshIndex index(scene.model);
  const Selection s = select(scene.model, {1, 3, 4, true}, one_way, scene.model.mesh.nodes.x, index);
  EXPECT_EQ(s.segments.size(), 1U);
}

/// A node inside a box has the thickness of its own part, though its segment reaches out, and not that of other parts.
TEST(Surface, NodesOfSegmentsThatABoxCuts) {
  Scene scene;
  const auto plate = scene.plate(scene.part(1, 1), {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 1, 1);
  const NodeIndex a = scene.node({-10, 0, 0}), b = scene.node({-10, 10, 0});
  scene.shell(scene.part(2, 3), {a, plate[0], plate[2], b});
  scene.model.sections[0].nloc = 1;
  model::Box box;
  box.low = Vector(-1, -1, -1);
  box.high = Vector(5, 11, 1);
  scene.model.boxes[4] = box;
  auto& contact = scene.contact("AUTOMATIC_SURFACE_TO_SURFACE");
  contact.a = {1, 3, 4, true};
  contact.b = {2, 3, 0, true};
  contact.shloff = 1;
  MeshIndex index(scene.model);
  const ContactSurfaces s = build_surfaces(scene.model, contact, scene.model.mesh.nodes.x, index, {});
  EXPECT_EQ(s.a.selection.segments.size(), 0U);
  EXPECT_EQ(s.a.nodes.node, (std::vector<NodeIndex>{plate[0], plate[2]}));
  EXPECT_EQ(s.a.nodes.half, (std::vector<double>{0.5, 0.5}));
  ASSERT_EQ(s.a.nodes.shift.size(), 2U);
  EXPECT_NEAR(s.a.nodes.shift[0].z(), -0.5, 1e-12);
}

/// Particles beside segments that a box cuts keep their part.
TEST(Surface, LooseNodesBesideABoxThatCuts) {
  Scene scene;
  const auto plate = scene.plate(scene.part(1, 1), {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 1, 1);
  const NodeIndex a = scene.node({20, 0, 0}), b = scene.node({20, 10, 0}), alone = scene.node({1, 1, 0});
  scene.shell(scene.part(2, 3), {alone, a, b, b});
  Selection s;
  s.cut.nodes = {scene.model.mesh.shells.nodes[0]};
  s.cut.element = {0};
  s.cut.element_kind = {model::ElementKind::shell};
  s.cut.kind = {SegmentKind::shell};
  s.nodes = {plate[0], alone};
  const ThicknessSide side;
  const auto& x = scene.model.mesh.nodes.x;
  fill_thickness(s.cut, scene.model, side, x);
  MeshIndex index(scene.model);
  const TrackedNodes nodes = tracked_nodes(s, scene.model, side, x, index);
  EXPECT_EQ(nodes.half, (std::vector<double>{0.5, 1.5}));
  EXPECT_EQ(nodes.part, (std::vector<PartIndex>{PartIndex{0}, PartIndex{1}}));
}

TEST(Surface, NodesTakeTheLargestThicknessOfTheirElements) {
  Scene scene;
  const auto thin = scene.plate(scene.part(1, 1), {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 1, 1);
  const NodeIndex a = scene.node({20, 0, 0}), b = scene.node({20, 10, 0});
  scene.shell(scene.part(2, 3), {thin[1], a, b, thin[3]});
  Selection s = pick(scene, 0, 5, single);
  const ThicknessSide side;
  const auto& x = scene.model.mesh.nodes.x;
  fill_thickness(s.segments, scene.model, side, x);
  MeshIndex index(scene.model);
  const TrackedNodes nodes = tracked_nodes(s, scene.model, side, x, index);
  EXPECT_EQ(nodes.half, (std::vector<double>{0.5, 1.5, 0.5, 1.5, 1.5, 1.5}));
  EXPECT_EQ(nodes.part[1], PartIndex{1});
}

TEST(Surface, NodeSetsLookAtAllElements) {
  Scene scene;
  const auto plate = scene.plate(scene.part(1, 2), {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 1, 1);
  scene.model.sets.nodes[6].members = {plate[2], scene.node({5, 5, 5})};
  const Selection s = pick(scene, 6, 4);
  MeshIndex index(scene.model);
  const TrackedNodes nodes = tracked_nodes(s, scene.model, {}, scene.model.mesh.nodes.x, index);
  EXPECT_EQ(nodes.half, (std::vector<double>{1, 0}));
  EXPECT_EQ(nodes.part[1], none<PartIndex>);
}

}  // namespace
}  // namespace gapcheck::contact::surface_test
