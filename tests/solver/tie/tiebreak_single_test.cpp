// Tiebreaks of a single surface: their twin is the tiebreak of two surfaces beside a contact of the single surface.
#include <gtest/gtest.h>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::tiebreak_single_test {
namespace {

/// A shell of 1 by 1 (part 2, nodes 5 to 8) that touches the middle of a held one of 3 by 3; curve 1 drives node loads.
std::string patch_on_plate(const std::string& contacts, const std::string& curve, const std::string& loads, double end,
                           int upper_part = 2) {
  std::string deck =
      "*NODE\n1,0.,0.,0.\n2,3.,0.,0.\n3,3.,3.,0.\n4,0.,3.,0.\n5,1.,1.,0.1\n6,2.,1.,0.1\n7,2.,2.,0.1\n8,1.,2.,0.1\n"
      "*PART\np\n1,1,1\n*PART\nq\n2,1,1\n*SECTION_SHELL\n1,2\n0.1\n*MAT_ELASTIC\n1,10.,1000.,0.25\n"
      "*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n2,0,1,1,1,1,1,1\n3,0,1,1,1,1,1,1\n4,0,1,1,1,1,1,1\n";
  deck += fmt::format("*ELEMENT_SHELL\n1,1,1,2,3,4\n2,{},5,6,7,8\n", upper_part);
  return deck + contacts + "*DEFINE_CURVE\n1\n" + curve + loads + fmt::format("*CONTROL_TERMINATION\n{}\n", end);
}

const std::string all_parts = "\n0,0,5\n\n\n", two_parts = "\n2,1,3,3\n\n\n";
const std::string single_contact = "*CONTACT_AUTOMATIC_SINGLE_SURFACE" + all_parts;

struct Course {
  std::vector<Vector> x;  ///< of the upper nodes, step by step
  std::vector<std::uint64_t> failures;
  double lost = 0;
};

/// Until the upper plate has moved by 1.
Course course(const std::string& deck) {
  bool far = false;
  RunSettings settings;
  settings.stop = [&far] { return far; };
  RunScene scene(deck, settings);
  Course course;
  if (!scene.prepared()) {
    ADD_FAILURE() << scene.message();
    return course;
  }
  scene.go([&](const solver::Run& run) {
    const State& state = run.stepper().state();
    for (std::size_t i = 4; i < 8; ++i) {
      course.x.push_back(state.x[i]);
      far = far || (state.x[i] - run.initial().x[i]).norm() > 1;
    }
    for (std::size_t i = 0; i < run.events().size(); ++i) course.failures.push_back(state.cycle);
  });
  course.lost = scene.energies().absorbed.sliding();
  return course;
}

/// Loads of all four nodes in the direction of an axis (1 to 3); that of the first one is `uneven` times the others'.
std::string load(int axis, double uneven) {
  std::string cards = "*LOAD_NODE_POINT\n";
  for (int node = 5; node <= 8; ++node) cards += fmt::format("{},{},1,{}\n", node, axis, node == 5 ? uneven : 1.0);
  return cards;
}

// Each option as between the two parts, to the failure and beyond: the plate is pulled off and does not come back.
TEST(TiebreakOfOneSurface, IsThatOfTwoSurfaces) {
  for (const char* card :
       {"2,1.2,0.8", "-2,1.2,0.8", "4,1.2", "5,1.2,0.8,7", "6,1.2,0.8,0.05", "7,1.2,0.8,0.,0.03,0.03", "8,1.2,0.8,0.05",
        "9,1.2,0.8,1.,0.03,0.03,30.", "11,1.2,0.8,-2.,0.03,0.04,30."})
    for (const int axis : {1, 3}) {
      const std::string card_4 = std::string(card) + "\n*DEFINE_CURVE\n7\n0.,1.\n0.1,0.5\n0.2,0.\n";
      const std::string curve = "0.,0.\n60.,0.6\n", loads = load(axis, 1.3) + load(3, 0.2);
      const Course one = course(patch_on_plate("*CONTACT_AUTOMATIC_SINGLE_SURFACE_TIEBREAK" + all_parts + card_4, curve,
                                               loads, 60)),
                   two = course(patch_on_plate(
                       "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK" + two_parts + card_4 + single_contact, curve,
                       loads, 60));
      ASSERT_EQ(one.x.size(), two.x.size()) << card;
      const bool slides = card[0] == '4' && axis == 1;  // beyond the end of the run
      EXPECT_EQ(one.failures.empty(), slides) << card << axis;
      EXPECT_EQ(one.failures, two.failures) << card << axis;
      double largest = 0;
      for (std::size_t i = 0; i < one.x.size(); ++i) largest = std::max(largest, (one.x[i] - two.x[i]).norm());
      EXPECT_EQ(largest, 0) << card << axis;
      EXPECT_EQ(one.lost, two.lost) << card << axis;
    }
}

// The failed plate comes back and meets the other one as in an ordinary contact of one surface: the older tiebreak that
// leaves no contact behind has the same criterion.
TEST(TiebreakOfOneSurface, BecomesAContactOfOneSurface) {
  const std::string curve = "0.,0.\n18.1,0.3033\n18.2,-0.15\n200.,-0.15\n", loads = load(3, 1);
  const Course one = course(
      patch_on_plate("*CONTACT_AUTOMATIC_SINGLE_SURFACE_TIEBREAK" + all_parts + "2,1.2,0.8\n", curve, loads, 30));
  const Course two = course(patch_on_plate(
      "*CONTACT_TIEBREAK_SURFACE_TO_SURFACE_ONLY" + two_parts + "1.2,0.8\n" + single_contact, curve, loads, 30));
  ASSERT_EQ(one.x.size(), two.x.size());
  EXPECT_EQ(one.failures, two.failures);
  EXPECT_EQ(one.failures.size(), 1u);
  double largest = 0, highest = 0, lowest = 1;
  for (std::size_t i = 0; i < one.x.size(); ++i) {
    largest = std::max(largest, (one.x[i] - two.x[i]).norm());
    highest = std::max(highest, one.x[i].z());
    if (highest > 0.12) lowest = std::min(lowest, one.x[i].z());
  }
  EXPECT_EQ(largest, 0);
  EXPECT_GT(highest, 0.12) << "it flies off";
  EXPECT_LT(lowest, 0.1) << "it comes back";
  EXPECT_GT(lowest, 0.02) << "and is held";
}

// The force of one node at its failure: the stress on its quarter of the plate.
TEST(TiebreakOfOneSurface, StrengthIsAStressOnTheNodesArea) {
  RunScene scene(patch_on_plate("*CONTACT_AUTOMATIC_SINGLE_SURFACE_TIEBREAK" + all_parts + "2,1.2,0.8\n",
                                "0.,0.\n200.,1.\n", load(3, 1), 120));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double failed = 0;
  scene.go([&](const solver::Run& run) {
    if (failed == 0 && !run.events().empty()) failed = run.stepper().state().time;
  });
  EXPECT_NEAR(failed / 200, 1.2 / 4, 0.01);
}

TEST(TiebreakOfOneSurface, BothFacesAreRefused) {
  const auto message = [](const std::string& card, int upper_part, const std::string& more = "") {
    RunScene scene(
        patch_on_plate("*CONTACT_AUTOMATIC_SINGLE_SURFACE_TIEBREAK_ID\n31\n" + all_parts.substr(1) + card + "\n" + more,
                       "0.,0.\n1.,0.\n", load(3, 1), 0.1, upper_part));
    if (!scene.status().ok()) {
      const bool faces = scene.message().find("published") != std::string::npos;
      EXPECT_EQ(scene.status().error().kind, faces ? Failure::Kind::not_calculated : Failure::Kind::contradiction);
      EXPECT_GT(scene.status().error().place.line, 0u);
    }
    return scene.message();
  };
  EXPECT_EQ(message("2,1.,1.", 2), "");
  EXPECT_NE(message("2,1.,1.", 1)
                .find("contact 31 (*CONTACT_AUTOMATIC_SINGLE_SURFACE_TIEBREAK_ID): node 5 of part 1 is "
                      "tied to its own part"),
            std::string::npos)
      << message("2,1.,1.", 1);
  EXPECT_EQ(message("1", 1), "");
  // A third plate below the middle of the first one, whose corner nodes the large plate's middle would tie to.
  const std::string under =
      "*NODE\n11,-1.,-1.,-0.1\n12,1.,-1.,-0.1\n13,1.,1.,-0.1\n14,-1.,1.,-0.1\n*PART\nr\n3,1,1\n"
      "*ELEMENT_SHELL\n3,3,11,12,13,14\n";
  const std::string both = message("6,1.,1.,0.1", 2, under);
  EXPECT_NE(both.find("node 1 of part 1 is tied to part 3, and node 13 of that one to part 1"), std::string::npos)
      << both;
  EXPECT_NE(both.find("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK"), std::string::npos) << both;
  EXPECT_EQ(message("-1", 2, under), "");
  EXPECT_NE(message("2,-1.,1.", 2).find("0 or more"), std::string::npos);
  EXPECT_NE(message("5,1.,1.,78", 2).find("no curve 78"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::solver::tiebreak_single_test
