// Impacts with mortar contact: balance of forces and moments, energy that comes back, free edges of shells, and the
// same bits for any number of threads.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/parallel.hpp"
#include "solver/contact_scene.hpp"
#include "solver/mortar/mortar_scene.hpp"

namespace gapcheck::solver::mortar_impact_test {
namespace {

RunSettings until(double time) {
  RunSettings settings;
  settings.until = time;
  return settings;
}

std::string thrown(int part, const Vector& velocity) {
  return fmt::format("*INITIAL_VELOCITY_GENERATION\n{},2,0.,{},{},{}\n0.,0.,0.,0.,0.,1.\n", part, velocity.x(),
                     velocity.y(), velocity.z());
}

const std::string elastic = "*MAT_ELASTIC\n1,1.,1000.,0.\n*CONTROL_TERMINATION\n100.\n";
const std::string two_sides = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n2,1,3,3\n";
const std::string one_side = "*CONTACT_AUTOMATIC_SINGLE_SURFACE_MORTAR\n0\n";

/// What a run shows in its forces.
struct Watched {
  double force = 0, moment = 0;  ///< greatest sums, which should be zero, over the greatest force and its arm
  double greatest = 0, first = -1, stored = 0;

  void watch(const solver::Run& run) {
    const ForceSums sums(run);
    if (!(sums.size > 0)) return;
    if (first < 0) first = run.stepper().state().time;
    greatest = std::max(greatest, sums.size / 2);
    force = std::max(force, sums.force.norm() / sums.size);
    moment = std::max(moment, sums.moment.norm() / (sums.size * sums.arm));
    if (const auto now = run.contacts()[0].stored()) stored = std::max(stored, *now);
  }
};

/// Two bars end to end, of 3 x 3 and 2 x 2 bricks across; the second one hits the first.
std::string bars(const std::string& contact) {
  const MortarBlock still{1, {3, 3, 10}, {0, 0, 0}, {1, 1, 10}, 0, 1};
  const MortarBlock moving{2, {2, 2, 10}, {0, 0, 10.01}, {1, 1, 10}, 0, 1};
  return still.mesh() + moving.mesh() + elastic + thrown(2, {0, 0, -0.5}) + contact + "0.\n10.,10.\n";
}

// With ν = 0 equal bars exchange their velocities after twice the time of a wave through one of them (Saint-Venant);
// what is missing stays in their vibrations.
TEST(MortarImpact, EqualBarsExchangeTheirVelocities) {
  for (const std::string& contact : {two_sides, one_side}) {
    RunScene scene(bars(contact), until(1.2));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    Watched watched;
    scene.go([&](const solver::Run& run) { watched.watch(run); });
    EXPECT_NEAR(watched.first, 0.02, 0.01);
    EXPECT_LT(watched.force, 1e-13);
    EXPECT_LT(watched.moment, 1e-13);
    // σ = ρ c v / 2 on an area of 1.
    EXPECT_NEAR(watched.greatest, 0.5 * std::sqrt(1000.0) * 0.5, 0.3 * 0.5 * std::sqrt(1000.0) * 0.5);
    double handed_over = 0;
    for (std::size_t i = 0; i < scene.state().x.size(); ++i)
      if (scene.read().model.mesh.nodes.id[i] < 20000) handed_over -= scene.state().mass[i] * scene.state().v[i].z();
    EXPECT_GT(handed_over, 0.95 * 10 * 0.5);
    EXPECT_LT(handed_over, 1.01 * 10 * 0.5);
    EXPECT_NEAR(scene.energies().ratio(), 1, 2e-3);
    EXPECT_GT(watched.stored, 0);
    // The contact gives back what it took.
    EXPECT_LT(std::abs(scene.energies().absorbed.sliding()), 0.02 * scene.energies().initial);
    RecordProperty("handed_over", fmt::format("{:.4f}", handed_over / 5));
    RecordProperty("left_in_contact",
                   fmt::format("{:.1e}", scene.energies().absorbed.sliding() / scene.energies().initial));
  }
}

// An oblique hit of shells: forces balance, and so do moments as long as nothing rubs.
TEST(MortarImpact, TiltedPlatesBalance) {
  const MortarSheet lower{1, 6, 6, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.04, 1};
  const MortarSheet upper{2, 5, 5, {0.21, 0.13, 0.06}, {0.6, 0.1, 0.05}, {-0.08, 0.6, 0.02}, 0.03, 1};
  for (const std::string& contact : {two_sides, one_side})
    for (const bool rubs : {false, true}) {
      RunScene scene(lower.mesh() + upper.mesh() + elastic + thrown(2, {0.2, 0.1, -1}) + contact +
                         (rubs ? "0.3,0.2,1.\n1.,1.\n" : "0.\n1.,1.\n"),
                     until(0.15));
      ASSERT_TRUE(scene.prepared()) << scene.message();
      const Vector momentum = scene.momentum();
      Watched watched;
      scene.go([&](const solver::Run& run) { watched.watch(run); });
      EXPECT_GT(watched.greatest, 0);
      EXPECT_LT(watched.force, 1e-13);
      // Friction acts at the mid-surfaces, a contact distance apart.
      EXPECT_LT(watched.moment, rubs ? 0.02 : 1e-13);
      EXPECT_LT((scene.momentum() - momentum).norm(), 1e-12 * momentum.norm());
      EXPECT_NEAR(scene.energies().ratio(), 1, 0.01);
      EXPECT_GE(scene.energies().absorbed.contact_friction, 0);
    }
}

// A plate that stands on its free edge over another one: the edge is flat and ends where the shell does, so the gap is
// that to the lower plate's surface.
TEST(MortarImpact, PlateFallsOnItsEdge) {
  const MortarSheet lower{1, 6, 6, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.1, 1};
  const MortarSheet upper{2, 3, 3, {0.23, 0.52, 0.06}, {0.5, 0, 0}, {0, 0, 0.5}, 0.08, 1};
  for (const std::string& contact : {two_sides, one_side}) {
    RunScene scene(lower.mesh() + upper.mesh() + elastic + thrown(2, {0, 0, -1}) + contact + "0.\n1.,1.\n",
                   until(0.15));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    Watched watched;
    double lowest = 1;
    scene.go([&](const solver::Run& run) {
      watched.watch(run);
      lowest = std::min(lowest, run.stepper().state().x.back().z());
    });
    // A single surface leaves out what is thicker than 0.4 of the shortest side.
    const double half = contact == one_side ? 0.2 / 6 : 0.05;
    EXPECT_NEAR(watched.first, 0.06 - half, 0.005);
    EXPECT_LT(watched.force, 1e-13);
    EXPECT_LT(watched.moment, 1e-13);
    Vector of_upper = Vector::Zero();
    for (std::size_t i = 0; i < scene.state().x.size(); ++i)
      if (scene.read().model.mesh.nodes.id[i] >= 20000) of_upper += scene.state().mass[i] * scene.state().v[i];
    EXPECT_GT(of_upper.z(), -0.2 * 0.08 * 0.25) << "held up";
    EXPECT_NEAR(scene.energies().ratio(), 1, 0.01);
  }
}

// Two sheets in one plane, edge against edge: contact begins where the edges meet, without any thickness between them.
TEST(MortarImpact, SheetsMeetEdgeOnEdge) {
  const MortarSheet still{1, 4, 4, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.1, 1};
  const MortarSheet moving{2, 4, 3, {1.01, 0.1, 0.02}, {1, 0, 0}, {0, 0.8, 0}, 0.1, 1};
  RunScene scene(still.mesh() + moving.mesh() + elastic + thrown(2, {-0.5, 0, 0}) + two_sides + "0.\n1.,1.\n",
                 until(0.12));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  Watched watched;
  double left = 0;
  scene.go([&](const solver::Run& run) {
    watched.watch(run);
    left = std::min(left, run.contacts()[0].state().force_b.x());
  });
  EXPECT_NEAR(watched.first, 0.02, 0.006) << "a step is that long";
  EXPECT_LT(left, 0);
  EXPECT_LT(watched.force, 1e-13);
  EXPECT_LT(watched.moment, 1e-13) << "with the moments that offset edges have";
  EXPECT_NEAR(scene.energies().ratio(), 1, 0.01);
}

TEST(MortarImpact, SameBitsForAnyNumberOfThreads) {
  std::vector<Vector> first;
  for (const std::size_t threads : {1, 2, 4}) {
    const JobLimit limit(threads);
    RunScene scene(bars(one_side), until(0.2));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    scene.go();
    if (first.empty())
      first = scene.state().x;
    else
      EXPECT_EQ(first, scene.state().x);
  }
}

// A search in every cycle (BSORT = 1) must change nothing: the margin and the sleep of pairs are bounds.
TEST(MortarImpact, SearchingMoreOftenChangesNothing) {
  RunScene rarely(bars(one_side), until(0.3)), always(bars(one_side) + "0,0.1,0,1.,2,2,1\n", until(0.3));
  ASSERT_TRUE(rarely.prepared() && always.prepared()) << always.message();
  rarely.go();
  always.go();
  EXPECT_EQ(rarely.state().x, always.state().x);
}

// Faces out of each other's reach cost nothing, those beyond the contact distance sleep.
TEST(MortarImpact, WhatIsFarSleeps) {
  const MortarSheet lower{1, 10, 10, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.02, 1};
  for (const double height : {3.0, 0.06}) {
    const MortarSheet upper{2, 10, 10, {0, 0, height}, {1, 0, 0}, {0, 1, 0}, 0.02, 1};
    ContactScene scene(lower.mesh() + upper.mesh() + elastic + one_side + "0.\n1.,1.\n", [](Structure& structure) {
      structure.state.v[0] = {0, 0, 0.01};
    });
    scene.step(50);
    const ContactCounters& counters = scene.contacts->counters();
    EXPECT_EQ(counters.searches, 1u);
    EXPECT_EQ(counters.candidates > 0, height < 1);
    EXPECT_LE(counters.pairs, counters.candidates) << "once after the search";
  }
}

// A stack of bricks at TSSFAC 0.9, whose contact is as stiff as it may be: no energy comes from nowhere.
TEST(MortarImpact, StackStaysStableAtTheUsualStep) {
  std::string deck = elastic;
  for (int part = 1; part <= 4; ++part)
    deck += MortarBlock{part, {1, 1, 1}, {0.1 * part, 0, 1.001 * part}, {1, 1, 1}, 0, 1}.mesh();
  deck += thrown(4, {0, 0, -0.3}) + thrown(1, {0, 0, 0.3});
  for (const double stiff : {1.0, 1000.0}) {
    RunScene scene(deck + one_side + fmt::format("0.\n{},{}\n", stiff, stiff), until(3));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double most = 0, least = 2;
    scene.go([&](const solver::Run& run) {
      most = std::max(most, run.stepper().energies().ratio());
      least = std::min(least, run.stepper().energies().ratio());
    });
    EXPECT_LT(most, 1.02) << stiff;
    EXPECT_GT(least, 0.98) << stiff;
  }
}

}  // namespace
}  // namespace gapcheck::solver::mortar_impact_test
