// The strengths of ties as their cards give them, in whole runs: works, stresses and sides.
#include "solver/tie/tie_strengths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/run_scene.hpp"
#include "solver/tie/tiebreak_scene.hpp"

namespace gapcheck::solver::tie_strengths_test {
namespace {

using namespace tiebreak_scene;

/// The node is pulled from the shell at constant speed: what the ties take, the largest force, and whether they fail.
struct Peeled {
  double work = 0, largest = 0, ratio = 0;
  bool broken = false;
};

Peeled peel(const std::string& keyword, const std::string& card, int direction, double way,
            const std::string& more = "") {
  constexpr double end = 100;
  std::string deck =
      node_on_shell(keyword, card, fmt::format("*BOUNDARY_PRESCRIBED_MOTION_NODE\n5,{},0,1\n", direction),
                    fmt::format("0.,{0}\n1000.,{0}\n", way / end), end) +
      more;
  RunScene scene(deck);
  Peeled peeled;
  if (!scene.prepared()) {
    ADD_FAILURE() << scene.message();
    return peeled;
  }
  scene.go([&](const solver::Run& run) {
    double force = 0;
    for (const ContactView& view : run.contacts()) {
      force += view.state().force_a.norm();
      for (const ContactNode& node : view.nodes()) peeled.broken |= node.kind == ContactNode::Kind::broken;
    }
    peeled.largest = std::max(peeled.largest, force);
  });
  peeled.work = scene.energies().absorbed.sliding();
  peeled.ratio = scene.energies().ratio();
  return peeled;
}

/// OPTION 7 and 9 to 11 on an area of 1: the works are ERATEN and ERATES, the largest stresses NFLS and SFLS.
TEST(Tiebreak, CohesiveLawsTakeTheirEnergies) {
  struct Case {
    const char *option, *param, *more;
  };
  for (const auto& [option, param, more] : {Case{"7", "0.", ""}, Case{"10", "0.", ""}, Case{"9", "1.", ",1.,300."},
                                            Case{"9", "-1.45", ",0.5,200."}, Case{"11", "2.", ""}}) {
    const std::string card = fmt::format("{},2.,3.,{},0.4,0.6{}", option, param, more);
    const Peeled opening = peel(automatic, card, 3, 0.5), sliding = peel(automatic, card, 1, 0.5);
    EXPECT_NEAR(opening.work, 0.4, 2e-3) << card;
    EXPECT_NEAR(opening.largest, 2, 0.02) << card;
    EXPECT_NEAR(sliding.work, 0.6, 3e-3) << card;
    EXPECT_NEAR(sliding.largest, 3, 0.03) << card;
    EXPECT_TRUE(opening.broken && sliding.broken) << card;
    EXPECT_NEAR(opening.ratio, 1, 1e-6);
  }
}

/// CN and CT2CN: stress per length, on twice the area.
TEST(Tiebreak, CohesiveStiffnessIsGiven) {
  for (const int direction : {1, 3}) {
    std::string deck = node_on_shell(automatic, "9,100.,100.,1.,1e3,1e3,0.5,150.",
                                     fmt::format("*BOUNDARY_PRESCRIBED_MOTION_NODE\n5,{},0,1\n", direction),
                                     "0.,1e-3\n1000.,1e-3\n", 20);
    for (const std::string corner : {"\n2,1.", "\n3,1."})
      deck.replace(deck.find(corner), corner.size(), corner.substr(0, 3) + "2.");
    RunScene scene(deck);
    ASSERT_TRUE(scene.prepared()) << scene.message();
    scene.go();
    const double way = 1e-3 * scene.state().time;
    double force = 0;
    for (const ContactView& view : scene.run().contacts()) force += view.state().force_a.norm();
    EXPECT_NEAR(force, 2 * 150 * (direction == 1 ? 0.5 : 1) * way, 1e-3) << direction;
  }
}

/// OPTION 5: strength times opening, with the strength falling to nothing at 0.4.
TEST(Tiebreak, PlasticLawSoftens) {
  const std::string curve = "*DEFINE_CURVE\n7\n0.,1.\n0.4,0.\n";
  const Peeled opening = peel(automatic, "5,2.,0.,7", 3, 0.5, curve);
  const double stiffness = 0.1 * 1000 / 1.5 / std::sqrt(2.0), onset = 2 / (stiffness + 2 / 0.4);
  EXPECT_NEAR(opening.largest, stiffness * onset, 0.02);
  EXPECT_NEAR(opening.work, stiffness * onset * 0.4 / 2, 2e-3);
  EXPECT_TRUE(opening.broken);
  const Peeled sliding = peel(automatic, "5,2.,0.,7", 1, 0.5, curve);
  EXPECT_NEAR(sliding.largest, 2 / std::sqrt(3.0), 0.01);
  EXPECT_FALSE(sliding.broken) << "sliding opens nothing";
  EXPECT_NEAR(sliding.work, 2 / std::sqrt(3.0) * (0.5 - 2 / std::sqrt(3.0) / stiffness / 2), 5e-3);
}

/// OPTION 4: tension alone breaks the tie; along the surface PARAM = 1 makes SFLS the friction, whatever the pressure,
/// and without it nothing holds the node.
TEST(Tiebreak, SlidesUntilTensionBreaksIt) {
  const Peeled opening = peel(automatic, "4,2.,1.", 3, 0.5);
  EXPECT_NEAR(opening.largest, 2, 0.02);
  EXPECT_TRUE(opening.broken);
  const double stiffness = 0.1 * 1000 / 1.5 / std::sqrt(2.0);
  const Peeled rubbing = peel(automatic, "4,2.,1.,1.", 1, 0.4);
  EXPECT_NEAR(rubbing.largest, 1, 1e-6);
  EXPECT_NEAR(rubbing.work, 0.4 - 0.5 / stiffness, 1e-3);
  EXPECT_FALSE(rubbing.broken);
  EXPECT_NEAR(rubbing.ratio, 1, 1e-6);
  const Peeled free = peel(automatic, "4,2.,1.", 1, 0.4);
  EXPECT_LT(free.largest, 1e-9);
  EXPECT_FALSE(free.broken);
  EXPECT_TRUE(peel(automatic, "4,2.,1.", 1, 0.8).broken) << "off the surface";
}

/// TBLCID of the older type: after the failure at 2 the stress falls from 1 to 0 over an opening of 0.4.
TEST(Tiebreak, ResistsOpeningAfterItsFailure) {
  const Peeled opening = peel("TIEBREAK_SURFACE_TO_SURFACE", "2.,2.,7", 3, 0.6, "*DEFINE_CURVE\n7\n0.,1.\n0.4,0.\n");
  const double stiffness = 0.1 * 1000 / 1.5 / std::sqrt(2.0), onset = 2 / stiffness;
  EXPECT_TRUE(opening.broken);
  EXPECT_NEAR(opening.largest, 2, 0.02);
  EXPECT_NEAR(opening.work, 2 * onset / 2 + (0.4 - onset) * (1 - onset / 0.4) / 2, 5e-3);
}

/// OPTION 2 with PARAM = 1 and older types take the front of the segment from the order of its nodes; THKOFF = 1 and
/// the other automatic ones the side on which the node lies.
TEST(Tiebreak, KnowsTensionByItsSide) {
  const auto fails_below = [](const std::string& keyword, const std::string& card) {
    std::string deck = node_on_shell(keyword, card, "*LOAD_NODE_POINT\n5,3,1,-1.\n", "0.,0.\n60.,3.\n", 30);
    deck.replace(deck.find("0.5,0.5,0.05"), 12, "0.5,0.5,-.05");
    RunScene scene(deck);
    EXPECT_TRUE(scene.prepared()) << scene.message();
    if (!scene.prepared()) return false;
    scene.go();
    return scene.state().x[4].z() < -1;
  };
  EXPECT_TRUE(fails_below(automatic, "2,0.5,0.5"));
  EXPECT_FALSE(fails_below(automatic, "2,0.5,0.5,1."));
  EXPECT_TRUE(fails_below("TIEBREAK_SURFACE_TO_SURFACE", "0.5,0.5,0,1"));
  EXPECT_FALSE(fails_below("TIEBREAK_SURFACE_TO_SURFACE", "0.5,0.5"));
}

/// FS and FD of TIED_SURFACE_TO_SURFACE_FAILURE are stresses on the area: tension, shear, both; a constraint carries
/// the load itself, so that the failure comes at once. Afterwards the node is free.
TEST(TiedWithFailure, FailsByItsStresses) {
  const auto fails_at = [](double x, double z, double area) {
    constexpr double rate = 0.05;
    std::string drive = "*LOAD_NODE_POINT\n";
    if (x != 0) drive += fmt::format("5,1,1,{}\n", x);
    if (z != 0) drive += fmt::format("5,3,1,{}\n", z);
    std::string deck = node_on_shell("TIED_SURFACE_TO_SURFACE_FAILURE", "", drive, "0.,0.\n60.,3.\n", 58);
    const std::string cards = "1,1,4,3\n0.\n1.,1.\n";
    deck.replace(deck.find(cards), cards.size(), "1,1,4,3\n1.5,1.\n1.,1.\n");
    for (const std::string corner : {"\n2,1.", "\n3,1."})
      deck.replace(deck.find(corner), corner.size(), fmt::format("{}{}", corner.substr(0, 3), area));
    RunScene scene(deck);
    EXPECT_TRUE(scene.prepared()) << scene.message();
    if (!scene.prepared()) return 0.0;
    double time = 0;
    std::string said;
    scene.go([&](const solver::Run& run) {
      for (const ContactEvent& event : run.events()) said += event.text;
      if (time == 0 && !said.empty()) time = run.stepper().state().time;
    });
    if (time > 0) {
      EXPECT_GT((scene.state().x[4] - scene.run().initial().x[4]).norm(), 0.01) << "flies off";
      EXPECT_NE(said.find("1 nodes have failed: 5"), std::string::npos) << said;
    }
    return rate * time;
  };
  EXPECT_NEAR(fails_at(0, 1, 1), 1.5, 0.01);
  EXPECT_NEAR(fails_at(1, 0, 1), 1, 0.01);
  EXPECT_NEAR(fails_at(1, 1, 1), 1 / std::sqrt(1 + 1 / 2.25), 0.01);
  EXPECT_NEAR(fails_at(0, 1, 1.5), 2.25, 0.01);
  EXPECT_EQ(fails_at(0, -1, 1), 0) << "compression";
}

}  // namespace
}  // namespace gapcheck::solver::tie_strengths_test
