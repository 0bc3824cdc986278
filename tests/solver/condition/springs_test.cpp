#include "solver/condition/springs.hpp"

#include <cmath>
#include <numbers>

#include "solver/build/build_forces.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::springs_test {
namespace {

/// A stepper with the springs of a deck.
struct Oscillation {
  Stepper stepper;
  const Springs* springs;
};

Oscillation run_of(const std::string& deck, const std::vector<Vector>& velocity, double step,
                   const std::vector<double>& inertia = {}) {
  const model::Read read = model::read_text(deck);
  EXPECT_EQ(read.errors(), 0u) << read.text();
  Diagnostics diagnostics;
  Structure structure = build_structure(read.model, {}, diagnostics).value();
  for (std::size_t i = 0; i < inertia.size(); ++i) structure.state.inertia[i] = inertia[i];
  for (std::size_t i = 0; i < velocity.size(); ++i)
    (inertia.empty() ? structure.state.v : structure.state.w)[i] = velocity[i];
  std::vector<std::unique_ptr<Force>> forces;
  const SolverStatus added = add_walls_and_springs(read.model, structure, forces, diagnostics);
  EXPECT_TRUE(added.ok()) << added.error().message;
  EXPECT_TRUE(diagnostics.sorted().empty());
  StepSettings settings;
  settings.greatest_step = step;
  Oscillation run{Stepper(std::move(structure), settings), dynamic_cast<const Springs*>(forces.at(0).get())};
  run.stepper.add(std::move(forces[0]));
  return run;
}

void go(Oscillation& run, int steps) {
  for (int i = 0; i < steps; ++i) {
    const SolverStatus status = run.stepper.step();
    ASSERT_TRUE(status.ok()) << status.error().message;
  }
}

const std::string one_mass = "*NODE\n1,0.,0.,0.\n*ELEMENT_MASS\n1,1,2.\n*ELEMENT_DISCRETE\n1,1,1,0\n";
const std::string two_masses =
    "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n*ELEMENT_MASS\n1,1,2.\n2,2,3.\n*ELEMENT_DISCRETE\n1,1,1,2\n";
const std::string part = "*PART\np\n1,1,1\n*SECTION_DISCRETE\n1\n\n";

// Central differences give x_n = v/ω' sin(n ω_d dt) with sin(ω_d dt / 2) = ω dt / 2, started half a step into it.
TEST(Springs, PeriodOfAMassOnTheGround) {
  constexpr double mass = 2, stiffness = 50, step = 0.05, speed = 0.3;
  Oscillation run = run_of(one_mass + part + "*MAT_SPRING_ELASTIC\n1,50.\n", {Vector(0, speed, 0)}, step);
  const double omega = std::sqrt(stiffness / mass), turn = 2 * std::asin(omega * step / 2);
  // x_0 = 0, x_1 = v dt: the first force is zero.
  for (int n = 1; n <= 500; ++n) {
    go(run, 1);
    EXPECT_NEAR(run.stepper.state().x[0].y(), speed * step * std::sin(n * turn) / std::sin(turn), 1e-12);
  }
  EXPECT_NEAR(run.stepper.energies().ratio(), 1, 1e-12);
  EXPECT_EQ(run.stepper.state().x[0].x(), 0);
}

TEST(Springs, TwoMassesAndTheEnergyOfTheSpring) {
  Oscillation run =
      run_of(two_masses + part + "*MAT_SPRING_ELASTIC\n1,50.\n", {Vector(-0.03, 0, 0), Vector(0.02, 0, 0)}, 1e-3);
  go(run, 1000);
  const double elongation = run.springs->elongation(0);
  EXPECT_NEAR(run.springs->tension(0), 50 * elongation, 1e-12);
  EXPECT_NEAR(run.stepper.energies().absorbed.springs, 25 * elongation * elongation, 1e-9);
  EXPECT_NEAR(run.stepper.energies().external, 0, 1e-12);
  EXPECT_NEAR(run.stepper.energies().ratio(), 1, 1e-11);
  // ω² = k (1/m1 + 1/m2)
  const double omega = std::sqrt(50.0 * 5 / 6), relative = 0.05;
  EXPECT_NEAR(elongation, relative / omega * std::sin(omega * 0.999), 1e-6);
}

// S scales, the offset stretches at the start.
TEST(Springs, ScaleAndOffset) {
  const std::string deck =
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n*ELEMENT_MASS\n1,1,2.\n2,2,3.\n*ELEMENT_DISCRETE\n"
      "1,1,1,2,0,3.,0,0.01\n";
  Oscillation run = run_of(deck + part + "*MAT_SPRING_ELASTIC\n1,50.\n", {}, 1e-3);
  go(run, 1);
  EXPECT_NEAR(run.springs->tension(0), 3 * 50 * 0.01, 1e-14);
  EXPECT_NEAR(run.stepper.net().force[0].x(), 1.5, 1e-14);
  EXPECT_NEAR(run.stepper.net().force[1].x(), -1.5, 1e-14);
}

// A damper: v is multiplied with 1 − c dt / m in each step, with 1 − c dt / 2 m in the first.
TEST(Springs, DamperDecay) {
  constexpr double step = 0.01;
  Oscillation run = run_of(one_mass + part + "*MAT_DAMPER_VISCOUS\n1,3.\n", {Vector(0.4, 0, 0)}, step);
  double speed = 0.4;
  for (int n = 0; n < 300; ++n) {
    go(run, 1);
    speed *= 1 - 3 * step / 2 / (n == 0 ? 2 : 1);
    EXPECT_NEAR(run.stepper.state().v[0].x(), speed, 1e-13);
  }
  EXPECT_NEAR(run.stepper.energies().absorbed.springs + run.stepper.energies().kinetic, run.stepper.energies().initial,
              1e-13);
  EXPECT_GT(run.stepper.energies().absorbed.springs, 0.9 * run.stepper.energies().initial);
}

TEST(Springs, NonlinearCurve) {
  Oscillation run = run_of(
      two_masses + part + "*MAT_SPRING_NONLINEAR_ELASTIC\n1,7\n*DEFINE_CURVE\n7\n-1.,-20.\n0.,0.\n0.1,1.\n0.2,9.\n",
      {Vector(0, 0, 0), Vector(0.5, 0, 0)}, 1e-3);
  double least = 0, most = 0;
  for (int i = 0; i < 1000; ++i) {
    go(run, 1);
    const double u = run.springs->elongation(0);
    const double expected = u < 0 ? 20 * u : u < 0.1 ? 10 * u : 1 + 80 * (u - 0.1);
    EXPECT_NEAR(run.springs->tension(0), expected, 1e-12);
    // The area below the curve, which the works meet but for the steps over its corners.
    const double stored = u < 0 ? 10 * u * u : u < 0.1 ? 5 * u * u : 0.05 + (u - 0.1) + 40 * (u - 0.1) * (u - 0.1);
    Absorbed held;
    run.springs->held(held);
    EXPECT_NEAR(held.springs, stored, 1e-13);
    EXPECT_NEAR(run.stepper.energies().absorbed.springs, stored, 1e-4);
    least = std::min(least, u);
    most = std::max(most, u);
  }
  EXPECT_LT(least, -0.05);
  EXPECT_GT(most, 0.1);
  EXPECT_NEAR(run.stepper.energies().ratio(), 1, 1e-9);
}

// Node and ground are in one place: there is no line for an offset to count along, nor energy in it.
TEST(Springs, NoOffsetWithoutALine) {
  Oscillation run = run_of("*NODE\n1,0.,0.,0.\n*ELEMENT_MASS\n1,1,2.\n*ELEMENT_DISCRETE\n1,1,1,0,0,1.,0,0.3\n" + part +
                               "*MAT_SPRING_ELASTIC\n1,50.\n",
                           {Vector(0.1, 0, 0)}, 1e-3);
  go(run, 100);
  const double u = run.springs->elongation(0);
  EXPECT_NEAR(u, 0.1 / 5 * std::sin(5 * 0.099), 1e-6);
  Absorbed held;
  run.springs->held(held);
  EXPECT_NEAR(held.springs, 25 * u * u, 1e-13);
}

// Two inertias turn against one another about the line between them.
TEST(Springs, Torsion) {
  constexpr double step = 1e-2, stiffness = 50;
  Oscillation run = run_of(two_masses + "*PART\np\n1,1,1\n*SECTION_DISCRETE\n1,1\n\n*MAT_SPRING_ELASTIC\n1,50.\n",
                           {Vector(0, 0, 0), Vector(0.1, 0, 0)}, step, {2, 3});
  const double omega = std::sqrt(stiffness * 5 / 6), turn = 2 * std::asin(omega * step / 2);
  for (int n = 0; n < 100; ++n) {
    go(run, 1);
    EXPECT_NEAR(run.springs->elongation(0), 0.1 * step * std::sin(n * turn) / std::sin(turn), 1e-12);
  }
  EXPECT_NEAR(run.stepper.energies().ratio(), 1, 1e-11);
}

// Nodes that meet leave no axis to turn about: no moment, until they part again.
TEST(Springs, TorsionOfNodesThatMeet) {
  Oscillation run = run_of(two_masses + "*PART\np\n1,1,1\n*SECTION_DISCRETE\n1,1\n\n*MAT_SPRING_ELASTIC\n1,50.\n",
                           {Vector(0, 0, 0), Vector(0.1, 0, 0)}, 1e-2, {2, 3});
  go(run, 10);
  State state = run.stepper.state();
  state.x[1] = state.x[0];
  Forces forces;
  forces.resize(2);
  const_cast<Springs*>(run.springs)->add(state, forces);
  EXPECT_EQ(forces.moment[0], Vector::Zero());
  EXPECT_EQ(forces.moment[1], Vector::Zero());
}

// The step is limited so that a chain of springs stays stable, and not more than needed.
TEST(Springs, StableStep) {
  std::string deck = "*NODE\n";
  for (int i = 1; i <= 20; ++i) deck += fmt::format("{},{}.,0.,0.\n", i, i);
  deck += "*ELEMENT_MASS\n";
  for (int i = 1; i <= 20; ++i) deck += fmt::format("{},{},0.01\n", i, i);
  deck += "*ELEMENT_DISCRETE\n";
  for (int i = 1; i < 20; ++i) deck += fmt::format("{},1,{},{}\n", i, i, i + 1);
  std::vector<Vector> velocity(20, Vector::Zero());
  velocity[3] = {1e-3, 0, 0};
  for (const char* material : {"*MAT_SPRING_ELASTIC\n1,5000.\n", "*MAT_DAMPER_VISCOUS\n1,30.\n"}) {
    Oscillation run = run_of(deck + part + material, velocity, 1);
    go(run, 3000);
    EXPECT_LT(run.stepper.state().dt, 1);
    EXPECT_NEAR(run.stepper.energies().ratio(), 1, 1e-9);
    for (const Vector& v : run.stepper.state().v) EXPECT_LT(v.norm(), 2e-3);
  }
  // ω² = 4 k / m for the chain.
  Oscillation run = run_of(deck + part + "*MAT_SPRING_ELASTIC\n1,5000.\n", velocity, 1);
  EXPECT_NEAR(run.springs->stable_step(), std::sqrt(0.19) * 2 / std::sqrt(4 * 5000 / 0.01), 1e-12);
  // 2 c dt = 0.76 with c = 4 · 30 / m.
  const Oscillation damped = run_of(deck + part + "*MAT_DAMPER_VISCOUS\n1,30.\n", velocity, 1);
  EXPECT_NEAR(damped.springs->stable_step(), 0.38 / (4 * 30 / 0.01), 1e-15);
}

// A lone shell runs at the bound of its step, which leaves springs less room than 0.9 of it does.
TEST(Springs, OnALoneShellAtTheBoundOfItsStep) {
  const std::string deck =
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,1.,0.\n4,1.,1.,0.\n*ELEMENT_SHELL\n1,1,1,2,4,3\n*PART\np\n1,1,1\n"
      "*SECTION_SHELL\n1,2,0.8333333333333333,5\n0.1,\n*MAT_ELASTIC\n1,1.,1.,0.\n*PART\ns\n2,2,2\n"
      "*SECTION_DISCRETE\n2\n\n*ELEMENT_DISCRETE\n1,2,1,0\n2,2,2,0\n3,2,3,0\n4,2,4,0\n";
  for (const double stiffness : {1e-5, 1e-3, 5e-3, 1e-2, 1.5e-2, 1.85e-2, 0.1, 10.0}) {
    Oscillation run = run_of(deck + fmt::format("*MAT_SPRING_ELASTIC\n2,{}\n", stiffness),
                             {Vector(1e-6, 2e-6, 3e-6), Vector(-1e-6, 1e-6, 3e-6), Vector(-1e-6, 5e-7, 1e-6)}, 1e9);
    double fastest = 0;
    for (int i = 0; i < 4000; ++i) {
      ASSERT_TRUE(run.stepper.step().ok()) << stiffness;
      for (const Vector& v : run.stepper.state().v) fastest = std::max(fastest, v.norm());
    }
    EXPECT_LT(fastest, 2e-5) << stiffness;
    EXPECT_GT(run.stepper.state().elements_share, 3.9);
  }
  // Soft springs cost nothing.
  const auto step = [&](double stiffness) {
    Oscillation run = run_of(deck + fmt::format("*MAT_SPRING_ELASTIC\n2,{}\n", stiffness), {}, 1e9);
    EXPECT_TRUE(run.stepper.step().ok());
    return run.stepper.state().dt;
  };
  EXPECT_EQ(step(1e-5), step(1e-9));
  EXPECT_LT(step(1.5e-2), 0.95 * step(1e-5));
}

// On a rigid body its mass counts, not that of the node.
TEST(Springs, OnARigidBody) {
  const std::string deck =
      brick_bar(1, {1, 1, 1}) + "*PART\np\n1,2,2\n*PART\ns\n2,1,1\n" + "*SECTION_DISCRETE\n1\n\n*SECTION_SOLID\n2,1\n" +
      "*MAT_SPRING_ELASTIC\n1,50.\n*MAT_RIGID\n2,4.,1000.,0.3\n*ELEMENT_DISCRETE\n9,2,1,0\n10,2,8,0\n";
  const model::Read read = model::read_text(deck);
  EXPECT_EQ(read.errors(), 0u) << read.text();
  Diagnostics diagnostics;
  Structure structure = build_structure(read.model, {}, diagnostics).value();
  structure.rigid.set_motion(0, {0.1, 0, 0}, {0, 0, 0}, structure.state);
  std::vector<std::unique_ptr<Force>> forces;
  ASSERT_TRUE(add_walls_and_springs(read.model, structure, forces, diagnostics).ok());
  EXPECT_GT(forces.at(0)->stable_step(), 0.01);
  StepSettings settings;
  settings.greatest_step = 1e-2;
  Stepper stepper(std::move(structure), settings);
  stepper.add(std::move(forces[0]));
  for (int i = 0; i < 500; ++i) ASSERT_TRUE(stepper.step().ok());
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-6);  // the body turns: curved ways within a step
  EXPECT_GT(stepper.energies().absorbed.springs, 0);
}

// S03 between a mass and the ground stops it after FY²/2K + FY u_p = m v²/2; it then swings about u_p.
TEST(Springs, PlasticSpringStopsAMass) {
  constexpr double step = 1e-4, speed = 0.9, energy = speed * speed;
  Oscillation run = run_of(one_mass + part + "*MAT_SPRING_ELASTOPLASTIC\n1,100.,0.,3.\n", {Vector(0, speed, 0)}, step);
  const double plastic = (energy - 9 / 200.) / 3;
  double most = 0, least = 1;
  for (int i = 0; i < 30000; ++i) {
    go(run, 1);
    const double y = run.stepper.state().x[0].y();
    most = std::max(most, y);
    if (i > 20000) least = std::min(least, y);
    EXPECT_LT(run.springs->tension(0), 3 + 1e-12);
  }
  EXPECT_NEAR(most, plastic + 0.03, 1e-4);
  EXPECT_NEAR(least, plastic - 0.03, 1e-4);
  Absorbed held;
  run.springs->held(held);
  EXPECT_NEAR(held.springs, run.stepper.energies().absorbed.springs, 1e-5);
  EXPECT_GT(held.springs, 3 * plastic - 1e-5);
  EXPECT_NEAR(run.stepper.energies().ratio(), 1, 1e-10);
}

// S08 along a line: the masses fly into one another against k and part with KU, so slower by √(k / KU); the same card
// for tension does not stop them.
TEST(Springs, InelasticSpringGivesBackALittle) {
  for (const int sense : {1, -1}) {
    Oscillation run = run_of(
        two_masses + part + fmt::format("*MAT_SPRING_INELASTIC\n1,7,800.,{}\n*DEFINE_CURVE\n7\n0.,0.\n1.,50.\n", sense),
        {Vector(0.2, 0, 0), Vector(-0.3, 0, 0)}, 1e-4);
    go(run, 6000);
    const auto& v = run.stepper.state().v;
    EXPECT_NEAR(v[1].x() - v[0].x(), sense == 1 ? 0.5 * std::sqrt(50 / 800.) : -0.5, 1e-3) << sense;
    EXPECT_EQ(run.springs->tension(0), 0);
    EXPECT_NEAR(run.stepper.energies().absorbed.springs, sense == 1 ? 0.5 * 1.2 * 0.25 * (1 - 50 / 800.) : 0, 1e-4);
    Absorbed held;
    run.springs->held(held);
    EXPECT_NEAR(held.springs, run.stepper.energies().absorbed.springs, 1e-5);
    EXPECT_NEAR(run.stepper.energies().ratio(), 1, 1e-10);
  }
}

// S05 along a line: 2 for what parts, 4 for what meets; each step multiplies the rate as a damper of that constant
// does.
TEST(Springs, NonlinearDamper) {
  constexpr double step = 0.01, mass = 1.2;
  for (const double speed : {0.5, -0.5}) {
    Oscillation run =
        run_of(two_masses + part + "*MAT_DAMPER_NONLINEAR_VISCOUS\n1,7\n*DEFINE_CURVE\n7\n-1.,-4.\n0.,0.\n1.,2.\n",
               {Vector(0, 0, 0), Vector(speed, 0, 0)}, step);
    const double constant = speed > 0 ? 2 : 4;
    double rate = speed;
    for (int n = 0; n < 60; ++n) {
      go(run, 1);
      EXPECT_NEAR(run.springs->tension(0), constant * rate, 1e-12);
      rate *= 1 - constant * step / mass / (n == 0 ? 2 : 1);
      EXPECT_NEAR(run.stepper.state().v[1].x() - run.stepper.state().v[0].x(), rate, 1e-12);
    }
    Absorbed held;
    run.springs->held(held);
    EXPECT_NEAR(held.springs, run.stepper.energies().absorbed.springs, 1e-13);
    EXPECT_GT(held.springs, 0.5 * mass * 0.25 * 0.5);
  }
}

// Without a line it resists the velocity as it is.
TEST(Springs, NonlinearDamperOfALoneMass) {
  Oscillation run = run_of(one_mass + part + "*MAT_S05\n1,7\n*DEFINE_CURVE\n7\n-1.,-4.\n0.,0.\n1.,2.\n",
                           {Vector(0.3, 0, -0.4)}, 0.01);
  go(run, 1);
  EXPECT_NEAR((run.stepper.net().force[0] + Vector(0.6, 0, -0.8)).norm(), 0, 1e-13);
  go(run, 200);
  EXPECT_NEAR(run.stepper.energies().absorbed.springs + run.stepper.energies().kinetic, run.stepper.energies().initial,
              1e-13);
  EXPECT_LT(run.stepper.energies().kinetic, 0.01);
}

// S07 with an offset is stretched at once, with K0, and relaxes between nodes that hold still.
TEST(Springs, MaxwellSpringRelaxes) {
  const std::string deck =
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n*ELEMENT_MASS\n1,1,2.e9\n2,2,3.e9\n*ELEMENT_DISCRETE\n1,1,1,2,0,2.,0,0.1\n";
  Oscillation run = run_of(deck + part + "*MAT_SPRING_MAXWELL\n1,100.,20.,4.,0.9,7.\n", {}, 1e-2);
  for (int n = 0; n < 100; ++n) {
    go(run, 1);
    const double time = 0.01 * n;
    if (time < 0.895) {
      EXPECT_NEAR(run.springs->tension(0), 2 * (20 * 0.1 + 80 * 0.1 * std::exp(-4 * time)), 1e-6) << time;
    } else if (time > 0.905) {
      EXPECT_EQ(run.springs->tension(0), 14);
    }
  }
  EXPECT_GT(run.stepper.net().force[0].x(), 0);  // tension pulls the first node to the second one
}

TEST(Springs, MaxwellEnergies) {
  Oscillation run =
      run_of(two_masses + part + "*MAT_SPRING_MAXWELL\n1,100.,20.,4.\n", {Vector(0, 0, 0), Vector(0.5, 0, 0)}, 1e-3);
  for (int i = 0; i < 3000; ++i) {
    go(run, 1);
    Absorbed held;
    run.springs->held(held);
    EXPECT_NEAR(held.springs, run.stepper.energies().absorbed.springs, 1e-5);
  }
  EXPECT_NEAR(run.stepper.energies().ratio(), 1, 1e-10);
  EXPECT_GT(run.stepper.energies().absorbed.springs, 0.1);
}

// Moments above FY turn the nodes on against FY alone: the spin falls by FY dt (1/J1 + 1/J2) in each step.
TEST(Springs, PlasticTorsion) {
  Oscillation run = run_of(two_masses + "*PART\np\n1,1,1\n*SECTION_DISCRETE\n1,1\n\n*MAT_S03\n1,50.,0.,0.2\n",
                           {Vector(0, 0, 0), Vector(0.5, 0, 0)}, 1e-3, {2, 3});
  go(run, 100);
  const double before = run.stepper.state().w[1].x() - run.stepper.state().w[0].x();
  go(run, 50);
  const double after = run.stepper.state().w[1].x() - run.stepper.state().w[0].x();
  EXPECT_EQ(run.springs->tension(0), 0.2);
  EXPECT_NEAR(before - after, 50 * 1e-3 * 0.2 * 5 / 6, 1e-12);
  EXPECT_NEAR(run.stepper.energies().ratio(), 1, 1e-11);
}

TEST(Springs, WhatIsMissingOrNotCalculatedIsTold) {
  const auto outcome = [](const std::string& deck, Diagnostics& diagnostics) {
    const model::Read read = model::read_text(deck);
    const Structure structure = build_structure(read.model, {}, diagnostics).value();
    std::vector<std::unique_ptr<Force>> forces;
    return add_walls_and_springs(read.model, structure, forces, diagnostics);
  };
  Diagnostics unused;
  EXPECT_EQ(outcome(one_mass, unused).error().kind, Failure::Kind::missing_material);
  EXPECT_EQ(outcome(one_mass + "*PART\np\n1,1,1\n*SECTION_SOLID\n1,1\n*MAT_S01\n1,1.\n", unused).error().kind,
            Failure::Kind::missing_material);
  EXPECT_EQ(outcome(one_mass + part + "*MAT_S05\n1,7\n", unused).error().kind, Failure::Kind::bad_material);
  EXPECT_EQ(outcome(one_mass + part + "*MAT_S06\n1,7,7\n", unused).error().kind, Failure::Kind::bad_material);
  const std::string curve = "*DEFINE_CURVE\n7\n0.,0.\n1.,1.\n";
  const SolverStatus senseless = outcome(one_mass + part + "*MAT_S08\n1,7\n" + curve, unused);
  ASSERT_FALSE(senseless.ok());
  EXPECT_NE(senseless.error().message.find("cannot tell tension from compression"), std::string::npos);
  EXPECT_EQ(senseless.error().place.line, 6u);
  EXPECT_FALSE(outcome(one_mass + part + "*MAT_S07\n1,5.,1.,1.,1.,2.\n", unused).ok());
  EXPECT_TRUE(outcome(one_mass + part + "*MAT_S07\n1,5.,1.,1.\n", unused).ok());
  EXPECT_TRUE(outcome(two_masses + part + "*MAT_S08\n1,7\n" + curve, unused).ok());
  EXPECT_EQ(outcome(one_mass + part + "*MAT_S04\n1,7\n", unused).error().kind, Failure::Kind::bad_material);
  Diagnostics diagnostics;
  EXPECT_TRUE(outcome("*NODE\n1,0.,0.,0.\n*ELEMENT_MASS\n1,1,2.\n*ELEMENT_DISCRETE\n1,1,1,0,5\n2,2,1,0\n3,3,1,0\n" +
                          part +
                          "*PART\nt\n2,2,1\n*PART\nl\n3,3,1\n*SECTION_DISCRETE\n2,1\n\n3,0,1.\n\n*MAT_S01\n1,1.\n",
                      diagnostics)
                  .ok());
  std::string text;
  for (const Diagnostic& d : diagnostics.sorted()) text += d.message + "\n";
  EXPECT_EQ(
      text,
      "discrete element 1 acts along a vector (VID), which is not calculated; it takes no part in the calculation\n"
      "discrete element 2 has no axis to turn about; it takes no part in the calculation\n"
      "section 3: KD, V0, CL, FD, CDL and TDL are not calculated\n");
}

}  // namespace
}  // namespace gapcheck::solver::springs_test
