#include "solver/output/element_states.hpp"

#include <cmath>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::element_states_test {
namespace {

using results::ElementStress;
using results::WeldForce;

RunSettings small_steps(std::uint64_t cycles = 0) {
  RunSettings settings;
  settings.step.greatest_step = 1e-4;
  settings.cycles = cycles;
  return settings;
}

std::vector<ElementStress> stresses_of(const std::string& deck) {
  RunScene scene(deck + "*DATABASE_ELOUT\n0.1\n*CONTROL_TERMINATION\n1.\n", small_steps(1));
  std::vector<ElementStress> list;
  EXPECT_TRUE(scene.prepared()) << scene.message();
  if (!scene.prepared()) return list;
  scene.go([&](const solver::Run& run) {
    if (list.empty()) list = element_stresses(run, ElementPlaces(run.model(), run.stepper().structure()));
  });
  return list;
}

// The stresses that the elements begin with, their effective stress and strain. A shell turned by a quarter about z has
// its own x along y; with EOCS = 1 its stresses stay in its axes.
TEST(ElementStresses, WhatTheMaterialHas) {
  const std::string solid = brick_bar(1, {1, 1, 1}) + elastic_deck(solid_section, 1000, 0.3, 2) +
                            "*INITIAL_STRESS_SOLID\n1,1\n8.,2.,1.,3.,0.,0.,0.\n*DATABASE_HISTORY_SOLID\n1\n";
  const std::string shell =
      "*NODE\n101,0.,0.,5.\n102,0.,1.,5.\n103,-1.,1.,5.\n104,-1.,0.,5.\n*ELEMENT_SHELL\n20,2,101,102,103,104\n*"
      "PART\ns\n2,2,1\n"
      "*SECTION_SHELL\n2,2,0.8333333333,2\n0.1\n*INITIAL_STRESS_SHELL\n20,1,2\n-0.57735027,4.,7.,0.,0.,0.,0.,0.\n"
      "0.57735027,5.,6.,0.,0.,0.,0.,0.\n*DATABASE_HISTORY_SHELL_ID\n20\n";
  for (const bool local : {false, true}) {
    const auto list = stresses_of(solid + shell + (local ? "*CONTROL_OUTPUT\n\n,,,,,,,1\n" : ""));
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].id, 1);
    EXPECT_EQ(list[0].part, 1);
    ASSERT_EQ(list[0].points.size(), 1u);
    EXPECT_EQ(list[0].points[0].stress, (std::array<double, 6>{8, 2, 1, 3, 0, 0}));
    EXPECT_NEAR(list[0].points[0].effective, std::sqrt((36. + 1 + 49) / 2 + 27), 1e-12);
    EXPECT_FALSE(list[0].points[0].plastic);
    EXPECT_EQ(list[1].id, 20);
    ASSERT_EQ(list[1].points.size(), 2u);
    EXPECT_EQ(list[1].layers, 2u);
    // The deck gives them in global axes (the default of *INITIAL_STRESS_SHELL), or the shell's: either is a right
    // angle away from the other.
    const double x = list[1].points[0].stress[0], y = list[1].points[0].stress[1];
    EXPECT_NEAR(x + y, 11, 1e-12);
    EXPECT_NEAR(std::abs(x - y), 3, 1e-12);
  }
  const double global = stresses_of(solid + shell)[1].points[0].stress[0];
  const double local = stresses_of(solid + shell + "*CONTROL_OUTPUT\n\n,,,,,,,1\n")[1].points[0].stress[0];
  EXPECT_NEAR(global + local, 11, 1e-12) << "what is x in one is y in the other";
}

// A truss and an integrated beam, stretched by a given velocity: the axial force is the stress times the area.
TEST(ElementStresses, Beams) {
  RunScene scene(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,1.,0.\n4,1.,1.,0.\n5,0.,5.,0.\n*ELEMENT_BEAM\n1,1,1,2\n2,2,3,4,5\n*"
      "PART\nt\n1,1,1\n*PART\nb\n"
      "2,2,1\n*SECTION_BEAM\n1,3\n0.2\n*SECTION_BEAM\n2,1,1.,2,0.\n0.5,0.5,0.5,0.5\n*MAT_ELASTIC\n1,2.,1000.,0.3\n"
      "*SET_NODE_LIST\n1\n1,3\n*SET_NODE_LIST\n2\n2,4\n*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n*BOUNDARY_SPC_SET\n2,0,0,1,"
      "1,1,1,1\n"
      "*DEFINE_CURVE\n1\n0.,0.1\n1.,0.1\n*BOUNDARY_PRESCRIBED_MOTION_SET\n2,1,0,1\n*DATABASE_HISTORY_BEAM\n1,2\n"
      "*DATABASE_ELOUT\n0.1\n*CONTROL_TERMINATION\n0.1\n",
      small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  std::vector<ElementStress> last;
  scene.go([&](const solver::Run& run) {
    last = element_stresses(run, ElementPlaces(run.model(), run.stepper().structure()));
  });
  ASSERT_EQ(last.size(), 2u);
  const double strain = std::log(1 + 0.1 * scene.state().time);
  EXPECT_NEAR(last[0].resultants[0], 1000 * 0.2 * strain, 1e-6);
  EXPECT_TRUE(last[0].points.empty());
  ASSERT_FALSE(last[1].points.empty());
  double sum = 0;
  for (const results::StressRow& point : last[1].points)
    sum += point.stress[0] / static_cast<double>(last[1].points.size());
  EXPECT_NEAR(last[1].resultants[0], sum * 0.25, 1e-9) << "four points of one weight";
  EXPECT_NEAR(sum, 1000 * strain, 1e-5);
  for (std::size_t k = 1; k < 6; ++k) EXPECT_NEAR(last[1].resultants[k], 0, 1e-9);
}

// Links: of two masses under a force on one of them, the other one's inertia; of two coincident nodes the force that
// shears them; after its time a weld carries nothing. The failed one says when.
TEST(Welds, Links) {
  RunScene scene(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,5.,0.\n4,0.,5.,0.\n5,0.,9.,0.\n6,1.,9.,0.\n*ELEMENT_MASS\n1,1,2.\n2,2,3.\n3,"
      "3,2.\n4,4,2.\n"
      "5,5,1.\n6,6,1.\n*CONSTRAINED_SPOTWELD_ID\n71\n1,2\n72\n3,4\n73\n5,6,0.,0.,0.,0.,0.01\n*DEFINE_CURVE\n1\n0.,1."
      "\n1.,1.\n"
      "*LOAD_NODE_POINT\n1,1,1,-5.\n3,2,1,4.\n4,2,1,-4.\n5,1,1,-2.\n6,1,1,2.\n*DATABASE_SWFORC\n0.01\n"
      "*CONTROL_TERMINATION\n0.02\n",
      small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  WeldForces welds(scene.run());
  EXPECT_FALSE(welds.empty());
  bool checked = false;
  scene.go([&](const solver::Run& run) {
    welds.advance(run);
    const std::vector<WeldForce> list = welds.states(run);
    ASSERT_EQ(list.size(), 3u);
    EXPECT_NEAR(list[0].axial, 3, 1e-10);
    EXPECT_NEAR(list[0].shear, 0, 1e-10);
    EXPECT_NEAR(list[1].axial, 0, 1e-10);
    EXPECT_NEAR(list[1].shear, 4, 1e-10);
    const bool holds = run.stepper().state().time < 0.01;
    EXPECT_NEAR(list[2].axial, holds ? 2 : list[2].axial, 1e-10);
    if (run.stepper().state().time > 0.0105) {
      EXPECT_TRUE(list[2].failed);
      EXPECT_EQ(list[2].axial, 0);
      EXPECT_NEAR(list[2].failure_time, 0.01, 1e-4 + 1e-12);
      checked = true;
    }
  });
  EXPECT_TRUE(checked);
}

// A brick of material 100 between held and pulled nodes: σ A in tension, and its height.
TEST(Welds, Brick) {
  RunScene scene(
      grid_nodes(1, 1, 1, {0.4, 0.5, 0.25}) +
          "*ELEMENT_SOLID\n9,1,1,2,4,3,5,6,8,7\n*PART\nw\n1,1,1\n*SECTION_SOLID\n1,1\n*MAT_SPOTWELD\n1,2.,1000.,0.,1e9,"
          "0.\n\n"
          "*SET_NODE_LIST\n1\n1,2,3,4\n*SET_NODE_LIST\n2\n5,6,7,8\n*BOUNDARY_SPC_SET\n1,0,1,1,1\n"
          "*BOUNDARY_SPC_SET\n2,0,1,1\n*DEFINE_CURVE\n1\n0.,0.01\n1.,0.01\n*BOUNDARY_PRESCRIBED_MOTION_SET\n2,3,0,1\n"
          "*CONTROL_BULK_VISCOSITY\n1e-12,1e-12\n*DATABASE_SWFORC\n0.01\n*CONTROL_TERMINATION\n0.1\n",
      small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  WeldForces welds(scene.run());
  std::vector<WeldForce> last;
  scene.go([&](const solver::Run& run) { last = welds.states(run); });
  ASSERT_EQ(last.size(), 1u);
  EXPECT_EQ(last[0].kind, WeldForce::Kind::solid);
  EXPECT_EQ(last[0].id, 9);
  const double stretch = 1 + 0.01 * scene.state().time / 0.25;
  EXPECT_NEAR(last[0].axial, 1000 * std::log(stretch) * 0.4 * 0.5, 1e-4 * last[0].axial);
  EXPECT_NEAR(last[0].shear, 0, 1e-9);
  EXPECT_NEAR(last[0].length, 0.25 * stretch, 1e-9);
}

}  // namespace
}  // namespace gapcheck::solver::element_states_test
