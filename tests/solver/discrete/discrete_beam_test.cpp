#include "solver/discrete/discrete_beam.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapcheck::solver::discrete_beam_test {
namespace {

/// Stiffnesses 10, 20, 30 and 40, 50, 60; mass 2, inertia 3.
DiscreteBeam spring(double scoor = 0) {
  DiscreteBeam beam;
  for (std::size_t i = 0; i < 6; ++i) beam.laws[i].stiffness = 10.0 * static_cast<double>(i + 1);
  beam.mass = 2;
  beam.inertia = 3;
  beam.scoor = scoor;
  return beam;
}

DiscreteState begun(const DiscreteBeam& beam, const Vector& way, const Matrix* axes = nullptr) {
  DiscreteState state;
  state.axes = discrete_axes(beam, axes, way, Vector::Zero());
  begin_discrete(beam, way, state);
  return state;
}

const Vector nothing = Vector::Zero();

TEST(DiscreteBeam, SixStiffnessesInLocalAxes) {
  const DiscreteBeam beam = spring();
  Matrix axes;  // r = y, s = z, t = x
  axes << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  for (int i = 0; i < 3; ++i)
    for (const bool turn : {false, true}) {
      DiscreteState state = begun(beam, nothing, &axes);
      const Vector rate = 1e-6 * axes.col(i);
      const BeamEnds ends{
          {nothing, turn ? nothing : rate}, {nothing, turn ? nothing : rate}, {nothing, turn ? rate : nothing}};
      const DiscreteForces forces = discrete_forces(beam, ends, 1, state);
      ASSERT_TRUE(forces.good);
      const double expected = 1e-6 * 10 * (i + 1 + (turn ? 3 : 0));
      EXPECT_NEAR((turn ? forces.moment : forces.force)[1].dot(axes.col(i)), expected, 1e-15);
      EXPECT_NEAR((turn ? forces.moment : forces.force)[0].dot(axes.col(i)), -expected, 1e-15);
      EXPECT_NEAR((turn ? forces.force : forces.moment)[1].norm(), 0, 1e-15);
      EXPECT_NEAR(stored_energy(beam, state, 0), 1e-6 * expected / 2, 1e-18);
    }
}

// A stretched and sheared beam of finite length turns once with its ends.
TEST(DiscreteBeam, AFullTurnTurnsTheForces) {
  constexpr int steps = 500;
  const Vector axis = Vector(2, -1, 2) / 3;
  for (const double scoor : {-3.0, -2.0, 2.0, 3.0}) {
    const DiscreteBeam beam = spring(scoor);
    std::array<Vector, 2> x{nothing, Vector(2, 0, 0)};
    DiscreteState state = begun(beam, x[1]);
    const Vector way(0.1, 0.2, -0.3);
    BeamEnds ends{{x[0], x[1] + way}, {nothing, way}, {Vector(0.1, 0, 0), Vector(0, 0.2, 0)}};
    const DiscreteForces before = discrete_forces(beam, ends, 1, state);
    EXPECT_GT(before.force[1].norm(), 1);
    x = ends.x;
    DiscreteForces after;
    for (int step = 0; step < steps; ++step) {
      const Vector spin = 2 * std::tan(std::numbers::pi / steps) * axis;
      const Matrix turn = spin_rotation(spin);
      const BeamEnds next{{turn * x[0], turn * x[1]}, {turn * x[0] - x[0], turn * x[1] - x[1]}, {spin, spin}};
      after = discrete_forces(beam, next, 1, state);
      x = next.x;
    }
    EXPECT_NEAR((after.force[1] - before.force[1]).norm(), 0, 1e-10) << scoor;
    EXPECT_NEAR((after.moment[1] - before.moment[1]).norm(), 0, 1e-10) << scoor;
  }
}

// |SCOOR| >= 2: forces and couples on both ends are in balance, a half of the couple on each. Otherwise there is none.
TEST(DiscreteBeam, CouplesBalanceForcesAcross) {
  for (const double scoor : {0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0}) {
    const DiscreteBeam beam = spring(scoor);
    DiscreteState state = begun(beam, Vector(2, 0, 0));
    const Vector way(0, 1e-3, 0);
    const BeamEnds ends{{nothing, Vector(2, 0, 0) + way}, {nothing, way}, {nothing, nothing}};
    const DiscreteForces forces = discrete_forces(beam, ends, 1, state);
    const Vector moment = forces.moment[0] + forces.moment[1] + ends.x[1].cross(forces.force[1]);
    const bool couples = std::abs(scoor) >= 2;
    EXPECT_NEAR(moment.norm(), couples ? 0 : 2 * 20 * 1e-3, 1e-12) << scoor;
    EXPECT_NEAR(forces.moment[0].z(), couples ? -20 * 1e-3 : 0, 1e-6) << scoor;
    EXPECT_NEAR((forces.moment[0] - forces.moment[1]).norm(), 0, 1e-12) << scoor;
  }
}

// End 1 turns by a quarter about z, end 2 stays; then end 2 moves along x: along s or r of the turned axes.
TEST(DiscreteBeam, ScoorChoosesWhatTurnsTheAxes) {
  const double quarter = std::numbers::pi / 2;
  for (const auto& [scoor, turned] : {std::pair(-1.0, 1.0), {0.0, 0.5}, {1.0, 0.0}, {-3.0, 1.0}, {3.0, 0.0}}) {
    const DiscreteBeam beam = spring(scoor);
    DiscreteState state = begun(beam, nothing);
    for (int step = 0; step < 1000; ++step)
      (void)discrete_forces(beam, {{nothing, nothing}, {nothing, nothing}, {Vector(0, 0, quarter), nothing}}, 1e-3,
                            state);
    const double angle = turned * quarter;
    EXPECT_NEAR((state.axes.col(0) - Vector(std::cos(angle), std::sin(angle), 0)).norm(), 0, 1e-5) << scoor;
  }
  DiscreteBeam beam = spring(-1);
  beam.fixed = {false, false, true};  // TRCON
  DiscreteState state = begun(beam, nothing);
  (void)discrete_forces(beam, {{nothing, nothing}, {nothing, nothing}, {Vector(0.1, 0, 5), nothing}}, 1, state);
  EXPECT_NEAR(state.axes.col(0).x(), 1, 1e-12);
}

// m / 2 at each end: ω² = 4 k / m. Greatest velocity over the one at the start; just below the stable step it stays
// bounded, just above it does not.
double amplitude(DiscreteBeam beam, double share) {
  const Vector apart(1, 0, 0);
  DiscreteState state = begun(beam, apart);
  constexpr double small = 1e-5;
  std::array<Vector, 2> x{nothing, apart}, v{small * Vector(-1, 0.5, 0), small * Vector(1, -0.5, 0.2)},
      w{nothing, nothing};
  const double dt = share * discrete_forces(beam, {x, {nothing, nothing}, {nothing, nothing}}, 0, state).step;
  double most = 0;
  for (int step = 0; step < 3000; ++step) {
    for (std::size_t k = 0; k < 2; ++k) x[k] += dt * v[k];
    const DiscreteForces forces = discrete_forces(beam, {x, v, w}, dt, state);
    for (std::size_t k = 0; k < 2; ++k) {
      v[k] -= dt * forces.force[k] / (beam.mass / 2);
      w[k] -= dt * forces.moment[k] / (beam.inertia / 2);
      most = std::max({most, v[k].norm() / small, w[k].norm() / small});
    }
    if (!(most < 1e6)) break;
  }
  return most;
}

TEST(DiscreteBeam, StableStep) {
  for (const double damping : {0.0, 0.3}) {
    DiscreteBeam beam;
    beam.mass = 2;
    beam.inertia = 3;
    beam.laws[0].stiffness = 10;
    beam.laws[0].damping = damping;
    DiscreteState state = begun(beam, Vector(1, 0, 0));
    const double step =
        discrete_forces(beam, {{nothing, Vector(1, 0, 0)}, {nothing, nothing}, {nothing, nothing}}, 0, state).step;
    const double c = 4 / beam.mass * damping, w2 = 4 / beam.mass * 10;
    EXPECT_NEAR(w2 * step * step + 2 * c * step, 4, 1e-12);
    EXPECT_LT(amplitude(beam, 0.999), 50) << damping;
    EXPECT_GT(amplitude(beam, 1.02), 1e6) << damping;
  }
  // Shear with couples: the rate of shear turns the ends too.
  DiscreteBeam sheared;
  sheared.scoor = 3;
  sheared.mass = 2;
  sheared.inertia = 0.5;
  sheared.laws[1].stiffness = 10;
  EXPECT_LT(amplitude(sheared, 0.99), 50);
  EXPECT_GT(amplitude(sheared, 1.05), 1e6);
}

TEST(DiscreteBeam, WithoutInertiaRotationsDoNotSetTheStep) {
  for (const double scoor : {0.0, 3.0}) {
    DiscreteBeam beam = spring(scoor);
    beam.inertia = 0;
    DiscreteState state = begun(beam, Vector(2, 0, 0));
    EXPECT_GT(state.inertia, 0);
    const BeamEnds ends{{nothing, Vector(2, 0, 0)}, {nothing, nothing}, {nothing, nothing}};
    const double step = discrete_forces(beam, ends, 0, state).step;
    EXPECT_GE(step * std::sqrt(2.0), std::sqrt(beam.mass / 30) - 1e-12) << scoor;
  }
}

/// Moves the ends of a beam apart along r; returns the force at each way.
std::vector<double> pulled(const DiscreteBeam& beam, const std::vector<double>& ways, DiscreteState& state,
                           double& dissipated) {
  std::vector<double> forces;
  double at = 0;
  for (const double way : ways) {
    constexpr int parts = 100;
    DiscreteForces last;
    for (int i = 1; i <= parts; ++i) {
      const Vector x(at + (way - at) * i / parts, 0, 0), v((way - at) / parts, 0, 0);
      last = discrete_forces(beam, {{nothing, x}, {nothing, v}, {nothing, nothing}}, 1, state);
      dissipated += last.dissipated;
    }
    at = way;
    forces.push_back(last.axial);
  }
  return forces;
}

TEST(DiscreteBeam, PlasticForcesHardenUnloadAndBalance) {
  DiscreteBeam beam;
  beam.mass = 1;
  beam.laws[0].stiffness = 100;
  beam.laws[0].yield = YieldCurve({{0, 10}, {1, 20}, {2, 20}});
  DiscreteState state = begun(beam, nothing);
  double dissipated = 0;
  // Up to 0.1 elastic; slope k H / (k + H) = 100 / 11 beyond; back by 0.1; and reversed yield at minus the hardened
  // force.
  const auto forces = pulled(beam, {0.1, 0.65, 0.55, -0.65}, state, dissipated);
  EXPECT_NEAR(forces[0], 10, 1e-9);
  EXPECT_NEAR(forces[1], 15, 1e-9);
  EXPECT_NEAR(forces[2], 5, 1e-9);
  EXPECT_NEAR(forces[3], -20, 1e-9);
  EXPECT_NEAR(state.plastic_way[0], 1.45, 1e-9);
  EXPECT_NEAR(stored_energy(beam, state, 0), 400.0 / 200, 1e-9);
  EXPECT_NEAR(dissipated, 12.5 * 0.5 + 17.5 * 0.5 + 20 * 0.45, 5e-3);
}

TEST(DiscreteBeam, NonlinearForcesDampersAndPreloads) {
  DiscreteBeam beam;
  beam.mass = 1;
  beam.laws[0].force = ForceCurve({{0, 0}, {1, 10}, {2, 40}});  // the same in compression
  beam.laws[0].preload = 3;
  DiscreteState state = begun(beam, nothing);
  double dissipated = 0;
  const auto forces = pulled(beam, {0.5, 2, 3, -2}, state, dissipated);
  EXPECT_NEAR(forces[0], 8, 1e-9);
  EXPECT_NEAR(forces[1], 43, 1e-9);
  EXPECT_NEAR(forces[2], 73, 1e-9) << "the last slope continues";
  EXPECT_NEAR(forces[3], -37, 1e-9);
  EXPECT_NEAR(dissipated, 0, 1e-12);
  EXPECT_NEAR(stored_energy(beam, state, 2), 5 + 25 - 6, 1e-9);
  DiscreteBeam damper;
  damper.mass = 1;
  damper.laws[0].damping = 7;
  damper.laws[0].viscous = ForceCurve({{-1, -2}, {0, 0}, {1, 5}});
  DiscreteState rest = begun(damper, nothing);
  const auto with = pulled(damper, {50.0}, rest, dissipated = 0);
  EXPECT_NEAR(with[0], 7 * 0.5 + 2.5, 1e-9);
  EXPECT_NEAR(dissipated, 6 * (50 - 0.25), 1e-9) << "the first step begins at rest";
}

TEST(DiscreteBeam, FailsByForcesOrWays) {
  DiscreteBeam beam = spring();
  beam.failure_force[0] = 5;
  beam.failure_force[1] = 10;
  EXPECT_TRUE(beam.can_fail());
  const auto fails = [&](const DiscreteBeam& one, const Vector& way) {
    DiscreteState state = begun(one, nothing);
    return discrete_forces(one, {{nothing, way}, {nothing, way}, {nothing, nothing}}, 1, state).failed;
  };
  // (10 u / 5)² + (20 v / 10)² = 1
  EXPECT_FALSE(fails(beam, Vector(0.35, 0.35, 9)));
  EXPECT_TRUE(fails(beam, Vector(0.36, 0.36, 0)));
  DiscreteBeam by_way = spring();
  by_way.failure_way[2] = 0.5;
  EXPECT_FALSE(fails(by_way, Vector(9, 9, 0.49)));
  EXPECT_TRUE(fails(by_way, Vector(0, 0, -0.5)));
}

Cable wire() {
  Cable cable;
  cable.young = 1000;
  cable.area = 0.5;
  return cable;
}

DiscreteForces at_length(const DiscreteBeam& beam, double length, double before, double time, DiscreteState& state) {
  const Vector way(0, length, 0), rate(0, length - before, 0);
  return cable_forces(*beam.cable, {{nothing, way}, {nothing, rate}, {nothing, nothing}}, time, 1, state);
}

// F = max(F0 + E A / L0 (L − L0), 0), L0 = length − OFFSET.
TEST(DiscreteCable, TensionOnly) {
  for (const double offset : {0.0, -0.1, 0.2}) {
    DiscreteBeam beam;
    beam.mass = 0;
    beam.density = 3;
    beam.cable = wire();
    beam.cable->offset = offset;
    beam.cable->force = 4;
    DiscreteState state = begun(beam, Vector(0, 2, 0));
    EXPECT_NEAR(state.mass, 3 * 0.5 * 2, 1e-12);
    const double l0 = 2 - offset, k = 500 / l0;
    double before = 2;
    for (const double length : {2.0, 2.1, 1.7, 2.3}) {
      const DiscreteForces forces = at_length(beam, length, before, 5, state);
      const double expected = std::max(4 + k * (length - l0), 0.0);
      EXPECT_NEAR(forces.axial, expected, 1e-10) << offset << " " << length;
      EXPECT_NEAR(forces.force[1].y(), expected, 1e-10);
      EXPECT_EQ(forces.moment[0], nothing);
      const double start = std::max(4 + k * offset, 0.0);
      EXPECT_NEAR(stored_energy(beam, state, length), (expected * expected - start * start) / (2 * k), 1e-10);
      before = length;
    }
    EXPECT_NEAR(at_length(beam, 2.3, 2.3, 5, state).step, std::sqrt(state.mass / k), 1e-12);
  }
}

TEST(DiscreteCable, CurveOfStressAndNegativeYoung) {
  DiscreteBeam beam;
  beam.mass = 1;
  beam.cable = wire();
  beam.cable->stress = ForceCurve({{0, 0}, {0.1, 20}, {0.2, 30}});
  DiscreteState state = begun(beam, Vector(0, 2, 0));
  EXPECT_NEAR(at_length(beam, 2.3, 2, 1, state).axial, 0.5 * 25, 1e-10);
  EXPECT_NEAR(stored_energy(beam, state, 2.3), 2 * 0.5 * (1 + 22.5 * 0.05), 1e-10);
  EXPECT_EQ(at_length(beam, 1.9, 2.3, 1, state).axial, 0);
  EXPECT_NEAR(stored_energy(beam, state, 1.9), 0, 1e-12);
  beam.cable = Cable{};
  beam.cable->stiffness = 70;
  DiscreteState stiff = begun(beam, Vector(0, 2, 0));
  EXPECT_NEAR(at_length(beam, 2.5, 2, 1, stiff).axial, 35, 1e-10);
}

// The force ramps up from 1 to 3 whatever the length does, is held until 5, and then follows the length. What holds it
// supplies the energy that the length does not.
TEST(DiscreteCable, PretensionIsHeldUntilTmaxf0) {
  DiscreteBeam beam;
  beam.mass = 1;
  beam.cable = wire();
  beam.cable->force = 8;
  beam.cable->start = 1;
  beam.cable->ramp = 2;
  beam.cable->end = 5;
  DiscreteState state = begun(beam, Vector(0, 2, 0));
  double before = 2, work = 0, supplied = 0, force = 0;
  for (int i = 0; i <= 600; ++i) {
    const double time = 0.01 * i, length = 2 - 0.02 * time;
    const DiscreteForces forces = at_length(beam, length, before, time, state);
    work += (force + forces.axial) / 2 * (length - before);
    supplied += forces.supplied;
    force = forces.axial;
    before = length;
    if (time < 4.995) {
      EXPECT_NEAR(force, 8 * std::clamp((time - 1) / 2, 0.0, 1.0), 1e-9) << time;
    }
  }
  EXPECT_NEAR(force, 8 - 250 * 0.02 * 1.01, 1e-9);
  EXPECT_NEAR(stored_energy(beam, state, before), work + supplied, 1e-9);
}

TEST(DiscreteCable, Fails) {
  DiscreteBeam beam;
  beam.mass = 1;
  beam.cable = wire();
  beam.cable->failure_strain = 0.1;
  DiscreteState state = begun(beam, Vector(0, 2, 0));
  EXPECT_FALSE(at_length(beam, 2.19, 2, 1, state).failed);
  EXPECT_TRUE(at_length(beam, 2.21, 2.19, 1, state).failed);
  beam.cable->failure_strain = 0;
  beam.cable->failure_force = 20;
  EXPECT_FALSE(at_length(beam, 2.07, 2.2, 1, state).failed);
  EXPECT_TRUE(at_length(beam, 2.09, 2.07, 1, state).failed);
}

}  // namespace
}  // namespace gapcheck::solver::discrete_beam_test
