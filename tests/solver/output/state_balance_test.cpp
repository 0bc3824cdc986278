// The energy of the state beside the works: closed forms, and energy that is
// created on purpose.
#include "solver/output/state_balance.hpp"

#include <cmath>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::state_balance_test {
namespace {

HeldEnergy held(const StateBalance& balance, HeldEnergy::Kind kind) {
  for (const HeldEnergy& one : balance.held)
    if (one.kind == kind) return one;
  ADD_FAILURE() << "nothing of this kind";
  return {};
}

// ½ k u² of the spring, c u̇² dt of the damper beside it; at the start it is stretched already.
TEST(StateBalance, SpringsAndDampers) {
  const std::string deck =
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n*ELEMENT_MASS\n1,1,2.\n2,2,3.\n*ELEMENT_"
      "DISCRETE\n1,1,1,2,0,1.,0,0.02\n"
      "*PART\np\n1,1,1\n*SECTION_DISCRETE\n1\n\n*MAT_SPRING_ELASTIC\n1,50.\n*"
      "CONTROL_TERMINATION\n3.\n";
  const std::string damper =
      "*ELEMENT_DISCRETE\n2,2,1,2\n*PART\nd\n2,1,2\n*"
      "MAT_DAMPER_VISCOUS\n2,0.4\n";
  RunSettings settings;
  settings.step.greatest_step = 1e-3;
  for (const bool damped : {false, true}) {
    RunScene scene(deck + (damped ? damper : "") + "*INITIAL_VELOCITY_NODE\n1,-0.03\n2,0.02\n", settings);
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double greatest = 0;
    scene.go([&](const solver::Run& run) {
      const StateBalance balance = state_balance(run);
      greatest = std::max(greatest, std::abs(balance.created()) / balance.largest);
      const double u = run.stepper().state().x[1].x() - run.stepper().state().x[0].x() - 1 + 0.02;
      if (!damped && run.stepper().state().cycle > 0) {
        EXPECT_NEAR(held(balance, HeldEnergy::Kind::springs).state, 25 * (u * u - 0.02 * 0.02), 1e-12);
      }
    });
    EXPECT_LT(greatest, 1e-4) << damped;
    EXPECT_TRUE(state_balance(scene.run()).faults().empty());
  }
}

/// A unit cube or square of one element that is pulled by its nodes along x to the elongation 0.1 and held across.
std::string pulled(bool shell, const std::string& material) {
  std::string text = "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n";
  if (!shell) text += "5,0.,0.,1.\n6,1.,0.,1.\n7,1.,1.,1.\n8,0.,1.,1.\n";
  text += shell ? "*ELEMENT_SHELL\n1,1,1,2,3,4\n*SECTION_SHELL\n1,2\n1.\n"
                : "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n*SECTION_SOLID\n1,1\n";
  text += "*PART\np\n1,1,1\n" + material + "*DEFINE_CURVE\n1\n0.,0.\n1.,0.1\n2.,0.1\n";
  for (const int node : shell ? std::vector<int>{1, 2, 3, 4} : std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}) {
    text += fmt::format("*BOUNDARY_SPC_NODE\n{},0,{},1,1,1,1,1\n", node, node % 4 > 1 || node % 4 == 3 ? 0 : 1);
    if (node % 4 == 2 || node % 4 == 3) text += fmt::format("*BOUNDARY_PRESCRIBED_MOTION_NODE\n{},1,2,1\n", node);
  }
  return text + "*CONTROL_TERMINATION\n1.\n";
}

// Held across: σ = M ln λ with M the modulus of a plane wave or a plate, over the area (thickness constant in shells).
TEST(StateBalance, ElasticElements) {
  const double strain = std::log(1.1), bulk = 1000 / 1.2, shear = 1000 / 2.6;
  for (const bool shell : {true, false}) {
    const double modulus = shell ? 1000 / 0.91 : bulk + 4 * shear / 3;
    RunScene scene(pulled(shell, "*MAT_ELASTIC\n1,1e-3,1000.,0.3\n"));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    scene.go();
    const HeldEnergy part =
        held(state_balance(scene.run()), shell ? HeldEnergy::Kind::shells : HeldEnergy::Kind::solids);
    EXPECT_EQ(part.id, 1);
    // Stored in the present volume.
    EXPECT_NEAR(part.state, 1.1 * modulus * strain * strain / 2, 0.01 * part.state) << shell;
    // ∫ M ln λ dλ
    EXPECT_NEAR(part.work, modulus * (1.1 * std::log(1.1) - 0.1), 0.01 * part.work) << shell;
  }
}

// Nearly all of the work of a perfectly plastic plate is 2/√3 σ₀ ε; of a cube the pressure stores much.
TEST(StateBalance, PlasticElements) {
  for (const bool shell : {true, false}) {
    RunScene scene(pulled(shell, "*MAT_PLASTIC_KINEMATIC\n1,1e-3,1000.,0.3,10.\n"));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    scene.go();
    const StateBalance balance = state_balance(scene.run());
    const HeldEnergy part = held(balance, shell ? HeldEnergy::Kind::shells : HeldEnergy::Kind::solids);
    if (shell) {
      EXPECT_NEAR(part.state, 2 / std::sqrt(3.) * 10 * 0.1, 0.1 * part.state);
    }
    EXPECT_NEAR(part.created(), 0, (shell ? 0.01 : 0.06) * part.work) << shell;
    if (!shell) {
      // σxx = K ln λ + 2/3 σ₀ beyond the yield strain σ₀ / 2G, over the constant section.
      const double bulk = 1000 / 1.2, yield_strain = 10 / (2 * 1000 / 2.6);
      EXPECT_NEAR(part.work, bulk * (1.1 * std::log(1.1) - 0.1) + 20.0 / 3 * (0.1 - yield_strain / 2),
                  0.01 * part.work);
    } else {
      EXPECT_NEAR(part.work, 2 / std::sqrt(3.) * 10 * 0.1, 0.1 * part.work);
    }
  }
}

// A plate of constant thickness whose forces act on its present area has no energy: stretched along x by e (in
// logarithms), then along y, then released along both, it gives back more than it took.
TEST(StateBalance, NamesThePartThatCreatesEnergy) {
  constexpr double e = 0.4, nu = 0.3;
  const double stretch = std::exp(e) - 1;
  const auto curve = [&](int id, double from, double to) {
    return fmt::format("*DEFINE_CURVE\n{}\n0.,0.\n{},0.\n{},{}\n2.,{}\n3.,0.\n4.,0.\n", id, from, to, stretch, stretch);
  };
  std::string deck = "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n*ELEMENT_SHELL\n1,1,1,2,3,4\n" +
                     elastic_deck("*SECTION_SHELL\n1,2\n1.\n", 1000, nu, 1e-3) + curve(1, 1e-3, 1) +
                     curve(2, 1, 1.999) + "*CONTROL_TERMINATION\n3.\n";
  for (int node = 1; node <= 4; ++node) {
    const bool x = node == 2 || node == 3, y = node > 2;
    deck += fmt::format("*BOUNDARY_SPC_NODE\n{},0,{},{},1,1,1,1\n", node, x ? 0 : 1, y ? 0 : 1);
    if (x) deck += fmt::format("*BOUNDARY_PRESCRIBED_MOTION_NODE\n{},1,2,1\n", node);
    if (y) deck += fmt::format("*BOUNDARY_PRESCRIBED_MOTION_NODE\n{},2,2,2\n", node);
  }
  RunScene scene(deck);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  const double once = (e - 1) * std::exp(e) + 1;  // ∫ s exp(s)
  const double twice = (e / 2 - 0.25) * std::exp(2 * e) + 0.25;
  const double work =
      1000 / (1 - nu * nu) * (once + std::exp(e) * (once + nu * e * (std::exp(e) - 1)) - 2 * (1 + nu) * twice);
  const StateBalance balance = state_balance(scene.run());
  ASSERT_EQ(balance.faults().size(), 1u);
  EXPECT_EQ(name(balance.faults()[0]), "shells of part 1");
  EXPECT_NEAR(balance.faults()[0].created(), -work, 0.05 * std::abs(work));
  EXPECT_LT(work, 0);
}

/// A held quad and node 5 of mass 1, thrown at it; `scale`: of the contact's stiffness.
std::string thrown_node(double scale, double height, double speed) {
  return fmt::format(
             "*NODE\n1,0.,0.,0.,7,7\n2,1.,0.,0.,7,7\n3,1.,1.,0.,7,7\n4,"
             "0.,1.,0.,7,7\n5,0.5,0.5,{}\n",
             height) +
         "*ELEMENT_SHELL\n1,1,1,2,3,4\n*PART\np\n1,1,1\n*SECTION_SHELL\n1,2\n0."
         "1\n*MAT_ELASTIC\n1,1.,1000.,0.25\n"
         "*ELEMENT_MASS\n5,5,1.\n*SET_NODE_LIST\n1\n5\n*SET_PART_LIST\n1\n1\n*"
         "CONTROL_TERMINATION\n1e9\n" +
         fmt::format("*INITIAL_VELOCITY_NODE\n5,0.,0.,{}\n", -speed) +
         fmt::format(
             "*CONTACT_AUTOMATIC_NODES_TO_SURFACE_ID\n7\n1,1,4,2\n0.\n{"
             "0},{0}\n0\n0.,0,0,1\n",
             scale);
}

// ½ k d² at the deepest point is all of the energy. With ω dt > 2 the spring throws the node out faster than it came:
// the ratio of the works does not notice, that of the state does, and names the contact.
TEST(StateBalance, ContactSprings) {
  constexpr double speed = 0.005, energy = speed * speed / 2;
  const double omega = std::sqrt(0.1 * (1000 / 1.5) / std::sqrt(2.0));
  for (const bool stable : {true, false}) {
    RunSettings settings;
    settings.step.greatest_step = (stable ? 0.02 : 2.6) / omega;
    settings.cycles = stable ? 200 : 6;
    const double start = 0.05 + (stable ? 0.01 : 1.2) * speed * settings.step.greatest_step;
    // The element's own step is shorter than the unstable one.
    settings.step.bounded_step = false;
    const std::string slow = stable ? "" : "*CONTROL_TIMESTEP\n0.,1000.\n";
    RunScene scene(thrown_node(1, start, speed) + slow, settings);
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double deepest = 0;
    scene.go([&](const solver::Run& run) {
      deepest = std::max(deepest, held(state_balance(run), HeldEnergy::Kind::contact).state);
      EXPECT_NEAR(run.stepper().energies().ratio(), 1, 1e-9);
    });
    const StateBalance balance = state_balance(scene.run());
    if (stable) {
      EXPECT_NEAR(deepest, energy, 0.01 * energy);
      EXPECT_TRUE(balance.faults().empty());
      EXPECT_NEAR(balance.ratio, 1, 1e-3);
    } else {
      ASSERT_EQ(balance.faults().size(), 1u);
      EXPECT_EQ(name(balance.faults()[0]), "contact 7");
      EXPECT_GT(balance.faults()[0].created(), energy);
      EXPECT_GT(balance.ratio, 2);
    }
  }
}

// A contact that dies while its spring is compressed: what the spring held is gone, and nothing was created.
TEST(StateBalance, WhatAnEndedContactHeldIsGone) {
  constexpr double speed = 0.005, pi = 3.14159265358979;
  const double omega = std::sqrt(0.1 * (1000 / 1.5) / std::sqrt(2.0));
  RunSettings settings;
  settings.step.greatest_step = 0.01 / omega;
  settings.until = 3 / omega;
  std::string deck = thrown_node(1, 0.05, speed);
  const std::string card = "1,1,4,2\n0.\n";
  deck.replace(deck.find(card), card.size(), fmt::format("1,1,4,2\n0.,0.,0.,0.,0.,0,0.,{}\n", pi / 4 / omega));
  RunScene scene(deck, settings);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  const StateBalance balance = state_balance(scene.run());
  // Half of the energy, at 45 degrees of the swing.
  EXPECT_NEAR(held(balance, HeldEnergy::Kind::contact).state, speed * speed / 4, 0.02 * speed * speed / 4);
  EXPECT_NEAR(balance.created() / balance.largest, 0, 0.01);  // of the last step's way
  EXPECT_EQ(scene.run().contacts()[0].state().touching, 0u);
}

}  // namespace
}  // namespace gapcheck::solver::state_balance_test
