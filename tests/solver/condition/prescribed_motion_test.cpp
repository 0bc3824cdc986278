#include <gtest/gtest.h>

#include <cmath>

#include "solver/conditioned.hpp"

namespace gapcheck::solver::prescribed_motion_test {
namespace {

const std::string bent_curve = "*DEFINE_CURVE\n5,0,1.,1.,0.,0.\n0.,0.\n0.3,2.\n0.7,-1.\n1.,4.\n";

double bent(double t) {
  if (t < 0.3) return 2 * t / 0.3;
  if (t < 0.7) return 2 - 3 * (t - 0.3) / 0.4;
  return t < 1 ? -1 + 5 * (t - 0.7) / 0.3 : 4;
}

// The displacement is that of the curve at the end of every step, and the energy that it costs is accounted for.
TEST(PrescribedMotion, DisplacementIsMetAtTheSteps) {
  Stepper stepper =
      good(point_mass + bent_curve + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,2,2,5,0.5\n").stepper(fixed_step(0.013));
  for (int i = 0; i < 100; ++i) {
    run(stepper, 1);
    EXPECT_NEAR(stepper.state().x[0].y(), 0.5 * bent(stepper.state().time), 1e-14);
  }
  EXPECT_NEAR(stepper.energies().total(), stepper.energies().initial + stepper.energies().external, 1e-12);
}

// x = Σ v(t + dt/2) dt; with a linear velocity exactly a t²/2.
TEST(PrescribedMotion, VelocityAndAcceleration) {
  const std::string ramp = "*DEFINE_CURVE\n5\n0.,0.\n10.,30.\n*DEFINE_CURVE\n6\n0.,3.\n1.,3.\n";
  Stepper stepper = good(point_mass + ramp +
                         "*INITIAL_VELOCITY_NODE\n1,0.,4.,0.\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,5\n1,2,1,6\n")
                        .stepper(fixed_step(0.01));
  run(stepper, 100);
  const double t = stepper.state().time;
  EXPECT_NEAR(stepper.state().x[0].x(), 1.5 * t * t, 1e-12);
  EXPECT_NEAR(stepper.state().x[0].y(), 4 * t + 1.5 * t * t, 1e-12);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-12);
}

// What moves from time 0 on has its velocity at the start: a jump in the first step would cost the work m v² for an
// energy of m v²/2. With a birth later than that it is at rest.
TEST(PrescribedMotion, BeginsWithItsVelocityAndItsEnergy) {
  const std::string steady = "*DEFINE_CURVE\n5\n0.,3.\n100.,3.\n*DEFINE_CURVE\n6\n0.,0.\n100.,300.\n";
  const std::string rigid = rigid_box + rigid_material + "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n";
  for (const std::string& moved : {point_mass + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,5\n",
                                   point_mass + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,2,6\n", rigid + "7,2,0,5\n",
                                   rigid + "7,7,0,5\n", rigid + "7,7,2,6\n"}) {
    Stepper stepper = good(moved + steady).stepper(fixed_step(0.01));
    const Energies& e = stepper.energies();
    run(stepper, 1);
    EXPECT_GT(e.printed_initial, 1) << moved;
    for (int i = 0; i < 10; ++i) {
      run(stepper, 1);
      EXPECT_NEAR(e.external, 0, 1e-12 * e.initial) << moved;
      EXPECT_NEAR(e.printed_ratio(), 1, 1e-12) << moved;
    }
  }
  Stepper late =
      good(point_mass + steady + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,5,1.,0,0.,0.05\n").stepper(fixed_step(0.01));
  run(late, 3);
  EXPECT_EQ(late.energies().kinetic, 0);
  run(late, 5);
  EXPECT_EQ(late.state().v[0].x(), 3);
}

// Free before birth, by the curve from its start at birth, free after death.
TEST(PrescribedMotion, BirthAndDeath) {
  Stepper stepper = good(point_mass +
                         "*DEFINE_CURVE\n5\n0.,3.\n100.,3.\n*INITIAL_VELOCITY_NODE\n1,1.,0.,0.\n"
                         "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,5,1.,0,2.,1.\n")
                        .stepper(fixed_step(0.125));
  run(stepper, 32);
  EXPECT_NEAR(stepper.state().x[0].x(), 1 * 1 + 3 * 3, 1e-14);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-14);
}

TEST(PrescribedMotion, DisplacementBeginsAtBirth) {
  Stepper stepper = good(point_mass + bent_curve + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,3,2,5,1.,0,0.,0.21\n")
                        .stepper(fixed_step(0.05));
  run(stepper, 25);
  EXPECT_NEAR(stepper.state().x[0].z(), bent(stepper.state().time - 0.21), 1e-14);
}

// A rigid box turned about an axis that is none of its principal ones: angle, place and energy.
TEST(PrescribedMotion, TurnOfARigidBody) {
  const std::string turned_box =
      "*NODE\n11,0.,0.,0.\n12,1.,0.5,0.\n13,1.,2.,0.\n14,0.,2.,0.\n15,0.,0.,3.\n16,1.,0.5,3.\n17,1.,2.,3.\n18,0.5,2.,"
      "3.\n*ELEMENT_SOLID\n9,7,11,12,13,14,15,16,17,18\n*PART\nbox\n7,7,7\n*SECTION_SOLID\n7,1\n";
  Conditioned body = good(turned_box + rigid_material + bent_curve +
                          "*DEFINE_CURVE\n6\n0.,0.\n"
                          "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n7,5,2,5,0.2\n7,6,0,6\n7,7,0,6\n"
                          "7,1,2,5,3.\n");
  const Vector center = body.structure.rigid[0].center(), arm = body.structure.state.x[6] - center;
  Stepper stepper = std::move(body).stepper(fixed_step(0.0037));
  for (int i = 0; i < 250; ++i) {
    run(stepper, 1);
    const double angle = 0.2 * bent(stepper.state().time);
    const Vector wanted = center + 3 * bent(stepper.state().time) * Vector::UnitX() +
                          Vector(arm.x(), std::cos(angle) * arm.y() - std::sin(angle) * arm.z(),
                                 std::sin(angle) * arm.y() + std::cos(angle) * arm.z());
    ASSERT_NEAR((stepper.state().x[6] - wanted).norm(), 0, 2e-13) << i;
  }
  const Energies& e = stepper.energies();
  EXPECT_GT(e.kinetic, 1);
  EXPECT_NEAR(e.total() - e.initial - e.external, 0, 1e-10 * e.kinetic);
}

// One rotation is given, the others are free: gyroscopic torques do no work.
TEST(PrescribedMotion, OneTurnOfThreeIsGiven) {
  const std::string steady = "*DEFINE_CURVE\n5\n0.,2.\n1.,2.\n";
  Stepper stepper = good(rigid_box + rigid_material + steady +
                         "*INITIAL_VELOCITY_GENERATION\n7,2,1.5,0.,0.,0.\n0.5,1.,1.5,0.,0.3,1.\n"
                         "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n7,5,0,5\n")
                        .stepper(fixed_step(0.01));
  run(stepper, 500);
  EXPECT_NEAR(stepper.structure().rigid[0].angular_velocity().x(), 2, 1e-12);
  const Energies& e = stepper.energies();
  EXPECT_GT(std::abs(e.external), 1e-3 * e.kinetic);
  EXPECT_NEAR(e.total() - e.initial - e.external, 0, 1e-10 * e.kinetic);
}

TEST(PrescribedMotion, AlongAVector) {
  const std::string steady =
      "*DEFINE_CURVE\n5\n0.,2.\n1.,2.\n*DEFINE_VECTOR\n3,0.,0.,0.,3.,4.,0.\n4,1.,0.,0.,1.,0.,-7.\n";
  Stepper stepper = good(point_mass + "*NODE\n2,0.,0.,0.\n*ELEMENT_MASS\n2,2,2.\n" + steady +
                         "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,-4,0,5,1.,3\n2,4,0,5,1.,4\n")
                        .stepper(fixed_step(0.25));
  run(stepper, 4);
  EXPECT_NEAR((stepper.state().x[0] - Vector(1.2, 1.6, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((stepper.state().x[1] - Vector(0, 0, -2)).norm(), 0, 1e-15);
  EXPECT_EQ(stepper.structure().constraints.mask(1), 4);
}

// Along a vector that is no axis a node follows the curve; across it the node is free.
TEST(PrescribedMotion, AlongAVectorAcrossTheAxes) {
  for (const int quantity : {0, 1, 2}) {
    const std::array<const char*, 3> curves{"0.,2.\n1.,2.\n", "0.,0.\n1.,0.\n", "0.,0.\n1.,2.\n"};
    Stepper stepper = good(point_mass + "*INITIAL_VELOCITY_NODE\n1,3.,1.,5.\n*DEFINE_VECTOR\n4,0.,0.,0.,3.,4.,0.\n" +
                           fmt::format("*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,4,{},9,,4\n*DEFINE_CURVE\n9\n{}", quantity,
                                       curves[static_cast<std::size_t>(quantity)]))
                          .stepper(fixed_step(1.0 / 64));
    run(stepper, 64);
    const Vector along(0.6, 0.8, 0), across(-0.8, 0.6, 0), x = stepper.state().x[0];
    // Across: −0.8 · 3 + 0.6; along with an acceleration of zero: 0.6 · 3 + 0.8.
    EXPECT_NEAR(x.dot(along), quantity == 1 ? 2.6 : 2, 1e-12) << quantity;
    EXPECT_NEAR(x.dot(across), -1.8, 1e-12) << quantity;
    EXPECT_NEAR(x.z(), 5, 1e-12) << quantity;
  }
}

TEST(PrescribedMotion, ContradictionsAreFailures) {
  const auto expect = [](const std::string& cards, Failure::Kind kind, std::string_view text) {
    const Conditioned result =
        conditioned(point_mass + rigid_box + "*MAT_RIGID\n7,2.,1000.,0.3\n" + bent_curve + cards);
    ASSERT_FALSE(result.status.ok()) << cards;
    EXPECT_EQ(result.status.error().kind, kind) << result.status.error().message;
    EXPECT_NE(result.status.error().message.find(text), std::string::npos) << result.status.error().message;
  };
  const std::string motion = "*BOUNDARY_PRESCRIBED_MOTION_";
  expect("*BOUNDARY_SPC_NODE\n1,0,1\n" + motion + "NODE\n1,1,0,5\n", Failure::Kind::contradiction, "x of node 1");
  expect(motion + "NODE\n1,2,0,5\n1,2,2,5\n", Failure::Kind::contradiction, "y of node 1");
  expect(motion + "NODE\n11,2,0,5\n", Failure::Kind::contradiction, "node 11 belongs to a rigid body");
  expect(motion + "RIGID\n7,7,0,5\n7,7,0,5\n", Failure::Kind::contradiction, "rotation about z of rigid body 7");
  expect(motion + "RIGID\n0,7,0,5\n", Failure::Kind::unknown_reference, "0 is no rigid part");
  expect(motion + "NODE\n1,2,0,99\n", Failure::Kind::unknown_reference, "curve 99");
  expect(motion + "NODE\n1,12,0,5\n", Failure::Kind::not_calculated, "DOF 12");
  expect(motion + "NODE\n1,1,3,5\n", Failure::Kind::not_calculated, "VAD 3");
  expect(motion + "NODE\n1,4,0,5,1.,8\n", Failure::Kind::unknown_reference, "vector 8");
  expect("*DEFINE_CURVE\n8\n1.,0.\n0.,1.\n" + motion + "NODE\n1,1,0,8\n", Failure::Kind::unknown_reference,
         "do not rise");
}

}  // namespace
}  // namespace gapcheck::solver::prescribed_motion_test
