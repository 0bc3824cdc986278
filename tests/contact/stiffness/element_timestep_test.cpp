#include "contact/stiffness/element_timestep.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/scene.hpp"

namespace gapcheck::contact::element_timestep_test {
namespace {

constexpr double for_shells = 6.75, shell_nu = 0.5;                     // E / (1 - ν²) = 9: c = 3
constexpr double for_solids = 16 * 1.25 * 0.5 / 0.75, solid_nu = 0.25;  // c = 4

model::Material material(double young, double poisson, double bulk = 0) {
  model::Material m;
  m.young = young;
  m.poisson = poisson;
  m.bulk = bulk;
  return m;
}

ElementTimestep smallest(const Scene& scene) {
  return smallest_element_timestep(scene.model, element_sizes(scene.model));
}

TEST(ElementTimestep, SoundSpeeds) {
  EXPECT_DOUBLE_EQ(shell_sound_speed(material(for_shells, shell_nu), 1, 0), 3);
  EXPECT_DOUBLE_EQ(shell_sound_speed(material(9, 0.5), 1, 2), 3);
  EXPECT_DOUBLE_EQ(solid_sound_speed(material(for_solids, solid_nu), 1), 4);
  EXPECT_DOUBLE_EQ(solid_sound_speed(material(0, 0, 50), 2), 5);
  EXPECT_DOUBLE_EQ(beam_sound_speed(material(8, 0.3), 2), 2);
  EXPECT_EQ(shell_sound_speed(material(0, 0), 1, 0), 0);
  EXPECT_EQ(beam_sound_speed(material(1, 0), 0), 0);
}

TEST(ElementTimestep, ShellLengths) {
  const std::vector<Vector> x{Vector(0, 0, 0), Vector(4, 0, 0), Vector(4, 3, 0), Vector(0, 3, 0)};
  const model::SegmentNodes quad{NodeIndex(0), NodeIndex(1), NodeIndex(2), NodeIndex(3)};
  const model::SegmentNodes triangle{NodeIndex(0), NodeIndex(1), NodeIndex(2), NodeIndex(2)};
  EXPECT_DOUBLE_EQ(shell_length(quad, 12, 0, x), 3);
  EXPECT_DOUBLE_EQ(shell_length(quad, 12, 1, x), 2.4);
  EXPECT_DOUBLE_EQ(shell_length(quad, 6, 2, x), 3);
  EXPECT_DOUBLE_EQ(shell_length(triangle, 6, 0, x), 2.4);  // lowest height: 2 · 6 / 5
}

TEST(ElementTimestep, SmallestOfAllKinds) {
  Scene scene;
  const PartIndex shells = scene.part(1, 1), solids = scene.part(2, 0), rigid = scene.part(3, 1);
  scene.model.sections[1].kind = model::SectionKind::solid;
  scene.material(shells, 1, 0, for_shells, shell_nu);
  scene.material(solids, 1, 0, for_solids, solid_nu);
  scene.material(rigid, 1, 0, 1e6).rigid = true;
  scene.plate(shells, Vector(0, 0, 0), Vector(6, 0, 0), Vector(0, 9, 0), 2, 1);  // 54 / 9 / 3 = 2
  scene.plate(rigid, Vector(0, 0, 5), Vector(1, 0, 0), Vector(0, 1, 0), 1, 1);
  scene.brick(solids, Vector(0, 0, 20), Vector(10, 10, 16));  // 16 · 100 / 160 / 4 = 2.5
  const ElementTimestep of_shells = smallest(scene);
  EXPECT_DOUBLE_EQ(of_shells.timestep, 2);
  EXPECT_EQ(of_shells.kind, model::ElementKind::shell);
  EXPECT_EQ(of_shells.element, 0u);
  scene.brick(solids, Vector(0, 0, 50), Vector(10, 10, 2));  // 2 / 4
  const ElementTimestep of_solids = smallest(scene);
  // Shorter by the linear bulk viscosity of 0.06: 1.0618 times.
  EXPECT_DOUBLE_EQ(of_solids.timestep, 0.5 / (0.06 + std::sqrt(1.0036)));
  EXPECT_EQ(of_solids.kind, model::ElementKind::solid);
  EXPECT_EQ(of_solids.element, 1u);
}

TEST(ElementTimestep, TetrahedraByTheirLowestHeight) {
  Scene scene;
  const NodeIndex a = scene.node(Vector(0, 0, 0)), b = scene.node(Vector(3, 0, 0)), c = scene.node(Vector(0, 3, 0)),
                  d = scene.node(Vector(0, 0, 1));
  const std::array<NodeIndex, 8> tetrahedron{a, b, c, d, d, d, d, d};
  const auto& x = scene.model.mesh.nodes.x;
  const double volume = brick_volume(tetrahedron, x);
  EXPECT_DOUBLE_EQ(volume, 1.5);
  // The largest face leans over a, b, c: its area is 0.5 |(-3, 3, 0) x (-3, 0, 1)| = 0.5 √(9 + 9 + 81).
  EXPECT_DOUBLE_EQ(solid_length(tetrahedron, volume, x), 4.5 / (0.5 * std::sqrt(99.0)));
}

TEST(ElementTimestep, NoneWithoutMaterial) {
  Scene scene;
  scene.plate(scene.part(1, 1), Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), 1, 1);
  EXPECT_EQ(smallest(scene).timestep, 0);
}

}  // namespace
}  // namespace gapcheck::contact::element_timestep_test
