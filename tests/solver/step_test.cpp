#include "solver/step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "base/parallel.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::step_test {
namespace {

/// A force given by a function of the state.
class Given : public Force {
 public:
  explicit Given(std::function<void(const State&, Forces&)> function) : function_(std::move(function)) {}
  void add(State& state, Forces& forces) override { function_(state, forces); }

 private:
  std::function<void(const State&, Forces&)> function_;
};

void expect_good(const SolverStatus& status) { EXPECT_TRUE(status.ok()) << status.error().message; }

Vector angular_momentum(const State& state) {
  Vector sum = Vector::Zero();
  for (std::size_t i = 0; i < state.x.size(); ++i)
    // Midway positions belong to the velocities.
    sum += state.mass[i] * (state.x[i] - state.dt / 2 * state.v[i]).cross(state.v[i]) + state.inertia[i] * state.w[i];
  return sum;
}

// A rod of speed v₀ runs into fixed nodes: the wave goes in with c, behind it σ = −ρ c v₀ and the rod stands still.
TEST(Rod, ImpactStress) {
  constexpr double young = 400, density = 4, speed = 0.01, wave = 10;  // c = √(E/ρ), ν = 0
  constexpr int n = 100;
  Structure rod = structure_of(brick_bar(n, {0.1, 0.1, 0.1}) + elastic_deck(solid_section, young, 0, density));
  for (std::size_t i = 0; i < rod.state.v.size(); ++i) {
    const bool wall = i % (n + 1) == 0;
    rod.state.v[i] = {wall ? 0 : -speed, 0, 0};
    if (wall) rod.constraints.hold(NodeIndex{static_cast<std::uint32_t>(i)}, 7);
  }
  StepSettings settings;
  settings.bounded_step = true;
  Stepper stepper(std::move(rod), settings);
  expect_good(run_until(stepper, 0.5));  // the wave has come to x = 5 of 10
  const SolidElements& solids = stepper.structure().solids;
  for (std::size_t e = 0; e < 40; ++e)
    EXPECT_NEAR(solids.point(e).stress[xx] / (-density * wave * speed), 1, e < 35 ? 0.02 : 0.2) << e;
  for (std::size_t e = 62; e < n; ++e) EXPECT_NEAR(solids.point(e).stress[xx] / (density * wave * speed), 0, 0.01) << e;
  std::size_t front = 0;
  while (solids.point(front).stress[xx] < -0.5 * density * wave * speed) ++front;
  EXPECT_NEAR(static_cast<double>(front), 50, 2);
  for (std::size_t e = 0; e < 35; ++e) EXPECT_NEAR(stepper.state().v[e].x() / speed, 0, 0.03);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-3);
  EXPECT_LT(stepper.energies().hourglass, 2e-3 * stepper.energies().internal);
}

// Held at one end, the rod's tip comes back to zero after half a period 2 L / c, less what the mesh disperses.
TEST(Rod, FirstFrequency) {
  constexpr int n = 40;
  Structure rod = structure_of(brick_bar(n, {0.25, 0.25, 0.25}) + elastic_deck(solid_section, 400, 0, 4));
  for (std::size_t i = 0; i < rod.state.v.size(); ++i) {
    rod.state.v[i].x() = 1e-3 * std::sin(std::numbers::pi / 2 * rod.state.x[i].x() / 10);
    if (i % (n + 1) == 0) rod.constraints.hold(NodeIndex{static_cast<std::uint32_t>(i)}, 7);
  }
  Stepper stepper(std::move(rod), {});
  expect_good(run_until(stepper, 1));
  double before = 1, last = 0;
  while (before > 0) {
    last = stepper.state().time;
    const double tip = stepper.state().x[n].x() - 10;
    expect_good(stepper.step());
    const double now = stepper.state().x[n].x() - 10;
    if (now <= 0) last += stepper.state().dt * tip / (tip - now);
    before = now;
    ASSERT_LT(stepper.state().time, 3);
  }
  EXPECT_NEAR(last, 2, 0.002);
}

// ω = 1.8751² √(E I / ρ A) / L²; the tip crosses zero after half a period.
TEST(Cantilever, FirstFrequency) {
  constexpr int n = 20;
  constexpr double length = 4, young = 1000, density = 1, thickness = 0.1;
  Structure strip = structure_of(plate(n, 1, {0.2, 0.2, 0}) + elastic_deck(shell_section, young, 0, density),
                                 {{HourglassKind::stiffness, 0.05}, {}});
  const double k = 1.875104069 / length, sigma = 0.734095514;
  for (std::size_t i = 0; i < strip.state.v.size(); ++i) {
    const double kx = k * strip.state.x[i].x();
    strip.state.v[i].z() = 1e-3 * (std::cosh(kx) - std::cos(kx) - sigma * (std::sinh(kx) - std::sin(kx)));
    strip.state.w[i].y() = -1e-3 * k * (std::sinh(kx) + std::sin(kx) - sigma * (std::cosh(kx) - std::cos(kx)));
    if (i % (n + 1) == 0) strip.constraints.hold(NodeIndex{static_cast<std::uint32_t>(i)}, 63);
  }
  const double omega = 1.875104069 * 1.875104069 * std::sqrt(young / density / 12) * thickness / (length * length);
  Stepper stepper(std::move(strip), {});
  const double half = std::numbers::pi / omega;
  expect_good(run_until(stepper, 0.9 * half));
  EXPECT_GT(stepper.state().x[n].z(), 0);
  while (stepper.state().x[n].z() > 0 && stepper.state().time < 2 * half) expect_good(stepper.step());
  EXPECT_NEAR(stepper.state().time / half, 1, 0.01);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-6);
}

// A loose plate that is thrown and twisted: energy to rounding (with a constant step), momentum, angular momentum.
TEST(Plate, ConservesEnergyAndMomentum) {
  Structure loose = structure_of(plate(6, 4, {0.2, 0.25, 0}) + elastic_deck(shell_section, 1000, 0.3, 1),
                                 {{HourglassKind::stiffness, 0.1}, {}});
  Vector momentum = Vector::Zero();
  for (std::size_t i = 0; i < loose.state.v.size(); ++i) {
    const Vector& x = loose.state.x[i];
    loose.state.v[i] = Vector(0.1, -0.2, 0.3) + Vector(0.5, 0.3, 1).cross(x) + Vector(0, 0, 0.3 * std::sin(3 * x.x()));
    loose.state.w[i] = Vector(0.5, 0.3, 1);
    momentum += loose.state.mass[i] * loose.state.v[i];
  }
  StepSettings settings;
  settings.greatest_step = 1e-3;
  Stepper stepper(std::move(loose), settings);
  expect_good(stepper.step());
  const Vector spin = angular_momentum(stepper.state());
  double least = 2, most = 0, bent = 0;
  for (int i = 0; i < 2000; ++i) {
    expect_good(stepper.step());
    least = std::min(least, stepper.energies().ratio());
    most = std::max(most, stepper.energies().ratio());
    bent = std::max(bent, stepper.energies().internal);
  }
  EXPECT_GT(bent, 1e-3 * stepper.energies().kinetic);  // it does deform
  EXPECT_LT(most - least, 1e-10);
  EXPECT_NEAR(least, 1, 1e-10);
  Vector now = Vector::Zero();
  for (std::size_t i = 0; i < stepper.state().v.size(); ++i) now += stepper.state().mass[i] * stepper.state().v[i];
  EXPECT_NEAR((now - momentum).norm(), 0, 1e-12);
  EXPECT_NEAR((angular_momentum(stepper.state()) - spin).norm() / spin.norm(), 0, 1e-4);
}

TEST(Stepper, SameBitsForAnyNumberOfThreads) {
  std::array<State, 2> result;
  std::array<Energies, 2> energies;
  for (std::size_t run = 0; run < 2; ++run) {
    const JobLimit jobs(run == 0 ? 1 : 4);
    Structure sheet = structure_of(plate(60, 60, {0.1, 0.1, 0}) + elastic_deck(shell_section, 1000, 0.3, 1));
    for (std::size_t i = 0; i < sheet.state.v.size(); ++i)
      sheet.state.v[i] = {0.1 * std::sin(5.0 * static_cast<double>(i)), 0.2 * std::cos(3.0 * static_cast<double>(i)),
                          1};
    Stepper stepper(std::move(sheet), {});
    for (int i = 0; i < 20; ++i) expect_good(stepper.step());
    result[run] = stepper.state();
    energies[run] = stepper.energies();
  }
  EXPECT_TRUE(result[0].x == result[1].x);
  EXPECT_TRUE(result[0].v == result[1].v);
  EXPECT_TRUE(result[0].w == result[1].w);
  EXPECT_EQ(result[0].time, result[1].time);
  EXPECT_EQ(energies[0].internal, energies[1].internal);
  EXPECT_EQ(energies[0].kinetic, energies[1].kinetic);
}

const std::string mass_deck = "*NODE\n7,1.,2.,3.\n8,0.,0.,0.\n*ELEMENT_MASS\n1,7,2.5\n";

// x = ½ F/m t², and the work of the force is the kinetic energy.
TEST(Stepper, ConstantForceOnAMass) {
  StepSettings settings;
  settings.greatest_step = 0.01;
  Stepper stepper(structure_of(mass_deck), settings);
  stepper.add(std::make_unique<Given>([](const State&, Forces& forces) { forces.force[0].x() += 5; }));
  for (int i = 0; i < 101; ++i) expect_good(stepper.step());
  EXPECT_NEAR(stepper.state().x[0].x(), 1 + 0.5 * 2 * 1.01 * 1.01, 1e-12);
  EXPECT_NEAR(stepper.energies().external, 5, 1e-9);  // F · x at t = 1
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-12);
}

// A node moved by force of a constraint: where it goes, and the work that it takes.
TEST(Stepper, PrescribedVelocity) {
  Structure mass = structure_of(mass_deck);
  mass.constraints.move(NodeIndex{0}, 1, Motion({{0, 0}, {1, 4}}));
  StepSettings settings;
  settings.greatest_step = 0.01;
  Stepper stepper(std::move(mass), settings);
  for (int i = 0; i < 101; ++i) expect_good(stepper.step());
  EXPECT_NEAR(stepper.energies().external, 2.5 / 2 * (3.98 * 4 + 0.02 * 0.02), 1e-9);
  EXPECT_NEAR(stepper.external().force[0].y(), 2.5 * 4 / 2, 1e-9);  // the curve has its kink here: half of m · 4
  EXPECT_NEAR(stepper.state().x[0].y(), 2 + 2 + 0.04, 1e-12);
  EXPECT_EQ(stepper.state().x[0].x(), 1);
}

TEST(Stepper, TimeStepIsTheFactorTimesTheElements) {
  const std::string deck = plate(2, 1, {0.5, 0.2, 0}) + elastic_deck(shell_section, 1000, 0.3, 1);
  StepSettings settings;
  settings.time_step_factor = 0.5;
  Stepper stepper(structure_of(deck), settings);
  expect_good(stepper.step());
  EXPECT_NEAR(stepper.state().dt, 0.5 * 0.2 / std::sqrt(1000 / 0.91), 1e-12);
  EXPECT_EQ(stepper.state().cycle, 1u);
}

// A cube must step by less than the manual's L / c with viscosity (contact rules, section 13); both are known.
TEST(Stepper, KnowsTheManualsStepBesideItsOwn) {
  constexpr double young = 1000, nu = 0.3, side = 0.1, linear = 0.06;
  Stepper stepper(structure_of(brick_bar(2, {side, side, side}) + elastic_deck(solid_section, young, nu, 1)), {});
  expect_good(stepper.step());
  const double speed = std::sqrt(young * (1 - nu) / ((1 + nu) * (1 - 2 * nu)));
  const double manual = 0.9 * side / speed / (linear + std::sqrt(1 + linear * linear));
  EXPECT_NEAR(stepper.state().manual_step, manual, 1e-12);
  EXPECT_LT(stepper.state().coming, 0.95 * manual);
  EXPECT_EQ(stepper.state().coming, stepper.state().dt);
}

TEST(Stepper, FailuresAreTold) {
  StepSettings settings;
  settings.greatest_step = 0.01;
  const auto kind_after = [](Stepper& stepper, int steps) {
    for (int i = 0; i < steps; ++i)
      if (const SolverStatus status = stepper.step(); !status.ok()) return std::optional(status.error().kind);
    return std::optional<Failure::Kind>();
  };
  {  // a force on a node without mass
    Stepper stepper(structure_of(mass_deck), settings);
    stepper.add(std::make_unique<Given>([](const State&, Forces& forces) { forces.force[1].x() = 1; }));
    const SolverStatus status = stepper.step();
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().kind, Failure::Kind::zero_mass);
    EXPECT_NE(status.error().message.find("node 8"), std::string::npos);
  }
  {  // a force that is not a number
    Stepper stepper(structure_of(mass_deck), settings);
    stepper.add(std::make_unique<Given>([](const State&, Forces& forces) { forces.force[0].x() = NAN; }));
    EXPECT_EQ(kind_after(stepper, 1), Failure::Kind::not_a_number);
  }
  {  // nothing limits the step
    Stepper stepper(structure_of(mass_deck), {});
    EXPECT_EQ(kind_after(stepper, 1), Failure::Kind::zero_time_step);
  }
  {  // a brick pushed through itself: one face is moved by 1.5 of its length in one step
    Structure bar = structure_of(brick_bar(1, {1, 1, 1}) + elastic_deck(solid_section, 1, 0.3, 1));
    const Motion inward({{0.0, -150.0}, {1.0, -150.0}});
    for (std::uint32_t i = 0; i < 8; ++i) bar.constraints.hold(NodeIndex{i}, 7);
    for (const std::uint32_t i : {1u, 3u, 5u, 7u}) bar.constraints.move(NodeIndex{i}, 0, inward);
    StepSettings wild = settings;
    wild.time_step_factor = 1000;
    wild.bounded_step = false;
    wild.energy_tolerance = 0;
    Stepper stepper(std::move(bar), wild);
    EXPECT_TRUE(stepper.step().ok());
    EXPECT_NEAR(stepper.state().x[1].x(), -0.5, 1e-12);
    EXPECT_EQ(kind_after(stepper, 1), Failure::Kind::bad_element);
  }
  {  // an unstable step
    Structure strip = structure_of(plate(4, 1, {0.2, 0.2, 0}) + elastic_deck(shell_section, 1000, 0.3, 1));
    strip.state.v[2] = {1e-3, 0, 0};
    StepSettings wild;
    wild.time_step_factor = 1.5;
    wild.bounded_step = false;
    Stepper stepper(std::move(strip), wild);
    const auto kind = kind_after(stepper, 5000);
    ASSERT_TRUE(kind.has_value());
    EXPECT_TRUE(kind == Failure::Kind::energy_ratio || kind == Failure::Kind::bad_element);
  }
}

TEST(Stepper, EmptyStructure) {
  StepSettings settings;
  settings.greatest_step = 1;
  Structure nothing;
  Stepper stepper(std::move(nothing), settings);
  expect_good(run_until(stepper, 3));
  EXPECT_EQ(stepper.energies().ratio(), 1);
}

}  // namespace
}  // namespace gapcheck::solver::step_test
