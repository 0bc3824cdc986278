// Coulomb friction of mortar contact: a rigid block on an elastic one, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/mortar/mortar_scene.hpp"

namespace gapcheck::solver::mortar_friction_test {
namespace {

constexpr double coefficient = 0.3;

/// A rigid cube of mass 1 that does not turn, on a long elastic block, which is held. Gravity grows to 1 until 0.4;
/// `push` sideways from 0.5 to 0.9.
std::string sliding_block(double speed, double push, const std::string& friction) {
  const MortarBlock floor{1, {12, 4, 1}, {-0.5, -0.1, -0.5}, {3, 1.2, 0.5}, 0, 1};
  const MortarBlock block{2, {3, 3, 4}, {0, 0, 0}, {1, 1, 1}, 0, 2};
  return floor.mesh() + block.mesh() + "*MAT_ELASTIC\n1,1.,1000.,0.3\n*MAT_RIGID\n2,1.,1000.,0.3\n1.,0.,7.\n" +
         "*SET_NODE_LIST\n1\n" + floor.level(0) + "*BOUNDARY_SPC_SET\n1,0,1,1,1\n" +
         fmt::format("*INITIAL_VELOCITY_GENERATION\n2,2,0.,{},0.,0.\n0.,0.,0.,0.,0.,1.\n", speed) +
         "*DEFINE_CURVE\n5\n0.,0.\n0.4,1.\n100.,1.\n*LOAD_BODY_Z\n5,1.\n" +
         "*DEFINE_CURVE\n6\n0.,0.\n0.5,0.\n0.9,1.\n100.,1.\n" +
         (push != 0 ? fmt::format("*LOAD_BODY_X\n6,{}\n", -push) : "") +
         "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n2,1,3,3\n" + friction + "\n50.,50.\n";
}

double place(const RunScene& scene) { return scene.run().stepper().structure().rigid[0].center().x() - 0.5; }

RunSettings until(double time) {
  RunSettings settings;
  settings.until = time;
  return settings;
}

// The velocity falls by μ ∫ g dt, until it sticks.
TEST(MortarFriction, SlidesToRest) {
  constexpr double speed = 0.5, after_growth = speed - coefficient * 0.2, stops = 0.4 + after_growth / coefficient;
  constexpr double way = 0.4 * speed - coefficient * 0.4 * 0.4 / 6 + after_growth * after_growth / (2 * coefficient);
  RunScene scene(sliding_block(speed, 0, "0.3,0.3,0.,0.,50.") + "*CONTROL_TERMINATION\n3.\n", until(3));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double at_stop = 0, normal = 0, tangential = 0, count = 0;
  scene.go([&](const solver::Run& run) {
    const double time = run.stepper().state().time;
    const ContactState& contact = run.contacts()[0].state();
    if (time < stops) at_stop = place(scene);
    if (time < 0.6 || time > 0.9 * stops) return;
    normal += contact.force_a.z();
    tangential -= contact.force_a.x();
    count += 1;
  });
  EXPECT_NEAR(normal / count, 1, 0.05) << "it still swings a little";
  EXPECT_NEAR(tangential / normal, coefficient, 0.01 * coefficient);
  EXPECT_NEAR(at_stop, way, 0.01 * way);
  EXPECT_NEAR(place(scene), at_stop, 5e-3) << "it stays there";
  // What it had is gone by friction; a little is left in damping and elastic sticking.
  EXPECT_NEAR(scene.energies().absorbed.contact_friction, 0.5 * speed * speed, 0.02 * 0.5 * speed * speed);
  EXPECT_NEAR(scene.energies().ratio(), 1, 0.01);
  RecordProperty("friction_ratio", fmt::format("{:.5f}", tangential / normal / coefficient));
  RecordProperty("way_ratio", fmt::format("{:.5f}", at_stop / way));
}

// Pushed with 0.25 it sticks at 0.3; pushed with 0.5 it is accelerated by the rest.
TEST(MortarFriction, SticksBelowTheLimitAndSlidesAboveIt) {
  RunScene sticks(sliding_block(0, 0.25, "0.3,0.3,0.,0.,50.") + "*CONTROL_TERMINATION\n2.9\n", until(2.9));
  ASSERT_TRUE(sticks.prepared()) << sticks.message();
  double at_1_9 = 0;
  sticks.go([&](const solver::Run& run) {
    if (run.stepper().state().time < 1.9) at_1_9 = place(sticks);
  });
  EXPECT_LT(std::abs(at_1_9), 0.005) << "elastic sticking";
  EXPECT_NEAR(place(sticks), at_1_9, 1e-3) << "no creep";
  RunScene slides(sliding_block(0, 0.5, "0.3,0.3,0.,0.,50.") + "*CONTROL_TERMINATION\n2.9\n", until(2.9));
  ASSERT_TRUE(slides.prepared()) << slides.message();
  double start = 0, speed = 0;
  slides.go([&](const solver::Run& run) {
    if (run.stepper().state().time >= 1.9) return;
    start = run.stepper().state().time;
    speed = run.stepper().structure().rigid[0].velocity().x();
  });
  const double gained = slides.run().stepper().structure().rigid[0].velocity().x() - speed;
  EXPECT_NEAR(gained / (slides.state().time - start), 0.5 - coefficient, 0.005 * coefficient);
}

// FD + (FS - FD) exp(-DC |v|): at this speed nearly FD.
TEST(MortarFriction, FallsFromTheStaticToTheDynamicCoefficient) {
  RunScene scene(sliding_block(0.8, 0.1, "0.4,0.1,20.,0.,50.") + "*CONTROL_TERMINATION\n1.2\n", until(1.2));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double normal = 0, tangential = 0;
  scene.go([&](const solver::Run& run) {
    if (run.stepper().state().time < 0.6) return;
    normal += run.contacts()[0].state().force_a.z();
    tangential -= run.contacts()[0].state().force_a.x();
  });
  EXPECT_NEAR(tangential / normal, 0.1, 1e-3);
}

}  // namespace
}  // namespace gapcheck::solver::mortar_friction_test
