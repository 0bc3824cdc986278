// Depths and speeds at which contact lets go, against central differences of masses and springs.
#include "solver/loss/impact_depth.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace gapcheck::solver::impact_depth_test {
namespace {

TEST(ImpactDepth, OneMassStaysBetweenTheBoundsForEveryPhase) {
  const double speed = 3, mass = 2, stiffness = 50;
  for (const double share : {0.01, 0.5, 2., 3.}) {
    const double dt = std::sqrt(share * mass / stiffness);
    const auto range = depth_of_one_mass(speed, 1 / mass, stiffness, dt);
    ASSERT_TRUE(range);
    double least = 1e9, most = 0;
    for (int phase = 0; phase < 400; ++phase) {
      double x = -(phase + 0.5) / 400 * speed * dt, v = speed, deepest = 0;
      for (int i = 0; i < 2000 && (x <= 0 || v > 0 || i < 2); ++i) {
        v -= dt * stiffness * std::max(x, 0.0) / mass;
        x += dt * v;
        deepest = std::max(deepest, x);
      }
      least = std::min(least, deepest);
      most = std::max(most, deepest);
      EXPECT_LE(deepest, range->most * (1 + 1e-12));
      EXPECT_GE(deepest, range->least * (1 - 1e-12));
    }
    const double middle = speed * std::sqrt(mass / stiffness);
    EXPECT_NEAR(range->least * range->most, middle * middle, 1e-12);
    fmt::print("share {}: {:.4f} to {:.4f} of v sqrt(m / k), bounds {:.4f} to {:.4f}\n", share, least / middle,
               most / middle, range->least / middle, range->most / middle);
  }
  EXPECT_FALSE(depth_of_one_mass(1, 1, 4, 1)) << "not stable";
  EXPECT_FALSE(depth_of_one_mass(1, 0, 4, 0.1)) << "nothing moves it";
}

/// Masses in a row that meet springs of their own at one time, and springs between all of them.
struct Chain {
  std::vector<double> mass, contact;  ///< contact 0: it meets nothing
  std::vector<std::vector<double>> between;
  [[nodiscard]] std::size_t size() const { return mass.size(); }
  /// The greatest depth of each.
  [[nodiscard]] std::vector<double> depths(double speed) const {
    double stiffest = 0, lightest = 1e9;
    for (std::size_t i = 0; i < size(); ++i) {
      double sum = contact[i];
      for (const double k : between[i]) sum += 2 * k;
      stiffest = std::max(stiffest, sum / mass[i]);
      lightest = std::min(lightest, mass[i]);
    }
    const double dt = 0.02 / std::sqrt(stiffest);
    std::vector<double> x(size(), 0), v(size(), speed), a(size()), deepest(size(), 0);
    double total = 0, stiffness = 0;
    for (std::size_t i = 0; i < size(); ++i) total += mass[i], stiffness += contact[i];
    const double end = 6 * std::sqrt(total / stiffness);
    for (double time = 0; time < end; time += dt) {
      for (std::size_t i = 0; i < size(); ++i) {
        double force = -contact[i] * std::max(x[i], 0.0);
        for (std::size_t j = 0; j < size(); ++j) force += between[i][j] * (x[j] - x[i]);
        a[i] = force / mass[i];
      }
      for (std::size_t i = 0; i < size(); ++i) {
        v[i] += dt * a[i];
        x[i] += dt * v[i];
        deepest[i] = std::max(deepest[i], x[i]);
      }
    }
    return deepest;
  }
};

TEST(ImpactDepth, BoundsOfElasticBodiesHoldForRandomOnes) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  double nearest_energy = 0, nearest_release = 1e9, nearest_sheet = 1e9;
  for (int n = 0; n < 300; ++n) {
    Chain chain;
    const std::size_t size = 2 + static_cast<std::size_t>(n % 5);
    const bool sheet = n % 2 == 0;
    for (std::size_t i = 0; i < size; ++i) {
      chain.mass.push_back(0.2 + unit(random));
      chain.contact.push_back(sheet || i < (size + 1) / 2 ? std::pow(10, 2 * unit(random)) : 0);
    }
    chain.between.assign(size, std::vector<double>(size, 0));
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < i; ++j)
        chain.between[i][j] = chain.between[j][i] = std::pow(10, 4 * unit(random) - 1) * (unit(random) < 0.6);
    const std::vector<double> depth = chain.depths(1);
    double total = 0, pressed = 0;
    std::vector<PressedNode> nodes;
    // Depths of release in the ratio of what the run reaches: the worst that they can be for the bounds.
    for (std::size_t i = 0; i < size; ++i) {
      total += chain.mass[i];
      if (chain.contact[i] == 0) continue;
      pressed += chain.mass[i];
      nodes.push_back({chain.contact[i], depth[i]});
    }
    for (std::size_t i = 0; i < size; ++i) {
      if (chain.contact[i] == 0) continue;
      const double bound = *depth_of_energy(total / 2, chain.contact[i], 0);
      EXPECT_LE(depth[i], bound * (1 + 1e-3));
      nearest_energy = std::max(nearest_energy, depth[i] / bound);
    }
    // With exactly these depths nothing is released at speed 1, so the speeds of certain release are not below it.
    const double release = speed_of_release(nodes, nodes, pressed);
    EXPECT_GE(release, 1);
    nearest_release = std::min(nearest_release, release);
    if (!sheet) continue;
    const double of_sheet = speed_of_release_of_sheet(nodes, total, 0);
    EXPECT_GE(of_sheet, 1 - 1e-3);
    nearest_sheet = std::min(nearest_sheet, of_sheet);
  }
  fmt::print("depth over its bound by energy: at most {:.3f}; speed of release: at least {:.3f} and {:.3f}\n",
             nearest_energy, nearest_release, nearest_sheet);
  EXPECT_GT(nearest_energy, 0.9) << "a bound that is never near says nothing";
  EXPECT_LT(nearest_sheet, 1.6);
  EXPECT_LT(nearest_release, 4);
}

}  // namespace
}  // namespace gapcheck::solver::impact_depth_test
