#include "contact/stiffness/segment_mass.hpp"

#include <gtest/gtest.h>

#include "contact/scene.hpp"
#include "contact/stiffness/node_masses.hpp"

namespace gapcheck::contact::segment_mass_test {
namespace {

/// One segment of an element.
Segments segment(const model::SegmentNodes& nodes, model::ElementKind kind, std::uint32_t element) {
  Segments s;
  s.nodes = {nodes};
  s.element = {element};
  s.element_kind = {kind};
  s.kind = {SegmentKind::shell};
  return s;
}

double mass_of(const Scene& scene, const Segments& s) {
  const ElementSizes sizes = element_sizes(scene.model);
  return segment_mass(scene.model, sizes, node_masses(scene.model, sizes), s, 0);
}

TEST(SegmentMass, OfShellsBeamsAndHalfOfSolids) {
  Scene scene;
  const PartIndex plate = scene.part(1, 0.5), block = scene.part(2, 0), rod = scene.part(3, 0);
  scene.material(plate, 3);
  scene.material(block, 2);
  scene.material(rod, 5);
  scene.model.sections[2].beam_area = 0.25;
  const auto n = scene.plate(plate, {0, 0, 0}, {2, 0, 0}, {0, 4, 0}, 1, 1);
  scene.brick(block, {9, 0, 0}, {1, 2, 3});
  auto& thick = scene.model.mesh.thick_shells;
  thick.id = {1};
  thick.nodes = scene.model.mesh.solids.nodes;
  thick.part = {block};
  thick.line = {0};
  auto& beams = scene.model.mesh.beams;
  beams.id = {1};
  beams.nodes = {{scene.node({0, 0, 9}), scene.node({3, 4, 9})}};
  beams.part = {rod};
  beams.line = {0};
  using Kind = model::ElementKind;
  EXPECT_DOUBLE_EQ(mass_of(scene, segment(scene.model.mesh.shells.nodes[0], Kind::shell, 0)), 3 * 0.5 * 8);
  const auto& brick = scene.model.mesh.solids.nodes[0];
  const model::SegmentNodes face{brick[0], brick[1], brick[2], brick[3]};
  EXPECT_DOUBLE_EQ(mass_of(scene, segment(face, Kind::solid, 0)), 2 * 6.0 / 2);
  EXPECT_DOUBLE_EQ(mass_of(scene, segment(face, Kind::thick_shell, 0)), 2 * 6.0 / 2);
  const auto& ends = beams.nodes[0];
  EXPECT_DOUBLE_EQ(mass_of(scene, segment({ends[0], ends[1], ends[1], ends[1]}, Kind::beam, 0)), 5 * 0.25 * 5);
}

// Without an element, or with one that has no mass or an endless one: a quarter of the nodes' masses at each corner.
TEST(SegmentMass, OfItsNodesOtherwise) {
  Scene scene;
  const PartIndex part = scene.part(1, 1);
  const auto n = scene.plate(part, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 1);
  auto& masses = scene.model.mesh.masses;
  for (const NodeIndex node : n) {
    masses.id.push_back(node.value + 1);
    masses.nodes.push_back({node});
    masses.part.push_back(none<PartIndex>);
    scene.model.mesh.mass_values.push_back(4 << node.value);  // 4, 8, 16, 32
  }
  const model::SegmentNodes quad{n[0], n[1], n[3], n[2]}, triangle{n[0], n[1], n[2], n[2]};
  using Kind = model::ElementKind;
  EXPECT_DOUBLE_EQ(mass_of(scene, segment(quad, Kind::shell, no_position)), 1 + 2 + 4 + 8);
  EXPECT_DOUBLE_EQ(mass_of(scene, segment(triangle, Kind::shell, no_position)), 1 + 2 + 4);
  EXPECT_DOUBLE_EQ(mass_of(scene, segment(quad, Kind::shell, 0)), 1 + 2 + 4 + 8) << "no material";
  scene.material(part, 1);
  scene.model.sections[0].thickness.fill(std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(mass_of(scene, segment(quad, Kind::shell, 0)), 1 + 2 + 4 + 8) << "an endless mass";
}

}  // namespace
}  // namespace gapcheck::contact::segment_mass_test
