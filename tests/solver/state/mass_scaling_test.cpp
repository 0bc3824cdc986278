#include "solver/state/mass_scaling.hpp"

#include <gtest/gtest.h>

#include "solver/run_scene.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::mass_scaling_test {
namespace {

double total_mass(const Structure& structure) {
  double sum = 0;
  for (const double mass : structure.state.mass) sum += mass;
  return sum;
}

double first_step(Structure structure) {
  StepSettings settings;
  settings.time_step_factor = 0.9;
  Stepper stepper(std::move(structure), settings);
  EXPECT_TRUE(stepper.begin_step().ok());
  return stepper.next_step();
}

std::string scaled(const std::string& deck, double dt2ms) {
  return deck + fmt::format("*CONTROL_TIMESTEP\n0.,0.9,0,0.,{}\n", dt2ms);
}

// A row of bricks, the first of them a tenth as long: with DT2MS below zero it alone gets mass, so much that its step
// is TSSFAC |DT2MS|.
TEST(MassScaling, NegativeScalesShortElementsOnly) {
  std::string deck = brick_bar(3, {1, 1, 1}) + elastic_deck(solid_section, 1000, 0, 7);
  for (const std::string corner : {"\n1,0,0,0", "\n5,0,1,0", "\n9,0,0,1", "\n13,0,1,1"}) {
    const std::size_t zero = deck.find(corner) + corner.find(',') + 1;
    deck.replace(zero, 1, "0.9");
  }
  const Structure plain = structure_of(deck);
  const double own = first_step(plain);
  for (const double factor : {2.0, 3.5}) {
    const double target = factor * own / 0.9;
    const Structure heavy = structure_of(scaled(deck, -target));
    EXPECT_NEAR(first_step(heavy), 0.9 * target, 1e-12);
    EXPECT_NEAR(total_mass(heavy), total_mass(plain) + heavy.added_mass, 1e-12);
    EXPECT_GT(heavy.added_mass, 0);
    EXPECT_EQ(heavy.state.mass[3], plain.state.mass[3]);  // of the last brick, which is long enough
  }
  EXPECT_EQ(structure_of(scaled(deck, -own / 0.9 / 2)).added_mass, 0);
}

// DT2MS above zero gives every element the same step: the mass of a regular plate changes by the square.
TEST(MassScaling, PositiveScalesAll) {
  const std::string deck = plate(3, 2, {0.5, 0.4, 0}) + elastic_deck(shell_section, 1000, 0.3, 7);
  const Structure plain = structure_of(deck);
  const double own = first_step(plain);
  for (const double factor : {0.5, 3.0}) {
    const Structure changed = structure_of(scaled(deck, factor * own / 0.9));
    EXPECT_NEAR(total_mass(changed), factor * factor * total_mass(plain), 1e-9 * total_mass(changed));
    EXPECT_NEAR(changed.state.inertia[0], factor * factor * plain.state.inertia[0], 1e-12);
    EXPECT_NEAR(first_step(changed), factor * own, 1e-12);
  }
}

/// A deck's end, with the nodes of set 2 moved by 0.5 against x in the time 1.
std::string pressed(const std::string& deck, const std::string& timestep) {
  return deck + "*BOUNDARY_PRESCRIBED_MOTION_SET\n2,1,2,9,-1.\n*DEFINE_CURVE\n9\n0.,0.\n1.,0.5\n2.,1.\n" +
         "*CONTROL_TERMINATION\n1.\n*CONTROL_TIMESTEP\n" + timestep + "\n";
}

// A truss that is pressed to half its length: its step falls with the length, so its mass grows with (L₀ / L)²,
// exactly. The new mass at the moving end comes with its energy.
TEST(MassScaling, GrowsDuringTheRun) {
  const std::string truss =
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,1.,0.\n*ELEMENT_BEAM\n1,1,1,2,3\n*PART\np\n1,1,1\n*SECTION_BEAM\n1,3\n0.25\n"
      "*MAT_ELASTIC\n1,4.,400.,0.3\n*SET_NODE_LIST\n2\n2\n*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n2,0,0,1,1,1,1,1\n";
  constexpr double mass = 4 * 0.25, target = 0.9 * 0.1;  // L / c
  for (const int ms1st : {0, 1}) {
    RunScene scene(pressed(truss, fmt::format("0.,0.9,0,0.,-0.1,0,0,{}", ms1st)));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double length = 0;
    scene.go([&](const solver::Run& run) {
      length = run.stepper().state().x[1].x();
      if (ms1st == 0) {
        EXPECT_NEAR(run.stepper().next_step(), target, 1e-9 * target);
      }
      EXPECT_NEAR(run.stepper().energies().ratio(), 1, 1e-9);
    });
    const double added = scene.run().stepper().structure().added_mass, grown = mass * (1 / (length * length) - 1);
    EXPECT_LT(length, 0.55);
    EXPECT_NEAR(added, ms1st == 0 ? grown : 0, 1e-9);
    EXPECT_NEAR(scene.state().mass[1], (mass + added) / 2, 1e-12);
    if (ms1st == 1) {
      EXPECT_LT(scene.run().stepper().next_step(), 0.6 * target);
    }
  }
}

// Bricks and shells keep their step, too, and lose no mass when they grow again; energies balance.
TEST(MassScaling, BricksAndShellsKeepTheirStep) {
  const std::string bricks = brick_bar(2, {1, 1, 1}) + elastic_deck(solid_section, 1000, 0.2, 7) +
                             "*SET_NODE_LIST\n2\n3,6,9,12\n*SET_NODE_LIST\n1\n1,4,7,10\n*BOUNDARY_SPC_SET\n1,0,1,1,1\n";
  const std::string shells = plate(2, 1, {1, 1, 0}) + elastic_deck(shell_section, 1000, 0.2, 7) +
                             "*SET_NODE_LIST\n2\n3,6\n*SET_NODE_LIST\n1\n1,4\n*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n";
  for (const std::string& deck : {bricks, shells}) {
    const double own = first_step(structure_of(deck)), target = 0.97 * own;
    RunScene scene(pressed(deck, fmt::format("0.,0.9,0,0.,{}", -target / 0.9)));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double before = 0;
    for (const double mass : scene.state().mass) before += mass;
    double added = 0;
    scene.go([&](const solver::Run& run) {
      EXPECT_GT(run.stepper().next_step(), target * 0.99);
      EXPECT_GE(run.stepper().structure().added_mass, added);
      added = run.stepper().structure().added_mass;
      EXPECT_NEAR(run.stepper().energies().ratio(), 1, 1e-2);
    });
    double after = 0;
    for (const double mass : scene.state().mass) after += mass;
    EXPECT_GT(added, 0.05 * before);
    EXPECT_NEAR(after, before + added, 1e-9 * after);
  }
}

// LCTM limits the step over time.
TEST(MassScaling, LimitOfTheStepByACurve) {
  RunScene scene(pressed(brick_bar(2, {1, 1, 1}) + elastic_deck(solid_section, 1000, 0.2, 7) +
                             "*SET_NODE_LIST\n2\n3,6,9,12\n*DEFINE_CURVE\n7\n0.,1e-3\n0.5,1e-3\n1.,1.\n",
                         "0.,0.9,0,0.,0.,7"));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double early = 0, late = 0;
  scene.go([&](const solver::Run& run) {
    double& most = run.stepper().state().time < 0.499 ? early : late;
    most = std::max(most, run.stepper().next_step());
  });
  EXPECT_NEAR(early, 1e-3, 1e-12);
  EXPECT_GT(late, 1e-2);
  for (const auto& [curve, expected] : {std::pair{"", "curve 7 (LCTM) is not defined"},
                                        {"*DEFINE_CURVE\n7\n0.,0.\n", "not above 0"},
                                        {"*DEFINE_CURVE\n7\n1.,1.\n0.,1.\n", "do not rise"}})
    EXPECT_NE(RunScene(pressed(brick_bar(2, {1, 1, 1}) + elastic_deck(solid_section, 1000, 0.2, 7) +
                                   "*SET_NODE_LIST\n2\n3,6,9,12\n" + curve,
                               "0.,0.9,0,0.,0.,7"))
                  .message()
                  .find(expected),
              std::string::npos)
        << expected;
}

}  // namespace
}  // namespace gapcheck::solver::mass_scaling_test
