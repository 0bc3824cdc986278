#include "solver/constraint/constraint_contact.hpp"

#include <cmath>

#include "base/parallel.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::constraint_contact_test {
namespace {

constexpr double thickness = 0.1;

/// A row of `quads` shells of 1 x 1 along x in z = 0, with 1 kg more at each node, and node 100 of 1 kg at the given
/// place: one constraint contact between them.
std::string node_over_row(const std::string& place, const std::string& velocity, int quads = 1,
                          const std::string& friction = "0.", const std::string& more = "") {
  std::string nodes = "*NODE\n100," + place + "\n", shells = "*ELEMENT_SHELL\n", masses = "*ELEMENT_MASS\n100,100,1.\n";
  for (int i = 0; i <= quads; ++i) {
    nodes += fmt::format("{},{}.,0.,0.\n{},{}.,1.,0.\n", 2 * i + 1, i, 2 * i + 2, i);
    masses += fmt::format("{0},{0},1.\n{1},{1},1.\n", 2 * i + 1, 2 * i + 2);
    if (i < quads) shells += fmt::format("{},1,{},{},{},{}\n", i + 1, 2 * i + 1, 2 * i + 3, 2 * i + 4, 2 * i + 2);
  }
  return nodes + shells + masses + "*INITIAL_VELOCITY_NODE\n100," + velocity + "\n" +
         fmt::format("*PART\np\n1,1,1\n*SECTION_SHELL\n1,2\n{}\n*MAT_ELASTIC\n1,1e-9,1e-6,0.25\n", thickness) +
         "*SET_NODE_LIST\n1\n100\n*SET_PART_LIST\n1\n1\n*CONTACT_CONSTRAINT_NODES_TO_SURFACE\n1,1,4,2\n" + friction +
         "\n\n0\n*CONTROL_TERMINATION\n1.\n" + more;
}

RunSettings cycles(std::uint64_t count, double step = 1e-3) {
  RunSettings settings;
  settings.cycles = count;
  settings.step.greatest_step = step;
  return settings;
}

const ContactState& contact(const RunScene& scene) { return scene.run().contacts()[0].state(); }

const std::string hold_row = "*SET_NODE_GENERAL\n5\nPART,1\n*BOUNDARY_SPC_SET\n5,0,1,1,1,1,1,1\n";

// A node thrown at a held plate lies on it afterwards; it gives m v and ½ m v² to it.
TEST(ConstraintContact, NodeStopsOnHeldPlate) {
  RunScene scene(node_over_row("0.4,0.3,0.0623", "0.,0.,-3.", 1, "0.", hold_row), cycles(20));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double impulse = 0;
  scene.go([&](const solver::Run& run) {
    impulse += run.contacts()[0].state().force_a.z() * 1e-3;
    EXPECT_NEAR(run.stepper().energies().ratio(), 1, 1e-13);
  });
  EXPECT_NEAR(impulse, 3, 1e-12);
  EXPECT_NEAR(scene.state().x[0].z(), thickness / 2, 1e-15);
  EXPECT_NEAR(scene.state().v[0].z(), 0, 1e-14);
  EXPECT_NEAR(contact(scene).energy_a, 4.5, 1e-12);
  EXPECT_NEAR(contact(scene).energy_b, 0, 1e-14);
  EXPECT_NEAR(scene.energies().kinetic, 0, 1e-13);
}

// Two free bodies go on together: the plate's four corners count as Σ w²/m, the lost energy is ½ m* v².
TEST(ConstraintContact, TwoMassesGoOnTogether) {
  RunScene scene(node_over_row("0.4,0.3,0.0623", "0.,0.,-3."), cycles(40));
  const double w[] = {0.6 * 0.7, 0.4 * 0.7, 0.4 * 0.3, 0.6 * 0.3};
  double squares = 0;
  for (const double weight : w) squares += weight * weight;
  const double reduced = 1 / (1 + squares);
  const Vector before(0, 0, -3);
  double last = 0;
  scene.go([&](const solver::Run& run) {
    EXPECT_LT((scene.momentum() - before).norm(), 1e-12);
    const double lost = run.stepper().energies().absorbed.contact_normal;
    EXPECT_GE(lost, last - 1e-12);
    last = lost;
  });
  EXPECT_NEAR(scene.energies().absorbed.contact_normal, 0.5 * reduced * 9, 1e-5);
  EXPECT_NEAR(scene.state().v[0].z(), -3 * (1 - reduced), 1e-3);  // the plate has turned a little since
}

// The middle of the plate: then it moves without turning, and all is exact.
TEST(ConstraintContact, CentralImpactIsExact) {
  RunScene scene(node_over_row("0.5,0.5,0.0623", "0.,0.,-3."), cycles(40));
  scene.go();
  EXPECT_NEAR(scene.energies().absorbed.contact_normal, 0.5 * 0.8 * 9, 1e-9);
  EXPECT_NEAR(scene.state().v[0].z(), -0.6, 1e-9);
  EXPECT_NEAR(scene.state().v[1].z(), -0.6, 1e-9);
  EXPECT_NEAR(scene.energies().ratio(), 1, 1e-12);
}

const std::string weight = "*DEFINE_CURVE\n9\n0.,1.\n1.,1.\n*LOAD_NODE_POINT\n100,3,9,-2.\n";

// A plate that is moved takes the node along, and it has the plate's velocity; the motion pays m v².
TEST(ConstraintContact, MovedPlateTakesTheNodeAlong) {
  const std::string moved =
      "*SET_NODE_GENERAL\n5\nPART,1\n*BOUNDARY_SPC_SET\n5,0,1,1,0,1,1,1\n*BOUNDARY_PRESCRIBED_MOTION_SET\n5,3,0,8\n"
      "*DEFINE_CURVE\n8\n0.,2.\n9.,2.\n";
  RunScene scene(node_over_row("0.4,0.3,0.0623", "0.,0.,0.", 1, "0.", moved), cycles(20));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double impulse = 0;
  scene.go([&](const solver::Run& run) { impulse += run.contacts()[0].state().force_a.z() * 1e-3; });
  EXPECT_NEAR(impulse, 2, 1e-12);
  EXPECT_NEAR(scene.state().v[0].z(), 2, 1e-13);
  EXPECT_NEAR(scene.state().x[0].z(), 20 * 2e-3 + thickness / 2, 1e-14);
  EXPECT_NEAR(scene.state().x[1].z(), 20 * 2e-3, 1e-14);
  EXPECT_NEAR(scene.energies().external - contact(scene).energy_b, 0, 1e-12);
}

// Two nodes meet a free plate in one step. The fast one takes the plate away from the slow one, which is then in no
// contact: no force, no record.
TEST(ConstraintContact, WhatTheOtherOneTakesAwayIsNotTouched) {
  std::string deck = node_over_row("0.5,0.5,0.051", "0.,0.,-3.");
  const auto put = [&](const std::string& old, const std::string& now) {
    deck.replace(deck.find(old), old.size(), now);
  };
  put("*INITIAL_VELOCITY_NODE\n",
      "*NODE\n101,0.2,0.3,0.05005\n*ELEMENT_MASS\n101,101,1.\n*INITIAL_VELOCITY_NODE\n"
      "101,0.,0.,-0.1\n");
  put("*SET_NODE_LIST\n1\n100\n", "*SET_NODE_LIST\n1\n101,100\n");
  RunScene scene(deck, cycles(1));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  EXPECT_EQ(contact(scene).touching, 1u);
  const std::vector<ContactNode> nodes = scene.run().contacts()[0].nodes();
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(scene.read().model.mesh.nodes.id[nodes[0].node.value], 100);
  EXPECT_EQ(scene.state().v.back().z(), -0.1);
  std::vector<ContactLink> links;
  const ContactView view = scene.run().contacts()[0];
  view.source->links(view.position, links);
  EXPECT_EQ(links.size(), 1u);
}

// A constant load: the reaction is that load in each cycle, and the node stays where it is.
TEST(ConstraintContact, LoadIsCarriedWithoutOscillation) {
  RunScene scene(node_over_row("0.4,0.3,0.05", "0.,0.,0.", 1, "0.", hold_row + weight), cycles(200));
  scene.go([&](const solver::Run& run) {
    EXPECT_NEAR(run.contacts()[0].state().force_a.z(), 2, 1e-9);
    EXPECT_NEAR(scene.state().x[0].z(), 0.05, 1e-15);
  });
  EXPECT_NEAR(contact(scene).energy_a, 0, 1e-12);
}

// It slides over the borders of the segments as if there were none.
TEST(ConstraintContact, SlidesOverBorders) {
  RunScene scene(node_over_row("0.2,0.3,0.05", "40.,0.,0.", 4, "0.", hold_row + weight), cycles(90));
  scene.go([&](const solver::Run& run) { EXPECT_EQ(run.contacts()[0].state().touching, 1u); });
  EXPECT_NEAR(scene.state().x[0].x(), 0.2 + 40 * 90e-3, 1e-9);
  EXPECT_NEAR(scene.state().x[0].z(), 0.05, 1e-14);
  EXPECT_NEAR(scene.state().v[0].x(), 40, 1e-12);
}

// μ N slows it down until it sticks; what is lost is friction.
TEST(ConstraintContact, FrictionStopsIt) {
  RunScene scene(node_over_row("0.2,0.3,0.05", "0.05,0.,0.", 1, "0.5,0.5", hold_row + weight), cycles(100));
  double at_20 = 0;
  scene.go([&](const solver::Run& run) {
    if (run.stepper().state().cycle == 20) at_20 = run.stepper().state().v[0].x();
  });
  EXPECT_NEAR(at_20, 0.05 - 0.5 * 2 * 20.5e-3, 1e-6);  // the first cycle has half a step
  EXPECT_NEAR(scene.state().v[0].x(), 0, 1e-14);
  EXPECT_NEAR(contact(scene).friction, 0.5 * 0.05 * 0.05, 3e-5);
  EXPECT_NEAR(scene.energies().ratio(), 1, 1e-10);
}

// Pressed, then pulled: it leaves as soon as the reaction would pull.
TEST(ConstraintContact, ReleasedWhenItWouldPull) {
  const std::string pull = "*DEFINE_CURVE\n9\n0.,-1.\n0.02,-1.\n0.0201,1.\n1.,1.\n*LOAD_NODE_POINT\n100,3,9,2.\n";
  RunScene scene(node_over_row("0.4,0.3,0.05", "0.,0.,0.", 1, "0.", hold_row + pull), cycles(100));
  scene.go([&](const solver::Run& run) {
    const std::uint64_t cycle = run.stepper().state().cycle;
    EXPECT_EQ(run.contacts()[0].state().touching, cycle <= 20 ? 1u : 0u) << cycle;
    EXPECT_GE(run.contacts()[0].state().force_a.z(), 0);
  });
  EXPECT_NEAR(scene.state().v[0].z(), 2 * 80e-3, 1e-12);
}

// A node that lies in the plate when the contact is born is moved onto it, without force and energy.
TEST(ConstraintContact, NodeInsideIsMovedBack) {
  const std::string late = node_over_row("0.4,0.3,0.04", "0.,0.,0.", 1, "0.,0.,0.,0.,0.,0,0.0055", hold_row);
  RunScene scene(late, cycles(20));
  scene.go();
  EXPECT_NEAR(scene.state().x[0].z(), 0.05, 2.1e-5);
  EXPECT_EQ(scene.state().v[0].norm(), 0);
  EXPECT_NEAR(contact(scene).energy_a, 0, 1e-15);
}

// A thick quad beside a thin one: a node that has come into it before the contact is born is moved to half the thick
// one's thickness, and stopped there.
TEST(ConstraintContact, NodeInsideAThickQuad) {
  std::string deck = node_over_row("1.4,0.3,0.15", "0.,0.,-10.", 2, "0.,0.,0.,0.,0.,0,0.0055",
                                   "*SET_NODE_GENERAL\n5\nPART,1,2\n*BOUNDARY_SPC_SET\n5,0,1,1,1,1,1,1\n"
                                   "*PART\nthick\n2,2,1\n*SECTION_SHELL\n2,2\n0.2\n");
  const auto put = [&](const std::string& old, const std::string& now) {
    deck.replace(deck.find(old), old.size(), now);
  };
  put("\n2,1,3,5,6,4\n", "\n2,2,3,5,6,4\n");
  put("*SET_PART_LIST\n1\n1\n", "*SET_PART_LIST\n1\n1,2\n");
  RunScene scene(deck, cycles(20));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  EXPECT_NEAR(scene.state().x[0].z(), 0.1, 1e-12);
  EXPECT_NEAR(scene.state().v[0].z(), 0, 1e-12);
  EXPECT_EQ(contact(scene).moved, 1u);
}

/// A block of 1 x 1 x 0.5 of n x n bricks, and one of 0.8 x 0.8 x 0.5 of m x m bricks above it.
std::string blocks(int below, int above, double gap, const std::string& material, const std::string& more) {
  std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n";
  int node = 1, element = 1;
  for (int part = 1; part <= 2; ++part) {
    const int n = part == 1 ? below : above, first = node;
    const double low = part == 1 ? -0.5 : gap, corner = part == 1 ? 0 : 0.1, side = (1 - 2 * corner) / n;
    for (int k = 0; k <= 1; ++k)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i, ++node)
          nodes += fmt::format("{},{},{},{}\n", node, corner + side * i, corner + side * j, low + 0.5 * k);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i, ++element) {
        const int a = first + i + (n + 1) * j, up = (n + 1) * (n + 1);
        solids += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", element, part, a, a + 1, a + n + 2, a + n + 1, a + up,
                              a + 1 + up, a + n + 2 + up, a + n + 1 + up);
      }
  }
  return nodes + solids + "*PART\nlow\n1,1,1\n*PART\nhigh\n2,1,2\n*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1," + material +
         "\n*MAT_ELASTIC\n2," + material +
         "\n*CONTACT_CONSTRAINT_SURFACE_TO_SURFACE\n1,2,3,3\n\n\n0\n*CONTROL_TERMINATION\n1.\n" + more;
}

// One block falls on another: momentum and balance of energies to rounding, energy is lost and never gained; they part
// again by their elasticity. Any number of threads gives the same bits.
TEST(ConstraintContact, BlocksInCollision) {
  const std::string deck = blocks(3, 2, 0.001, "1.,1e4,0.3", "*INITIAL_VELOCITY_GENERATION\n2,2,0.,0.1,0.2,-5.\n");
  std::vector<Vector> first;
  for (const std::size_t threads : {1, 3}) {
    const JobLimit limit(threads);
    RunScene scene(deck, cycles(300, 1.0));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    const Vector before = scene.momentum();
    double least = 0, most = 0;
    std::uint64_t touched = 0;
    scene.go([&](const solver::Run& run) {
      EXPECT_LT((scene.momentum() - before).norm(), 1e-12 * before.norm());
      const double lost = run.stepper().energies().absorbed.contact_normal;
      EXPECT_GT(lost, most - 0.01 * run.stepper().energies().initial);
      most = std::max(most, lost);
      least = std::min(least, lost);
      touched += run.contacts()[0].state().touching > 0;
    });
    EXPECT_GT(touched, 5u);
    EXPECT_GE(least, -1e-12);
    EXPECT_NEAR(scene.energies().ratio(), 1, 0.01);
    EXPECT_GT(scene.energies().absorbed.contact_normal, 0);
    double highest = -1e9, lowest = 1e9;  // nothing has gone through
    for (std::size_t i = 0; i < 32; ++i) highest = std::max(highest, scene.state().x[i].z());
    for (std::size_t i = 32; i < 50; ++i) lowest = std::min(lowest, scene.state().x[i].z());
    EXPECT_GT(lowest, highest);
    if (first.empty())
      first = scene.state().x;
    else
      EXPECT_EQ(first, scene.state().x);
  }
}

// Under its weight a block stays on the surface of the other: no gap in any cycle, and the mean force is the weight.
TEST(ConstraintContact, BlockAtRestUnderGravity) {
  const std::string deck = blocks(1, 1, 0, "1.,1e4,0.",
                                  "*SET_NODE_LIST_GENERATE\n3\n1,4\n*BOUNDARY_SPC_SET\n3,0,1,1,1\n"
                                  "*DEFINE_CURVE\n9\n0.,0.\n0.1,10.\n10.,10.\n*LOAD_BODY_Z\n9,1.\n");
  RunScene scene(deck, cycles(4000, 1.0));
  double impulse = 0, since = 0, widest = 0;
  scene.go([&](const solver::Run& run) {
    const std::vector<Vector>& x = run.stepper().state().x;
    if (run.stepper().state().time < 0.05) return;
    impulse += run.contacts()[0].state().force_a.z() * run.stepper().next_step();
    since += run.stepper().next_step();
    for (std::size_t i = 8; i < 12; ++i) {
      const double s = x[i].x(), t = x[i].y();
      const double surface =
          (1 - s) * (1 - t) * x[4].z() + s * (1 - t) * x[5].z() + (1 - s) * t * x[6].z() + s * t * x[7].z();
      widest = std::max(widest, std::abs(x[i].z() - surface));
    }
  });
  EXPECT_GT(since, 0.9);
  EXPECT_LT(widest, 1e-9);
  EXPECT_NEAR(impulse / since, -0.32 * 10 * (1 - 0.05 / 0.95 * 0.25), 0.05);  // SURFA is below; the load still grows
}

TEST(ConstraintContact, RigidBodiesAreRefused) {
  const std::string rigid = node_over_row("0.4,0.3,0.0623", "0.,0.,-3.");
  std::string deck = rigid;
  deck.replace(deck.find("*MAT_ELASTIC"), 12, "*MAT_RIGID");
  RunScene scene(deck, cycles(20));
  ASSERT_FALSE(scene.prepared());
  for (const std::string word : {"contact 1", "rigid part 1", "penalty"})
    EXPECT_NE(scene.message().find(word), std::string::npos) << scene.message();
  RunScene weld(rigid + "*CONSTRAINED_SPOTWELD\n1,2\n", cycles(20));
  ASSERT_FALSE(weld.prepared());
  EXPECT_NE(weld.message().find("node 1 of a rigid body or weld"), std::string::npos) << weld.message();
}

}  // namespace
}  // namespace gapcheck::solver::constraint_contact_test
