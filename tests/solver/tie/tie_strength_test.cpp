// Laws of ties that fail: strengths, energies, the way back.
#include "solver/tie/tie_strength.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapcheck::solver::tie_strength_test {
namespace {

const Vector up(0, 0, 1);
constexpr double stiffness = 200;

/// Works of the two modes over a way that is stretched in one direction until the tie fails, the largest force, and the
/// elongation at failure.
struct Crack {
  double tension_work = 0, shear_work = 0, largest = 0, end = 0;
};

Crack stretch(const TieStrength& strength, double angle, double longest = 1) {
  constexpr int steps = 40'000;
  const Vector along(std::sin(angle), 0, std::cos(angle));
  TieDamage damage;
  Crack crack;
  Vector before = Vector::Zero();
  for (int i = 1; i <= steps; ++i) {
    const Vector force = damage.respond(strength, stiffness, longest * i / steps * along, up).force;
    const Vector mean = -(force + before) / 2 * (longest / steps);
    crack.tension_work += mean.z() * along.z();
    crack.shear_work += mean.x() * along.x();
    crack.largest = std::max(crack.largest, force.norm());
    before = force;
    if (damage.broken) {
      crack.end = longest * i / steps;
      break;
    }
  }
  return crack;
}

TieStrength cohesive(double exponent) {
  TieStrength strength;
  strength.law = TieLaw::cohesive;
  strength.normal = 2;
  strength.shear = 3;
  strength.normal_energy = 0.1;
  strength.shear_energy = 0.25;
  strength.exponent = exponent;
  strength.stiffness_ratio = 0.7;
  return strength;
}

TEST(CohesiveLaw, PureModesTakeTheirEnergies) {
  for (const double exponent : {1.0, 2.0, -1.45}) {
    const TieStrength strength = cohesive(exponent);
    const Crack opening = stretch(strength, 0), sliding = stretch(strength, std::acos(0.0));
    EXPECT_NEAR(opening.tension_work, 0.1, 1e-4) << exponent;
    EXPECT_NEAR(opening.largest, 2, 1e-3);
    EXPECT_NEAR(opening.end, 2 * 0.1 / 2, 1e-4) << "2 G / strength";
    EXPECT_NEAR(sliding.shear_work, 0.25, 1e-4) << exponent;
    EXPECT_NEAR(sliding.largest, 3, 1e-3);
    EXPECT_NEAR(sliding.end, 2 * 0.25 / 3, 1e-4);
  }
}

/// The works of the two modes at failure obey the criterion of the energies itself.
TEST(CohesiveLaw, MixedModesFailByTheirCriterion) {
  for (const double angle : {0.3, 0.8, 1.2}) {
    for (const double exponent : {1.0, 1.7}) {
      const Crack crack = stretch(cohesive(exponent), angle);
      const double sum = std::pow(crack.tension_work / 0.1, exponent) + std::pow(crack.shear_work / 0.25, exponent);
      EXPECT_NEAR(sum, 1, 2e-3) << angle << ' ' << exponent;
    }
    for (const double exponent : {1.0, 2.3}) {
      const Crack crack = stretch(cohesive(-exponent), angle);
      const double work = crack.tension_work + crack.shear_work;
      EXPECT_NEAR(work, 0.1 + 0.15 * std::pow(crack.shear_work / work, exponent), 2e-4) << angle << ' ' << exponent;
    }
  }
}

/// Onset under tension and shear together: the quadratic criterion of the stresses.
TEST(CohesiveLaw, BeginsByTheQuadraticCriterion) {
  const TieStrength strength = cohesive(1);
  const double angle = 0.9;
  const Vector along(std::sin(angle), 0, std::cos(angle));
  const double start =
      1 / std::hypot(stiffness * along.z() / strength.normal, 0.7 * stiffness * along.x() / strength.shear);
  TieDamage damage;
  EXPECT_EQ(damage.respond(strength, stiffness, 0.999 * start * along, up).share, 1);
  EXPECT_LT(damage.respond(strength, stiffness, 1.001 * start * along, up).share, 1);
}

TEST(CohesiveLaw, DamageStaysAndCompressionIsWhole) {
  const TieStrength strength = cohesive(1);
  TieDamage damage;
  const double share = damage.respond(strength, stiffness, 0.05 * up, up).share;
  EXPECT_GT(share, 0);
  EXPECT_LT(share, 0.5);
  // Back along the line to the origin, in shear too.
  EXPECT_NEAR(damage.respond(strength, stiffness, 0.02 * up, up).force.z(), -share * stiffness * 0.02, 1e-12);
  EXPECT_NEAR(damage.respond(strength, stiffness, Vector(0.001, 0, 0), up).force.x(), -share * 0.7 * stiffness * 0.001,
              1e-12);
  EXPECT_EQ(damage.respond(strength, stiffness, -0.3 * up, up).force.z(), stiffness * 0.3);
  EXPECT_EQ(damage.respond(strength, stiffness, -0.3 * up, up).share, share);
  // The back of the segment: tension is downward.
  TieStrength behind = strength;
  behind.side = -1;
  TieDamage other;
  EXPECT_EQ(other.respond(behind, stiffness, 0.3 * up, up).force.z(), -stiffness * 0.3) << "compression";
  EXPECT_LT(other.respond(behind, stiffness, -0.05 * up, up).share, 1);
}

/// OPTION 7: pressure adds to the shear that the tie takes before it begins to fail.
TEST(CohesiveLaw, PressureAddsToTheShearStrength) {
  TieStrength strength = cohesive(1);
  strength.stiffness_ratio = 1;
  strength.friction = 0.5;
  constexpr double pressure = 4, onset = 3 + 0.5 * pressure;
  TieDamage damage;
  const auto respond = [&](double shear) {
    return damage.respond(strength, stiffness, Vector(shear / stiffness, 0, -pressure / stiffness), up);
  };
  EXPECT_EQ(respond(0.999 * onset).share, 1);
  EXPECT_LT(respond(1.001 * onset).share, 1);
}

/// Too little energy for the strength: brittle, at the strength.
TEST(CohesiveLaw, WithLittleEnergyItIsBrittle) {
  TieStrength strength = cohesive(1);
  strength.normal_energy = 1e-3;
  const Crack crack = stretch(strength, 0);
  EXPECT_NEAR(crack.largest, 2, 1e-2);
  EXPECT_NEAR(crack.end, 2 / stiffness, 1e-4);
}

TEST(PlasticLaw, YieldsInTensionAndShear) {
  TieStrength strength;
  strength.law = TieLaw::plastic;
  strength.normal = 2;
  for (const double angle : {0.0, 0.5, 1.1, std::acos(0.0)}) {
    TieDamage damage;
    Vector offset = Vector::Zero(), force = Vector::Zero();
    const Vector along(std::sin(angle), 0, std::cos(angle));
    for (int i = 1; i <= 400; ++i) {
      const TieResponse response = damage.respond(strength, stiffness, 1e-3 * i * along - offset, up);
      offset += response.flow;
      force = response.force;
    }
    EXPECT_NEAR(force.z() * force.z() + 3 * force.x() * force.x(), 4, 1e-9) << angle;
    EXPECT_NEAR(offset.norm() + std::hypot(force.x(), force.z()) / stiffness, 0.4, 1e-3) << "permanent";
    EXPECT_FALSE(damage.broken);
  }
  // Under pressure shear alone counts.
  TieDamage damage;
  const Vector force = damage.respond(strength, stiffness, Vector(0.1, 0, -0.5), up).force;
  EXPECT_NEAR(std::sqrt(3.0) * std::abs(force.x()), 2, 1e-9);
  EXPECT_NEAR(force.z(), stiffness * 0.5, 1e-9);
}

/// With a curve from one at no opening to zero at c the force follows strength (1 - w/c) on top of the elastic line,
/// and the tie is gone at c.
TEST(PlasticLaw, SoftensByItsCurve) {
  constexpr double critical = 0.2;
  model::Curve curve;
  curve.points = {{0.0, 1.0}, {critical, 0.0}};
  TieStrength strength;
  strength.law = TieLaw::plastic;
  strength.normal = 2;
  strength.curve = &curve;
  TieDamage damage;
  Vector offset = Vector::Zero();
  double work = 0, before = 0, largest = 0, end = 0;
  constexpr double step = 1e-5;
  for (int i = 1; end == 0 && i < 100'000; ++i) {
    const TieResponse response = damage.respond(strength, stiffness, step * i * up - offset, up);
    offset += response.flow;
    work += step * (before - response.force.z()) / 2;
    before = -response.force.z();
    largest = std::max(largest, before);
    if (damage.broken) end = step * i;
  }
  const double onset = 2 / (stiffness + 2 / critical);
  EXPECT_NEAR(end, critical, 2e-5);
  EXPECT_NEAR(largest, stiffness * onset, 1e-3);
  EXPECT_NEAR(work, stiffness * onset * critical / 2, 1e-5);
}

/// TBLCID: after the failure the stress over the opening is that of the curve, without shear; on the way back nothing
/// is gained.
TEST(BrittleLaw, ResistsOpeningAfterTheFailure) {
  model::Curve curve;
  curve.points = {{0.0, 1.5}, {0.1, 0.5}, {0.3, 0.0}};
  TieStrength strength;
  strength.normal = 2;
  strength.area = 3;
  strength.curve = &curve;
  TieDamage damage;
  EXPECT_NEAR(damage.respond(strength, stiffness, 0.009 * up, up).force.z(), -stiffness * 0.009, 1e-12);
  EXPECT_FALSE(damage.broken);
  const Vector force = damage.respond(strength, stiffness, Vector(0.01, 0, 0.05), up).force;
  EXPECT_TRUE(damage.broken);
  EXPECT_TRUE(damage.bridges(strength));
  EXPECT_NEAR(force.z(), -3 * 1.0, 1e-12);
  EXPECT_EQ(force.x(), 0);
  EXPECT_NEAR(damage.respond(strength, stiffness, 0.02 * up, up).force.z(), -3 * 1.0 * 0.02 / 0.05, 1e-12);
  EXPECT_EQ(damage.respond(strength, stiffness, -0.02 * up, up).force.z(), 0) << "the contact takes pressure";
  EXPECT_NEAR(damage.respond(strength, stiffness, 0.2 * up, up).force.z(), -3 * 0.25, 1e-12);
  TieDamage without_segment = damage;
  without_segment.end();
  EXPECT_FALSE(without_segment.bridges(strength));
  EXPECT_EQ(damage.respond(strength, stiffness, 0.31 * up, up).force.z(), 0);
  EXPECT_FALSE(damage.bridges(strength));
}

}  // namespace
}  // namespace gapcheck::solver::tie_strength_test
