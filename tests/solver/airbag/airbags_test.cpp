#include "solver/airbag/airbags.hpp"

#include <cmath>

#include "solver/conditioned.hpp"

namespace gapcheck::solver::airbags_test {
namespace {

/// A box of 2 x 3 x 5 without elements: masses of 4 at its corners, of which the lower ones are held and the upper
/// ones move along z.
const std::string piston =
    "*NODE\n1,0.,0.,0.\n2,2.,0.,0.\n3,2.,3.,0.\n4,0.,3.,0.\n5,0.,0.,5.\n6,2.,0.,5.\n7,2.,3.,5.\n8,0.,3.,5.\n"
    "*ELEMENT_MASS\n1,1,4.\n2,2,4.\n3,3,4.\n4,4,4.\n5,5,4.\n6,6,4.\n7,7,4.\n8,8,4.\n"
    "*SET_NODE_LIST\n1\n1,2,3,4\n*SET_NODE_LIST\n2\n5,6,7,8\n*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n"
    "*BOUNDARY_SPC_SET\n2,0,1,1,0,1,1,1\n";
const std::string outward = "*SET_SEGMENT\n9\n1,4,3,2\n5,6,7,8\n1,2,6,5\n2,3,7,6\n3,4,8,7\n4,1,5,8\n";
const std::string box = piston + outward;
const std::string moving = "*INITIAL_VELOCITY_NODE\n5,0.,0.,-9.\n6,0.,0.,-9.\n7,0.,0.,-9.\n8,0.,0.,-9.\n";
const std::string air = "*AIRBAG_SIMPLE_AIRBAG_MODEL\n9\n700.,980.,0.,0,0.,0.,100.,1.2\n0\n";

struct Scene {
  Stepper stepper;
  const Airbags* airbags;
};

Scene scene(const std::string& deck, double step, double energy_tolerance = 1e-9) {
  Conditioned result = good(deck);
  const Airbags* airbags = nullptr;
  for (const auto& force : result.forces)
    if (const auto* found = dynamic_cast<const Airbags*>(force.get())) airbags = found;
  EXPECT_NE(airbags, nullptr) << result.warnings;
  StepSettings settings = fixed_step(step);
  settings.energy_tolerance = energy_tolerance;
  return {std::move(result).stepper(settings), airbags};
}

// The gas is pressed together by the moving side and throws it back: its pressure follows p V^k, the side feels what is
// above the ambient pressure, and the work it gets is what the gas loses, less that of the ambient pressure.
TEST(Airbags, AdiabaticPiston) {
  Scene run = scene(box + moving + air, 1e-3);
  double least = 30;
  bool back = false;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(run.stepper.step().ok());
    const AirbagState& now = run.airbags->states().at(0);
    const double height = run.stepper.state().x[4].z() - run.stepper.state().dt * run.stepper.state().v[4].z();
    EXPECT_NEAR(now.volume, 6 * height, 1e-11);
    EXPECT_NEAR(now.pressure, 100 * std::pow(30 / now.volume, 1.4), 1e-9 * now.pressure);
    EXPECT_NEAR(run.stepper.net().force[4].z(), (now.pressure - 100) * 6 / 4, 1e-9 * now.pressure);
    EXPECT_NEAR(now.mass, 36, 1e-12);
    const double lost = 100 * 30 / 0.4 - now.energy;
    EXPECT_NEAR(run.stepper.energies().external, lost - 100 * (now.volume - 30), 0.02);
    least = std::min(least, now.volume);
    back = back || run.stepper.state().v[4].z() > 5;
  }
  EXPECT_NEAR(run.stepper.energies().ratio(), 1, 1e-9);
  EXPECT_TRUE(back);
  // At rest the kinetic energy 16 v²/2 is in the gas and in the atmosphere.
  const auto taken = [](double volume) {
    return 100 * 30 / 0.4 * (std::pow(30 / volume, 0.4) - 1) + 100 * (volume - 30);
  };
  EXPECT_NEAR(taken(least), 8 * 81, 0.5);
  EXPECT_LT(least, 20);
}

// All corners free: what the gas does to them has no resultant, and it blows the box up.
TEST(Airbags, FreeBoxKeepsItsMomentum) {
  std::string deck = box.substr(0, box.find("*SET_NODE_LIST")) + outward;
  Scene run = scene(deck +
                        "*AIRBAG_SIMPLE_AIRBAG_MODEL_ID\n77,bag\n9\n700.,980.,300.,3,0.,0.,100.,1.2\n0\n"
                        "*DEFINE_CURVE\n3\n0.,2.\n1.,2.\n",
                    1e-3);
  for (int i = 0; i < 300; ++i) ASSERT_TRUE(run.stepper.step().ok());
  Vector momentum = Vector::Zero();
  for (const Vector& v : run.stepper.state().v) momentum += 4 * v;
  EXPECT_NEAR(momentum.norm(), 0, 1e-9);
  EXPECT_GT(run.airbags->states()[0].volume, 40);
  EXPECT_GT(run.stepper.energies().external, 0);
  EXPECT_NEAR(run.stepper.energies().ratio(), 1, 1e-9);
  EXPECT_NEAR(run.airbags->states()[0].rate_in, 2, 1e-9);
  EXPECT_NEAR(run.airbags->states()[0].mass, 36 + 2 * 0.299, 1e-9);
}

TEST(Airbags, PressureByVolume) {
  Scene run = scene(box + moving + "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n9,0,0,0.,2.\n40.,0.5\n", 1e-3);
  for (int i = 0; i < 300; ++i) {
    ASSERT_TRUE(run.stepper.step().ok());
    const AirbagState& now = run.airbags->states()[0];
    EXPECT_NEAR(now.pressure, 20 * 30 / now.volume, 1e-10);
    EXPECT_NEAR(run.stepper.net().force[6].z(), 2 * now.pressure * 6 / 4, 1e-9);
    EXPECT_EQ(now.mass, 0);
  }
  EXPECT_NEAR(run.stepper.energies().ratio(), 1, 1e-9);
}

TEST(Airbags, PressureByCurves) {
  const std::string curve = "*DEFINE_CURVE\n3\n0.,90.\n0.5,70.\n1.,30.\n2.,10.\n";
  Scene run = scene(box + moving + "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n9\n0.,0.,3\n" + curve, 1e-3);
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(run.stepper.step().ok());
  const AirbagState& now = run.airbags->states()[0];
  EXPECT_LT(now.volume, 25);
  EXPECT_NEAR(now.pressure, 30 + 80 * (1 - now.volume / 30), 1e-10);
  Scene timed = scene(box + moving + "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n9\n-3.,2.\n" + curve, 1e-3);
  for (int i = 0; i < 251; ++i) ASSERT_TRUE(timed.stepper.step().ok());
  const AirbagState& later = timed.airbags->states()[0];
  EXPECT_NEAR(later.pressure, 2 * 80 * 30 / later.volume, 1e-9);
}

// VSCA and VINI make the gas's volume of that of the surface, PSCA the surface's pressure of that of the gas.
TEST(Airbags, ScalesAndTheExcludedVolume) {
  Scene run =
      scene(box + moving + "*AIRBAG_SIMPLE_AIRBAG_MODEL\n9,0,0,2.,3.,10.\n700.,980.,0.,0,0.,0.,100.,1.2\n0\n", 1e-3);
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(run.stepper.step().ok());
  const AirbagState& now = run.airbags->states()[0];
  const double height = run.stepper.state().x[4].z() - run.stepper.state().dt * run.stepper.state().v[4].z();
  EXPECT_NEAR(now.volume, 2 * 6 * height - 10, 1e-11);
  EXPECT_NEAR(now.pressure, 100 * std::pow(50 / now.volume, 1.4), 1e-9);
  EXPECT_NEAR(run.stepper.net().force[4].z(), 3 * (now.pressure - 100) * 6 / 4, 1e-9);
  EXPECT_NEAR(now.density * now.volume, 1.2 * 50, 1e-10);
  EXPECT_NEAR(now.temperature * now.density * 280, now.pressure, 1e-9);
}

// ω² = k p / V Σ |∂V/∂x|² / m: the step is bounded by it, and stable there.
TEST(Airbags, StableStep) {
  Scene run = scene(box + moving + air, 10, 0.1);
  ASSERT_TRUE(run.stepper.step().ok());
  const double sum = 8 * (15 * 15 + 10 * 10 + 6 * 6) / 16.0 / 4;
  EXPECT_NEAR(run.airbags->stable_step(), std::sqrt(0.76 / (1.4 * 100 / 30 * sum)), 1e-12);
  for (int i = 0; i < 3000; ++i) {
    const SolverStatus status = run.stepper.step();
    ASSERT_TRUE(status.ok()) << i << ": " << status.error().message;
  }
  EXPECT_NEAR(run.stepper.energies().ratio(), 1, 0.02);  // each fall of the step costs a little
  EXPECT_LT(run.stepper.energies().kinetic, 1.1 * 8 * 81);
}

// The box as shells of a rigid part: gas inside moves nothing.
TEST(Airbags, PartSet) {
  const std::string shells =
      "*NODE\n1,0.,0.,0.\n2,2.,0.,0.\n3,2.,3.,0.\n4,0.,3.,0.\n5,0.,0.,5.\n6,2.,0.,5.\n7,2.,3.,5.\n8,0.,3.,5.\n"
      "*ELEMENT_SHELL\n1,1,1,4,3,2\n2,1,5,6,7,8\n3,1,1,2,6,5\n4,1,2,3,7,6\n5,2,3,4,8,7\n6,2,4,1,5,8\n"
      "*PART\na\n1,1,1\n*PART\nb\n2,1,2\n*SECTION_SHELL\n1,2\n0.1\n*MAT_RIGID\n1,1.,1000.,0.3\n*MAT_RIGID\n2,1.,1000.,"
      "0.3\n"
      "*CONSTRAINED_RIGID_BODIES\n1,2\n*SET_PART_LIST\n9\n1,2\n";
  Scene run = scene(shells + "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n9,1\n40.,1.\n", 1e-3);
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(run.stepper.step().ok());
  EXPECT_NEAR(run.airbags->states()[0].volume, 30, 1e-12);
  EXPECT_NEAR(run.airbags->states()[0].area, 62, 1e-12);
  for (const Vector& v : run.stepper.state().v) EXPECT_NEAR(v.norm(), 0, 1e-12);
  EXPECT_GT(run.airbags->stable_step(), 1e3);
}

TEST(Airbags, ASideThatPassesTheOtherOne) {
  const std::string fast = "*INITIAL_VELOCITY_NODE\n5,0.,0.,-9e4\n6,0.,0.,-9e4\n7,0.,0.,-9e4\n8,0.,0.,-9e4\n";
  Scene run = scene(box + fast + air, 1e-3);
  SolverStatus status;
  for (int i = 0; i < 3 && status.ok(); ++i) status = run.stepper.step();
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("volume of airbag 1"), std::string::npos) << status.error().message;
}

struct BadAirbag {
  const char* name;
  std::string deck;
  Failure::Kind kind;
  const char* says;
};

class BadAirbagCard : public testing::TestWithParam<BadAirbag> {};

TEST_P(BadAirbagCard, IsNamed) {
  const Conditioned result = conditioned(GetParam().deck);
  ASSERT_FALSE(result.status.ok());
  EXPECT_EQ(result.status.error().kind, GetParam().kind) << result.status.error().message;
  EXPECT_NE(result.status.error().message.find(GetParam().says), std::string::npos) << result.status.error().message;
  EXPECT_NE(result.status.error().message.find("AIRBAG_SIMPLE"), std::string::npos) << result.status.error().message;
  EXPECT_GT(result.status.error().place.line, 0u);
}

using FailureKind = Failure::Kind;

std::string gas_bag(const std::string& card, const std::string& first = "9") {
  return box + "*AIRBAG_SIMPLE_AIRBAG_MODEL\n" + first + "\n" + card +
         "\n*DEFINE_CURVE\n3\n0.,1.\n1.,2.\n*DEFINE_CURVE\n4\n0.,1.\n1.,-2.\n*DEFINE_CURVE\n5\n0.,1.\n0.,2.\n";
}
std::string pressure_bag(const std::string& card, const std::string& first = "9") {
  return gas_bag("700.,980.,0.,0,0.,0.,100.,1.2\n0") + "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n" + first + "\n" + card + "\n";
}
std::string surface_bag(const std::string& segments) { return piston + "*SET_SEGMENT\n9\n" + segments + air; }

INSTANTIATE_TEST_SUITE_P(
    All, BadAirbagCard,
    testing::Values(
        BadAirbag{"no_set", gas_bag("700.,980.,0.,0,0.,0.,100.,1.2", "7"), FailureKind::unknown_reference,
                  "segment set 7"},
        BadAirbag{"no_part_set", gas_bag("700.,980.,0.,0,0.,0.,100.,1.2", "7,1"), FailureKind::unknown_reference,
                  "part set 7"},
        BadAirbag{"sensor", gas_bag("700.,980.,0.,0,0.,0.,100.,1.2", "9,0,-5"), FailureKind::not_calculated, "RBID"},
        BadAirbag{"damping", gas_bag("700.,980.,0.,0,0.,0.,100.,1.2", "9,0,0,0.,0.,0.,1."), FailureKind::not_calculated,
                  "MWD"},
        BadAirbag{"stagnation", gas_bag("700.,980.,0.,0,0.,0.,100.,1.2", "9,0,0,0.,0.,0.,0.,1."),
                  FailureKind::not_calculated, "SPSF"},
        BadAirbag{"volume_scale", gas_bag("700.,980.,0.,0,0.,0.,100.,1.2", "9,0,0,-1."), FailureKind::contradiction,
                  "VSCA is -1"},
        BadAirbag{"pressure_scale", gas_bag("700.,980.,0.,0,0.,0.,100.,1.2", "9,0,0,0.,-1."),
                  FailureKind::contradiction, "PSCA is -1"},
        BadAirbag{"excluded_volume", gas_bag("700.,980.,0.,0,0.,0.,100.,1.2", "9,0,0,0.,0.,31."),
                  FailureKind::contradiction, "is -1; it must be above zero"},
        BadAirbag{"no_card", gas_bag(""), FailureKind::not_calculated, "CV = 0"},
        BadAirbag{"molar", gas_bag("0.,0.,300.,3,0.,0.,100.,1.2\n0,300.,29.,0.,0.028,8.3"), FailureKind::not_calculated,
                  "CV = 0"},
        BadAirbag{"negative_capacity", gas_bag("-700.,980.,0.,0,0.,0.,100.,1.2"), FailureKind::contradiction,
                  "CV is -700"},
        BadAirbag{"capacities", gas_bag("980.,700.,0.,0,0.,0.,100.,1.2"), FailureKind::contradiction, "CP is 700"},
        BadAirbag{"ambient_pressure", gas_bag("700.,980.,0.,0,0.,0.,-100.,1.2"), FailureKind::contradiction, "PE"},
        BadAirbag{"ambient_density", gas_bag("700.,980.,0.,0,0.,0.,100.,-1.2"), FailureKind::contradiction, "RO"},
        BadAirbag{"no_density", gas_bag("700.,980.,0.,0,0.,0.,100.,0."), FailureKind::contradiction, "RO is 0"},
        BadAirbag{"no_temperature", gas_bag("700.,980.,0.,3,0.,0.,100.,1.2"), FailureKind::contradiction, "T is 0"},
        BadAirbag{"no_curve", gas_bag("700.,980.,300.,99,0.,0.,100.,1.2"), FailureKind::unknown_reference, "curve 99"},
        BadAirbag{"sucking_inflow", gas_bag("700.,980.,300.,4,0.,0.,100.,1.2"), FailureKind::contradiction, "LCID"},
        BadAirbag{"exit_curve", gas_bag("700.,980.,300.,3,0.,0.,100.,1.2\n99"), FailureKind::unknown_reference,
                  "curve 99 (LOU)"},
        BadAirbag{"two_exits", gas_bag("700.,980.,300.,3,0.7,0.1,100.,1.2\n3"), FailureKind::contradiction, "LOU"},
        BadAirbag{"area_curve", gas_bag("700.,980.,300.,3,0.7,-4.,100.,1.2"), FailureKind::contradiction,
                  "curve 4 (AREA)"},
        BadAirbag{"shape_curve", gas_bag("700.,980.,300.,3,-5.,1.,100.,1.2"), FailureKind::contradiction,
                  "curve 5 (MU)"},
        BadAirbag{"no_law", pressure_bag("0.,1."), FailureKind::contradiction, "CN is 0"},
        BadAirbag{"no_factor", pressure_bag("40.,0."), FailureKind::contradiction, "BETA is 0"},
        BadAirbag{"no_volume_curve", pressure_bag("0.,0.,98"), FailureKind::unknown_reference, "curve 98"},
        BadAirbag{"no_time_curve", pressure_bag("-98.,1."), FailureKind::unknown_reference, "curve 98"},
        BadAirbag{"open", surface_bag("1,4,3,2\n1,2,6,5\n2,3,7,6\n3,4,8,7\n4,1,5,8\n"), FailureKind::contradiction,
                  "4 edges of its surface, the first between the nodes 5 and 6"},
        BadAirbag{"mixed", surface_bag("1,2,3,4\n5,6,7,8\n1,2,6,5\n2,3,7,6\n3,4,8,7\n4,1,5,8\n"),
                  FailureKind::contradiction, "same side out"},
        BadAirbag{"inward", surface_bag("1,2,3,4\n5,8,7,6\n1,5,6,2\n2,6,7,3\n3,7,8,4\n4,8,5,1\n"),
                  FailureKind::contradiction, "its volume is -30: the normals of its segments point inward"},
        BadAirbag{"flat", surface_bag("1,2,3,4\n1,4,3,2\n"), FailureKind::contradiction, "above zero"},
        BadAirbag{"relaxation", gas_bag("700.,980.,0.,0,0.,0.,100.,1.2") + "*CONTROL_DYNAMIC_RELAXATION\n,,,,,,,1\n",
                  FailureKind::not_calculated, "dynamic relaxation"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Airbags, WithoutSegmentsItDoesNothing) {
  const Conditioned result = good(piston +
                                  "*SET_PART_LIST\n9\n5\n*AIRBAG_SIMPLE_AIRBAG_MODEL\n9,1\n700.,980.,0.,0,0.,0."
                                  ",100.,1.2\n0\n");
  EXPECT_TRUE(result.forces.empty());
  EXPECT_NE(result.warnings.find("airbag 1 has no segments; it does nothing"), std::string::npos) << result.warnings;
}

}  // namespace
}  // namespace gapcheck::solver::airbags_test
