// RIGID contacts: forces by curves over the penetration.
#include "solver/contact/curve_rule.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "solver/contact/contact_method.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::curve_rule_test {
namespace {

model::Curve curve(std::vector<std::array<double, 2>> points) {
  model::Curve made;
  made.points = std::move(points);
  return made;
}

TEST(CurveForce, UnloadsAlongTheCurveOrByItsStiffness) {
  const model::Curve loading = curve({{0, 0}, {1, 10}, {2, 40}}), unloading = curve({{0, 0}, {2, 8}});
  CurveForce force;
  force.loading = &loading;
  EXPECT_EQ(force.at(1.5, 0), 25);
  EXPECT_EQ(force.at(0.5, 2), 5) << "back along the curve";
  force.unloading_stiffness = 50;
  EXPECT_EQ(force.at(2, 2), 40);
  EXPECT_NEAR(force.at(1.8, 2), 40 - 50 * 0.2, 1e-12);
  EXPECT_EQ(force.at(0.5, 2), 0) << "not below zero";
  EXPECT_EQ(force.at(2.5, 2), 40) << "deeper than ever: the curve, constant beyond its end";
  force.unloading = &unloading;
  EXPECT_NEAR(force.at(1.8, 2), 30, 1e-12);
  EXPECT_EQ(force.at(0.5, 2), 2) << "not below UNLCID";
}

TEST(CurveForce, DampingByTheSpeed) {
  const model::Curve damping = curve({{0, 1}, {10, 3}});
  CurveForce force;
  force.damping = &damping;
  force.damping_scale = 2;
  EXPECT_EQ(force.damping_at(5), 4);
  EXPECT_EQ(force.damping_at(-5), 4);
}

/// A rigid cube of edge 1 and mass 8 that meets a fixed rigid plate in the plane z = 0 from above at speed 1.
std::string cube_on_plate(const std::string& keyword, const std::string& sides, const std::string& card,
                          const std::string& curves, double end = 4) {
  std::string deck = "*NODE\n";
  const auto corner = [&](int first, double size, double z) {
    return fmt::format("{},{},{},{}\n{},{},{},{}\n{},{},{},{}\n{},{},{},{}\n", first, -size, -size, z, first + 1, size,
                       -size, z, first + 2, size, size, z, first + 3, -size, size, z);
  };
  deck += corner(1, 2, 0) + corner(11, 0.5, 0.1) + corner(15, 0.5, 1.1);
  deck += "*ELEMENT_SHELL\n1,1,1,2,3,4\n*ELEMENT_SOLID\n2,2,11,12,13,14,15,16,17,18\n";
  deck += "*PART\nplate\n1,1,1\n*PART\ncube\n2,2,2\n*SECTION_SHELL\n1,2\n0.01\n*SECTION_SOLID\n2,1\n";
  deck += "*MAT_RIGID\n1,1.,1e4,0.3\n1.,7,7\n*MAT_RIGID\n2,8.,1e4,0.3\n1.,4,7\n";
  deck += "*INITIAL_VELOCITY_RIGID_BODY\n2,0.,0.,-1.\n*SET_NODE_LIST\n1\n11,12,13,14\n";
  deck += fmt::format("*CONTACT_{}\n{}\n0.\n1.,1.\n{}\n{}*CONTROL_TIMESTEP\n0.002,0.9\n*CONTROL_TERMINATION\n{}\n",
                      keyword, sides, card, curves, end);
  return deck;
}

struct Bounce {
  double deepest = 0, largest = 0, back = 0, ratio = 0;
};

Bounce bounce(const std::string& deck) {
  RunScene scene(deck);
  Bounce bounce;
  if (!scene.prepared()) {
    ADD_FAILURE() << scene.message();
    return bounce;
  }
  scene.go([&](const solver::Run& run) {
    bounce.deepest = std::max(bounce.deepest, -run.stepper().state().x[4].z());
    bounce.largest = std::max(bounce.largest, run.contacts().front().state().force_a.norm());
  });
  bounce.back = scene.state().v[4].z();
  bounce.ratio = scene.energies().ratio();
  return bounce;
}

const std::string one_way = "RIGID_BODY_ONE_WAY_TO_RIGID_BODY", nodes = "RIGID_NODES_TO_RIGID_BODY";
const std::string line = "*DEFINE_CURVE\n1\n0.,0.\n1.,50.\n";

/// Four nodes with F = 50 p each: depth v √(m/k), force v √(m k), and the speed back is that of the impact.
TEST(CurveContact, ReboundGivesBackWhatTheCurveStores) {
  for (const auto& [keyword, sides] : {std::pair(one_way, "2,1,3,3"), std::pair(nodes, "1,1,4,3")}) {
    const Bounce found = bounce(cube_on_plate(keyword, sides, "1,2", line));
    EXPECT_NEAR(found.deepest, std::sqrt(8.0 / 200), 1e-3) << keyword;
    EXPECT_NEAR(found.largest, std::sqrt(8.0 * 200), 0.1) << keyword;
    EXPECT_NEAR(found.back, 1, 1e-3) << keyword;
    EXPECT_NEAR(found.ratio, 1, 1e-4) << keyword;
  }
}

/// FCM = 3: the faces at a node of the cube have an area of 3/4, so each node carries 0.75 · 50 p.
TEST(CurveContact, PressureCountsWithTheArea) {
  const Bounce found = bounce(cube_on_plate(one_way, "2,1,3,3", "1,3", line));
  EXPECT_NEAR(found.deepest, std::sqrt(8.0 / 150), 1e-3);
  EXPECT_NEAR(found.back, 1, 1e-3);
}

/// With US = 4 times the slope the way back is a quarter: of the energy k p²/2 a quarter comes back.
TEST(CurveContact, UnloadingStiffnessTakesEnergy) {
  const Bounce found = bounce(cube_on_plate(one_way, "2,1,3,3", "1,2,200.", line));
  EXPECT_NEAR(found.deepest, std::sqrt(8.0 / 200), 1e-3);
  EXPECT_NEAR(found.back, 0.5, 3e-3);
  EXPECT_NEAR(found.ratio, 1, 1e-4);
}

/// Damping of a share 0.1 of the critical one, 4 C = 2 · 0.1 √(k m): the rebound of a damped oscillator that never
/// pulls.
TEST(CurveContact, DampsByTheSpeed) {
  const double share = 0.1, constant = 2 * share * std::sqrt(200.0 * 8) / 4;
  const std::string damping = fmt::format("*DEFINE_CURVE\n2\n0.,{0}\n100.,{0}\n", constant / 2);
  const Bounce found = bounce(cube_on_plate(one_way, "2,1,3,3", "1,2,,,2,2.", line + damping));
  // From the contact on until the force is zero: tan(ω_d t) = 2 ζ √(1 - ζ²)/(2 ζ² - 1), and v = exp(-ζ ω t) there.
  const double root = std::sqrt(1 - share * share);
  const double phase = std::atan2(2 * share * root, 2 * share * share - 1);
  EXPECT_NEAR(found.back, std::exp(-share / root * phase), 5e-3);
}

/// Both ways: the plate's nodes lie beside the cube, so nothing changes.
TEST(CurveContact, ActsBothWays) {
  const Bounce found = bounce(cube_on_plate("RIGID_BODY_TWO_WAY_TO_RIGID_BODY", "2,1,3,3", "1,2", line));
  EXPECT_NEAR(found.deepest, std::sqrt(8.0 / 200), 1e-3);
  EXPECT_NEAR(found.back, 1, 1e-3);
}

TEST(CurveContact, RefusesWhatItCannotDo) {
  const auto message = [](const std::string& card, const std::string& curves = line) {
    return RunScene(cube_on_plate(one_way, "2,1,3,3", card, curves)).message();
  };
  EXPECT_NE(message("7,2").find("no curve 7 (LCID)"), std::string::npos);
  EXPECT_NE(message("1,2,-5.").find("US"), std::string::npos);
  EXPECT_NE(message("1,2,0.,,0,0.,1").find("UNLCID needs"), std::string::npos);
  EXPECT_NE(message("1,2", "*DEFINE_CURVE\n1\n0.,0.\n1.,-50.\n").find("-50"), std::string::npos);
  const auto why = [](const std::string& keyword, const std::string& card) {
    const model::Read read = model::read_text("*CONTACT_" + keyword + "\n1,2,3,3\n\n\n" + card + "\n");
    return std::string(choose_method(read.model.contacts.at(0)).why_not);
  };
  EXPECT_NE(why(one_way, "1,1").find("FCM"), std::string::npos);
  EXPECT_NE(why(one_way, "1,4").find("FCM"), std::string::npos);
  EXPECT_NE(why(nodes, "1,3").find("FCM = 2"), std::string::npos);
  EXPECT_EQ(why(one_way, "1,3"), "");
}

/// DT = -9999: a node on a spring, pushed by a contact only in the windows of the curve.
TEST(ContactTimes, ActInTheWindowsOfTheCurve) {
  std::string deck = cube_on_plate(one_way, "2,1,3,3", "1,2", line + "*DEFINE_CURVE\n5\n0.15,0.2\n0.3,9.\n", 0.5);
  const std::string card2 = "\n0.\n1.,1.";
  deck.replace(deck.find(card2), card2.size(), "\n0.,0.,0.,0.,0.,0,5.,-9999.\n1.,1.");
  RunScene scene(deck);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go([&](const solver::Run& run) {
    const double time = run.stepper().state().time, force = run.contacts().front().state().force_a.norm();
    const bool acts = (time >= 0.15 && time < 0.2) || time >= 0.3;
    EXPECT_EQ(force > 0, acts) << time;
  });
  deck.replace(deck.find("0.3,9."), 6, "9.,0.3");
  EXPECT_NE(RunScene(deck).message().find("not after its birth"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::solver::curve_rule_test
