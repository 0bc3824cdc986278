#include "contact/stiffness/node_masses.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "base/parallel.hpp"
#include "contact/scene.hpp"

namespace gapcheck::contact::node_masses_test {
namespace {

std::vector<double> masses(const Scene& scene) { return node_masses(scene.model, element_sizes(scene.model)); }

TEST(NodeMasses, ShellsShareEquallyAndTrianglesInThree) {
  Scene scene;
  const PartIndex part = scene.part(1, 0.5);
  scene.material(part, 3);
  const auto n = scene.plate(part, Vector(0, 0, 0), Vector(2, 0, 0), Vector(0, 4, 0), 2, 1);
  const NodeIndex tip = scene.node(Vector(0, -6, 0));
  scene.shell(part, {tip, n[1], n[0], n[0]});
  const auto m = masses(scene);
  EXPECT_DOUBLE_EQ(m[n[5].value], 3 * 0.5 * 8 / 4);
  EXPECT_DOUBLE_EQ(m[n[4].value], 2 * 3 * 0.5 * 8 / 4);
  EXPECT_DOUBLE_EQ(m[tip.value], 3 * 0.5 * 6 / 3);
  EXPECT_DOUBLE_EQ(m[n[0].value], 3 * 0.5 * 8 / 4 + 3 * 0.5 * 6 / 3);
}

TEST(NodeMasses, SolidsByTheirDistinctNodes) {
  Scene scene;
  const PartIndex part = scene.part(1, 0);
  scene.material(part, 2);
  scene.brick(part, Vector(0, 0, 0), Vector(1, 2, 3));
  const NodeIndex a = scene.node(Vector(10, 0, 0)), b = scene.node(Vector(11, 0, 0)), c = scene.node(Vector(10, 1, 0)),
                  d = scene.node(Vector(10, 0, 3));
  scene.solid(part, {a, b, c, d, d, d, d, d});
  const auto m = masses(scene);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_DOUBLE_EQ(m[i], 2 * 6.0 / 8);
  EXPECT_DOUBLE_EQ(m[d.value], 2 * 0.5 / 4);
}

// Contact rules, section 12: in the printed step ρ V / 8 at each listed node; tetrahedra by ELFORM have four.
TEST(NodeMasses, PrintedOfSolidsByTheirListedNodes) {
  for (const std::int64_t elform : {1, 10}) {
    Scene scene;
    const PartIndex part = scene.part(1, 0);
    scene.material(part, 2);
    scene.model.sections[0].kind = model::SectionKind::solid;
    scene.model.sections[0].elform = elform;
    const NodeIndex a = scene.node(Vector(10, 0, 0)), b = scene.node(Vector(11, 0, 0)),
                    c = scene.node(Vector(10, 1, 0)), d = scene.node(Vector(10, 0, 3));
    scene.solid(part, {a, b, c, d, d, d, d, d});
    const auto m = node_masses(scene.model, element_sizes(scene.model), true);
    EXPECT_DOUBLE_EQ(m[a.value], 2 * 0.5 / (elform == 1 ? 8 : 4)) << elform;
    EXPECT_DOUBLE_EQ(m[d.value], 2 * 0.5 * (elform == 1 ? 5. / 8 : 1. / 4)) << elform;
  }
}

// A brick whose top is sheared upwards at one corner: the volume under a bilinear face is base times mean height.
TEST(NodeMasses, VolumeUnderABilinearFace) {
  Scene scene;
  const PartIndex part = scene.part(1, 0);
  scene.brick(part, Vector(5, 5, 5), Vector(1, 1, 1));
  scene.model.mesh.nodes.x[6] += Vector(0, 0, 1);
  EXPECT_NEAR(brick_volume(scene.model.mesh.solids.nodes[0], scene.model.mesh.nodes.x), 1.25, 1e-14);
}

TEST(NodeMasses, BeamsMassesAndPlies) {
  Scene scene;
  const PartIndex beam = scene.part(1, 0), laminate = scene.part(2, 0.75);
  scene.material(beam, 4);
  scene.model.sections[0].beam_area = 0.5;
  const NodeIndex a = scene.node(Vector(0, 0, 0)), b = scene.node(Vector(3, 4, 0));
  scene.model.mesh.beams.id.push_back(1);
  scene.model.mesh.beams.nodes.push_back({a, b});
  scene.model.mesh.beams.part.push_back(beam);
  scene.model.mesh.masses.id.push_back(1);
  scene.model.mesh.masses.nodes.push_back({b});
  scene.model.mesh.masses.part.push_back(none<PartIndex>);
  scene.model.mesh.mass_values = {7};
  scene.model.materials.emplace_back().density = 10;
  auto& part = scene.model.parts[laminate.value];
  part.composite_thickness = 0.75;
  part.plies = {{1, 0.5, 0}, {2, 0.25, 1}};
  const auto n = scene.plate(laminate, Vector(0, 0, 9), Vector(1, 0, 0), Vector(0, 1, 0), 1, 1);
  const auto m = masses(scene);
  EXPECT_DOUBLE_EQ(m[a.value], 4 * 0.5 * 5 / 2);
  EXPECT_DOUBLE_EQ(m[b.value], 4 * 0.5 * 5 / 2 + 7);
  EXPECT_DOUBLE_EQ(m[n[0].value], (4 * 0.5 + 10 * 0.25) / 4);
}

TEST(NodeMasses, WithoutSense) {
  Scene scene;
  const PartIndex part = scene.part(1, 1);
  const auto n = scene.plate(part, Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), 2, 1);
  EXPECT_EQ(masses(scene)[n[0].value], 0);  // no material
  scene.material(part, 1);
  scene.model.mesh.shells.part[0] = none<PartIndex>;
  scene.model.mesh.nodes.x[n[2].value] = Vector::Constant(1e300);
  for (const double m : masses(scene)) EXPECT_EQ(m, 0);
}

// Large enough for several threads: the same sums, bit by bit.
TEST(NodeMasses, AnyNumberOfThreads) {
  Scene scene;
  const PartIndex part = scene.part(1, 0.3);
  scene.material(part, 7.85e-9);
  scene.plate(part, Vector(0.1, 0.2, 0.3), Vector(1.1, 0.01, 0), Vector(0.02, 0.9, 0), 300, 200);
  const auto many = masses(scene);
  const double area = 1.1 * 0.9 - 0.01 * 0.02;
  EXPECT_NEAR(many.front(), 7.85e-9 * 0.3 * area / 4, 1e-22) << "a corner";
  EXPECT_NEAR(std::accumulate(many.begin(), many.end(), 0.0), 7.85e-9 * 0.3 * area * 60000, 1e-15);
  const JobLimit one(1);
  EXPECT_EQ(many, masses(scene));
}

}  // namespace
}  // namespace gapcheck::contact::node_masses_test
