#include "solver/condition/loads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/conditioned.hpp"

namespace gapcheck::solver::loads_test {
namespace {

const std::string one = "*DEFINE_CURVE\n5\n0.,1.\n1.,1.\n";

// Central differences have v(t − dt/2) = g (t − dt/2) and x = g t² / 2 without error. The frame's acceleration upwards
// pulls downwards.
TEST(Loads, FallingBodies) {
  Stepper stepper = good(point_mass + rigid_box + rigid_material + one + "*LOAD_BODY_Z\n5,9.81\n*LOAD_BODY_X\n5,-2.\n")
                        .stepper(fixed_step(0.01));
  const Vector center = stepper.structure().rigid[0].center();
  run(stepper, 100);
  const double t = stepper.state().time, middle = t - 0.005;
  const Vector pull(2, 0, -9.81);
  EXPECT_NEAR((stepper.state().v[0] - middle * pull).norm(), 0, 1e-12);
  EXPECT_NEAR((stepper.state().x[0] - t * t / 2 * pull).norm(), 0, 1e-12);
  EXPECT_NEAR((stepper.structure().rigid[0].center() - center - t * t / 2 * pull).norm(), 0, 1e-12);
  EXPECT_EQ(stepper.structure().rigid[0].angular_velocity().norm(), 0);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-12);
}

TEST(Loads, BodyLoadsOfSomePartsOnly) {
  Conditioned result =
      good(rigid_box + rigid_material + plate(1, 1, {1, 1, 0}) + elastic_deck(shell_section, 1000, 0.3, 7) + one +
           "*ELEMENT_MASS\n1,1,2.,7\n*SET_PART_LIST\n3\n1\n*LOAD_BODY_PARTS\n3\n*LOAD_BODY_Y\n5,1.\n");
  Forces forces;
  forces.resize(result.structure.state.x.size(), 1);
  ASSERT_EQ(result.forces.size(), 1u);
  result.forces[0]->add(result.structure.state, forces);
  Vector sum = Vector::Zero();
  for (const Vector& force : forces.force) sum += force;
  EXPECT_NEAR((sum - Vector(0, -7 * 0.1, 0)).norm(), 0, 1e-14);
  EXPECT_EQ(forces.body_force[0].norm(), 0);
}

// v = F t / m.
TEST(Loads, ForceOnAMassAndABody) {
  Stepper stepper = good(point_mass + rigid_box + rigid_material +
                         "*DEFINE_CURVE\n5\n0.,0.\n1.,6.\n*LOAD_NODE_POINT\n1,2,5,2.\n"
                         "*LOAD_RIGID_BODY\n7,3,5,4.\n7,5,5,1.\n")
                        .stepper(fixed_step(0.01));
  run(stepper, 100);
  const double middle = stepper.state().time - 0.005;
  // Impulse of the ramp by the trapezoidal rule up to the last force, half the first step before it.
  const double impulse = 6 * (0.99 * 0.99 / 2 + 0.99 * 0.005);
  EXPECT_NEAR(middle, 0.995, 1e-12);
  EXPECT_NEAR(stepper.state().v[0].y(), 2 * impulse / 2, 1e-12);
  EXPECT_NEAR(stepper.structure().rigid[0].velocity().z(), 4 * impulse / 12, 1e-12);
  const double inertia = 12 * (4 + 9) / 12.0;
  EXPECT_NEAR(stepper.structure().rigid[0].angular_velocity().x(), impulse / inertia, 1e-12);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-9);
}

// A pressure of 3 against the normal (0, 0, 1) of a plate of 2 x 1, from t = 0.25 on by the curve's start.
// A force follows a body that turns about z by 2: the velocity of a mass is F / (m ω) (sin ωt, 1 − cos ωt, 0).
TEST(Loads, ForceFollowsNodes) {
  const double spin = 2, force = 6, mass = 2;
  const std::string turning = rigid_box + rigid_material +
                              "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n7,7,0,9,2.\n*DEFINE_CURVE\n9\n0.,1.\n" + point_mass;
  Stepper stepper = good(turning + "*LOAD_NODE_POINT\n1,4,9,6.,,11,14,15\n").stepper(fixed_step(1e-3));
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    run(stepper, 1);
    const double middle = stepper.state().time - stepper.state().dt / 2;
    const Vector expected = force / (mass * spin) * Vector(std::sin(spin * middle), 1 - std::cos(spin * middle), 0);
    worst = std::max(worst, (stepper.state().v[8] - expected).norm());
  }
  EXPECT_LT(worst, 2e-6 * force / (mass * spin));
  // The other way round it points the other way.
  Stepper back = good(turning + "*LOAD_NODE_POINT\n1,4,9,6.,,11,15,14\n").stepper(fixed_step(1e-3));
  run(back, 1);
  EXPECT_NEAR(back.external().force[8].x(), -6, 1e-12);
}

TEST(Loads, MomentFollowsNodes) {
  // On the body's centre, about the normal (1, 0, 0) of its own nodes: L = M t.
  Stepper stepper = good(rigid_box + rigid_material + "*LOAD_RIGID_BODY\n7,8,9,6.,,11,14,15\n*DEFINE_CURVE\n9\n0.,1.\n")
                        .stepper(fixed_step(1e-3));
  run(stepper, 1000);
  EXPECT_NEAR((stepper.structure().rigid[0].angular_momentum() - Vector(6 * 0.9995, 0, 0)).norm(), 0, 6e-3);
  EXPECT_NEAR(stepper.net().body_moment[0].x(), 6, 1e-12);
}

TEST(Loads, InALocalSystem) {
  const std::string system = "*DEFINE_COORDINATE_VECTOR\n3,3.,4.,0.,-4.,3.,0.\n*DEFINE_CURVE\n9\n0.,1.\n";
  Stepper stepper = good(point_mass + system + "*LOAD_NODE_POINT\n1,2,9,10.,3\n1,3,9,7.,3\n").stepper(fixed_step(1e-3));
  run(stepper, 1);
  EXPECT_NEAR((stepper.external().force[0] - Vector(-8, 6, 7)).norm(), 0, 1e-13);
  Stepper body =
      good(rigid_box + rigid_material + system + "*LOAD_RIGID_BODY\n7,5,9,10.,3\n").stepper(fixed_step(1e-3));
  run(body, 1);
  EXPECT_NEAR((body.external().body_moment[0] - Vector(6, 8, 0)).norm(), 0, 1e-13);
}

TEST(Loads, PressurePushesIntoTheSegment) {
  const std::string ramp = "*DEFINE_CURVE\n5\n0.,3.\n1.,4.\n";
  for (const std::string load :
       {"*LOAD_SEGMENT\n5,1.,0.25,1,2,5,4\n5,1.,0.25,2,3,6,5\n",
        "*SET_SEGMENT\n3\n1,2,5,4\n2,3,6,5\n*LOAD_SEGMENT_SET_ID\n1,push\n3,5,1.,0.25\n",
        "*LOAD_SHELL_ELEMENT\n1,5,1.,0.25\n2,5,1.,0.25\n", "*SET_SHELL_LIST\n3\n1,2\n*LOAD_SHELL_SET\n3,5,1.,0.25\n"}) {
    Conditioned result = good(plate(2, 1, {1, 1, 0}) + elastic_deck(shell_section, 1000, 0.3, 7) + ramp + load);
    ASSERT_EQ(result.forces.size(), 1u) << load;
    const auto sum_at = [&](double time) {
      Forces forces;
      forces.resize(result.structure.state.x.size());
      result.structure.state.time = time;
      result.forces[0]->add(result.structure.state, forces);
      EXPECT_EQ(forces.force[1].z(), 2 * forces.force[0].z());
      Vector sum = Vector::Zero();
      for (const Vector& force : forces.force) sum += force;
      return sum;
    };
    EXPECT_EQ(sum_at(0.2).norm(), 0) << load;
    EXPECT_NEAR((sum_at(0.25) - Vector(0, 0, -6)).norm(), 0, 1e-13) << load;
    EXPECT_NEAR((sum_at(0.75) - Vector(0, 0, -7)).norm(), 0, 1e-13) << load;
  }
}

// A closed box of warped quads and triangles has no resultant, neither force nor moment of the triangles.
TEST(Loads, PressureInAClosedBox) {
  Pressures pressures;
  State state;
  state.x = {{0, 0, 0},   {1, 0.1, -0.2}, {1.2, 1, 0.3}, {-0.1, 1, 0},
             {0, 0.2, 1}, {1, 0, 1.4},    {1, 1.3, 1},   {0, 1, 0.8}};
  const auto node = [](std::uint32_t i) { return NodeIndex{i}; };
  const TimedValue value{std::make_shared<const TimeCurve>(std::vector<TimeCurve::Point>{{0, 2}}), 1, 0};
  for (const auto& s : {std::array{0u, 3u, 2u, 1u},
                        {4u, 5u, 6u, 7u},
                        {0u, 1u, 5u, 4u},
                        {1u, 2u, 6u, 5u},
                        {2u, 3u, 7u, 6u},
                        {3u, 0u, 4u, 4u},
                        {3u, 4u, 7u, 7u}})
    pressures.add_segment({node(s[0]), node(s[1]), node(s[2]), node(s[3])}, value);
  Forces forces;
  forces.resize(8);
  pressures.add(state, forces);
  Vector sum = Vector::Zero();
  double size = 0;
  for (const Vector& force : forces.force) {
    sum += force;
    size += force.norm();
  }
  EXPECT_GT(size, 1);
  EXPECT_NEAR(sum.norm(), 0, 1e-15 * size);
}

// v = v₀ (1 − D dt / 2) (1 − D dt)ⁿ⁻¹; what is lost is the damping's.
TEST(Loads, GlobalDamping) {
  constexpr double damping = 1.5, dt = 0.01;
  Stepper stepper =
      good(point_mass + rigid_box + rigid_material + "*DAMPING_GLOBAL\n0,1.5\n*INITIAL_VELOCITY\n0\n3.,0.,0.\n")
          .stepper(fixed_step(dt));
  run(stepper, 100);
  const double wanted = 3 * (1 - damping * dt / 2) * std::pow(1 - damping * dt, 99);
  EXPECT_NEAR(stepper.state().v[0].x(), wanted, 1e-14);
  EXPECT_NEAR(stepper.structure().rigid[0].velocity().x(), wanted, 1e-14);
  const Energies& e = stepper.energies();
  EXPECT_NEAR(e.external, 0, 1e-12);
  EXPECT_NEAR(e.absorbed.damping, e.initial - e.kinetic, 1e-12);
  EXPECT_GT(e.absorbed.damping, 0.9 * e.initial);
}

// A load along a vector is the sum of those along the axes.
TEST(Loads, BodyLoadAlongAVector) {
  const std::string curve = "*DEFINE_CURVE\n5\n0.,2.\n1.,4.\n";
  const auto forces_of = [&](const std::string& cards) {
    Conditioned result = good(point_mass + rigid_box + rigid_material + curve + cards);
    result.structure.state.time = 0.5;
    Forces forces;
    forces.resize(9, 1);
    for (auto& force : result.forces) force->add(result.structure.state, forces);
    return forces;
  };
  const Forces vector = forces_of("*LOAD_BODY_VECTOR\n5,10.\n0.6,0.,-0.8\n");
  const Forces axes = forces_of("*LOAD_BODY_X\n5,6.\n*LOAD_BODY_Z\n5,-8.\n");
  EXPECT_NEAR((vector.force[0] - Vector(-2 * 3 * 6, 0, 2 * 3 * 8)).norm(), 0, 1e-12);
  EXPECT_NEAR((vector.force[0] - axes.force[0]).norm(), 0, 1e-12);
  EXPECT_NEAR((vector.body_force[0] - axes.body_force[0]).norm(), 0, 1e-11);
  EXPECT_GT(axes.body_force[0].norm(), 100);
  const Conditioned bad = conditioned(point_mass + curve + "*LOAD_BODY_VECTOR\n5,10.\n0.,0.,2.\n");
  ASSERT_FALSE(bad.status.ok());
  EXPECT_NE(bad.status.error().message.find("length 2"), std::string::npos) << bad.status.error().message;
  EXPECT_FALSE(conditioned(point_mass + curve + "*LOAD_BODY_VECTOR\n5,10.\n\n").status.ok());
}

/// A brick of part 3 (nodes 21 to 28, mass 2) beside the rigid box, damped relative to it.
std::string damped_beside_box(const std::string& card) {
  return rigid_box + rigid_material +
         "*NODE\n21,5.,0.,0.\n22,6.,0.,0.\n23,6.,1.,0.\n24,5.,1.,0.\n25,5.,0.,1.\n26,6.,0.,1.\n27,6.,1.,1.\n"
         "28,5.,1.,1.\n*ELEMENT_SOLID\n19,3,21,22,23,24,25,26,27,28\n*PART\nsoft\n3,3,3\n*SECTION_SOLID\n3,1\n"
         "*MAT_ELASTIC\n3,2.,1000.,0.3\n*SET_PART_LIST\n4\n3\n*DEFINE_CURVE\n5\n0.,0.1\n1.,0.3\n*DAMPING_RELATIVE\n" +
         card;
}

// −D m (v − V − ω × r) with D = 4 π FREQ CDAMP, node by node; what moves with the body is not damped, and the body
// feels nothing.
TEST(Loads, RelativeDampingIsThatOfTheRelativeVelocity) {
  for (const bool by_curve : {false, true}) {
    Conditioned result = good(damped_beside_box(by_curve ? "7.,3.,7,4,0.,5\n" : "0.2,3.,7,4\n"));
    ASSERT_EQ(result.forces.size(), 1u);
    Structure& structure = result.structure;
    State& state = structure.state;
    state.time = 0.5;  // the curve is 0.2 there
    const Vector velocity(1, 2, 3), spin(-2, 0.5, 1.5);
    structure.rigid.set_motion(0, velocity, spin, state);
    structure.rigid.start(state);
    for (std::size_t i = 8; i < 16; ++i) {
      const auto angle = static_cast<double>(i);
      state.v[i] = Vector(std::cos(angle), std::sin(3 * angle), 2);
    }
    Forces forces;
    forces.resize(16, 1);
    result.forces[0]->add(state, forces);
    const double constant = 4 * std::numbers::pi * 3 * 0.2;
    for (std::size_t i = 8; i < 16; ++i) {
      const Vector frame = velocity + spin.cross(state.x[i] - structure.rigid[0].center());
      EXPECT_NEAR((forces.force[i] + constant * 0.25 * (state.v[i] - frame)).norm(), 0, 1e-12) << i;
      state.v[i] = frame;
    }
    EXPECT_GT(forces.force[8].norm(), 1);
    EXPECT_EQ(forces.body_force[0], Vector::Zero());
    forces.resize(16, 1);
    result.forces[0]->add(state, forces);
    for (const Vector& force : forces.force) EXPECT_NEAR(force.norm(), 0, 1e-12);
    EXPECT_NEAR(result.forces[0]->stable_step(), 1 / constant, 1e-12);
  }
}

// The relative velocity falls with (1 − D dt)ⁿ while the box flies on; the loss is of the relative motion, and what the
// frame does is external work.
TEST(Loads, RelativeDampingOverTime) {
  constexpr double dt = 1e-3, fly = 10, slip = 3;
  Stepper stepper =
      good(damped_beside_box("0.2,3.,7,4\n*SET_NODE_LIST\n8\n21,22,23,24,25,26,27,28\n"
                             "*SET_NODE_LIST\n9\n11,12,13,14,15,16,17,18\n*INITIAL_VELOCITY\n8\n13.,0.,0.\n"
                             "*INITIAL_VELOCITY\n9\n10.,0.,0.\n"))
          .stepper(fixed_step(dt));
  run(stepper, 300);
  const double constant = 4 * std::numbers::pi * 3 * 0.2;
  const double left = slip * (1 - constant * dt / 2) * std::pow(1 - constant * dt, 299);
  EXPECT_NEAR(stepper.state().v[8].x(), fly + left, 1e-10);
  EXPECT_EQ(stepper.structure().rigid[0].velocity().x(), fly);
  const Energies& e = stepper.energies();
  EXPECT_NEAR(e.total() - e.initial, e.external, 1e-9);
  EXPECT_NEAR(e.external, 2 * fly * (left - slip), 0.05) << "the frame brakes it: momentum times its velocity";
  EXPECT_NEAR(e.absorbed.damping, 2 / 2. * (slip * slip - left * left), 0.03);
}

TEST(Loads, RelativeDampingRefused) {
  const auto refused = [](const std::string& card, std::string_view text) {
    const Conditioned bad = conditioned(damped_beside_box(card));
    ASSERT_FALSE(bad.status.ok()) << text;
    EXPECT_NE(bad.status.error().message.find(text), std::string::npos) << bad.status.error().message;
    EXPECT_GT(bad.status.error().place.line, 0u);
  };
  refused("-0.2,3.,7,4\n", "CDAMP");
  refused("0.2,-3.,7,4\n", "FREQ");
  refused("0.2,3.,3,4\n", "no rigid part");
  refused("0.2,3.,0,4\n", "no rigid part");
  refused("0.2,3.,7,5\n", "part set 5");
  refused("0.2,3.,7\n", "PSID");
  refused("0.2,3.,7,4,1.\n", "DV2");
  refused("0.2,3.,7,4,0.,6\n", "curve 6");
}

TEST(Loads, DampingByACurveAndDirection) {
  Conditioned result = good(
      point_mass + "*DEFINE_CURVE\n5\n0.,2.\n1.,4.\n*DAMPING_GLOBAL\n5,0.,0.,1.\n*INITIAL_VELOCITY\n0\n3.,3.,0.\n");
  Forces forces;
  forces.resize(1);
  result.structure.state.time = 0.5;
  ASSERT_EQ(result.forces.size(), 1u);
  result.forces[0]->add(result.structure.state, forces);
  EXPECT_NEAR((forces.force[0] - Vector(0, -3.0 * 2 * 3, 0)).norm(), 0, 1e-14);
  EXPECT_NEAR(result.forces[0]->stable_step(), 1.0 / 3, 1e-15);
}

// In a frame that turns: x = x₀ cosh(n α) with 2 sinh(α / 2) = ω dt, nothing along the axis.
TEST(Loads, TurningFrame) {
  constexpr double rate = 2, dt = 0.01;
  Stepper stepper =
      good("*NODE\n1,3.,5.,4.\n*ELEMENT_MASS\n1,1,2.\n*LOAD_BODY_RY\n5,2.,0,1.,9.,4.\n" + one).stepper(fixed_step(dt));
  run(stepper, 100);
  EXPECT_NEAR(stepper.state().x[0].x(), 1 + 2 * std::cosh(100 * 2 * std::asinh(rate * dt / 2)), 1e-11);
  EXPECT_EQ(stepper.state().x[0].y(), 5);
  EXPECT_NEAR(stepper.state().x[0].z(), 4, 1e-14);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-11);
  // A rigid body: the sums over its masses.
  Conditioned body = good(
      "*NODE\n1,1.,0.,0.\n2,0.,2.,1.\n3,3.,1.,2.\n*ELEMENT_MASS\n1,1,2.\n2,2,1.\n3,3,3.\n*SET_NODE_LIST\n4\n1,2,3\n"
      "*CONSTRAINED_NODAL_RIGID_BODY\n4,0,4\n*LOAD_BODY_RZ\n5,2.,0,0.5,0.,0.\n" +
      one);
  Forces forces;
  forces.resize(3, 1);
  body.forces[0]->add(body.structure.state, forces);
  Vector force = Vector::Zero(), moment = Vector::Zero();
  const Vector center = body.structure.rigid[0].center();
  for (const auto& [x, mass] : {std::pair{Vector(1, 0, 0), 2}, {Vector(0, 2, 1), 1}, {Vector(3, 1, 2), 3}}) {
    const Vector push = mass * rate * rate * Vector(x.x() - 0.5, x.y(), 0);
    force += push;
    moment += (x - center).cross(push);
  }
  EXPECT_NEAR((forces.body_force[0] - force).norm(), 0, 1e-12);
  EXPECT_NEAR((forces.body_moment[0] - moment).norm(), 0, 1e-12);
  EXPECT_GT(moment.norm(), 1);
}

// The damped part slows down as *DAMPING_GLOBAL has it, the other one flies on; the same for a rigid part.
TEST(Loads, DampingOfParts) {
  constexpr double damping = 1.5, dt = 0.001;
  const std::string other =
      "*NODE\n5,9.,0.,0.\n6,10.,0.,0.\n7,10.,1.,0.\n8,9.,1.,0.\n*ELEMENT_SHELL\n2,2,5,6,7,8\n*PART\nq\n2,1,1\n";
  Stepper stepper = good(plate(1, 1, {1, 1, 0}) + elastic_deck(shell_section, 1000, 0.3, 7) + other + rigid_box +
                         rigid_material + one + "*DAMPING_PART_MASS\n1,5,1.5\n*SET_PART_LIST\n3\n7\n" +
                         "*DAMPING_PART_MASS_SET\n3,5,1.5,1\n1.,0.,1.,1.,1.,1.\n*INITIAL_VELOCITY\n0\n3.,2.,0.\n")
                        .stepper(fixed_step(dt));
  run(stepper, 100);
  const double left = (1 - damping * dt / 2) * std::pow(1 - damping * dt, 99);
  EXPECT_NEAR(stepper.state().v[0].x(), 3 * left, 1e-10);
  EXPECT_NEAR(stepper.state().v[0].y(), 2 * left, 1e-10);
  EXPECT_NEAR(stepper.state().v[4].x(), 3, 1e-10);
  EXPECT_NEAR(stepper.structure().rigid[0].velocity().x(), 3 * left, 1e-10);
  EXPECT_NEAR(stepper.structure().rigid[0].velocity().y(), 2, 1e-10);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-10);
  EXPECT_GT(stepper.energies().absorbed.damping, 0);
}

TEST(Loads, WhatCannotBeIsAFailure) {
  for (const auto& [cards, text] : std::vector<std::pair<std::string, std::string>>{
           {"*LOAD_NODE_POINT\n1,1,99\n", "*LOAD_NODE_POINT: curve 99"},
           {"*LOAD_NODE_POINT\n1,4,5\n", "DOF 4"},
           {"*LOAD_NODE_POINT\n1,1,5,1.,3\n", "local system 3"},
           {"*LOAD_NODE_POINT\n1,5,5\n", "no rotational inertia"},
           {"*NODE\n2,0.,0.,0.\n*LOAD_NODE_POINT\n2,1,5\n", "node 2 has no mass"},
           {"*LOAD_NODE_SET\n4,1,5\n", "node set 4"},
           {"*LOAD_RIGID_BODY\n4,1,5\n", "4 is no rigid part"},
           {"*LOAD_SEGMENT\n5,1.,0.,1,1,8\n", "node 8"},
           {"*LOAD_SEGMENT_SET\n6,5\n", "segment set 6"},
           {"*LOAD_SHELL_ELEMENT\n6,5\n", "shell 6"},
           {"*LOAD_SHELL_SET\n6,5\n", "shell set 6"},
           {"*LOAD_BODY_X\n99\n", "curve 99"},
           {"*LOAD_BODY_X\n5\n*LOAD_BODY_PARTS\n8\n", "part set 8"},
           {"*DAMPING_PART_MASS\n9,5,1.\n", "part 9"},
           {"*DAMPING_PART_MASS_SET\n9,5,1.\n", "part set 9"},
           {"*LOAD_BODY_RX\n99\n", "curve 99"},
           {"*DAMPING_GLOBAL\n99\n", "curve 99"}}) {
    const Conditioned result = conditioned(point_mass + one + cards);
    ASSERT_FALSE(result.status.ok()) << cards;
    EXPECT_NE(result.status.error().message.find(text), std::string::npos) << result.status.error().message;
  }
}

}  // namespace
}  // namespace gapcheck::solver::loads_test
