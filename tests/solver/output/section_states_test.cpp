#include "solver/output/section_states.hpp"

#include <cmath>

#include "solver/output/run_record.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::section_states_test {
namespace {

constexpr double young = 1000, density = 2;
const std::string end = "*CONTROL_TERMINATION\n0.05\n*DATABASE_SECFORC\n0.01\n";

RunSettings one_cycle() {
  RunSettings settings;
  settings.cycles = 1;
  settings.step.greatest_step = 1e-4;
  return settings;
}

/// The sections of a deck before anything has moved.
std::vector<results::SectionState> at_start(const std::string& deck) {
  RunScene scene(deck + end, one_cycle());
  std::vector<results::SectionState> states;
  EXPECT_TRUE(scene.prepared()) << scene.message();
  if (!scene.prepared()) return states;
  scene.go([&](const solver::Run& run) {
    if (states.empty())
      states = section_states(run, ElementPlaces(run.model(), run.stepper().structure()), section_cuts(run.model()));
  });
  return states;
}

std::string plane(double x, int direction, const std::string& more = "") {
  return fmt::format("*DATABASE_CROSS_SECTION_PLANE_ID\n7,cut\n0,{},0.,0.,{},0.,0.,0.\n{}\n", x, x + direction, more);
}

std::string solid_stress(int solid, double sxx, double sxy) {
  return fmt::format("*INITIAL_STRESS_SOLID\n{},1\n{},0.,0.,{},0.,0.,0.\n", solid, sxx, sxy);
}

void expect_near(const Vector& found, const Vector& wanted) { EXPECT_NEAR((found - wanted).norm(), 0, 1e-12); }

// A uniform stress: σ A along the normal, τ A across it, no moment about the middle of the section, wherever the plane
// cuts the bricks. The other direction of the normal counts the nodes of the other side.
TEST(Sections, PulledAndShearedBar) {
  const std::string bar = brick_bar(3, {1, 0.5, 0.25}) + elastic_deck(solid_section, young, 0.3, density) +
                          solid_stress(1, 8, 2) + solid_stress(2, 8, 2) + solid_stress(3, 8, 2);
  const double area = 0.5 * 0.25;
  const auto states = at_start(bar + plane(1.5, 1) + plane(1.25, -1));
  ASSERT_EQ(states.size(), 2u);
  EXPECT_EQ(states[0].section, 7);
  expect_near(states[0].force, area * Vector(8, 2, 0));
  expect_near(states[0].centroid, {1.5, 0.25, 0.125});
  expect_near(states[0].moment, Vector::Zero());
  EXPECT_NEAR(states[0].area, area, 1e-14);
  expect_near(states[1].force, -area * Vector(8, 2, 0));
  expect_near(states[1].centroid, {1.25, 0.25, 0.125});
  EXPECT_NEAR(states[1].area, area, 1e-14);
}

// The same from sets: the nodes of one station and the brick in front of them. A plane through nodes cuts what is in
// front of it only, and so does one that ends in the bar's corner.
TEST(Sections, SetsAndPlanesThroughNodes) {
  const std::string bar = brick_bar(3, {1, 0.5, 0.25}) + elastic_deck(solid_section, young, 0.3, density) +
                          solid_stress(2, 8, 0) + solid_stress(3, 5, 0);
  const std::string sets = "*SET_NODE_LIST\n4\n2,6,10,14\n*SET_SOLID\n5\n2\n*DATABASE_CROSS_SECTION_SET\n4,5\n";
  const auto states = at_start(bar + sets + plane(1, 1) + plane(2, 1, "2.,1.,0.,0.6,0.3"));
  ASSERT_EQ(states.size(), 3u);
  for (const auto& [at, stress, x] : {std::tuple(0, 8., 1.), {1, 8., 1.}, {2, 5., 2.}}) {
    const results::SectionState& state = states[static_cast<std::size_t>(at)];
    expect_near(state.force, 0.125 * Vector(stress, 0, 0));
    expect_near(state.centroid, {x, 0.25, 0.125});
    EXPECT_NEAR(state.area, 0.125, 1e-14);
  }
}

// Two bricks across the section with opposite stresses: no force, and the moment σ a h of a couple.
TEST(Sections, Couple) {
  const std::string block =
      grid_nodes(1, 2, 1, {1, 0.5, 0.25}) + "*ELEMENT_SOLID\n1,1,1,2,4,3,7,8,10,9\n2,1,3,4,6,5,9,10,12,11\n" +
      elastic_deck(solid_section, young, 0.3, density) + solid_stress(1, -8, 0) + solid_stress(2, 8, 0);
  const auto states = at_start(block + plane(0.5, 1));
  ASSERT_EQ(states.size(), 1u);
  expect_near(states[0].force, Vector::Zero());
  expect_near(states[0].moment, {0, 0, -8 * 0.125 * 0.5});
  EXPECT_NEAR(states[0].area, 0.25, 1e-14);
}

// A strip of shells: membrane force σ t w, and the bending moment ∫ σ z dA, of two Gauss points.
TEST(Sections, ShellStrip) {
  const double thick = 0.1, width = 0.5, low = 3, high = 7;
  std::string strip = plate(3, 1, {1, width, 1}) + elastic_deck(shell_section, young, 0.3, density);
  for (int i = 1; i <= 3; ++i)
    strip += fmt::format(
        "*INITIAL_STRESS_SHELL\n{},1,2\n-0.57735027,{},0.,0.,0.,0.,0.,0.\n0.57735027,{},0.,0.,0.,0.,0.,0."
        "\n",
        i, low, high);
  const auto states = at_start(strip + plane(1.5, 1));
  ASSERT_EQ(states.size(), 1u);
  expect_near(states[0].force, {(low + high) / 2 * thick * width, 0, 0});
  EXPECT_NEAR(states[0].moment.y(), (high - low) * thick * thick / (4 * std::sqrt(3)) * width, 1e-12);
  expect_near(states[0].centroid, {1.5, width / 2, 0});
  EXPECT_NEAR(states[0].area, thick * width, 1e-14);
}

// While a wave runs through a bar, the section's force is what accelerates the part behind it, whose other end is
// free; the truss beside it adds its tension.
TEST(Sections, ForceIsTheRateOfMomentum) {
  RunSettings settings;
  settings.step.greatest_step = 1e-4;
  RunScene scene(brick_bar(6, {0.2, 0.5, 0.25}) + elastic_deck(solid_section, young, 0.3, density) +
                     "*NODE\n101,0.,2.,0.\n102,1.,2.,0.\n*ELEMENT_BEAM\n50,2,101,102\n*PART\nt\n2,2,1\n"
                     "*SECTION_BEAM\n2,3\n0.1\n*SET_NODE_LIST\n3\n7,14,21,28\n*DEFINE_CURVE\n1\n0.,0.\n0.02,3.\n1.,3.\n"
                     "*LOAD_NODE_SET\n3,1,1,1.\n3,2,1,0.5\n*LOAD_NODE_POINT\n102,1,1,2.\n" +
                     plane(0.7, 1) + end,
                 settings);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const std::vector<CutSection> cuts = section_cuts(scene.read().model);
  const ElementPlaces places(scene.read().model, scene.run().stepper().structure());
  Vector momentum = Vector::Zero();
  double most = 0, worst = 0;
  scene.go([&](const solver::Run& run) {
    const State& state = run.stepper().state();
    Vector now = Vector::Zero();
    for (std::size_t i = 0; i < state.x.size(); ++i)
      if (scene.read().model.mesh.nodes.x[i].x() <= 0.7) now += state.mass[i] * state.v[i];
    const Vector force = section_state(run, places, cuts[0]).force;
    const Vector wanted = (now - momentum) / ((state.dt + run.stepper().next_step()) / 2);
    worst = std::max(worst, (force - wanted).norm());
    most = std::max(most, force.norm());
    momentum = now;
  });
  EXPECT_GT(most, 5);
  EXPECT_LT(worst, 1e-9 * most);
}

// What cannot be calculated is named, and the rest is.
TEST(Sections, HostileOnesAreNamed) {
  std::string deck = brick_bar(1, {1, 1, 1}) + elastic_deck(solid_section, young, 0.3, density) + end;
  deck +=
      "*DATABASE_CROSS_SECTION_PLANE_ID\n1\n99,0.5,0.,0.,1.,0.,0.\n\n2\n0,0.5,0.,0.,0.5,0.,0.\n\n3\n0,9.,0.,0.,10.,0.,"
      "0.\n\n4\n0,0.5,0.,0.,1.,0.,0.\n,,,,,8,1\n5\n0,0.5,0.,0.,1.,0.,0.,-1.\n\n6\n0,0.5,0.,0.,1.,0.,0.\n\n"
      "*DATABASE_CROSS_SECTION_SET_ID\n7\n98,1\n8\n98\n9\n97\n*SET_NODE_LIST\n98\n1,2\n";
  const model::Read read = model::read_text(deck);
  std::string text;
  for (const model::Output::Note& note : output_notes(read.model)) text += note.text + "\n";
  for (const char* words :
       {"section 1 is not in secforc: part set 99", "section 2 is not in secforc: the normal",
        "section 3 is not in secforc: it has no deformable elements", "section 4 is not in secforc: its local",
        "section 5 is not in secforc: RADIUS", "section 7 is not in secforc: its set of elements 1 (HSID)",
        "section 8 is not in secforc: it has no", "section 9 is not in secforc: node set 97"})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  EXPECT_EQ(text.find("section 6"), std::string::npos);
  ASSERT_EQ(section_cuts(read.model).size(), 9u);
  EXPECT_FALSE(section_cuts(read.model)[5].empty());
}

TEST(Sections, ThousandsOfThemAreNamedOnce) {
  std::string deck = brick_bar(1, {1, 1, 1}) + elastic_deck(solid_section, young, 0.3, density) + end +
                     "*DATABASE_CROSS_SECTION_PLANE\n";
  for (int i = 0; i < 3000; ++i) deck += "0,9.,0.,0.,10.,0.,0.\n\n";
  const std::vector<model::Output::Note> notes = output_notes(model::read_text(deck).model);
  ASSERT_EQ(notes.size(), 21u);
  EXPECT_NE(notes.back().text.find("2980 more cross-sections"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::solver::section_states_test
