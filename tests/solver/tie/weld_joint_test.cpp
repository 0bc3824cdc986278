// Two sheets, one above the other, and one weld between them, a beam or a brick, in equilibrium: what goes through the
// weld follows from the balance of the upper sheet alone.
#include <gtest/gtest.h>

#include "solver/tie/tie_scene.hpp"

namespace gapcheck::solver::weld_joint_test {
namespace {

using Grid = TieDeck::Grid;

constexpr double thickness = 0.1, half_width = 0.4, load = 1e-6;
const std::string stiff = "*MAT_ELASTIC\n{},1.,1000.,0.\n";
/// The lower sheet is held at x = -1, the upper one loaded at x = 1.
const Grid lower{1, {-1, -half_width, 0}, {1.2, 2 * half_width, thickness}, 6, 3, 0, stiff},
    upper{2, {-0.2, -half_width, thickness}, {1.2, 2 * half_width, thickness}, 6, 3, 0, stiff};

std::string mat_100(const std::string& limits = "") { return "*MAT_SPOTWELD\n3,1.,1000.,0.,1e3,1e3\n" + limits + "\n"; }

/// Forces and moments on the two ends of a weld, at the middles of the ends.
struct Ends {
  Vector x[2], force[2], moment[2];
};

/// The weld of one joint; `offset`: distance of its ends from the mid-planes.
struct Weld {
  std::string deck;
  std::vector<int> nodes[2];
};

Weld beam_weld(double offset, const std::string& limits = "") {
  return {
      fmt::format("*NODE\n3001,0.03,0.,{:.17g}\n3002,0.03,0.,{:.17g}\n3003,1.,0.,0.\n", offset, thickness - offset) +
          "*ELEMENT_BEAM\n3001,3,3001,3002,3003\n*PART\nweld\n3,3,3\n*SECTION_BEAM\n3,9,1.,2,1\n0.1,0.1\n" +
          mat_100(limits),
      {{3001}, {3002}}};
}

Weld brick_weld(double offset, const std::string& limits = "", const std::string& elform = "2") {
  std::string nodes = "*NODE\n";
  Weld weld;
  for (int k = 0; k < 8; ++k) {
    nodes += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", 3001 + k, k % 4 == 1 || k % 4 == 2 ? 0.08 : -0.02,
                         k % 4 > 1 ? 0.05 : -0.05, k < 4 ? offset : thickness - offset);
    weld.nodes[k / 4].push_back(3001 + k);
  }
  weld.deck = nodes + "*ELEMENT_SOLID\n3001,3,3001,3002,3003,3004,3005,3006,3007,3008\n*PART\nweld\n3,3,3\n" +
              "*SECTION_SOLID\n3," + elform + "\n" + mat_100(limits);
  return weld;
}

TieDeck joint(const Weld& weld, const std::string& contact) {
  TieDeck deck;
  deck.add(lower).add(upper).also(weld.deck);
  // Springs as soft as those of a contact would let the upper sheet swing for long.
  const double scale = contact.ends_with("BEAM_OFFSET") ? 20 : 1;
  // With a viscous control one-point shells that bend in their plane creep.
  deck.also("*CONTROL_HOURGLASS\n4,0.1\n");
  for (int end = 0; end < 2; ++end) deck.tie(contact, weld.nodes[end], end + 1, thickness, "", scale);
  return deck;
}

Ends ends_of(const RunScene& scene, const Weld& weld) {
  Ends ends;
  const auto& all = scene.read().model.mesh.nodes.id;
  const Structure& structure = scene.run().stepper().structure();
  for (std::size_t end = 0; end < 2; ++end) {
    ends.x[end] = mean_of(scene, scene.state().x, weld.nodes[end]);
    ends.force[end] = ends.moment[end] = Vector::Zero();
    for (const int id : weld.nodes[end]) {
      const auto n = static_cast<std::size_t>(std::find(all.begin(), all.end(), id) - all.begin());
      Vector force = Vector::Zero(), moment = Vector::Zero();
      structure.solids.gather(n, force);
      structure.beams.gather(n, force, moment);
      ends.force[end] -= force;  // the weld pulls its nodes with the opposite
      ends.moment[end] -= moment + (scene.state().x[n] - ends.x[end]).cross(force);
    }
  }
  return ends;
}

struct Case {
  const char* name;
  const char* contact;
  bool brick = false;
  double offset = 0;
};

std::string test_name(const testing::TestParamInfo<Case>& info) { return info.param.name; }

class WeldJoint : public testing::TestWithParam<Case> {
 protected:
  [[nodiscard]] Weld weld(const std::string& limits = "") const {
    return GetParam().brick ? brick_weld(GetParam().offset, limits) : beam_weld(GetParam().offset, limits);
  }
};

/// The load goes through the weld, and so does its moment about each end: lap shear (x), peel (z) and shear across (y),
/// the latter only where the weld takes torsion.
TEST_P(WeldJoint, CarriesTheLoadAndItsMoments) {
  const bool torsion = GetParam().brick || std::string(GetParam().contact).find("TORSION") != std::string::npos;
  for (int direction = 1; direction <= 3; ++direction) {
    if (direction == 2 && !torsion) continue;
    const Weld weld = this->weld();
    TieDeck deck = joint(weld, GetParam().contact);
    const std::vector<int> edge = TieDeck::nodes(upper, upper.nx);
    deck.hold(TieDeck::nodes(lower, 0)).load(edge, direction, load).also("*DAMPING_GLOBAL\n0,1.6\n");
    RunScene scene(deck.text(direction == 2 ? 50 : 25));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    scene.go();
    const Ends ends = ends_of(scene, weld);
    Vector force = Vector::Zero();
    force[direction - 1] = load;
    const Vector at = mean_of(scene, scene.state().x, edge);
    double worst = 0;
    for (std::size_t end = 0; end < 2; ++end) {
      const double sign = end == 0 ? -1 : 1;
      worst = std::max(worst, (sign * ends.force[end] - force).norm() / load);
      worst = std::max(worst, (sign * ends.moment[end] - (at - ends.x[end]).cross(force)).norm() / load);
    }
    EXPECT_LT(worst, 1e-3) << "direction " << direction;
    RecordProperty(fmt::format("direction_{}", direction), fmt::format("{:.1e}", worst));
    EXPECT_NEAR(scene.run().contacts()[0].state().force_a.norm() / load, 1, 1e-3);
    EXPECT_NEAR(scene.energies().ratio(), 1, 1e-4);
  }
}

/// A joint that spins freely: the weld has the centripetal force of half of it, no matter how far it has turned. The
/// load comes at once, so that it vibrates between zero and twice that.
TEST_P(WeldJoint, TurnsWithoutForce) {
  constexpr double omega = 0.05;
  const Weld weld = this->weld();
  TieDeck deck = joint(weld, GetParam().contact);
  deck.also("*INITIAL_VELOCITY_GENERATION\n");
  const Vector axis = Vector(1, 2, 2) / 3;
  for (const int part : {1, 2, 3})
    deck.also(fmt::format("{},2,{}\n0.,0.,{},{:.17g},{:.17g},{:.17g}\n", part, omega, thickness / 2, axis.x(), axis.y(),
                          axis.z()));
  RunScene scene(deck.text(1.5 / omega));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double worst = 0;
  scene.go([&](const auto&) { worst = std::max(worst, ends_of(scene, weld).force[1].norm()); });
  const double mass = 1.2 * 2 * half_width * thickness;
  EXPECT_LT(worst, 2.5 * mass * omega * omega * 0.4);
  EXPECT_NEAR(scene.energies().ratio(), 1, 1e-5);
  EXPECT_LT(scene.momentum().norm(), 1e-3 * 2 * mass * omega);
}

/// Under a load that grows slowly the weld fails at NRR in peel; then the sheets are free of one another, the ends of
/// the weld stay with them, and no energy is lost.
TEST_P(WeldJoint, PeelsAtItsStrength) {
  constexpr double strength = load / 2, slow = 60;
  const Weld weld = this->weld(fmt::format("0.,{}", strength));
  TieDeck deck = joint(weld, GetParam().contact);
  deck.hold(TieDeck::nodes(lower, 0)).also("*DAMPING_GLOBAL\n0,1.6\n");
  deck.also(fmt::format("*DEFINE_CURVE\n99\n0.,0.\n{},1.\n*LOAD_NODE_POINT\n", slow));
  const std::vector<int> edge = TieDeck::nodes(upper, upper.nx);
  for (const int node : edge)
    deck.also(fmt::format("{},3,99,{:.17g}\n", node, load / static_cast<double>(edge.size())));
  RunScene scene(deck.text(0.6 * slow));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double failed = 0, before = 0, height = 0, ratio = 0;
  scene.go([&](const auto& run) {
    if (failed > 0) return;
    if (run.stepper().failures().empty())
      before = ends_of(scene, weld).force[1].z(), ratio = run.stepper().energies().ratio();
    else
      failed = run.stepper().failures()[0].time, height = mean_of(scene, run.stepper().state().x, edge).z();
  });
  EXPECT_NEAR(before / strength, 1, 2e-3);
  EXPECT_GT(failed, slow / 2) << "the load leads by what damping takes from the upper sheet";
  EXPECT_LT(failed, 0.6 * slow);
  const Ends ends = ends_of(scene, weld);
  EXPECT_EQ(ends.force[0].norm() + ends.force[1].norm(), 0);
  EXPECT_GT(mean_of(scene, scene.state().x, edge).z(), height + 1e-6) << "the upper sheet goes with the load";
  EXPECT_NEAR(ratio, 1, 1e-4);
  // The light ends of the weld vibrate on springs so fast that the kinetic energy, that of mean velocities, misses
  // some.
  const bool springs = std::string(GetParam().contact).ends_with("BEAM_OFFSET");
  EXPECT_NEAR(scene.energies().ratio(), 1, springs ? 0.06 : 3e-3);
}

INSTANTIATE_TEST_SUITE_P(
    Welds, WeldJoint,
    testing::Values(Case{"beam_spotweld", "SPOTWELD"}, Case{"beam_torsion", "SPOTWELD_WITH_TORSION"},
                    Case{"beam_shell_edge", "TIED_SHELL_EDGE_TO_SURFACE"},
                    Case{"beam_offset", "SPOTWELD_BEAM_OFFSET", false, 0.02},
                    Case{"beam_constrained", "TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET", false, 0.02},
                    Case{"brick_nodes", "TIED_NODES_TO_SURFACE", true}, Case{"brick_spotweld", "SPOTWELD", true},
                    Case{"brick_constrained", "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET", true, 0.02}),
    test_name);

/// A moment about the axis of a weld on one free sheet. With torsion it turns the sheet, whose angular momentum is
/// moment times time; without it only the nodes turn where they are.
TEST(WeldTorsion, TurnsTheSheetWithTorsionOnly) {
  constexpr double moment = 1e-6, end = 2;
  for (const auto& [contact, turns] :
       {std::pair("SPOTWELD", false), {"SPOTWELD_WITH_TORSION", true}, {"SPOTWELD_WITH_TORSION_PENALTY", true}}) {
    const Weld weld = beam_weld(0);
    TieDeck deck;
    deck.add(upper).also(weld.deck).tie(contact, weld.nodes[1], 2, thickness);
    deck.also(fmt::format("*DEFINE_CURVE\n99\n0.,1.\n1e9,1.\n*LOAD_NODE_POINT\n3001,7,99,{}\n", moment));
    RunScene scene(deck.text(end));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    scene.go();
    Vector momentum = Vector::Zero(), by_nodes = Vector::Zero();
    const State& state = scene.state();
    for (std::size_t n = 0; n < state.x.size(); ++n) {
      momentum += state.mass[n] * state.x[n].cross(state.v[n]);
      by_nodes += state.inertia[n] * state.w[n];
    }
    EXPECT_NEAR((momentum + by_nodes).z() / (moment * state.time), 1, 1e-3) << contact;
    if (turns)
      EXPECT_GT(momentum.z(), 0.9 * moment * state.time) << contact;
    else
      EXPECT_LT(std::abs(momentum.z()), 1e-6 * moment * state.time) << contact;
    EXPECT_NEAR(scene.energies().ratio(), 1, 1e-6);
  }
}

}  // namespace
}  // namespace gapcheck::solver::weld_joint_test
