#include "solver/build/build.hpp"

#include <gtest/gtest.h>

#include "contact/stiffness/element_timestep.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::build_test {
namespace {

double total_mass(const Structure& structure) {
  double sum = 0;
  for (const double mass : structure.state.mass) sum += mass;
  return sum;
}

// ρ A t and ρ V, whatever the shape; a point mass beside them.
TEST(Build, LumpedMass) {
  const Structure sheet =
      structure_of(plate(3, 2, {0.5, 0.4, 0}) + elastic_deck(shell_section, 1000, 0.3, 7) + "*ELEMENT_MASS\n1,1,2.5\n");
  EXPECT_NEAR(total_mass(sheet), 7 * 1.5 * 0.8 * 0.1 + 2.5, 1e-12);
  EXPECT_NEAR(sheet.state.mass[0], 7 * 0.2 * 0.1 / 4 + 2.5, 1e-12);
  EXPECT_NEAR(sheet.state.inertia[0], 7 * 0.2 * 0.1 / 4 * 0.2 / 8, 1e-12);
  const Structure bar = structure_of(brick_bar(3, {0.5, 0.4, 2}) + elastic_deck(solid_section, 1000, 0.3, 7));
  EXPECT_NEAR(total_mass(bar), 7 * 1.5 * 0.4 * 2, 1e-12);
  EXPECT_NEAR(bar.state.mass[0], 7 * 0.5 * 0.4 * 2 / 8, 1e-12);
  EXPECT_EQ(bar.state.inertia[0], 0);
}

TEST(Build, TrianglesAndTetrahedra) {
  const Structure triangle = structure_of("*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,1.,0.\n*ELEMENT_SHELL\n1,1,1,2,3,3\n" +
                                          elastic_deck(shell_section, 1000, 0.3, 7));
  EXPECT_NEAR(triangle.state.mass[2], 7 * 0.5 * 0.1 / 3, 1e-12);
  const Structure tetrahedron =
      structure_of("*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,1.,0.\n4,0.,0.,1.\n*ELEMENT_SOLID\n1,1,1,2,3,4,4,4,4,4\n" +
                   elastic_deck(solid_section, 1000, 0.3, 7));
  EXPECT_NEAR(tetrahedron.state.mass[3], 7.0 / 6 / 4, 1e-12);
}

TEST(Build, OwnThickness) {
  const Structure shell = structure_of(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n*ELEMENT_SHELL_THICKNESS\n1,1,1,2,3,4\n0.4,0.4,0.2,0.\n" +
      elastic_deck(shell_section, 1000, 0.3, 1));
  EXPECT_NEAR(shell.shells.state(0).thickness, (0.4 + 0.4 + 0.2 + 0.1) / 4, 1e-15);
}

Material material_of(const std::string& deck) {
  const model::Read read = model::read_text(deck);
  EXPECT_EQ(read.text(), "");
  auto built = build_material(read.model, read.model.materials.at(0));
  if (!built) {
    ADD_FAILURE() << built.error().message;
    return {};
  }
  return built.value();
}

TEST(Build, Materials) {
  const Material kinematic = material_of("*MAT_003\n1,1.,1000.,0.3,10.,100.,0.25\n40.,5.\n");
  const double slope = 1000.0 * 100 / 900;
  EXPECT_EQ(kinematic.kind, MaterialKind::plastic);
  EXPECT_NEAR(kinematic.kinematic_slope, 0.75 * slope, 1e-12);
  EXPECT_NEAR(kinematic.yield.stress(1), 10 + 0.25 * slope, 1e-12);
  EXPECT_EQ(kinematic.rate_c, 40);
  EXPECT_EQ(kinematic.rate_p, 5);
  const std::string head = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,1.,1000.,0.3,10.,100.\n";
  EXPECT_NEAR(material_of(head).yield.stress(1), 10 + slope, 1e-12);
  const Material points = material_of(head + "40.,5.\n0.,0.1,0.5\n20.,30.,50.\n");
  EXPECT_NEAR(points.yield.stress(0.3), 40, 1e-12);
  EXPECT_EQ(points.rate_c, 40);
  const Material curve = material_of(head + ",,9\n*DEFINE_CURVE\n9,,,2.\n0.,20.\n1.,30.\n");
  EXPECT_NEAR(curve.yield.stress(0.5), 50, 1e-12);
  EXPECT_EQ(material_of("*MAT_NULL\n1,1.\n").kind, MaterialKind::null);
  EXPECT_EQ(material_of("*MAT_RIGID\n1,1.,1000.,0.3\n").kind, MaterialKind::rigid);
}

TEST(Build, AnisotropyAndRateTables) {
  const Material sheet = material_of("*MAT_037\n1,1.,1000.,0.3,10.,100.,-1.5\n");
  EXPECT_EQ(sheet.kind, MaterialKind::anisotropic);
  EXPECT_EQ(sheet.anisotropy, 1.5);
  EXPECT_NEAR(sheet.yield.stress(0.1), 20, 1e-12);
  EXPECT_EQ(material_of("*MAT_037\n1,1.,1000.,0.3,10.,0.,1.,9\n*DEFINE_CURVE\n9\n0.,20.\n1.,30.\n").yield.stress(0.5),
            25);
  const std::string curves = "*DEFINE_CURVE\n9\n0.,20.\n1.,30.\n*DEFINE_CURVE\n10\n0.,40.\n0.5,60.\n";
  const Material rates =
      material_of("*MAT_024\n1,1.,1000.,0.3,10.,100.\n40.,5.,8\n*DEFINE_TABLE\n8\n1.\n3.\n" + curves);
  ASSERT_EQ(rates.table.curves.size(), 2u);
  EXPECT_NEAR(rates.yield_at(2).stress(0.5), (25 + 60) / 2.0, 1e-12);
  EXPECT_NEAR(rates.yield_at(1e3).stress(0.75), 70, 1e-12);  // no Cowper-Symonds factor beside a table
  EXPECT_FALSE(material_of("*MAT_024\n1,1.,1000.,0.3,10.\n,,9\n" + curves).table.logarithmic);
}

// VP = 1 changes something only where the yield stress depends on a rate.
TEST(Build, ViscoplasticRates) {
  const std::string head = "*MAT_024\n1,1.,1000.,0.3,10.,100.\n", curve = "*DEFINE_CURVE\n7\n0.,20.\n1.,40.\n";
  EXPECT_FALSE(material_of(head + "0.,0.,0,0,1.\n").viscoplastic);
  EXPECT_FALSE(material_of(head + "0.,0.,7,0,1.\n" + curve).viscoplastic);
  EXPECT_FALSE(material_of(head + "40.,5.\n").viscoplastic);
  const Material added = material_of(head + "40.,5.,7,0,1.\n" + curve);
  EXPECT_TRUE(added.viscoplastic);
  EXPECT_NEAR(added.viscous_stress(0.5, 40), 30 + 10, 1e-12);
  EXPECT_NEAR(material_of("*MAT_024\n1,1.,1000.,0.3\n40.,5.,7,0,1.\n" + curve).viscous_stress(0.5, 40), 60, 1e-12);
  const Material kinematic = material_of("*MAT_003\n1,1.,1000.,0.3,10.,100.,1.\n40.,5.,0.,1.\n");
  EXPECT_TRUE(kinematic.viscoplastic);
  EXPECT_NEAR(kinematic.viscous_stress(0, 40), 20, 1e-12);
  const Material table =
      material_of(head + "0.,0.,8,0,1.\n*DEFINE_TABLE\n8\n1.\n3.\n" + curve + "*DEFINE_CURVE\n9\n0.,60.\n1.,60.\n");
  EXPECT_TRUE(table.viscoplastic);
  EXPECT_NEAR(table.viscous_stress(0.5, 2), 45, 1e-12);
}

TEST(Build, WhatMaterialsLeaveOutIsNamedOnce) {
  const model::Read read =
      model::read_text(plate(2, 1, {1, 1, 0}) + "*PART\np\n1,1,1\n" + shell_section +
                       "*MAT_024\n1,1.,1000.,0.3,10.,100.,0.2\n40.,5.,0,7,3.\n*DEFINE_CURVE\n7\n0.,1.\n1.,1.\n");
  Diagnostics diagnostics;
  EXPECT_TRUE(build_structure(read.model, {}, diagnostics).ok());
  std::string text;
  for (const Diagnostic& d : diagnostics.sorted()) text += d.message + "\n";
  EXPECT_EQ(text,
            "material 1 (*MAT_PIECEWISE_LINEAR_PLASTICITY): VP = 3 is not calculated; the total strain rate counts\n"
            "material 1 (*MAT_PIECEWISE_LINEAR_PLASTICITY): the curve LCSR over the rate is not calculated\n");
}

TEST(Build, FailuresAreTold) {
  const std::string nodes = "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n*ELEMENT_SHELL\n5,1,1,2,3,4\n";
  const auto fails = [](const std::string& deck, Failure::Kind kind, std::string_view text) {
    const Failure failure = failure_of(deck);
    EXPECT_EQ(failure.kind, kind);
    EXPECT_NE(failure.message.find(text), std::string::npos) << failure.message;
  };
  fails(nodes + "*PART\np\n1,1,1\n" + shell_section, Failure::Kind::missing_material, "shell 5");
  fails(nodes + elastic_deck("", 1, 0.3, 1), Failure::Kind::missing_material, "shell 5");
  fails(nodes + elastic_deck(solid_section, 1, 0.3, 1), Failure::Kind::missing_material, "section 1");
  fails(nodes + elastic_deck(shell_section, 1, 0.5, 1), Failure::Kind::bad_material, "out of range");
  fails(nodes + elastic_deck(shell_section, 1, 0.3, 0), Failure::Kind::bad_material, "out of range");
  fails(nodes + elastic_deck("*SECTION_SHELL\n1,2\n0.\n", 1, 0.3, 1), Failure::Kind::bad_element, "thickness 0");
  fails(nodes + "*PART\np\n1,1,1\n" + shell_section + "*MAT_POWER_LAW_PLASTICITY\n1,1.,1.,0.3\n",
        Failure::Kind::bad_material, "MAT_POWER_LAW_PLASTICITY");
  fails(nodes + "*PART\np\n1,1,1\n" + shell_section + "*MAT_024\n1,1.,1.,0.3,1.\n,,77\n", Failure::Kind::bad_material,
        "curve");
  fails(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,0.,0.,1.\n*ELEMENT_SHELL\n5,1,1,2,3,4\n"
      "*ELEMENT_SOLID\n8,1,1,2,3,5,5,5,5,5\n" +
          elastic_deck(shell_section, 1, 0.3, 1),
      Failure::Kind::missing_material, "solid 8");
  std::string bar = brick_bar(1, {1, 1, 1});
  fails(bar.substr(0, bar.find("*ELEMENT")) + "*ELEMENT_SOLID\n6,1,5,6,8,7,1,2,4,3\n" +
            elastic_deck(solid_section, 1, 0.3, 1),
        Failure::Kind::bad_element, "solid 6");
  fails(bar.substr(0, bar.find("*ELEMENT")) + "*ELEMENT_SOLID\n6,1,5,6,8,7,1,2,4,3\n*PART\np\n1,1,1\n" + solid_section +
            "*MAT_RIGID\n1,1.,1.,0.3\n",
        Failure::Kind::bad_element, "solid 6");
}

// The first step is the one that the audit foretells, on skewed elements too.
TEST(Build, TimeStepIsThatOfTheContactRules) {
  for (const std::string& deck :
       {plate(3, 2, {0.5, 0.4, 0}) + elastic_deck(shell_section, 1000, 0.3, 7),
        "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,1.5,0.\n*ELEMENT_SHELL\n1,1,1,2,3,3\n" +
            elastic_deck(shell_section, 1000, 0.3, 7),
        brick_bar(3, {0.5, 0.4, 2}) + elastic_deck(solid_section, 1000, 0.3, 7),
        "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,1.5,0.\n4,0.2,0.1,2.\n*ELEMENT_SOLID\n1,1,1,2,3,4,4,4,4,4\n" +
            elastic_deck(solid_section, 1000, 0.3, 7)}) {
    model::Read read = model::read_text(deck);
    for (Vector& x : read.model.mesh.nodes.x) x += Vector(0.3 * x.y(), 0.2 * x.z(), 0.1 * x.x());
    Diagnostics diagnostics;
    StepSettings settings;
    settings.time_step_factor = 1;
    settings.bounded_step = false;
    Stepper stepper(build_structure(read.model, {}, diagnostics).value(), settings);
    ASSERT_TRUE(stepper.step().ok());
    const double foretold = contact::smallest_element_timestep(read.model, contact::element_sizes(read.model)).timestep;
    EXPECT_NEAR(stepper.state().dt, foretold, 1e-12 * foretold) << deck;
  }
}

TEST(Build, NodesThatAreNotThere) {
  model::Read read = model::read_text(plate(1, 1, {1, 1, 0}) + elastic_deck(shell_section, 1, 0.3, 1));
  read.model.mesh.shells.nodes[0][2] = none<NodeIndex>;
  Diagnostics diagnostics;
  const auto built = build_structure(read.model, {}, diagnostics);
  ASSERT_FALSE(built.ok());
  EXPECT_EQ(built.error().message, "shell 1 has a node that is not there");
}

TEST(Build, OtherElementsAreNamed) {
  const model::Read read =
      model::read_text("*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,1.,0.\n*ELEMENT_BEAM\n1,1,1,2,3\n" +
                       elastic_deck("*SECTION_BEAM\n1,6\n1.,1.\n", 1, 0.3, 1) + "*ELEMENT_SPH\n3,1,0.5\n");
  Diagnostics diagnostics;
  const auto built = build_structure(read.model, {}, diagnostics);
  EXPECT_TRUE(built.ok());
  ASSERT_EQ(diagnostics.sorted().size(), 2u);
  EXPECT_EQ(diagnostics.sorted()[0].message, "1 particles take no part in the calculation");
  EXPECT_EQ(diagnostics.sorted()[1].message, "section 1: beams of ELFORM 6 take no part in the calculation");
}

}  // namespace
}  // namespace gapcheck::solver::build_test
