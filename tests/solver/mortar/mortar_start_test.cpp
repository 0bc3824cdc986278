// Penetrations at the start of mortar contacts: IGNORE 0 to 4, MPAR1, MPAR2 against the closed form of the pressure
// law.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/mortar/mortar_law.hpp"
#include "solver/mortar/mortar_scene.hpp"

namespace gapcheck::solver::mortar_start_test {
namespace {

RunSettings until(double time) {
  RunSettings settings;
  settings.until = time;
  return settings;
}

// Sheets 0.1 thick whose mid-surfaces are 0.07 apart; SLSFAC so small that the step does not bound the stiffness.
constexpr double overlap = 0.03, slsfac = 1e-6, young = 1000, poisson = 0.25;
constexpr double bulk = young / (3 * (1 - 2 * poisson)), area = 0.8 * 0.7;
constexpr MortarLaw law{slsfac * bulk / 0.1, MortarLaw::relative_knee * 0.1};

/// The lower sheet is held, the upper one moves in z by a curve, in this deck not at all.
std::string sheets(const std::string& card_c, const std::string& curve = "0.,0.\n100.,0.\n") {
  const MortarSheet lower{1, 4, 4, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.1, 1};
  const MortarSheet upper{2, 3, 3, {0.1, 0.1, 0.1 - overlap}, {0.8, 0, 0}, {0, 0.7, 0}, 0.1, 2};
  std::string held;
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i) held += fmt::format("{}\n", lower.id(i, j));
  return lower.mesh() + upper.mesh() +
         fmt::format("*MAT_ELASTIC\n1,1.,{0},{1}\n*MAT_RIGID\n2,1.,{0},{1}\n1.,4.,7.\n", young, poisson) +
         "*SET_NODE_LIST\n1\n" + held + "*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n*DEFINE_CURVE\n1\n" + curve +
         "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,3,2,1\n*CONTROL_TERMINATION\n10.\n" +
         fmt::format("*CONTROL_CONTACT\n{}\n", slsfac) +
         "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n2,1,3,3\n0.\n1.,1.\n\n\n" + card_c;
}

/// Force on the upper sheet over the run.
std::vector<std::array<double, 2>> forces(const std::string& deck, double end) {
  RunScene scene(deck, until(end));
  EXPECT_TRUE(scene.prepared()) << scene.message();
  std::vector<std::array<double, 2>> found;
  if (!scene.prepared()) return found;
  scene.go([&](const solver::Run& run) {
    found.push_back({run.stepper().state().time, run.contacts()[0].state().force_a.z()});
  });
  return found;
}

TEST(MortarStart, PenetrationIsForgiven) {
  for (const std::string ignore : {"0", "1", "2"})
    for (const auto& [time, force] : forces(sheets("1," + ignore), 0.2)) EXPECT_EQ(force, 0) << ignore;
}

TEST(MortarStart, Mpar1IsAPressureAtTheStart) {
  constexpr double pressure = 1e-5;
  for (const std::string ignore : {"0", "2"})
    for (const auto& [time, force] : forces(sheets("1," + ignore + ",1e-5"), 0.2))
      EXPECT_NEAR(force, pressure * area, 1e-10 * pressure);
}

TEST(MortarStart, PenetrationIsPressedOutInTheTimeMpar1) {
  for (const std::string ignore : {"3", "4"}) {
    int during = 0, after = 0;
    for (const auto& [time, force] : forces(sheets("1," + ignore + ",0.2,0.05"), 0.3)) {
      const double depth = overlap * std::min(1.0, time / 0.2);
      EXPECT_NEAR(force, law.pressure(depth) * area, 1e-10 * law.pressure(overlap)) << time;
      (time < 0.2 ? during : after) += 1;
    }
    EXPECT_GT(during, 5);
    EXPECT_GT(after, 5);
  }
}

/// Up by 0.02 and back; then 0.01 deeper than at the start.
const std::string up_and_down = "0.,0.\n0.2,0.02\n0.4,0.\n0.6,-0.01\n10.,-0.01\n";

TEST(MortarStart, Ignore1GivesTheThicknessBack) {
  int deeper = 0;
  double lowest = overlap;
  double height = 0;
  for (const auto& [time, force] : forces(sheets("1,1", up_and_down), 0.7)) {
    height = time < 0.2 ? 0.1 * time : time < 0.4 ? 0.04 - 0.1 * time : time < 0.6 ? 0.02 - 0.05 * time : -0.01;
    const double depth = overlap - height;
    EXPECT_NEAR(force, law.pressure(depth - lowest) * area, 2e-3 * law.pressure(overlap) * area) << time;
    lowest = std::min(lowest, depth);
    deeper += time > 0.65;
  }
  EXPECT_GT(deeper, 3);
  EXPECT_NEAR(lowest, overlap - 0.02, 1e-3);
}

TEST(MortarStart, Ignore2KeepsTheThinnerSurface) {
  for (const auto& [time, force] : forces(sheets("1,2", up_and_down), 0.7)) {
    if (time < 0.4) {
      EXPECT_EQ(force, 0) << time;
    }
    if (time > 0.65) {
      EXPECT_NEAR(force, law.pressure(0.01) * area, 1e-9 * law.pressure(0.01)) << time;
    }
  }
}

// Blocks that overlap by more than a solid holds: without MPAR2 there is no contact, with it there is.
TEST(MortarStart, Mpar2AllowsLargePenetrations) {
  const MortarBlock lower{1, {2, 2, 4}, {0, 0, 0}, {1, 1, 1}, 0, 1}, upper{2, {2, 2, 4}, {0, 0, 0.7}, {1, 1, 1}, 0, 1};
  const std::string deck =
      lower.mesh() + upper.mesh() + "*MAT_ELASTIC\n1,1.,1000.,0.\n*CONTROL_TERMINATION\n2.\n*SET_SEGMENT\n11\n" +
      lower.faces(true) + "*SET_SEGMENT\n12\n" + upper.faces(false) +
      "*DAMPING_GLOBAL\n0,5.\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n12,11\n0.\n1.,1.\n\n\n";
  for (const bool large : {false, true}) {
    RunScene scene(deck + (large ? "1,4,1.,0.35" : "1,3,1."), until(2));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    std::string told;
    scene.go([&](const solver::Run& run) {
      for (const ContactEvent& event : run.events()) told += event.text;
    });
    EXPECT_EQ(told.find("deeper in each other than they are held = 4") == std::string::npos, large) << told;
    double gap = 0;
    for (std::size_t i = 0; i < 9; ++i) gap += (scene.state().x[45 + i].z() - scene.state().x[36 + i].z()) / 9;
    if (large) {
      EXPECT_GT(gap, -0.03) << "pressed out";
    } else {
      EXPECT_NEAR(gap, -0.3, 1e-9) << "no contact";
    }
  }
}

}  // namespace
}  // namespace gapcheck::solver::mortar_start_test
