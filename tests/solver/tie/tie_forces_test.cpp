// Forces of ties: balance, rigid rotation, chains, bodies, times; constraints against a slow solution of the same
// equations.
#include "solver/tie/tie_forces.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "solver/output/state_balance.hpp"
#include "solver/tie/tie_constraints.hpp"
#include "solver/tie/tie_scene.hpp"

namespace gapcheck::solver::tie_forces_test {
namespace {

using Grid = TieDeck::Grid;

std::string test_name(const testing::TestParamInfo<const char*>& info) {
  std::string name = info.param;
  return name;
}

/// Kinetic energy, momentum and angular momentum of the middle of the last step.
struct Motions {
  double energy = 0;
  Vector momentum = Vector::Zero(), angular = Vector::Zero();
  explicit Motions(const State& state) {
    for (std::size_t i = 0; i < state.x.size(); ++i) {
      const double m = state.mass[i], inertia = state.inertia[i];
      energy += m / 2 * state.v[i].squaredNorm() + inertia / 2 * state.w[i].squaredNorm();
      momentum += m * state.v[i];
      angular += state.x[i].cross(m * state.v[i]) + inertia * state.w[i];
    }
  }
};

/// A small plate tied above a larger one, or above a block, at a distance; both fly and spin.
std::string spinning(const std::string& keyword, bool block, double distance, double end) {
  const Grid base{1, {0, 0, 0}, {2, 2, block ? 1 : 0.1}, 4, 4, block ? 2 : 0};
  const double top = block ? 1 : 0;
  const Grid upper{2, {0.3, 0.4, top + distance}, {1.1, 1.2, 0.1}, 3, 3, 0};
  TieDeck deck;
  deck.add(base).add(upper).tie(keyword, TieDeck::nodes(upper, -1), 1, 1);
  std::string velocities = "*INITIAL_VELOCITY_GENERATION\n";
  for (const int part : {1, 2}) velocities += fmt::format("{},2,1e-3,2e-4,1e-4,3e-4\n0.5,0.5,0.5,0.3,0.5,0.8\n", part);
  deck.also(velocities);
  return deck.text(end);
}

class Spinning : public testing::TestWithParam<const char*> {};

TEST_P(Spinning, KeepsMomentumAndEnergy) {
  const std::string keyword = GetParam();
  const bool carries = keyword.find("BEAM") != keyword.npos || keyword.find("CONSTRAINED") != keyword.npos;
  const bool penalty = keyword.find("OFFSET") != keyword.npos && keyword.find("CONSTRAINED") == keyword.npos;
  for (const bool block : {false, true}) {
    // Types without OFFSET move the nodes onto the segments.
    const double distance = keyword.find("OFFSET") == keyword.npos ? 0 : 0.2;
    RunScene scene(spinning(keyword, block, distance, 400));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    std::optional<Motions> start;
    double worst_force = 0, held = 0;
    scene.go([&](const solver::Run& run) {
      const State& state = run.stepper().state();
      if (state.cycle == 1) start.emplace(state);
      const ContactState& tie = run.contacts().front().state();
      const double size = tie.force_a.norm() + 1e-12;
      worst_force = std::max(worst_force, (tie.force_a + tie.force_b).norm() / size);
      if (carries || !penalty)
        worst_force = std::max(worst_force, (tie.moment_a + tie.moment_b).norm() / (size + tie.moment_a.norm()));
      held = std::max(held, std::abs(tie.energy_a + tie.energy_b));
    });
    const Motions end(scene.state());
    EXPECT_LT(worst_force, 1e-9) << block;
    EXPECT_LT((end.momentum - start->momentum).norm(), 1e-11 * start->momentum.norm()) << block;
    if (carries || !penalty) {
      EXPECT_LT((end.angular - start->angular).norm(), 1e-9 * start->angular.norm()) << block;
    }
    const Energies& e = scene.energies();
    EXPECT_NEAR(e.total() / e.initial, 1, 1e-5) << block;
    // Without the moment of their offset ties do work in a spin: the fault of the OFFSET forms.
    EXPECT_LT(held, (penalty && !carries ? 5e-3 : 1e-6) * e.initial) << block;
    RecordProperty(block ? "held_block" : "held_plate", fmt::format("{:.2g}", held / e.initial));
  }
}

INSTANTIATE_TEST_SUITE_P(Ties, Spinning,
                         testing::Values("TIED_NODES_TO_SURFACE", "TIED_SHELL_EDGE_TO_SURFACE",
                                         "TIED_NODES_TO_SURFACE_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE_OFFSET",
                                         "TIED_NODES_TO_SURFACE_BEAM_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET",
                                         "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET",
                                         "TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET"),
                         test_name);

/// Springs give no force while everything turns as a rigid body, however far.
TEST(TieForces, RigidRotationGivesNoForce) {
  for (const char* keyword : {"TIED_SHELL_EDGE_TO_SURFACE_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET"})
    for (const bool block : {false, true}) {
      model::Read read = model::read_text(spinning(keyword, block, 0.2, 1));
      contact::SurfaceStore surfaces(read.model);
      contact::InitialCounters counters;
      const contact::InitialState initial = contact::initialise_contacts(read.model, surfaces, {}, counters);
      Diagnostics diagnostics;
      auto built = build_structure(read.model, {}, diagnostics);
      Structure& structure = built.value();
      State& state = structure.state;
      state.coming = state.manual_step = 0.01;
      TieForces ties(read.model, surfaces, initial, structure);
      Forces forces;
      forces.resize(state.x.size());
      ties.add(state, forces);
      ASSERT_EQ(ties.nodes(0).size(), 16u);
      const Vector spin(0.3, -0.2, 0.4);
      state.dt = 0.01;
      for (int step = 0; step < 1000; ++step) {
        const std::vector<Vector> before = state.x;
        const Matrix turn = spin_rotation(state.dt * spin);
        for (std::size_t i = 0; i < state.x.size(); ++i) {
          state.x[i] = turn * before[i];
          state.v[i] = (state.x[i] - before[i]) / state.dt;
          state.w[i] = spin;
        }
        forces.resize(state.x.size());
        ties.add(state, forces);
        for (std::size_t i = 0; i < state.x.size(); ++i) {
          ASSERT_LT(forces.force[i].norm(), 1e-13) << keyword << " " << step;
          ASSERT_LT(forces.moment[i].norm(), 1e-13) << keyword << " " << step;
        }
      }
    }
}

/// Two rigid bodies tied at several points turn as one: the springs stay as good as empty.
TEST(RigidBodiesTied, TurnAsOne) {
  const std::string rigid = "*MAT_RIGID\n{},1.,1.,0.\n";
  for (const char* keyword : {"TIED_SURFACE_TO_SURFACE_OFFSET", "TIED_SURFACE_TO_SURFACE_BEAM_OFFSET"}) {
    const Grid base{1, {0, 0, 0}, {2, 2, 1}, 2, 2, 1, rigid}, upper{2, {0.5, 0.5, 1.3}, {1, 1, 0.5}, 2, 2, 1, rigid};
    TieDeck deck;
    deck.add(base).add(upper).tie(keyword, TieDeck::nodes(upper, -1, -1, 0), 1, 1);
    deck.also(
        "*INITIAL_VELOCITY_GENERATION\n1,2,1e-4,1e-3\n0.8,1.,0.77,0.,0.,1.\n2,2,1e-4,1e-3\n0.8,1.,0.77,0.,0.,1.\n"
        "*CONTROL_TIMESTEP\n0.,0.9,0,0.05\n");
    RunScene scene(deck.text(3000));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    ASSERT_EQ(scene.run().contacts().size(), 1u);
    scene.go();
    const Energies& e = scene.energies();
    EXPECT_GT(e.initial, 0);
    EXPECT_NEAR(e.total() / e.initial, 1, 1e-6) << keyword;
    EXPECT_LT(std::abs(e.absorbed.sliding()), 1e-4 * e.initial) << keyword;
    const double distance = (mean_of(scene, scene.state().x, {2001}) - mean_of(scene, scene.state().x, {1001})).norm();
    EXPECT_NEAR(distance, Vector(0.5, 0.5, 1.3).norm(), 1e-4) << keyword;
  }
}

/// A node on a node of a node: a chain of ties, and one node that two contacts want.
TEST(TieChains, MoveTogether) {
  const Grid first{1, {0, 0, 0}, {1, 1, 0.1}, 1, 1, 0}, second{2, {0.25, 0.25, 0}, {0.5, 0.5, 0.1}, 1, 1, 0},
      third{3, {0.4, 0.4, 0}, {0.2, 0.2, 0.1}, 1, 1, 0};
  for (const char* keyword : {"TIED_NODES_TO_SURFACE", "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET",
                              "TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET", "TIED_NODES_TO_SURFACE_OFFSET"}) {
    TieDeck deck;
    deck.add(first).add(second).add(third);
    deck.tie(keyword, TieDeck::nodes(third, -1), 2, 0.1).tie(keyword, TieDeck::nodes(second, -1), 1, 0.1);
    deck.tie(keyword, TieDeck::nodes(third, -1), 1, 0.1);
    deck.load({3001}, 1, 1e-4).load({3002}, 3, 2e-6);
    RunScene scene(deck.text(20));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    const bool constraint = std::string(keyword).find("_OFFSET") == std::string::npos ||
                            std::string(keyword).find("CONSTRAINED") != std::string::npos;
    scene.go();
    EXPECT_EQ(scene.run().contacts().size(), 3u) << keyword;
    const State& state = scene.state();
    // All three get what the force gives their mass together.
    const double mass = 0.1 * (1 + 0.25 + 0.04);
    const double time = state.time + scene.run().stepper().next_step() / 2;
    EXPECT_NEAR(scene.momentum().x() / (1e-4 * time), 1, 1e-9) << keyword;
    const auto speed = [&](const std::vector<int>& nodes) { return mean_of(scene, state.v, nodes).x(); };
    const double expected = 1e-4 * time / mass;
    for (const Grid* grid : {&first, &second, &third})
      EXPECT_NEAR(speed(TieDeck::nodes(*grid, -1)) / expected, 1, constraint ? 0.05 : 0.5) << keyword;
    // The point that each node is tied to moves as the node does.
    const std::vector<Vector>& start = scene.run().initial().x;
    for (const ContactView& view : scene.run().contacts()) {
      std::vector<ContactLink> links;
      view.source->links(view.position, links);
      // The first contact has the nodes: a constraint of the third one gets none.
      EXPECT_EQ(links.size(), constraint && view.state().contact == ContactIndex{2} ? 0u : 4u) << keyword;
      for (const ContactNode& node : view.nodes()) EXPECT_EQ(node.kind, ContactNode::Kind::tied);
      for (const ContactLink& link : links) {
        const Vector before = link.tracked.of(start) - link.reference.of(start),
                     after = link.tracked.of(state.x) - link.reference.of(state.x);
        EXPECT_LT((after - before).norm(), constraint ? 1e-14 : 0.02) << keyword;
      }
    }
  }
}

/// The first contact takes the node; the second one ties it by a spring where IPBACK asks for it.
TEST(Ipback, TiesWhatTheFirstContactHas) {
  const Grid upper{1, {0, 0, 0}, {1, 1, 0.1}, 1, 1, 0}, lower{2, {0, 0, 0}, {1, 1, 0.1}, 1, 1, 0},
      small{3, {0.4, 0.4, 0}, {0.2, 0.2, 0.1}, 1, 1, 0};
  for (const bool ipback : {false, true}) {
    TieDeck deck;
    deck.add(upper).add(lower).add(small);
    deck.tie("TIED_NODES_TO_SURFACE", TieDeck::nodes(small, -1), 1, 0.1);
    deck.tie("TIED_NODES_TO_SURFACE", TieDeck::nodes(small, -1), 2, 0.1, ipback ? "\n\n\n\n,,1\n" : "");
    deck.load(TieDeck::nodes(upper, -1), 1, 1e-4);
    RunScene scene(deck.text(100));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    scene.go();
    const double speed = mean_of(scene, scene.state().v, TieDeck::nodes(lower, -1)).x();
    // F t over the masses of all three, which swing against one another a little.
    EXPECT_NEAR(speed, ipback ? 1e-4 * 100 / (0.1 + 0.1 + 0.004) : 0, ipback ? 0.03 * 0.05 : 0);
  }
}

/// Held nodes, ties of nothing but held nodes, nodes without mass, equations that say the same twice.
TEST(TieConstraints, LeaveOutWhatMovesNothing) {
  const Grid base{1, {0, 0, 0}, {1, 1, 0.1}, 1, 1, 0}, upper{2, {0.2, 0.2, 0}, {0.6, 0.6, 0.1}, 1, 1, 0};
  TieDeck deck;
  deck.add(base).add(upper).hold(TieDeck::nodes(base, -1)).hold({2001});
  deck.also("*NODE\n9001,0.5,0.5,0.\n").tie("TIED_NODES_TO_SURFACE", {2001, 2002, 2003, 2004, 9001}, 1, 0.1);
  deck.load({2004}, 3, 1e-3);
  RunScene scene(deck.text(50));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  for (const Vector& v : scene.state().v) EXPECT_EQ(v.norm(), 0);
  EXPECT_EQ(scene.run().contacts().front().nodes().size(), 4u);
  std::string said;
  for (const Diagnostic& d : scene.diagnostics().sorted()) said += d.message + "\n";
  EXPECT_NE(said.find("1 nodes stay untied"), std::string::npos) << said;
  EXPECT_NE(said.find("no mass"), std::string::npos) << said;
}

/// Two plates on one another, each tied to the other: every equation is there twice.
TEST(TieConstraints, SayingItTwiceIsNoHarm) {
  const Grid base{1, {0, 0, 0}, {1, 1, 0.1}, 2, 2, 0}, upper{2, {0, 0, 0}, {1, 1, 0.1}, 2, 2, 0};
  TieDeck deck;
  deck.add(base).add(upper);
  deck.tie("TIED_NODES_TO_SURFACE", TieDeck::nodes(upper, -1), 1, 0.1);
  deck.tie("TIED_NODES_TO_SURFACE", TieDeck::nodes(base, -1), 2, 0.1);
  deck.load({2001}, 3, 1e-5);
  RunScene scene(deck.text(20));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  for (int i = 1; i <= 9; ++i) {
    const Vector above = mean_of(scene, scene.state().v, {2000 + i}),
                 below = mean_of(scene, scene.state().v, {1000 + i});
    EXPECT_LT((above - below).norm(), 1e-13);
  }
  EXPECT_GT(mean_of(scene, scene.state().v, {1001}).z(), 0);
}

/// Ties act between birth and death.
TEST(TieTimes, BirthAndDeath) {
  for (const char* keyword : {"TIED_NODES_TO_SURFACE", "TIED_NODES_TO_SURFACE_OFFSET"}) {
    const Grid base{1, {0, 0, 0}, {1, 1, 0.1}, 1, 1, 0}, upper{2, {0.2, 0.2, 0}, {0.6, 0.6, 0.1}, 1, 1, 0};
    std::string text = TieDeck()
                           .add(base)
                           .add(upper)
                           .tie(keyword, TieDeck::nodes(upper, -1), 1, 0.1)
                           .load(TieDeck::nodes(upper, -1), 1, 1e-4)
                           .text(30);
    const std::size_t card = text.find("\n0.\n1,1,");
    ASSERT_NE(card, text.npos);
    text.replace(card, 4, "\n0.,0.,0.,0.,0.,0,10.,20.\n");
    RunScene scene(text);
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double before = -1, after = -1;
    scene.go([&](const solver::Run& run) {
      const double speed = run.stepper().state().v[0].x();
      if (run.stepper().state().time < 9) before = speed;
      if (run.stepper().state().time > 21 && after < 0) after = speed;
    });
    EXPECT_EQ(before, 0) << keyword;
    // F t over the mass of both by constraints; springs swing about that.
    const double both = 1e-4 * 20 / (0.1 + 0.036);
    EXPECT_NEAR(after / both, 1, std::string(keyword) == "TIED_NODES_TO_SURFACE" ? 0.04 : 1) << keyword;
    EXPECT_GT(after, 0) << keyword;
    EXPECT_EQ(scene.run().contacts().front().nodes().size(), 0u);
  }
}

/// Four nodes on one facet of a brick: the stretch is F/4 over SLSFAC SFS K A²/V.
TEST(TieForces, StiffnessIsThatOfAContact) {
  const Grid base{1, {0, 0, 0}, {1, 1, 1}, 1, 1, 1}, upper{2, {0.2, 0.2, 1}, {0.6, 0.6, 0.5}, 1, 1, 1};
  const double stiffness = 0.1 * 1.5 / 3;
  TieDeck deck;
  deck.add(base).add(upper).hold(TieDeck::nodes(base, -1)).hold(TieDeck::nodes(upper, -1), "0,1,1");
  deck.tie("TIED_NODES_TO_SURFACE_OFFSET", TieDeck::nodes(upper, -1, -1, 0), 1, 0.1, "", 1.5);
  deck.load(TieDeck::nodes(upper, -1, -1, 0), 1, 4e-4).also("*DAMPING_GLOBAL\n0,1.\n");
  RunScene scene(deck.text(60));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  const ContactView view = scene.run().contacts().front();
  std::vector<ContactLink> links;
  view.source->links(view.position, links);
  ASSERT_EQ(links.size(), 4u);
  const std::vector<Vector>&now = scene.state().x, &start = scene.run().initial().x;
  for (const ContactLink& link : links) {
    const Vector stretch =
        (link.tracked.of(now) - link.reference.of(now)) - (link.tracked.of(start) - link.reference.of(start));
    EXPECT_NEAR(stretch.x() * stiffness / 1e-4, 1, 1e-3);
    EXPECT_NEAR(link.force.x() / -1e-4, 1, 1e-3);
  }
  // F²/2k of each.
  ASSERT_TRUE(view.stored().has_value());
  EXPECT_NEAR(*view.stored() / (4 * 1e-8 / 2 / stiffness), 1, 3e-3);
}

/// However stiff they are, springs shorten the step of the elements to one half and no further.
TEST(TieForces, ShortenTheStepToOneHalf) {
  const Grid base{1, {0, 0, 0}, {1, 1, 1}, 1, 1, 1}, upper{2, {0.2, 0.2, 1}, {0.6, 0.6, 0.5}, 1, 1, 1};
  const auto step = [&](double scale) {
    TieDeck deck;
    deck.add(base).add(upper);
    deck.tie("TIED_NODES_TO_SURFACE_OFFSET", TieDeck::nodes(upper, -1, -1, 0), 1, 0.1, "", scale);
    RunSettings settings;
    settings.cycles = 1;
    RunScene scene(deck.text(1e9), settings);
    EXPECT_TRUE(scene.prepared()) << scene.message();
    scene.go();
    return scene.state().dt;
  };
  const double free = step(1e-6);
  EXPECT_NEAR(step(1e3) / free, 0.5, 1e-3);
  EXPECT_NEAR(step(1e6) / free, 0.5, 1e-3);
}

/// Walls act before constraint ties, so what they stop may move on: told, with the number of nodes that are tied so.
TEST(TieWalls, NodesThatConstraintsTieAreNamed) {
  const Grid base{1, {0, 0, 0}, {1, 1, 0.1}, 1, 1, 0}, upper{2, {0.2, 0.2, 0}, {0.6, 0.6, 0.1}, 1, 1, 0};
  const std::string wall = "*RIGIDWALL_PLANAR\n0\n0,0,-5,0,0,1\n",
                    far = "*NODE\n9001,0.5,0.5,3.\n*ELEMENT_MASS\n9,9001,1.\n";
  const auto said = [&](const char* keyword, const std::string& more) {
    TieDeck deck;
    deck.add(base).add(upper).also(far + more).tie(keyword, {2001, 2002, 2003, 2004, 9001}, 1, 0.1);
    const RunScene scene(deck.text(1));
    EXPECT_TRUE(scene.prepared()) << scene.message();
    std::string text;
    for (const Diagnostic& d : scene.diagnostics().sorted()) text += d.message + "\n";
    return text;
  };
  EXPECT_NE(said("TIED_NODES_TO_SURFACE", wall).find("rigid walls do not stop the 4 nodes that constraints tie"),
            std::string::npos)
      << said("TIED_NODES_TO_SURFACE", wall);
  EXPECT_EQ(said("TIED_NODES_TO_SURFACE", "").find("rigid walls"), std::string::npos);
  EXPECT_EQ(said("TIED_NODES_TO_SURFACE_OFFSET", wall).find("rigid walls"), std::string::npos);
}

/// Springs between very different masses and moduli stay stable, whatever PENOPT takes.
TEST(TieForces, StableForAnyStiffnessRatio) {
  for (const double ratio : {1e-6, 1e-3, 1e3, 1e6})
    for (const int penopt : {1, 2, 3}) {
      const Grid base{1, {0, 0, 0}, {1, 1, 0.5}, 2, 2, 1},
          upper{2,
                {0.2, 0.2, 0.55},
                {0.6, 0.6, 0.5},
                2,
                2,
                1,
                fmt::format("*MAT_ELASTIC\n{{}},{:.3g},{:.3g},0.\n", std::sqrt(ratio), ratio)};
      TieDeck deck;
      deck.add(base).add(upper).tie("TIED_NODES_TO_SURFACE_BEAM_OFFSET", TieDeck::nodes(upper, -1, -1, 0), 1, 0.1);
      deck.also(fmt::format("*CONTROL_CONTACT\n0.1,0.,0,0,{}\n", penopt));
      deck.load(TieDeck::nodes(upper, -1, -1, 1), 1, 1e-3 * std::min(1.0, ratio));
      RunSettings settings;
      settings.cycles = 3000;
      RunScene scene(deck.text(1e9), settings);
      ASSERT_TRUE(scene.prepared()) << scene.message();
      const auto end = scene.try_to_go();
      EXPECT_TRUE(end && *end == RunEnd::cycles) << ratio << " " << penopt << " " << scene.message();
      EXPECT_NEAR(scene.energies().ratio(), 1, 0.02) << ratio << " " << penopt;
      const StateBalance balance = state_balance(scene.run());
      EXPECT_NEAR(balance.created() / balance.largest, 0, 0.02) << ratio << " " << penopt;
    }
}

// ---- constraints against a dense solution ----

/// Matrix of all equations of a list of ties, by finite differences of what they say about velocities.
Eigen::MatrixXd dense(const std::vector<Tie>& ties, const State& state) {
  const auto n = static_cast<Eigen::Index>(state.x.size());
  Eigen::Index rows = 0;
  for (const Tie& tie : ties) rows += tie.rotations ? 6 : 3;
  Eigen::MatrixXd g(rows, 6 * n);
  for (Eigen::Index column = 0; column < 6 * n; ++column) {
    std::vector<Vector> v(state.x.size(), Vector::Zero()), w = v;
    (column % 6 < 3 ? v : w)[static_cast<std::size_t>(column / 6)][column % 3] = 1;
    Eigen::Index row = 0;
    for (const Tie& tie : ties) {
      const TieMotion moving = motion(tie, SegmentAxes(tie.point.nodes, state.x), v, w);
      const Vector arm = state.x[tie.node.value] - tie.point.of(state.x);
      g.block<3, 1>(row, column) = moving.velocity - (tie.carries ? Vector(moving.spin.cross(arm)) : Vector::Zero());
      row += 3;
      if (!tie.rotations) continue;
      g.block<3, 1>(row, column) = moving.turn;
      row += 3;
    }
  }
  return g;
}

class DenseTwin : public testing::TestWithParam<const char*> {};

TEST_P(DenseTwin, SameForces) {
  const bool block = std::string(GetParam()).find("NODES") != std::string::npos;
  const Grid base{1, {0, 0, 0}, {2, 2, 0.3}, 2, 2, block ? 1 : 0},
      middle{2, {0.3, 0.2, block ? 0.35 : 0.05}, {1.5, 1.4, 0.1}, 2, 3, 0},
      top{3, {0.5, 0.4, block ? 0.4 : 0.1}, {0.9, 0.8, 0.1}, 2, 1, 0};
  TieDeck deck;
  deck.add(base).add(middle).add(top).hold({1001, 1002}, "1,0,1").hold({3001}, "0,1,0,1");
  deck.tie(GetParam(), TieDeck::nodes(middle, -1), 1, 0.1).tie(GetParam(), TieDeck::nodes(top, -1), 2, 0.1);
  model::Read read = model::read_text(deck.text(1));
  ASSERT_EQ(read.errors(), 0u) << read.text();
  contact::SurfaceStore surfaces(read.model);
  contact::InitialCounters counters;
  const contact::InitialState initial = contact::initialise_contacts(read.model, surfaces, {}, counters);
  Diagnostics diagnostics;
  auto built = build_structure(read.model, {}, diagnostics);
  Structure& structure = built.value();
  structure.state.x = initial.x;
  for (const int held : {1001, 1002, 3001})
    for (std::uint32_t i = 0; i < initial.x.size(); ++i)
      if (structure.node_id[i] == held) structure.constraints.hold(NodeIndex{i}, held == 3001 ? 10 : 5);
  structure.constraints.finish();
  State& state = structure.state;
  state.dt = 0;
  Forces net, external;
  net.resize(state.x.size());
  external.resize(state.x.size());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  // Forces that are small enough for the arms hardly to turn.
  const auto any = [&] { return Vector(1e-9 * Vector(number(random), number(random), number(random))); };
  for (Vector& f : net.force) f = any();
  for (std::size_t i = 0; i < net.moment.size(); ++i)
    if (state.inertia[i] > 0) net.moment[i] = any();
  const double mean = 0.3, next = 0.4;
  TieConstraints ties(read.model, surfaces, initial, structure, diagnostics);
  const Forces before = net;
  ties.react(state, mean, next, net, external);

  const std::vector<Tie> list = tie_list(read.model, surfaces, initial, structure, true);
  ASSERT_GT(list.size(), 10u);
  const Eigen::MatrixXd g = dense(list, state);
  Eigen::VectorXd inverse(g.cols()), force(g.cols());
  for (Eigen::Index c = 0; c < g.cols(); ++c) {
    const auto node = static_cast<std::size_t>(c / 6);
    const double mass = c % 6 < 3 ? state.mass[node] : state.inertia[node];
    const bool held = (structure.constraints.held(node) >> (c % 6) & 1u) != 0;
    inverse[c] = held || mass <= 0 ? 0 : 1 / mass;
    force[c] = (c % 6 < 3 ? before.force : before.moment)[node][c % 3];
  }
  // Arms that turn over the step leave a small rest in the equations, which is given.
  Eigen::VectorXd found(g.cols());
  for (Eigen::Index c = 0; c < g.cols(); ++c)
    found[c] = inverse[c] * (c % 6 < 3 ? net.force : net.moment)[static_cast<std::size_t>(c / 6)][c % 3];
  const Eigen::VectorXd rest = g * found;
  EXPECT_LT(rest.lpNorm<Eigen::Infinity>(), 1e-6 * found.lpNorm<Eigen::Infinity>());
  const Eigen::MatrixXd a = g * inverse.asDiagonal() * g.transpose();
  const Eigen::VectorXd lambda = a.completeOrthogonalDecomposition().solve(rest - g * inverse.asDiagonal() * force);
  const Eigen::VectorXd expected = inverse.asDiagonal() * (force + g.transpose() * lambda);
  const double largest = (found - expected).lpNorm<Eigen::Infinity>();
  EXPECT_LT(largest, 1e-10 * expected.lpNorm<Eigen::Infinity>());
  RecordProperty("difference", fmt::format("{:.2g}", largest / expected.lpNorm<Eigen::Infinity>()));
}

INSTANTIATE_TEST_SUITE_P(Ties, DenseTwin,
                         testing::Values("TIED_NODES_TO_SURFACE", "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET",
                                         "TIED_SHELL_EDGE_TO_SURFACE", "TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET"),
                         test_name);

// Two lone shells vibrate at the highest frequency that their bound of the step allows: springs beside them have less
// room than in a mesh, where TSSFAC sets the step. A small load must not make a large motion.
TEST(TieForces, LoneShellsAtTheBoundOfTheirStep) {
  const Grid base{1, {0, 0, 0}, {1, 1, 0.1}, 1, 1, 0}, upper{2, {0.2, 0.2, 0}, {0.6, 0.6, 0.1}, 1, 1, 0};
  for (const char* form :
       {"TIED_NODES_TO_SURFACE_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET"})
    for (const double factor : {0.5, 0.85, 0.9, 1.0}) {
      TieDeck deck;
      deck.add(base).add(upper).load({2001}, 3, 1e-8).tie(form, TieDeck::nodes(upper, -1), 1, 1);
      deck.also(fmt::format("*CONTROL_TIMESTEP\n0.,{}\n", factor));
      RunScene scene(deck.text(2000));
      ASSERT_TRUE(scene.prepared()) << scene.message();
      double fastest = 0;
      scene.go([&](const solver::Run& run) {
        for (const Vector& v : run.stepper().state().v) fastest = std::max(fastest, v.norm());
      });
      // The load moves a mass of 0.136 for 2,000: 1.5e-4 without vibrations.
      EXPECT_LT(fastest, 1e-3) << form << factor;
      EXPECT_GT(fastest, 1e-4) << form << factor;
      EXPECT_EQ(scene.state().elements_share > usual_share, factor > 0.8) << factor;
    }
}

}  // namespace
}  // namespace gapcheck::solver::tie_forces_test
