#include "solver/condition/wall_impulse.hpp"

#include <cmath>

#include "solver/condition/wall_flight.hpp"

namespace gapcheck::solver::wall_impulse_test {
namespace {

// A wall of mass 6 meets a mass of 2: both go on with the common velocity, and the rest of the energy is lost.
TEST(WallImpulse, WallWithAMass) {
  WallFlight flight =
      fly(mass_at("0.,0.,0.0123") + "*RIGIDWALL_PLANAR_MOVING\n1\n0,0,0,0,0,1\n6.,2.\n", {0.5, 0, -1}, 1e-3);
  double impulse = 0;
  for (int i = 0; i < 20; ++i) {
    run(flight, 1);
    impulse += flight.wall().force.z() * 1e-3;
    EXPECT_NEAR(flight.stepper.energies().ratio(), 1, 1e-13);
    EXPECT_NEAR(6 * flight.wall().velocity.z() + 2 * flight.stepper.state().v[0].z(), 10, 1e-12);
  }
  EXPECT_NEAR(flight.stepper.state().v[0].z(), 1.25, 1e-12);
  EXPECT_NEAR(flight.wall().velocity.z(), 1.25, 1e-12);
  EXPECT_NEAR(impulse, 2 * 2.25, 1e-12);
  EXPECT_NEAR(flight.wall().energy, 0.5 * 6 * 2 / 8 * 9, 1e-12);
  EXPECT_NEAR(flight.stepper.energies().external, 0.5 * 6 * (4 - 1.25 * 1.25), 1e-12);  // what the wall has lost
  EXPECT_NEAR(flight.stepper.state().x[0].z(), flight.wall().shift.z() + 1e-3 * flight.wall().velocity.z(), 1e-14);
}

// A wall of mass M runs into a bar: V = V0 exp(−ρ c A t / M) until the wave comes back from the free end.
TEST(WallImpulse, WallWithAMassAgainstARod) {
  constexpr double speed = 0.01, mass = 0.4, resistance = 4 * 10 * 0.01;  // ρ c A
  WallFlight flight = fly(brick_bar(100, {0.1, 0.1, 0.1}) + elastic_deck(solid_section, 400, 0, 4) +
                              "*RIGIDWALL_PLANAR_MOVING\n0\n0,0,0,1,0,0\n0.4,0.01\n",
                          Vector::Zero(), 1e-3);
  double most = 0;
  while (flight.stepper.state().time < 1.5) {
    run(flight, 1);
    const double time = flight.stepper.state().time, expected = speed * std::exp(-resistance * time / mass);
    if (time > 0.1) most = std::max(most, std::abs(flight.wall().velocity.x() - expected) / speed);
    EXPECT_NEAR(flight.stepper.energies().ratio(), 1, 1e-6);
  }
  RecordProperty("moving_wall_velocity_error", fmt::format("{:.2e}", most));
  EXPECT_LT(most, 1e-2);
  EXPECT_LT(flight.wall().velocity.x(), 0.3 * speed);
}

// A wall that follows a curve of velocity or displacement pushes a mass: it lies on the wall at each step, and the work
// is that of the wall.
TEST(WallImpulse, WallThatFollowsACurve) {
  const std::string velocity = "*DEFINE_CURVE\n3\n0.,0.\n1.,4.\n", way = "*DEFINE_CURVE\n3\n0.,0.\n1.,2.\n";
  for (const int option : {0, 1}) {
    WallFlight flight =
        fly(mass_at("0.,0.,0.") +
                fmt::format("*RIGIDWALL_GEOMETRIC_FLAT_MOTION\n1\n0,0,0,0,0,1\n1,0,0\n3,{},0.,0.,3.\n", option) +
                (option == 0 ? velocity : way),
            Vector::Zero(), 1e-2);
    run(flight, 50);
    const State& state = flight.stepper.state();
    EXPECT_NEAR(state.x[0].z(), option == 0 ? 4 * 0.5 * 0.5 / 2 : 1, 1e-12);
    EXPECT_NEAR(state.v[0].z(), option == 0 ? 4 * 0.495 : 2, 1e-12);
    EXPECT_NEAR(flight.stepper.energies().ratio(), 1, 1e-12);
    EXPECT_GT(flight.stepper.energies().external, 0);
  }
  // The curve begins at the wall's birth.
  WallFlight late =
      fly(mass_at("0.,0.,0.") + "*RIGIDWALL_GEOMETRIC_FLAT_MOTION\n1,0,0,0.25\n0,0,0,0,0,1\n1,0,0\n3,0,0.,0.,3.\n" +
              velocity,
          Vector::Zero(), 1.0 / 128);
  run(late, 96);
  EXPECT_NEAR(late.stepper.state().x[0].z(), 4 * 0.5 * 0.5 / 2, 1e-12);
}

// FRIC 2 and 3 weld what comes faster than WVEL, without and with sliding; the rest bounces off a pull.
TEST(WallImpulse, Welds) {
  const auto pulled = [](double fric, double limit) {
    WallFlight flight =
        fly(mass_at("0.,0.,0.01") + fmt::format("*RIGIDWALL_PLANAR\n1\n0,0,0,0,0,1,{},{}\n", fric, limit), {5, 0, -3},
            1e-3);
    flight.stepper.add(std::make_unique<SteadyPush>(Vector(1, 0, 4)));
    run(flight, 500);
    EXPECT_NEAR(flight.stepper.energies().ratio(), 1, 1e-10);
    return flight.stepper.state();
  };
  const State rough = pulled(3, 2), smooth = pulled(2, 2), slow = pulled(2, 4);
  EXPECT_NEAR(rough.x[0].z(), 0, 1e-14);
  EXPECT_NEAR(rough.v[0].norm(), 0, 1e-14);
  EXPECT_NEAR(smooth.x[0].z(), 0, 1e-14);
  EXPECT_NEAR(smooth.v[0].x(), 5 + 0.5 * 0.4995, 1e-12);
  EXPECT_GT(slow.x[0].z(), 0.2);
}

// SOFT: the velocity falls in equal parts over that many cycles, and with it the force.
TEST(WallImpulse, Soft) {
  WallFlight flight = fly(mass_at("0.,0.,0.004") + "*RIGIDWALL_PLANAR_FORCES\n1\n0,0,0,0,0,1\n10\n", {0, 0, -3}, 1e-3);
  run(flight, 2);  // it meets the wall in the second step
  for (int i = 1; i < 10; ++i) {
    EXPECT_NEAR(flight.stepper.state().v[0].z(), -3 * (1 - 0.1 * i), 1e-12);
    run(flight, 1);
    EXPECT_NEAR(flight.wall().force.z(), 2 * 0.3 / 1e-3, 1e-6);
  }
  run(flight, 2);
  EXPECT_NEAR(flight.stepper.state().v[0].z(), 0, 1e-14);
  EXPECT_EQ(flight.wall().touching, 0u);
  EXPECT_NEAR(flight.wall().energy, 9, 1e-12);
  EXPECT_NEAR(flight.stepper.energies().ratio(), 1, 1e-12);
}

// Friction by direction: μa along d, μb across it; between them an ellipse; the same ones as FRIC would be.
TEST(WallImpulse, FrictionByDirection) {
  const auto left = [](const Vector& velocity, const std::string& coefficients) {
    WallFlight flight =
        fly(mass_at("0.,0.,0.01") + "*RIGIDWALL_PLANAR_ORTHO\n1\n0,0,0,0,0,1\n" + coefficients + "\n0,0,1.,0.,0.\n",
            velocity, 1e-3);
    run(flight, 10);
    return flight.stepper.state().v[0];
  };
  EXPECT_NEAR(left({5, 0, -3}, "0.2,0.4,0.2,0.4").x(), 5 - 0.2 * 3, 1e-12);
  EXPECT_NEAR(left({0, 5, -3}, "0.2,0.4,0.2,0.4").y(), 5 - 0.4 * 3, 1e-12);
  EXPECT_NEAR(left({3, 4, -3}, "0.3,0.3,0.3,0.3").norm(), 5 - 0.3 * 3, 1e-3);  // in two steps: the second one's share
  EXPECT_NEAR(left({0.1, 0.1, -3}, "0.2,0.4,0.2,0.4").norm(), 0, 1e-12);
  // The dynamic one at high speed.
  EXPECT_NEAR(left({5, 0, -3}, "0.9,0.9,0.2,0.2,100.,100.").x(), 5 - 0.2 * 3, 1e-12);
}

}  // namespace
}  // namespace gapcheck::solver::wall_impulse_test
