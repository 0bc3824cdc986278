#include "contact/mesh/mesh_index.hpp"

#include <gtest/gtest.h>

#include "contact/scene.hpp"
#include "contact/surface/segment_elements.hpp"
#include "contact/surface/surface.hpp"

namespace gapcheck::contact::mesh_index_test {
namespace {

std::vector<std::uint32_t> list(std::span<const std::uint32_t> entries) { return {entries.begin(), entries.end()}; }

TEST(MeshIndex, ElementsByNodeAndPart) {
  Scene scene;
  const auto plate = scene.plate(scene.part(1, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2, 1);
  const NodeIndex far = scene.node({9, 9, 9});
  scene.shell(scene.part(2, 1), {plate[0], plate[1], plate[3], plate[3]});
  MeshIndex index(scene.model);
  EXPECT_EQ(list(index.shells.at(plate[1])), (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(list(index.shells.at(plate[5])), (std::vector<std::uint32_t>{1}));
  EXPECT_TRUE(index.shells.at(far).empty());
  EXPECT_EQ(list(index.shells.of(PartIndex{0})), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(list(index.shells.of(PartIndex{1})), (std::vector<std::uint32_t>{2}));
  EXPECT_TRUE(index.solids.at(far).empty());
  EXPECT_TRUE(index.beams.of(PartIndex{1}).empty());
}

/// Small surfaces are looked up, large ones by passing over the mesh: both give the same.
TEST(MeshIndex, SmallSurfacesAreThoseOfTheWholeMesh) {
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 20, 20);  // 441 nodes: up to 27 are few
  scene.brick(scene.part(2, 0), {30, 0, 0}, {1, 1, 1});
  scene.plate(scene.part(3, 2), {0, 0, 5}, {1, 0, 0}, {0, 1, 0}, 1, 1);
  const auto& mesh = scene.model.mesh;
  const model::SegmentNodes shell = mesh.shells.nodes[37];
  const auto& solid = mesh.solids.nodes[0];
  const std::vector<model::SegmentNodes> few{{shell[2], shell[1], shell[0], shell[3]},
                                             {solid[4], solid[5], solid[6], solid[7]}};
  std::vector<model::SegmentNodes> many(mesh.shells.nodes.begin(), mesh.shells.nodes.begin() + 200);
  many.insert(many.begin(), few.begin(), few.end());
  MeshIndex index(scene.model);
  for (const auto& segments : {few, many}) {
    const auto found = find_segment_elements(mesh, segments, index);
    ASSERT_EQ(found.size(), segments.size());
    EXPECT_EQ(found[0].element, 37U);
    EXPECT_EQ(found[0].kind, model::ElementKind::shell);
    EXPECT_EQ(found[1].element, 0U);
    EXPECT_EQ(found[1].kind, model::ElementKind::solid);
  }
  const ContactType two{.code = ContactCode::automatic_surface,
                        .treatment = Treatment::two_way,
                        .family = Family::automatic,
                        .not_checked = {}};
  const auto& x = mesh.nodes.x;
  const Selection part = select(scene.model, {3, 3, 0, true}, two, x, index);
  EXPECT_EQ(part.segments.element, (std::vector<std::uint32_t>{400}));
  scene.model.sets.nodes[6].members = {mesh.shells.nodes[400][1], mesh.shells.nodes[3][0]};
  const TrackedNodes nodes =
      tracked_nodes(select(scene.model, {6, 4, 0, true}, two, x, index), scene.model, {}, x, index);
  EXPECT_EQ(nodes.node, (std::vector<NodeIndex>{mesh.shells.nodes[3][0], mesh.shells.nodes[400][1]}));
  EXPECT_EQ(nodes.half, (std::vector<double>{0.5, 1}));
}

// Opposite faces of one brick are faces of one body, though they share no node; bricks apart are bodies of their own.
TEST(MeshIndex, SolidsWithCommonNodesAreOneBody) {
  Scene scene;
  const PartIndex part = scene.part(1, 0);
  scene.brick(part, {0, 0, 0}, {1, 1, 1});
  scene.brick(part, {5, 0, 0}, {1, 1, 1});
  const auto& solids = scene.model.mesh.solids.nodes;
  MeshIndex index(scene.model);
  const std::vector<std::uint32_t>& body = *index.bodies();
  EXPECT_EQ(body[solids[0][0].value], body[solids[0][6].value]);
  EXPECT_NE(body[solids[0][0].value], body[solids[1][0].value]);
  EXPECT_EQ(index.bodies().get(), &body) << "built once";
}

}  // namespace
}  // namespace gapcheck::contact::mesh_index_test
