#include "solver/condition/spring_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapcheck::solver::spring_law_test {
namespace {

SpringLaw plastic(double stiffness, double tangent, double yield) {
  SpringLaw law;
  law.kind = SpringLaw::Kind::elastoplastic;
  law.stiffness = stiffness;
  law.hardening = stiffness * tangent / (stiffness - tangent);
  law.yield = yield;
  return law;
}

/// A line through the points in `steps` even steps each; the force after each step goes to `watch`.
template <class Watch>
void walk(const SpringLaw& law, const std::vector<double>& corners, int steps, double dt, const Watch& watch) {
  SpringHistory history;
  double time = 0, from = 0;
  for (const double to : corners) {
    for (int i = 1; i <= steps; ++i) {
      const double u = i == steps ? to : from + (to - from) * i / steps;
      const double force = law.update(u * Vector::UnitX(), dt, time += dt, history).x();
      watch(u, time, force, history);
    }
    from = to;
  }
}

// Load, unload, reversed yield at the force that was reached, load again: bilinear, whatever the steps.
TEST(SpringLaw, ElastoplasticPath) {
  const SpringLaw law = plastic(100, 20, 5);
  for (const int steps : {1, 7, 100}) {
    std::vector<double> ends;
    walk(law, {0.15, -0.05, 0.3}, steps, 1, [&](double u, double, double force, const SpringHistory&) {
      if (u == 0.15 || u == -0.05 || u == 0.3) ends.push_back(force);
    });
    ASSERT_EQ(ends.size(), 3u);
    const double first = 5 + 20 * (0.15 - 0.05);  // FY + KT (u - FY / K)
    EXPECT_NEAR(ends[0], first, 1e-13);
    const double back = 0.15 - 2 * first / 100;  // yields at minus what was reached
    const double second = -first + 20 * (-0.05 - back);
    EXPECT_NEAR(ends[1], second, 1e-13);
    const double again = -0.05 - 2 * second / 100;
    EXPECT_NEAR(ends[2], -second + 20 * (0.3 - again), 1e-13);
  }
}

// What is held is the area below the path.
TEST(SpringLaw, ElastoplasticEnergyIsTheArea) {
  const SpringLaw law = plastic(100, 20, 5);
  double area = 0, before_u = 0, before_f = 0, held = 0;
  walk(law, {0.15, -0.05, 0.3, -0.4}, 20000, 1, [&](double u, double, double force, const SpringHistory& history) {
    area += (u - before_u) * (force + before_f) / 2;
    before_u = u;
    before_f = force;
    held = law.held(history);
    EXPECT_NEAR(held, area, 1e-7);
  });
  EXPECT_GT(held, 3);
}

// In all directions it is the same law along any line.
TEST(SpringLaw, ElastoplasticWithoutALine) {
  const SpringLaw law = plastic(100, 0, 5);
  const Vector along = Vector(2, -1, 2) / 3;
  SpringHistory line, space;
  for (const double u : {0.03, 0.2, 0.1, -0.1, 0.0, 0.4, 0.35}) {
    const double force = law.update(u * Vector::UnitX(), 1, 1, line).x();
    EXPECT_NEAR((law.update(u * along, 1, 1, space) - force * along).norm(), 0, 1e-13) << u;
    EXPECT_NEAR(law.held(line), law.held(space), 1e-13);
  }
}

SpringLaw maxwell(double transient, double rest, double decay) {
  SpringLaw law;
  law.kind = SpringLaw::Kind::maxwell;
  law.stiffness = rest;
  law.transient = transient;
  law.decay = decay;
  return law;
}

// An even rate, then rest: F = KI u + (K0 - KI) r / BETA (1 - exp(-BETA t)), which then decays. Exact for any step.
TEST(SpringLaw, MaxwellAtAnEvenRateAndAtRest) {
  for (const int steps : {1, 3, 50}) {
    const double dt = 0.6 / steps, rate = 0.3 / 0.6, settled = 80 * rate / 2.5;
    const SpringLaw law = maxwell(80, 20, 2.5);
    walk(law, {0.3, 0.3}, steps, dt, [&](double u, double time, double force, const SpringHistory& history) {
      const double ramp = std::min(time, 0.6), faded = settled * (1 - std::exp(-2.5 * ramp));
      EXPECT_NEAR(force, 20 * u + faded * std::exp(-2.5 * (time - ramp)), 1e-12);
      EXPECT_NEAR(law.held(history), 10 * u * u + rate * settled * (ramp - (1 - std::exp(-2.5 * ramp)) / 2.5), 1e-12);
    });
  }
}

// BETA = 0 is elastic with K0; at a high rate the spring answers with K0, at a low one with KI.
TEST(SpringLaw, MaxwellLimits) {
  walk(maxwell(80, 20, 0), {0.3, -0.1}, 10, 1,
       [&](double u, double, double force, const SpringHistory&) { EXPECT_NEAR(force, 100 * u, 1e-12); });
  walk(maxwell(80, 20, 1e-7), {0.3}, 1, 1, [&](double u, double, double force, const SpringHistory& history) {
    EXPECT_NEAR(force, 100 * u, 2e-6);
    EXPECT_NEAR(maxwell(80, 20, 1e-7).held(history), 50 * u * u, 1e-6);
  });
  walk(maxwell(80, 20, 1e6), {0.3}, 10, 1,
       [&](double u, double, double force, const SpringHistory&) { EXPECT_NEAR(force, 20 * u, 1e-4); });
}

TEST(SpringLaw, MaxwellCutoff) {
  SpringLaw law = maxwell(80, 20, 2.5);
  law.cutoff = 5;
  law.cutoff_force = -3;
  double work = 0;
  walk(law, {0.5, 0.9}, 5, 1, [&](double u, double time, double force, const SpringHistory& history) {
    if (time <= 5) {
      EXPECT_GT(force, 20 * u);
      work = law.held(history);
    } else {
      EXPECT_EQ(force, -3);
      EXPECT_NEAR(law.held(history), work - 3 * (u - 0.5), 1e-12);
    }
  });
}

SpringLaw crushed(double sense) {
  SpringLaw law;
  law.kind = SpringLaw::Kind::inelastic;
  law.loading = ForceCurve({{0, 0}, {0.1, 8}, {0.3, 12}, {0.4, 10}});
  law.stiffness = 200;
  law.sense = sense;
  return law;
}

/// The law again, by remembering all points of a fine path: on the curve at the farthest one, else along the line.
double crushed_twin(double way, double farthest) {
  const auto curve = [](double u) {
    if (u < 0.1) return 80 * u;
    return u < 0.3 ? 8 + 20 * (u - 0.1) : 12 - 20 * (u - 0.3);
  };
  if (way >= farthest) return curve(way);
  return std::max(0.0, curve(farthest) - 200 * (farthest - way));
}

// One sense pulls (or pushes) along the curve, unloads with KU down to nothing, and is loaded again the same way; in
// the other sense there is no force.
TEST(SpringLaw, InelasticInOneSense) {
  for (const double sense : {1.0, -1.0}) {
    const SpringLaw law = crushed(sense);
    double farthest = 0, area = 0, before_u = 0, before_f = 0, most = 0;
    std::vector<double> corners{0.05, -0.2, 0.2, 0.16, 0.35, 0.1, 0.5};
    for (double& corner : corners) corner *= sense;
    walk(law, corners, 20000, 1, [&](double u, double, double force, const SpringHistory& history) {
      farthest = std::max(farthest, sense * u);
      EXPECT_NEAR(sense * force, crushed_twin(sense * u, farthest), 1e-9);
      area += (u - before_u) * (force + before_f) / 2;
      before_u = u;
      before_f = force;
      most = std::max(most, sense * force);
      EXPECT_NEAR(law.held(history), area, 1e-6);
    });
    EXPECT_NEAR(most, 12, 1e-3);  // a step passes by the top
    EXPECT_GT(area, 3);
  }
}

TEST(SpringLaw, BoundsForTheStep) {
  EXPECT_EQ(plastic(100, 20, 5).largest_stiffness(), 100);
  EXPECT_EQ(maxwell(80, 20, 2).largest_stiffness(), 100);
  EXPECT_EQ(crushed(1).largest_stiffness(), 200);
  SpringLaw damper;
  damper.rates = ForceCurve({{-1, -4}, {0, 0}, {1, 2}});
  damper.damping = 3;
  EXPECT_EQ(damper.largest_damping(), 7);
}

}  // namespace
}  // namespace gapcheck::solver::spring_law_test
