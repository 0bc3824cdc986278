// OPTION 1 and 3 of tiebreaks: nodes that stick when they touch.
#include "solver/tie/tie_stick.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "solver/run_scene.hpp"
#include "solver/tie/tiebreak_scene.hpp"

namespace gapcheck::solver::tie_stick_test {
namespace {

using namespace tiebreak_scene;

/// Of the contact of a node with the held shell: SLSFAC K A / diagonal.
const double stiffness = 0.1 * 1000 / 1.5 / std::sqrt(2.0);
const double frequency = std::sqrt(stiffness);  // of a mass of 1

/// Node 5 flies towards the shell from a height of 0.5 with the velocity (0.1, 0, -0.2), and meets it after 2.25.
std::string flying(const std::string& card, double end, const std::string& drive = "", double load = 0) {
  std::string deck =
      node_on_shell(automatic, card, drive + "*INITIAL_VELOCITY_NODE\n5,0.1,0.,-0.2\n*CONTROL_TIMESTEP\n,0.1\n",
                    fmt::format("0.,{0}\n100.,{0}\n", load), end);
  const std::string place = "5,0.5,0.5,0.05";
  deck.replace(deck.find(place), place.size(), "5,0.3,0.5,0.5");
  return deck;
}
constexpr double meeting = 2.25;

// A spring in all directions at the place where it has touched: x = v/ω sin ωt, along and across, for many periods.
TEST(TieStick, TouchedNodesStayAndSwingInAllDirections) {
  for (const std::string& card :
       {std::string("1"), std::string("-1"), std::string("1,0.001,0.001"), std::string("3,2.,2.")}) {
    RunScene scene(flying(card, 10));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    const double ahead = 0.3 + 0.1 * meeting;
    double low = 1, high = -1, left = 1, right = -1;
    scene.go([&](const solver::Run& run) {
      const State& state = run.stepper().state();
      if (state.time < meeting + 0.01) return;
      const Vector& x = state.x[4];
      low = std::min(low, x.z() - half_thickness), high = std::max(high, x.z() - half_thickness);
      left = std::min(left, x.x() - ahead), right = std::max(right, x.x() - ahead);
    });
    EXPECT_NEAR(high, 0.2 / frequency, 2e-3 * 0.2) << card;
    EXPECT_NEAR(low, -0.2 / frequency, 2e-3 * 0.2) << card;
    EXPECT_NEAR(right, 0.1 / frequency, 2e-3 * 0.2) << card;
    EXPECT_NEAR(left, -0.1 / frequency, 2e-3 * 0.2) << card;
    EXPECT_NEAR(scene.energies().ratio(), 1, 1e-3) << card;
    EXPECT_EQ(scene.run().contacts().back().state().touching, 1u) << card;
  }
}

// What the contact has stored when the node sticks is not counted twice. In the step of the first touch the work of a
// spring by the trapezoidal rule is k p L/2 for the whole way L, of which only p was below the surface.
TEST(TieStick, StoredEnergyGoesFromTheContactToTheTie) {
  RunScene scene(flying("1", 6));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double excess = 0;
  scene.go([&](const solver::Run& run) {
    const State& state = run.stepper().state();
    const double depth = half_thickness - state.x[4].z();
    if (depth > 0 && excess == 0) excess = stiffness * depth / 2 * (0.2 * state.dt - depth);
  });
  double stored = 0, lost = 0, work = 0;
  for (const ContactView& view : scene.run().contacts()) {
    stored += view.stored().value_or(1e9);
    lost += view.state().lost;
    work += view.state().energy_a + view.state().energy_b;
  }
  EXPECT_GT(excess, 1e-7);
  EXPECT_NEAR(stored + lost + excess, work, 1e-12);
}

// It comes back and pulls: at NFLS it is free, with what energy is left.
TEST(TieStick, Option3FailsInTension) {
  const double strength = 0.5, share = strength / (frequency * 0.2);
  RunScene scene(flying("3,0.5", 5));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  const Vector& v = scene.state().v[4];
  EXPECT_NEAR(v.z(), 0.2 * std::sqrt(1 - share * share), 2e-3);
  EXPECT_NEAR(v.x(), -0.1 * std::sqrt(1 - share * share), 2e-3);
  EXPECT_EQ(scene.run().contacts().back().state().force_a.norm(), 0);
}

// Once it has failed it is a contact like others: pressed down again it bounces, and keeps its velocity across.
TEST(TieStick, AFailedNodeDoesNotStickAgain) {
  RunScene scene(flying("3,0.5", 6, "*LOAD_NODE_POINT\n5,3,1,1.\n", -0.3));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double across = 0, pressed = 0;
  scene.go([&](const solver::Run& run) {
    const State& state = run.stepper().state();
    if (state.time > 3 && across == 0) across = state.v[4].x();
    if (state.time < 3) return;
    for (const ContactView& view : run.contacts()) pressed = std::max(pressed, view.state().force_a.z());
  });
  EXPECT_LT(across, -0.05);
  EXPECT_GT(pressed, 0.5) << "it has come back";
  EXPECT_NEAR(scene.state().v[4].x(), across, 1e-12);
}

// A node in touch at the start is tied there, as with OPTION 2.
TEST(TieStick, NodesInTouchAtTheStartAreTied) {
  const std::string drive = "*LOAD_NODE_POINT\n5,1,1,1.\n5,3,1,1.\n";
  RunScene scene(node_on_shell(automatic, "1", drive, "0.,0.\n60.,3.\n", 60));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  EXPECT_NEAR(scene.state().x[4].x() - 0.5, 3 / stiffness, 2e-2 * 3 / stiffness);
  EXPECT_NEAR(scene.state().x[4].z() - half_thickness, 3 / stiffness, 2e-2 * 3 / stiffness);
}

/// Two free plates of four shells, the upper one from the height `height` with the velocity (1, 0, -1).
std::string two_plates(const std::string& keyword, double height, double end) {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n", velocities = "*INITIAL_VELOCITY_NODE\n";
  for (int layer = 0; layer < 2; ++layer)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        const int id = 1 + i + 3 * j + 100 * layer;
        nodes += fmt::format("{},{},{},{}\n", id, 0.5 * i + 0.1 * layer, 0.5 * j + 0.1 * layer, height * layer);
        if (layer == 1) velocities += fmt::format("{},1.,0.,-1.\n", id);
        if (i < 2 && j < 2) shells += fmt::format("{},{},{},{},{},{}\n", id, layer + 1, id, id + 1, id + 4, id + 3);
      }
  return nodes + shells + velocities +
         fmt::format(
             "*PART\np\n1,1,1\n*PART\nq\n2,1,1\n*SECTION_SHELL\n1,2\n0.1\n*MAT_ELASTIC\n1,1.,10000.,0.25\n"
             "*CONTACT_{}\n*CONTROL_TERMINATION\n{}\n",
             keyword, end);
}

/// How far the mean of the upper plate is from where it is relative to the lower one at first contact, at most.
double largest_gap(RunScene& scene) {
  double gap = 0;
  scene.go([&](const solver::Run& run) {
    const State& state = run.stepper().state();
    Vector lower = Vector::Zero(), upper = Vector::Zero();
    for (std::size_t i = 0; i < 9; ++i) lower += state.x[i] / 9, upper += state.x[9 + i] / 9;
    gap = std::max(gap, (upper - lower).z());
  });
  return gap;
}

// Plates that meet stay together, whichever contact sticks; without sticking they part again.
TEST(TieStick, PlatesOfOneSurfaceStayTogether) {
  const std::string single = "AUTOMATIC_SINGLE_SURFACE", apart = "\n1,2,3,3\n\n\n";
  const std::string parts = "\n0,0,5\n\n\n";
  for (const std::string& keyword : {single + "_TIEBREAK" + parts + "1", single + "_TIEBREAK" + parts + "-1",
                                     "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK" + apart + "1",
                                     "AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK" + apart + "1"}) {
    RunScene scene(two_plates(keyword, 0.3, 2));
    ASSERT_TRUE(scene.prepared()) << keyword << scene.message();
    const Vector before(0.1, 0, -0.1);  // a plate has a mass of 0.1
    EXPECT_LT(largest_gap(scene), 0.301) << keyword;
    EXPECT_NEAR((scene.momentum() - before).norm(), 0, 1e-12) << keyword;
    EXPECT_NEAR(scene.energies().ratio(), 1, 2e-2) << keyword;
  }
  RunScene scene(two_plates(single + parts, 0.3, 2));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  EXPECT_GT(largest_gap(scene), 0.5);
}

/// One mass above the held shell: contact in the cycle in which it touches, then a spring to that place.
struct LoneMass {
  Vector x, v;
  double mass = 1;
  bool stuck = false;
  Vector place = Vector::Zero();

  void step(double before, double next) {
    Vector force = Vector::Zero();
    if (stuck) {
      force = -stiffness * (x - place);
    } else if (x.z() < half_thickness) {
      force.z() = stiffness * (half_thickness - x.z());
      stuck = true;
      place = {x.x(), x.y(), half_thickness};
    }
    v += (before + next) / 2 / mass * force;
    x += next * v;
  }
};

TEST(TieStick, AgreesWithLoneMasses) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int round = 0; round < 10; ++round) {
    std::vector<LoneMass> masses;
    std::string nodes, weights, velocities = "*INITIAL_VELOCITY_NODE\n", set;
    for (int i = 0; i < 6; ++i) {
      LoneMass one;
      one.x = {0.5 + 0.2 * any(random), 0.5 + 0.2 * any(random), 0.4 + 0.1 * any(random)};
      one.v = {0.1 * any(random), 0.1 * any(random), -0.4 + 0.2 * any(random)};
      one.mass = 1 + 0.5 * any(random);
      nodes += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", 11 + i, one.x.x(), one.x.y(), one.x.z());
      weights += fmt::format("{0},{0},{1:.17g}\n", 11 + i, one.mass);
      velocities += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", 11 + i, one.v.x(), one.v.y(), one.v.z());
      set += fmt::format(",{}", 11 + i);
      masses.push_back(one);
    }
    std::string deck = node_on_shell(automatic, "1", "*NODE\n" + nodes + "*ELEMENT_MASS\n" + weights + velocities,
                                     "0.,0.\n1.,0.\n", 4);
    const std::string list = "*SET_NODE_LIST\n1\n5\n";
    deck.replace(deck.find(list), list.size(), "*SET_NODE_LIST\n1\n" + set.substr(1) + "\n");
    RunScene scene(deck);
    ASSERT_TRUE(scene.prepared()) << scene.message();
    scene.go([&](const solver::Run& run) {
      const double before = run.stepper().state().dt, next = run.stepper().next_step();
      for (std::size_t i = 0; i < masses.size(); ++i) {
        EXPECT_NEAR((run.stepper().state().x[5 + i] - masses[i].x).norm(), 0, 1e-10);
        masses[i].step(before, next);
      }
    });
    for (const LoneMass& mass : masses) EXPECT_TRUE(mass.stuck);
  }
}

}  // namespace
}  // namespace gapcheck::solver::tie_stick_test
