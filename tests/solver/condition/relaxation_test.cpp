#include "solver/condition/relaxation.hpp"

#include <cmath>

#include "solver/conditioned.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::relaxation_test {
namespace {

/// The stepper of a deck in its relaxation, with the scaling of velocities by `factor`.
Stepper relaxing(const std::string& deck, double factor, double step) {
  Conditioned ready = good(deck);
  ready.structure.state.relaxing = true;
  Stepper stepper(std::move(ready.structure), fixed_step(step));
  stepper.add(std::make_unique<RelaxationDamping>(stepper.structure(), factor));
  for (auto& force : ready.forces) stepper.add(std::move(force));
  return stepper;
}

const std::string constant_curve = "*DEFINE_CURVE\n1,1\n0.,1.\n1.,1.\n";

// A mass under a constant force: v⁺ = f (v⁻ + F dt̄ / m), the first time over half a step. The force is the only work,
// the scaling the only loss.
TEST(Relaxation, ScalesTheVelocityOfAMass) {
  constexpr double factor = 0.9, step = 0.01, force = 3, mass = 2;
  Stepper stepper = relaxing(point_mass + "*LOAD_NODE_POINT\n1,1,1,3.\n" + constant_curve, factor, step);
  double v = 0, x = 0;
  for (int i = 0; i < 60; ++i) {
    run(stepper, 1);
    v = factor * (v + (i == 0 ? step / 2 : step) * force / mass);
    x += step * v;
    ASSERT_NEAR(stepper.state().v[0].x(), v, 1e-13) << i;
    ASSERT_NEAR(stepper.state().x[0].x(), x, 1e-13) << i;
    const Energies& e = stepper.energies();
    ASSERT_NEAR(e.total() - e.initial, e.external, 1e-12);
    ASSERT_NEAR(e.external, force * (x - step * v), 1e-12) << "the work of the force alone";
    if (i > 1) {
      ASSERT_GT(e.absorbed.damping, 0);
    }
  }
  EXPECT_NEAR(v, factor / (1 - factor) * force * step / mass, 3e-3) << "what it tends to";
}

// The same of a rigid body and its spin about a principal axis; what is held does not move.
TEST(Relaxation, ScalesTheMotionOfARigidBody) {
  constexpr double factor = 0.9, step = 1e-3, mass = 12, about_z = mass * (1 + 4) / 12.;
  Stepper stepper =
      relaxing(rigid_box + "*MAT_RIGID\n7,2.,1000.,0.3\n1.,2,0\n*LOAD_RIGID_BODY\n7,1,1,5.\n7,7,1,4.\n7,2,1,9.\n" +
                   constant_curve,
               factor, step);
  double v = 0, w = 0;
  for (int i = 0; i < 40; ++i) {
    run(stepper, 1);
    const double mean = i == 0 ? step / 2 : step;
    v = factor * (v + mean * 5 / mass);
    w = factor * (w + mean * 4 / about_z);
    const RigidBody& body = stepper.structure().rigid[0];
    ASSERT_NEAR(body.velocity().x(), v, 1e-13);
    ASSERT_EQ(body.velocity().y(), 0);
    ASSERT_NEAR(body.angular_velocity().z(), w, 1e-13);
    ASSERT_NEAR(stepper.energies().total() - stepper.energies().initial, stepper.energies().external, 1e-13);
  }
  EXPECT_GT(stepper.energies().absorbed.damping, 0.5 * stepper.energies().external);
}

// Supports keep their reaction, and a motion keeps its velocity.
TEST(Relaxation, LeavesImposedMotionAlone) {
  Stepper stepper = relaxing(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n*ELEMENT_MASS\n1,1,2.\n2,2,3.\n*DEFINE_CURVE\n2,1\n0.,7.\n"
      "1.,7.\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,2\n*BOUNDARY_SPC_NODE\n2,0,1,1\n"
      "*LOAD_NODE_POINT\n2,1,1,3.\n2,3,1,6.\n" +
          constant_curve,
      0.5, 0.01);
  run(stepper, 20);
  EXPECT_EQ(stepper.state().v[0].x(), 7);
  EXPECT_EQ(stepper.state().v[1].x(), 0);
  EXPECT_NEAR(stepper.state().v[1].z(), 0.01 * 6 / 3., 1e-6) << "f / (1 - f) F dt / m";
  EXPECT_NEAR(stepper.reaction(1)[0].x(), -3, 1e-12);
}

// What does not act: a load for the run alone, in the relaxation; one for the relaxation, in the run.
TEST(Relaxation, CurvesActInTheirPhases) {
  const auto force = [](int sidr, bool in_relaxation) {
    Conditioned ready =
        good(point_mass + fmt::format("*LOAD_NODE_POINT\n1,1,1,3.\n*DEFINE_CURVE\n1,{}\n0.,1.\n1.,1.\n", sidr));
    ready.structure.state.relaxing = in_relaxation;
    Forces forces;
    forces.resize(1);
    ready.forces.at(0)->add(ready.structure.state, forces);
    return forces.force[0].x();
  };
  EXPECT_EQ(force(0, false), 3);
  EXPECT_EQ(force(0, true), 0);
  EXPECT_EQ(force(1, false), 0);
  EXPECT_EQ(force(1, true), 3);
  EXPECT_EQ(force(2, false), 3);
  EXPECT_EQ(force(2, true), 3);
}

// LCIDDR replaces LCID in the relaxation.
TEST(Relaxation, BodyLoadsHaveACurveOfTheirOwn) {
  Conditioned ready =
      good(point_mass + "*LOAD_BODY_Z\n1,10.,2\n*DEFINE_CURVE\n1,2\n0.,1.\n1.,1.\n*DEFINE_CURVE\n2,1\n0.,5.\n1.,5.\n");
  for (const bool in_relaxation : {false, true}) {
    ready.structure.state.relaxing = in_relaxation;
    Forces forces;
    forces.resize(1);
    ready.forces.at(0)->add(ready.structure.state, forces);
    EXPECT_EQ(forces.force[0].z(), in_relaxation ? -100 : -20);
  }
  const Conditioned bad = conditioned(point_mass +
                                      "*LOAD_BODY_Z\n1,10.,2\n*DEFINE_CURVE\n1,2\n0.,1.\n1.,1.\n"
                                      "*DEFINE_CURVE\n2\n0.,5.\n1.,5.\n");
  ASSERT_FALSE(bad.status.ok());
  EXPECT_NE(bad.status.error().message.find("curve 2 (LCIDDR)"), std::string::npos) << bad.status.error().message;
}

// Two masses: the energy of their relative motion, ½ m₁ m₂ / (m₁ + m₂) Δv², whatever their common one.
TEST(Relaxation, DistortionalEnergyIsThatOfTheRelativeMotion) {
  Structure structure =
      structure_of("*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n*ELEMENT_MASS\n1,1,2.\n2,2,3.\n" + rigid_box + rigid_material);
  structure.state.v[0] = Vector(100, 50, 0);
  structure.state.v[1] = Vector(104, 53, 0);
  for (std::size_t i = 2; i < 10; ++i) structure.state.v[i] = Vector(0, 0, 1e3);  // of the rigid body
  EXPECT_NEAR(distortional_energy(structure), 2 * 3 / 5. / 2 * 25, 1e-8);
}

TEST(Relaxation, WhichModelsRelax) {
  const auto relaxes_with = [](const std::string& deck) { return relaxes(model::read_text(deck).model); };
  const std::string with_curve = "*DEFINE_CURVE\n1,2\n0.,1.\n1.,1.\n";
  EXPECT_FALSE(relaxes_with("*CONTROL_DYNAMIC_RELAXATION\n\n"));
  EXPECT_TRUE(relaxes_with("*CONTROL_DYNAMIC_RELAXATION\n,,,,,,,1\n"));
  EXPECT_TRUE(relaxes_with(with_curve));
  EXPECT_TRUE(relaxes_with(with_curve + "*CONTROL_DYNAMIC_RELAXATION\n\n"));
  EXPECT_FALSE(relaxes_with(with_curve + "*CONTROL_DYNAMIC_RELAXATION\n,,,,,,,-999\n"));
  EXPECT_FALSE(relaxes_with("*DEFINE_CURVE\n1,0\n0.,1.\n1.,1.\n"));
}

TEST(Relaxation, Settings) {
  const auto settings = [](const std::string& card, const std::string& more = "") {
    return relaxation_settings(model::read_text("*CONTROL_DYNAMIC_RELAXATION\n" + card + "\n" + more).model);
  };
  const auto normal = settings("");
  ASSERT_TRUE(normal);
  EXPECT_EQ(normal.value().check_every, 250u);
  EXPECT_EQ(normal.value().tolerance, 0.001);
  EXPECT_EQ(normal.value().factor, 0.995);
  EXPECT_FALSE(std::isfinite(normal.value().end));
  EXPECT_EQ(settings("", "*CONTROL_TIMESTEP\n0.,0.7\n").value().time_step_factor, 0.7);
  const auto given = settings("10,0.1,0.9,3.,0.5", "*CONTROL_TIMESTEP\n0.,0.7\n");
  ASSERT_TRUE(given);
  EXPECT_EQ(given.value().check_every, 10u);
  EXPECT_EQ(given.value().tolerance, 0.1);
  EXPECT_EQ(given.value().factor, 0.9);
  EXPECT_EQ(given.value().end, 3);
  EXPECT_EQ(given.value().time_step_factor, 0.5);
  EXPECT_TRUE(settings(",,1.,3."));
  const auto refused = [&](const std::string& card, std::string_view text, const std::string& more = "") {
    const auto bad = settings(card, more);
    ASSERT_FALSE(bad) << text;
    EXPECT_NE(bad.error().message.find(text), std::string::npos) << bad.error().message;
    EXPECT_GT(bad.error().place.line, 0u);
  };
  refused("-1", "NRCYCK");
  refused(",-0.1", "DRTOL");
  refused(",1.", "DRTOL");
  refused(",,1.", "DRFCTR");
  refused(",,-0.5", "DRFCTR");
  refused(",,1.5,3.", "DRFCTR");
  refused(",,,-1.", "DRTERM");
  refused(",,,,-1.", "TSSFDR");
  refused("", "wall 1 moves", "*RIGIDWALL_PLANAR_MOVING\n0\n0.,0.,0.,0.,0.,1.\n1.,2.\n");
  refused("", "cable material 4", "*MAT_CABLE_DISCRETE_BEAM\n4,1.,1000.,0,3.\n");
}

TEST(Relaxation, CurvesThatStillChange) {
  const model::Model model =
      model::read_text("*DEFINE_CURVE\n7,1\n0.,0.\n2.,1.\n9.,1.\n*DEFINE_CURVE\n5,2\n0.,0.\n8.,1.\n").model;
  EXPECT_EQ(unfinished_curve(model, 1.9), 7);
  EXPECT_EQ(unfinished_curve(model, 2), 0);
}

}  // namespace
}  // namespace gapcheck::solver::relaxation_test
