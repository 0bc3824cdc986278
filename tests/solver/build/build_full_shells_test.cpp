#include "solver/build/build_full_shells.hpp"

#include <gtest/gtest.h>

#include "contact/stiffness/element_timestep.hpp"
#include "contact/stiffness/node_masses.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::build_full_shells_test {
namespace {

/// A quad and a triangle of this form; all warnings in one text.
struct Deck {
  std::string text, warnings;
  Structure structure;

  explicit Deck(int elform, const std::string& more = "", const std::string& part = "1,1,1") {
    text =
        "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,2.,0.,0.\n*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,2,5,3,3\n"
        "*PART\np\n" +
        part + fmt::format("\n*SECTION_SHELL\n1,{},0.8333,3\n0.1\n", elform) + "*MAT_ELASTIC\n1,1.,1000.,0.3\n" + more;
    const model::Read read = model::read_text(text);
    EXPECT_EQ(read.errors(), 0u) << read.text();
    Diagnostics diagnostics;
    auto built = build_structure(read.model, {}, diagnostics);
    if (!built) return;
    structure = std::move(built).value();
    structure.shells.finish(5);
    for (const Diagnostic& one : diagnostics.sorted()) warnings += one.message + "\n";
  }
  [[nodiscard]] std::size_t points(std::size_t shell) const { return structure.shells.points(shell).size(); }
};

TEST(BuildFullShells, FourPointsInThePlane) {
  const Deck one(2), full(16);
  EXPECT_EQ(one.points(0), 3u);
  EXPECT_EQ(full.points(0), 12u);
  EXPECT_EQ(one.warnings, "");
  EXPECT_EQ(full.warnings, "");
  EXPECT_EQ(full.structure.state.mass, one.structure.state.mass);
  EXPECT_EQ(full.structure.state.inertia, one.structure.state.inertia);
}

TEST(BuildFullShells, EsortDecidesOnTriangles) {
  const auto sorted = [](int esort) { return Deck(16, fmt::format("*CONTROL_SHELL\n20.,{}\n", esort)); };
  EXPECT_EQ(Deck(16).points(1), 12u) << "a quad with two equal corners";
  EXPECT_EQ(sorted(0).points(1), 12u);
  EXPECT_EQ(sorted(1).points(1), 3u);
  EXPECT_EQ(sorted(1).warnings, "");
  EXPECT_FALSE(sorted(1).structure.shells.properties(1).discrete_kirchhoff);
  EXPECT_EQ(sorted(2).points(0), 12u);
  EXPECT_EQ(sorted(2).points(1), 9u) << "a DKT triangle";
  EXPECT_EQ(sorted(2).structure.shells.points_in_plane(1), 3u);
  EXPECT_EQ(sorted(2).warnings, "");
  EXPECT_EQ(Deck(2).points(1), 3u) << "one-point shells: always a C0 triangle";
}

TEST(BuildFullShells, AbsurdEsortEndsTheRun) {
  for (const int esort : {-1, 3, 99}) {
    const Failure failure = failure_of(Deck(16, fmt::format("*CONTROL_SHELL\n20.,{}\n", esort)).text);
    EXPECT_EQ(failure.kind, Failure::Kind::contradiction);
    EXPECT_EQ(
        failure.message,
        fmt::format("*CONTROL_SHELL: ESORT is {}, with which triangle 2 cannot be calculated; set 0 (quad with two "
                    "equal corners), 1 (C0 triangle) or 2 (DKT triangle)",
                    esort));
    EXPECT_GT(failure.place.line, 0u);
  }
  // Without fully integrated triangles nothing depends on it.
  EXPECT_EQ(Deck(2, "*CONTROL_SHELL\n20.,99\n").points(1), 3u);
}

// What the audit foretells does not depend on the form: masses of the nodes, and the first step.
TEST(BuildFullShells, MassesAndStepOfTheAudit) {
  for (const int esort : {0, 1}) {
    const std::string deck = Deck(16, fmt::format("*CONTROL_SHELL\n20.,{}\n", esort)).text;
    const model::Read read = model::read_text(deck);
    const contact::ElementSizes sizes = contact::element_sizes(read.model);
    StepSettings settings;
    settings.time_step_factor = 1;
    settings.bounded_step = false;
    Stepper stepper(structure_of(deck), settings);
    ASSERT_TRUE(stepper.step().ok());
    const double foretold = contact::smallest_element_timestep(read.model, sizes).timestep;
    EXPECT_NEAR(stepper.state().dt, foretold, 1e-12 * foretold) << esort;
    const std::vector<double> masses = contact::node_masses(read.model, sizes);
    for (std::size_t i = 0; i < masses.size(); ++i) EXPECT_NEAR(stepper.state().mass[i], masses[i], 1e-15) << i;
  }
}

// Corner 3 is pulled in so far that the quad is folded over there.
TEST(BuildFullShells, FoldedQuadsEndTheRun) {
  std::string deck = Deck(16).text;
  deck.replace(deck.find("3,1.,1.,0."), 10, "3,.1,.1,0.");
  const Failure failure = failure_of(deck);
  EXPECT_EQ(failure.kind, Failure::Kind::bad_element);
  EXPECT_EQ(failure.message,
            "shell 1 has no area at one of its four integration points; move its nodes until all its corners are below "
            "180 degrees, or give it ELFORM 2");
  EXPECT_EQ(failure.place.line, 8u);
}

TEST(BuildFullShells, HigherAccuracyIsNamed) {
  const Deck deck(-16);
  EXPECT_EQ(deck.points(0), 12u);
  EXPECT_EQ(deck.warnings, "section 1: ELFORM -16 is calculated as ELFORM 16\n");
}

TEST(BuildFullShells, OtherFormsAreTheNearest) {
  const Deck full(6);
  EXPECT_EQ(full.points(0), 12u);
  EXPECT_EQ(full.warnings, "section 1: ELFORM 6 is calculated as ELFORM 16\n");
  const Deck one_point(25);
  EXPECT_EQ(one_point.points(0), 3u);
  EXPECT_EQ(one_point.warnings, "section 1: ELFORM 25 is calculated as the one-point shell (ELFORM 2)\n");
}

TEST(BuildFullShells, HourglassTypeEightIsAlwaysOn) {
  EXPECT_EQ(Deck(16, "*CONTROL_HOURGLASS\n8\n").warnings, "");
  EXPECT_EQ(Deck(16, "*HOURGLASS\n4,8\n", "1,1,1,0,4").warnings, "");
  const std::string named =
      "part 1: hourglass control IHQ 4 is calculated as type 8 (full projection), as fully integrated shells have no "
      "hourglass modes\n";
  EXPECT_EQ(Deck(16, "*CONTROL_HOURGLASS\n4\n").warnings, named);
  EXPECT_EQ(Deck(16, "*HOURGLASS\n4,4\n", "1,1,1,0,4").warnings, named);
  EXPECT_EQ(Deck(16, "", "1,1,1,0,4").warnings,
            "part 1 names hourglass control 4, which is not defined; type 8 is taken\n");
}

}  // namespace
}  // namespace gapcheck::solver::build_full_shells_test
