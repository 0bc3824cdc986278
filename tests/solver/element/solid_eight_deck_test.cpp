// Decks with ELFORM 2, -1, -2 and 15, and *CONTROL_SOLID.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "solver/element/nodal_mass.hpp"
#include "solver/output/state_balance.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::solid_eight_deck_test {
namespace {

std::string section(int elform) { return fmt::format("*SECTION_SOLID\n1,{}\n", elform); }

/// Two boxes of 2 x 1 x 1: corners 1 … 8 and 11 … 18.
const std::string corners =
    "*NODE\n1,0.,0.,0.\n2,2.,0.,0.\n3,2.,1.,0.\n4,0.,1.,0.\n5,0.,0.,1.\n6,2.,0.,1.\n7,2.,1.,1.\n8,0.,1.,1.\n"
    "11,0.,0.,5.\n12,2.,0.,5.\n13,2.,1.,5.\n14,0.,1.,5.\n15,0.,0.,6.\n16,2.,0.,6.\n17,2.,1.,6.\n18,0.,1.,6.\n";
const std::string brick = "1,1,1,2,3,4,5,6,7,8\n", wedge = "2,1,11,12,13,14,15,15,18,18\n",
                  old_wedge = "2,1,11,12,13,13,15,16,17,17\n", pyramid = "3,1,11,12,13,14,15,15,15,15\n",
                  tetrahedron = "4,1,11,12,13,15,15,15,15,15\n";

std::string deck(const std::string& solids, int elform, int esort = 0) {
  return corners + "*ELEMENT_SOLID\n" + solids + elastic_deck(section(elform), 1000, 0.3, 6) +
         fmt::format("*CONTROL_SOLID\n{}\n", esort);
}

std::vector<std::string> warnings_of(const std::string& text) {
  const model::Read read = model::read_text(text);
  EXPECT_EQ(read.errors(), 0u) << read.text();
  Diagnostics diagnostics;
  EXPECT_TRUE(build_structure(read.model, {}, diagnostics)) << text;
  std::vector<std::string> messages;
  for (const Diagnostic& one : diagnostics.sorted()) messages.push_back(one.message);
  return messages;
}

TEST(SolidEightDeck, PointsAndMassesByShape) {
  struct Case {
    std::string solids;
    int elform, esort;
    std::size_t points;
    double mass_of_ridge, mass_of_base;  ///< nodes 15 and 11, of ρ V = 6 · volume
  };
  const double brick_share = 6 * 2 / 8.0;
  for (const Case& one : {
           Case{"1,1,11,12,13,14,15,16,17,18\n", 2, 0, 8, brick_share, brick_share},
           Case{"1,1,11,12,13,14,15,16,17,18\n", -1, 1, 8, brick_share, brick_share},
           Case{"1,1,11,12,13,14,15,16,17,18\n", -2, 0, 8, brick_share, brick_share},
           Case{"1,1,11,12,13,14,15,16,17,18\n", 1, 1, 1, brick_share, brick_share},
           Case{wedge, 2, 0, 8, 6.0 / 4, 6.0 / 8},
           Case{wedge, 2, 1, 8, 1, 1},
           Case{wedge, -2, 4, 8, 1, 1},
           Case{wedge, -1, 0, 8, 6.0 / 4, 6.0 / 8},
           Case{wedge, 15, 0, 8, 1, 1},
           Case{old_wedge, 15, 0, 8, 1, 1},
           Case{wedge, 1, 1, 8, 1, 1},
           Case{wedge, 1, 13, 8, 1, 1},
           Case{wedge, 1, 2, 1, 6.0 / 4, 6.0 / 8},
           Case{wedge, 1, 0, 1, 6.0 / 4, 6.0 / 8},
           Case{pyramid, 2, 1, 8, 6 * 2 / 3.0 / 2, 6 * 2 / 3.0 / 8},
           Case{tetrahedron, 2, 0, 1, 0.5, 0.5},
           Case{tetrahedron, 15, 1, 1, 0.5, 0.5},
           Case{tetrahedron, 10, 0, 1, 0.5, 0.5},
       }) {
    const std::string text = deck(one.solids, one.elform, one.esort);
    const Structure structure = structure_of(text);
    ASSERT_EQ(structure.solids.size(), 1u);
    EXPECT_EQ(structure.solids.properties(0).rules.brick, solid_rules(one.elform, one.esort).brick);
    Stepper stepper(structure, {});
    EXPECT_EQ(stepper.structure().solids.points(0).size(), one.points) << text;
    EXPECT_NEAR(structure.state.mass[12], one.mass_of_ridge, 1e-12) << text;
    EXPECT_NEAR(structure.state.mass[8], one.mass_of_base, 1e-12) << text;
    const std::vector<double> masses = nodal_masses(model::read_text(text).model, {true});
    for (std::size_t i = 0; i < masses.size(); ++i) EXPECT_NEAR(masses[i], structure.state.mass[i], 1e-12) << text << i;
  }
}

TEST(SolidEightDeck, WarningsNameWhatIsCalculatedOtherwise) {
  EXPECT_TRUE(warnings_of(deck(brick, 2)).empty());
  EXPECT_TRUE(warnings_of(deck(brick + wedge, -2, 1)).empty());
  EXPECT_TRUE(warnings_of(deck(brick + wedge, 1)).empty());
  EXPECT_TRUE(warnings_of(deck(brick + tetrahedron, 2, 1)).empty());
  EXPECT_TRUE(warnings_of(deck(tetrahedron, 10)).empty());
  EXPECT_TRUE(warnings_of(deck(brick, 2) + "*CONTROL_HOURGLASS\n6,0.1\n").empty());
  EXPECT_EQ(warnings_of(deck(brick, 1) + "*CONTROL_HOURGLASS\n8,0.1\n").size(), 1u);
  const auto only = [](const std::string& text, const std::string& part) {
    const std::vector<std::string> found = warnings_of(text);
    ASSERT_EQ(found.size(), 1u) << text;
    EXPECT_NE(found[0].find(part), std::string::npos) << found[0];
  };
  only(deck(brick + tetrahedron, -1), "1 tetrahedra are calculated as ELFORM 10, as with ESORT = 1");
  only(deck(brick + wedge, 1, 2), "1 wedges are calculated as one-point bricks, not as ELFORM 115");
  only(deck(brick + tetrahedron, 10), "1 solids are no tetrahedra");
  only(deck(brick, 3), "ELFORM 3 is calculated as ELFORM 2");
}

TEST(SolidEightDeck, ContradictionsAreRefused) {
  const auto refused = [](const std::string& text, const std::string& part, std::uint32_t line) {
    const Failure failure = failure_of(text);
    EXPECT_NE(failure.message.find(part), std::string::npos) << failure.message;
    EXPECT_EQ(failure.place.line, line) << failure.message;
  };
  refused(deck(wedge + brick, 15), "solid 1 is not a wedge, but ELFORM 15 of its section 1 is for wedges", 20);
  refused(deck(pyramid, 15), "solid 3 is not a wedge", 19);
  refused(deck(brick, 2, 7), "ESORT of *CONTROL_SOLID is 7; set 0 to 4 or 11 to 14", 28);
  refused(deck(brick, 2, -1), "ESORT of *CONTROL_SOLID is -1", 28);
  const std::string rubber = "*PART\np\n1,1,1\n" + section(-2) + "*MAT_MOONEY-RIVLIN_RUBBER\n1,1e-6,0.49,1.,0.5\n";
  refused(corners + "*ELEMENT_SOLID\n" + brick + rubber, "ELFORM -2 is not calculated with rubber", 24);
  // Turned inside out, and with one corner pushed through the opposite side: bad at a point, not as a whole.
  refused(deck("1,1,5,6,7,8,1,2,3,4\n", 2), "solid 1 has the volume", 19);
  std::string pushed = deck(brick, 2);
  pushed.replace(pushed.find("7,2.,1.,1."), 10, "7,.1,.1,.1");
  refused(pushed, "solid 1 has the volume -", 19);
  EXPECT_NE(failure_of(pushed).message.find("by the least of its eight points; mend"), std::string::npos);
}

TEST(SolidEightDeck, AbsurdFormulationsBuildOrSayWhy) {
  for (const std::string value : {"-2", "-1", "2", "15", "0", "-18", "99999999", "1e30", "x", ""}) {
    const model::Read read =
        model::read_text(corners + "*ELEMENT_SOLID\n" + brick + "*PART\np\n1,1,1\n*SECTION_SOLID\n1," + value +
                         "\n*MAT_ELASTIC\n1,1.,1000.,0.3\n*CONTROL_SOLID\n" + value + "\n");
    if (read.errors() > 0) continue;
    Diagnostics diagnostics;
    const auto built = build_structure(read.model, {}, diagnostics);
    EXPECT_TRUE(built || !built.error().message.empty());
  }
}

/// n³ bricks of side 5 and 5 x 5 x 1 about the origin, in mm, ms, kg; of wedges twice as many.
std::string block(int n, int elform, bool wedges = false) {
  std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n";
  const auto id = [&](int i, int j, int k) { return 1 + i + (n + 1) * (j + (n + 1) * k); };
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        nodes += fmt::format("{},{},{},{}\n", id(i, j, k), 5 * i - 2.5 * n + 0.4 * ((7 * i + 3 * j + k) % 5 - 2),
                             5 * j - 2.5 * n + 0.4 * ((3 * i + 11 * j + 2 * k) % 5 - 2), 1.5 * k - 0.75 * n);
  int element = 0;
  const auto add = [&](std::array<int, 8> c) {
    solids += fmt::format("{},1,{},{},{},{},{},{},{},{}\n", ++element, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]);
  };
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = id(i, j, k), b = id(i + 1, j, k), c = id(i + 1, j + 1, k), d = id(i, j + 1, k);
        const int e = id(i, j, k + 1), f = id(i + 1, j, k + 1), g = id(i + 1, j + 1, k + 1), h = id(i, j + 1, k + 1);
        if (!wedges) add({a, b, c, d, e, f, g, h});
        if (wedges) add({a, b, c, c, e, f, g, g});
        if (wedges) add({c, d, a, a, g, h, e, e});
      }
  return nodes + solids + fmt::format("*PART\nblock\n1,1,1\n*SECTION_SOLID\n1,{}\n", elform) +
         "*MAT_ELASTIC\n1,7.85e-6,210.,0.3\n";
}

struct Course {
  double least = 1e300, greatest = 0, hourglass = 0, created = 0;
};

Course calculate(const std::string& text, std::uint64_t cycles) {
  RunSettings settings;
  settings.cycles = cycles;
  settings.step.energy_tolerance = 0;
  RunScene scene(text + "*CONTROL_TERMINATION\n1e9\n", settings);
  EXPECT_TRUE(scene.prepared()) << scene.message();
  Course course;
  if (!scene.prepared()) return course;
  scene.go([&](const Run& run) {
    const Energies& e = run.stepper().energies();
    const double sum = (e.printed_kinetic + e.internal) / e.printed_initial;
    course.least = std::min(course.least, sum);
    course.greatest = std::max(course.greatest, sum);
    course.hourglass = std::max(course.hourglass, std::abs(e.hourglass));
  });
  const StateBalance balance = state_balance(scene.run());
  course.created = balance.created() / balance.largest;
  return course;
}

// Turning and vibrating freely for 10,000 cycles: no energy comes or goes, none is hourglass energy.
TEST(SolidEightDeck, FreeBlocksKeepTheirEnergy) {
  const std::string spin = "*INITIAL_VELOCITY_GENERATION\n1,2,10.,0.,0.,0.\n0.,0.,0.,1.,2.,3.\n";
  std::string shake = "*INITIAL_VELOCITY_NODE\n";
  for (int node = 1; node <= 27; ++node)
    shake += fmt::format("{},{:.4f},{:.4f},{:.4f}\n", node, 2 * std::sin(12.9898 * node), 2 * std::sin(78.233 * node),
                         2 * std::sin(37.719 * node));
  for (const int elform : {2, -1, -2, 15})
    for (const bool spins : {true, false})
      for (const bool viscous : {true, false}) {
        if (viscous && spins) continue;
        const std::string text = block(2, elform, elform == 15) + (spins ? spin : shake) +
                                 (viscous ? "" : "*CONTROL_BULK_VISCOSITY\n1e-30,1e-30\n");
        const Course course = calculate(text, 10000);
        const std::string name = fmt::format("elform_{}_{}{}", elform, spins ? "spin" : "shake", viscous ? "_q" : "");
        RecordProperty(name, fmt::format("{:.6f} {:.6f} {:.2e}", course.least, course.greatest, course.created));
        EXPECT_NEAR(course.least, 1, 5e-3) << name;
        EXPECT_NEAR(course.greatest, 1, 5e-3) << name;
        EXPECT_NEAR(course.created, 0, 1e-3) << name;
        EXPECT_EQ(course.hourglass, 0) << name;
      }
}

// The step is the manual's L / c times TSSFAC or the bound, whichever is less.
TEST(SolidEightDeck, StepOfEightPoints) {
  const double c = std::sqrt(1000 * 0.7 / (1.3 * 0.4) / 6);
  for (const int elform : {2, -1, -2}) {
    StepSettings settings;
    settings.time_step_factor = 0.1;
    Stepper stepper(structure_of(deck(brick, elform)), settings);
    ASSERT_TRUE(stepper.begin_step().ok());
    EXPECT_NEAR(stepper.next_step(), 0.1 * (2.0 / 2) / c, 1e-12) << elform;
  }
}

}  // namespace
}  // namespace gapcheck::solver::solid_eight_deck_test
