// Mortar contact of rigid bodies: the masses that bound the stiffness are those of the bodies, so the pressure has the
// depth of its formula.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/mortar/mortar_law.hpp"
#include "solver/mortar/mortar_mobility.hpp"
#include "solver/mortar/mortar_scene.hpp"
#include "solver/output/state_balance.hpp"

namespace gapcheck::solver::mortar_rigid_test {
namespace {

// A heavy block falls on a fixed one, with a step of its own (no element limits it) and with a given one. Its energy is
// that of the quadratic law at the greatest depth: m v² / 2 = A κ d³ / 12 ε d_c.
TEST(MortarRigid, BlocksBounceAtTheDepthOfTheFormula) {
  constexpr double young = 210, poisson = 0.3, density = 7.8e-4, speed = 10, gap = 0.5;
  const MortarBlock base{1, {4, 4, 2}, {0, 0, 0}, {40, 40, 10}, 0, 1};
  const MortarBlock hammer{2, {3, 3, 2}, {5, 5, 10 + gap}, {30, 30, 20}, 0, 2};
  const double area = 900, mass = density * area * 20, bulk = young / (3 * (1 - 2 * poisson));
  const double length = 10;  // V / A of the hammer's bricks
  const double slope = 0.1 * bulk / length, knee = 0.03 * length;
  const double deepest = std::cbrt(6 * knee * mass * speed * speed / (slope * area));
  // Its own step is so long, 1.7 / ω, that a few cycles see the contact and none of them the deepest place.
  for (const auto& [step, within] : {std::pair<std::string, double>{"0.", 0.02}, {"0.005", 0.005}}) {
    RunScene scene(
        base.mesh() + hammer.mesh() +
        fmt::format("*MAT_RIGID\n1,{0},{1},{2}\n1.,7.,7.\n*MAT_RIGID\n2,{0},{1},{2}\n", density, young, poisson) +
        "*CONTROL_TIMESTEP\n" + step + "\n*CONTROL_TERMINATION\n0.4\n" +
        fmt::format("*INITIAL_VELOCITY_GENERATION\n2,2,0.,0.,0.,-{}.\n", speed) +
        "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n2,1,3,3\n0.\n1.,1.\n");
    ASSERT_TRUE(scene.prepared()) << scene.message();
    const Vector start = scene.state().x.back();
    double lowest = 0;
    scene.go(
        [&](const solver::Run& run) { lowest = std::min(lowest, run.stepper().state().x.back().z() - start.z()); });
    EXPECT_NEAR(-lowest - gap, deepest, within * deepest) << step;
    EXPECT_NEAR(scene.state().v.back().z(), speed, 0.005 * speed) << step;
    const StateBalance balance = state_balance(scene.run());
    EXPECT_LT(std::abs(balance.created()), 0.005 * balance.largest) << step;
  }
}

// A tool of light shells that a curve moves follows no force, so its mass bounds nothing.
TEST(MortarRigid, LightToolThatACurveMovesPressesByTheFormula) {
  constexpr double young = 20, thickness = 5, skin = 0.1, depth = 0.02;
  const MortarSheet plate{1, 2, 2, {0, 0, 0}, {20, 0, 0}, {0, 20, 0}, thickness, 1};
  const MortarSheet tool{2, 1, 1, {5, 5, (thickness + skin) / 2}, {10, 0, 0}, {0, 10, 0}, skin, 2};
  std::string held;
  for (int j = 0; j <= 2; ++j)
    for (int i = 0; i <= 2; ++i) held += fmt::format("{}\n", plate.id(i, j));
  RunScene scene(plate.mesh() + tool.mesh() +
                 fmt::format("*MAT_ELASTIC\n1,1.E-6,{0},0.\n*MAT_RIGID\n2,1.E-6,200.,0.3\n1.,4.,7.\n", young) +
                 "*SET_NODE_LIST\n1\n" + held + "*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n" +
                 fmt::format("*DEFINE_CURVE\n1\n0.,0.\n1.,-{}\n*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,3,2,1\n", depth) +
                 "*CONTROL_TERMINATION\n1.\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n1,2,3,3\n0.\n1.,1.\n");
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double force = 0;
  scene.go([&](const solver::Run& run) { force = run.contacts()[0].state().force_b.z(); });
  const MortarLaw law{0.1 * young / 3 / thickness, 0.03 * thickness};
  EXPECT_NEAR(force, 100 * law.pressure(depth), 0.01 * 100 * law.pressure(depth));
}

// Springs of a stiffness per area under a free plate: the translation is the fastest motion, 1 / (M / A). Under its
// rim, half as long as the plate is wide, the rotation counts too.
TEST(MortarRigid, MobilityOfAPlate) {
  BodyState plate;
  plate.mass = 2;
  plate.push_response = Vector::Constant(1 / plate.mass);
  const double inertia = plate.mass / 12;  // edge 1
  plate.turn_response = Vector(1 / inertia, 1 / inertia, 1 / (2 * inertia)).asDiagonal();
  const std::array<Vector, 4> face{Vector(-0.5, -0.5, 0), Vector(0.5, -0.5, 0), Vector(0.5, 0.5, 0),
                                   Vector(-0.5, 0.5, 0)};
  EXPECT_NEAR(body_mobility(plate, {face}), 0.5, 1e-12);
  EXPECT_NEAR(body_mobility(plate, {face, face}), 1, 1e-12);
  plate.push_response.z() = 0;  // held along the normal
  EXPECT_NEAR(body_mobility(plate, {face}), 1 / 12.0 / inertia, 1e-12);
  plate.turn_response = Matrix::Zero();
  EXPECT_NEAR(body_mobility(plate, {face}), 0, 1e-12);
}

}  // namespace
}  // namespace gapcheck::solver::mortar_rigid_test
