#include "solver/rigid/rigid_bodies.hpp"

#include <cmath>

#include "solver/structure/mass_points.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::rigid_bodies_test {
namespace {

const std::string rigid_material = "*MAT_RIGID\n1,3.,1000.,0.3\n";

std::string rigid_deck(const std::string& mesh, const std::string& section) {
  return mesh + "*PART\np\n1,1,1\n" + section + rigid_material;
}

// A box: m (b² + c²) / 12 about the axes through its centre. A plate: with its thickness.
TEST(MassPoints, BoxAndPlate) {
  const Structure box = structure_of(rigid_deck(brick_bar(3, {0.5, 0.4, 2}), solid_section));
  ASSERT_EQ(box.rigid.size(), 1u);
  const double mass = 3 * 1.5 * 0.4 * 2;
  EXPECT_NEAR(box.rigid[0].mass(), mass, 1e-12);
  EXPECT_NEAR((box.rigid[0].center() - Vector(0.75, 0.2, 1)).norm(), 0, 1e-14);
  EXPECT_NEAR(box.rigid[0].inertia()(0, 0), mass / 12 * (0.16 + 4), 1e-12);
  EXPECT_NEAR(box.rigid[0].inertia()(2, 2), mass / 12 * (2.25 + 0.16), 1e-12);
  const Structure sheet = structure_of(rigid_deck(plate(3, 2, {0.5, 0.4, 0}), shell_section));
  const double plate_mass = 3 * 1.5 * 0.8 * 0.1;
  EXPECT_NEAR(sheet.rigid[0].mass(), plate_mass, 1e-12);
  EXPECT_NEAR(sheet.rigid[0].inertia()(0, 0), plate_mass / 12 * (0.64 + 0.01), 1e-12);
  EXPECT_NEAR(sheet.rigid[0].inertia()(2, 2), plate_mass / 12 * (0.64 + 2.25), 1e-12);
}

// ∫ x² dV = 1/60 and ∫ x y dV = 1/120 in the tetrahedron between the axes and x + y + z = 1.
TEST(MassPoints, Tetrahedron) {
  const Vector top(0, 0, 1);
  double mass = 0, second = 0, mixed = 0;
  for (const auto& [x, m] : solid_mass_points({Vector(0, 0, 0), {1, 0, 0}, {0, 1, 0}, top, top, top, top, top}, 1)) {
    mass += m;
    second += m * x.x() * x.x();
    mixed += m * x.x() * x.y();
  }
  EXPECT_NEAR(mass, 1.0 / 6, 1e-15);
  EXPECT_NEAR(second, 1.0 / 60, 1e-15);
  EXPECT_NEAR(mixed, 1.0 / 120, 1e-15);
}

// A free spinning box in the stepper: its nodes keep their distances, energy and momentum stay.
TEST(RigidBodies, SpinFreely) {
  Structure box = structure_of(rigid_deck(brick_bar(3, {0.5, 0.4, 2}), solid_section));
  box.rigid.set_motion(0, {1, 0, 0}, {0.1, 3, 0.2}, box.state);
  StepSettings settings;
  settings.greatest_step = 1e-3;
  Stepper stepper(std::move(box), settings);
  const std::vector<Vector> start = stepper.state().x;
  const Vector momentum = stepper.structure().rigid[0].angular_momentum();
  for (int i = 0; i < 2000; ++i) ASSERT_TRUE(stepper.step().ok());
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-11);
  EXPECT_EQ((stepper.structure().rigid[0].angular_momentum() - momentum).norm(), 0);
  EXPECT_NEAR(stepper.structure().rigid[0].center().x(), 0.75 + 2, 1e-11);
  for (std::size_t i = 1; i < start.size(); ++i)
    EXPECT_NEAR((stepper.state().x[i] - stepper.state().x[0]).norm(), (start[i] - start[0]).norm(), 1e-11);
}

// Two parts of one body, an extra node with a mass, and a nodal rigid body.
TEST(RigidBodies, MergedPartsExtraNodesAndNodalBodies) {
  const Structure both = structure_of(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,2.,0.,0.\n6,2.,1.,0.\n7,9.,0.,0.\n8,9.,1.,0.\n9,9.,2.,"
      "0.\n"
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,2,5,6,3\n*PART\na\n1,1,1\n*PART\nb\n2,1,1\n*ELEMENT_MASS\n1,7,2.\n2,8,3.\n3,9,"
      "3.\n"
      "*CONSTRAINED_RIGID_BODIES\n1,2\n*CONSTRAINED_EXTRA_NODES_NODE\n2,7\n*SET_NODE_LIST\n4\n8,9\n"
      "*CONSTRAINED_NODAL_RIGID_BODY\n5,,4\n" +
      shell_section + rigid_material);
  ASSERT_EQ(both.rigid.size(), 2u);
  EXPECT_NEAR(both.rigid[0].mass(), 3 * 2 * 0.1 + 2, 1e-12);
  EXPECT_NEAR(both.rigid[0].center().x(), (0.6 * 1 + 2 * 9) / 2.6, 1e-12);
  EXPECT_TRUE(both.rigid.holds(6));
  EXPECT_NEAR(both.rigid[1].mass(), 6, 1e-12);
  EXPECT_NEAR(both.rigid[1].center().y(), 1.5, 1e-12);
}

// A rigid brick between springy ones: momentum goes through it. The bar flies on as a whole.
TEST(RigidBodies, ShareNodesWithElements) {
  std::string mesh = brick_bar(3, {1, 1, 1});
  mesh.replace(mesh.find("\n2,1,", mesh.find("*ELEMENT")), 5, "\n2,2,");
  Structure bar = structure_of(mesh + "*PART\np\n1,1,2\n*PART\nr\n2,1,1\n" + solid_section + rigid_material +
                               "*MAT_ELASTIC\n2,3.,1000.,0.\n");
  ASSERT_EQ(bar.solids.size(), 2u);
  EXPECT_NEAR(bar.rigid[0].mass(), 3 + 2 * 1.5, 1e-12);  // its own and half of each neighbour
  for (const std::uint32_t i : {0u, 4u, 8u, 12u}) bar.state.v[i].x() = 0.01;
  StepSettings settings;
  settings.greatest_step = 2e-3;
  Stepper stepper(std::move(bar), settings);
  for (int i = 0; i < 500; ++i) ASSERT_TRUE(stepper.step().ok());
  double momentum = stepper.structure().rigid[0].mass() * stepper.structure().rigid[0].velocity().x();
  for (std::size_t i = 0; i < stepper.state().x.size(); ++i)
    if (!stepper.structure().rigid.holds(i)) momentum += stepper.state().mass[i] * stepper.state().v[i].x();
  EXPECT_NEAR(momentum, 1.5 * 0.01, 1e-12);
  EXPECT_GT(stepper.structure().rigid[0].velocity().x(), 0);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-9);
}

}  // namespace
}  // namespace gapcheck::solver::rigid_bodies_test
