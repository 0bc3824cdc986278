// The statements of docs/workshop/, on the decks of data/workshop/. What is expected are closed forms of the contact
// rules, sections 5 to 7.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "model/read.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver::workshop_test {
namespace {

// As in scripts/make_workshop.py: mm, ms, kg.
constexpr double density = 7.85e-6, young = 210, poisson = 0.3;
const double bulk = young / (3 * (1 - 2 * poisson));
constexpr double slsfac = 0.1;
/// Square shell segment: 0.1 K A / d.
double shell_stiffness(double size, double modulus = bulk) { return slsfac * modulus * size / std::sqrt(2.0); }
/// Facet of a brick: 0.1 K A² / V.
double solid_stiffness(double area, double volume) { return slsfac * bulk * area * area / volume; }

// The thrown shell: four equal nodes, each a mass on its spring against what does not move.
const double node_mass = 0.003 + density * 25 / 4;
constexpr int thrown_nodes = 4;
const double stiffness = shell_stiffness(5), frequency = std::sqrt(stiffness / node_mass);

struct Sample {
  double time = 0, step = 0;
  double height = 0, speed = 0;  ///< of the first node that is thrown or pushed, along z
  double force = 0;              ///< of the contact on the upper body, along z
  double energy = 0;             ///< of the contact
  std::uint64_t touching = 0, released = 0;
};

class Recorder : public Run::Observer {
 public:
  [[nodiscard]] SolverStatus observe(const Run& run, std::optional<RunEnd>) override {
    constexpr std::int64_t first_upper = 2001;
    const State& state = run.stepper().state();
    const auto& ids = run.model().mesh.nodes.id;
    const auto place = static_cast<std::size_t>(std::find(ids.begin(), ids.end(), first_upper) - ids.begin());
    const ContactState& contact = run.contacts()[0].state();
    Sample sample{state.time, run.stepper().next_step(),           state.x.at(place).z(), state.v[place].z(),
                  0,          contact.energy_a + contact.energy_b, contact.touching,      contact.released};
    for (const ContactNode& node : run.contacts()[0].nodes())
      sample.force += ids[node.node.value] >= first_upper ? node.force.z() : -node.force.z();
    samples.push_back(sample);
    return {};
  }
  std::vector<Sample> samples;
};

struct Course {
  std::vector<Sample> samples;
  contact::InitialState initial;
  double energy_ratio = 0;
  [[nodiscard]] const Sample& last() const { return samples.back(); }
  [[nodiscard]] double lowest() const {
    double least = samples[0].height;
    for (const Sample& sample : samples) least = std::min(least, sample.height);
    return least;
  }
  [[nodiscard]] std::uint64_t most_released() const {
    std::uint64_t most = 0;
    for (const Sample& sample : samples) most = std::max(most, sample.released);
    return most;
  }
};

Course calculate(const std::string& name) {
  std::ifstream file(fmt::format("{}/data/workshop/{}.k", GAPCHECK_ROOT, name));
  EXPECT_TRUE(file) << name;
  const model::Read read = model::read_text({std::istreambuf_iterator<char>(file), {}});
  EXPECT_EQ(read.text(), "") << name;
  contact::SurfaceStore surfaces(read.model);
  Diagnostics diagnostics;
  auto prepared = Run::prepare(read.model, surfaces, {}, diagnostics);
  EXPECT_TRUE(diagnostics.sorted().empty()) << name;
  if (!prepared) {
    ADD_FAILURE() << name << ": " << prepared.error().message;
    return {{Sample{}}, {}, 0};
  }
  Run& run = prepared.value();
  Recorder recorder;
  EXPECT_EQ(run.go(recorder), RunEnd::time) << name;
  return {recorder.samples, run.initial(), run.stepper().energies().ratio()};
}

/// Half a period of central differences misses v and v / ω by less than this: 1 / cos(α / 2) with 2 sin(α / 2) = ω dt,
/// and ω dt <= 0.224.
constexpr double share = 0.0065;

// Rebound -----------------------------------------------------------------------------------------------------------

constexpr double thrown = 20;  // speed

// Twice the contact thickness, half of it: the shell turns round v / ω inside the contact distance, and leaves as
// fast as it came.
TEST(Workshop, ContactThicknessMovesTheTurningPoint) {
  const double depth = thrown / frequency;
  for (const auto& [name, distance] :
       {std::pair{"rebound_reference", 1.0}, {"rebound_double", 2.0}, {"rebound_half", 0.5}}) {
    const Course course = calculate(name);
    EXPECT_NEAR(distance - course.lowest(), depth, share * depth) << name;
    EXPECT_NEAR(course.last().speed, thrown, share * thrown) << name;
    EXPECT_EQ(course.most_released(), 0u) << name;
    EXPECT_NEAR(course.energy_ratio, 1, 1e-9) << name;
  }
}

/// The speed behind a contact that let go at `depth`: the force starts and ends with a step, so the depth over which it
/// acts differs by up to the length of one.
void expect_passed(const std::string& name, double distance, double depth, double spring) {
  const Course course = calculate(name);
  EXPECT_EQ(course.most_released(), static_cast<std::uint64_t>(thrown_nodes)) << name;
  EXPECT_LT(course.last().height, -distance) << name << ": on the other side";
  const double squared_frequency = spring / node_mass;
  const auto speed = [&](double d) { return std::sqrt(thrown * thrown - squared_frequency * d * d); };
  EXPECT_GE(-course.last().speed, (1 - share) * speed(depth + thrown * course.samples[0].step)) << name;
  EXPECT_LE(-course.last().speed, (1 + share) * speed(depth - thrown * course.samples[0].step)) << name;
  // What the springs held is lost.
  const double lost = thrown_nodes * node_mass * (thrown * thrown - course.last().speed * course.last().speed) / 2;
  EXPECT_NEAR(course.last().energy, lost, 1e-6 * lost) << name;
}

// 0.4 (0.15 + 0.15) is less than v / ω.
TEST(Workshop, TooThinContactLetsTheShellThrough) {
  ASSERT_GT(thrown / frequency, 0.12);
  expect_passed("rebound_thin", 0.15, 0.12, stiffness);
}

// SOFT = 0: the weaker segment decides. It would take v / ω = 0.99 to stop the shell, and 0.4 (1 + 1) is all there is.
TEST(Workshop, Soft0LetsTheShellThroughASoftPlate) {
  const double weak = shell_stiffness(10, bulk / 100);
  ASSERT_LT(weak, stiffness);
  ASSERT_GT(thrown / std::sqrt(weak / node_mass), 0.8);
  expect_passed("rebound_soft_plate", 1, 0.8, weak);
}

// SOFT = 1: k = 0.1 · 0.5 m / Δt², so v / ω = v Δt √20 whatever the moduli are, Δt the manual's step of the thrown
// shell. The segment's nodes weigh more than the thrown one.
TEST(Workshop, Soft1StopsTheShell) {
  ASSERT_GT(4 * density * 100, node_mass) << "the corners of the middle segment, each with the mass of one element";
  const Course course = calculate("rebound_soft_plate_soft_1");
  const double manual_step = 0.9 * 5 / std::sqrt(young / (density * (1 - poisson * poisson)));
  ASSERT_GT(manual_step, 1.03 * course.samples[0].step) << "the run's own step is shorter";
  const double depth = thrown * manual_step * std::sqrt(20.0);
  EXPECT_NEAR(1 - course.lowest(), depth, share * depth);
  EXPECT_NEAR(course.last().speed, thrown, share * thrown);
  EXPECT_EQ(course.most_released(), 0u);
}

// Push --------------------------------------------------------------------------------------------------------------

/// A stretch of the way over which springs of stiffness `slope` together grow from nothing at `touch`.
struct Stretch {
  double touch = 0, from = 0, to = 0, slope = 0;
};

/// Contact force over the way, zero outside the stretches.
void expect_curve(const std::string& name, const std::vector<Stretch>& stretches) {
  constexpr double start = 1.2, doubt = 1e-6;
  const Course course = calculate(name);
  EXPECT_GT(course.samples.size(), 200u) << name;
  for (const Sample& sample : course.samples) {
    const double way = start - sample.height;
    double expected = 0;
    bool boundary = false;
    for (const Stretch& s : stretches) {
      boundary = boundary || std::abs(way - s.from) < doubt || std::abs(way - s.to) < doubt;
      if (way > s.from && way < s.to) expected += s.slope * (way - s.touch);
    }
    if (boundary) continue;
    ASSERT_NEAR(sample.force, expected, 1e-6) << name << " at " << way;
  }
  if (start - course.last().height > stretches.back().to) {
    EXPECT_NEAR(course.last().force, 0, 1e-9) << name;
  }
}

// 9 nodes of the upper plate are over the lower one, 4 of the lower one under the upper.
constexpr double upper_nodes = 9, lower_nodes = 4;
/// Bricks of 5 x 5 x 1: nodes inside the facet have the stiffness of 5 x 5 facets, those at the rim of the upper body
/// also belong to the narrow sides, and the least counts.
const double solids_slope = (upper_nodes - 8 + lower_nodes) * solid_stiffness(25, 25) + 8 * solid_stiffness(5, 25);

// A: mid-surfaces 1.2 apart touch at a distance of 1 and let go 0.4 (1 + 1) further.
TEST(Workshop, ShellIntoShell) {
  expect_curve("push_shell_shell", {{0.2, 0.2, 1.0, (upper_nodes + lower_nodes) * stiffness}});
}

// B: shell nodes are half a thickness away from a facet and let go after 0.5 · 0.4 V/A; nodes of the facet, and those
// of the lower face behind it, are let go by the shells after 0.4 · 1.
TEST(Workshop, ShellIntoSolidReleasesEarly) {
  expect_curve("push_shell_solid", {{0.7, 0.7, 0.9, upper_nodes * stiffness},
                                    {0.7, 0.7, 1.1, lower_nodes * stiffness},
                                    {1.7, 1.7, 2.1, lower_nodes * stiffness}});
}

// C: facets meet at 1.2 and let go after 0.5 · 0.4 V/A = 0.2.
TEST(Workshop, SolidIntoSolidReleasesEarly) { expect_curve("push_solid_solid", {{1.2, 1.2, 1.4, solids_slope}}); }

// D: with SLDTHK = 1 the curve is that of the shells, until the coat of the other face brings a second contact.
TEST(Workshop, CoatMovesTheCurveToTheShells) {
  expect_curve("push_shell_solid_sldthk",
               {{0.2, 0.2, 1.0, (upper_nodes + lower_nodes) * stiffness}, {1.2, 1.2, 2.0, lower_nodes * stiffness}});
  expect_curve("push_solid_solid_sldthk", {{0.2, 0.2, 1.0, solids_slope}, {1.2, 1.2, 2.0, solids_slope}});
}

// Type 26 does not let go: beyond the mid-surface the springs push the other way.
TEST(Workshop, GeneralContactHoldsOn) {
  const double slope = (upper_nodes + lower_nodes) * stiffness;
  expect_curve("push_general", {{0.2, 0.2, 1.2, slope}, {2.2, 1.2, 2.2, slope}});
}

// Half the element size: half the stiffness of each spring, 25 + 16 of them.
TEST(Workshop, MoreNodesInContactAreStiffer) {
  const double slope = (25 + 16) * shell_stiffness(2.5);
  EXPECT_GT(slope, 1.5 * (upper_nodes + lower_nodes) * stiffness);
  expect_curve("push_shell_shell_fine", {{0.2, 0.2, 1.0, slope}});
}

// Penetration -------------------------------------------------------------------------------------------------------

constexpr double approach = 5, initial_depth = 0.2, contact_distance = 1;
const double kinetic = thrown_nodes * node_mass * approach * approach / 2;
const double way_in = approach / frequency;  // deeper by so much, then back

TEST(Workshop, ShootingNodesAreMovedWithoutForce) {
  const Course course = calculate("penetration_snlog_0");
  EXPECT_NEAR(course.samples[0].height, 0.8 + 1.002 * initial_depth, 1e-12);
  EXPECT_EQ(course.samples[0].force, 0);
  EXPECT_NEAR(contact_distance - course.lowest(), way_in, share * way_in);
  EXPECT_NEAR(course.last().speed, approach, share * approach);
  EXPECT_NEAR(course.last().energy, 0, 2 * share * kinetic);
}

// −½ k p² of each node appears.
TEST(Workshop, WithoutShootingNodesEnergyAppears) {
  const Course course = calculate("penetration_snlog_1");
  const double energy = thrown_nodes * stiffness * initial_depth * initial_depth / 2;
  EXPECT_NEAR(course.samples[0].force, thrown_nodes * stiffness * initial_depth, 1e-9);
  EXPECT_NEAR(course.last().energy, -energy, 2 * share * energy);
  const double speed = std::sqrt(approach * approach + 2 * energy / (thrown_nodes * node_mass));
  EXPECT_NEAR(course.last().speed, speed, share * speed);
}

TEST(Workshop, IgnoredPenetrationIsKept) {
  const Course tracked = calculate("penetration_ignore_1"), warned = calculate("penetration_ignore_2");
  for (const Course& course : {tracked, warned}) {
    ASSERT_EQ(course.initial.penetrations.size(), std::size_t{thrown_nodes});
    EXPECT_EQ(course.initial.penetrations[0].outcome, Outcome::kept);
    EXPECT_EQ(course.samples[0].height, 0.8);
    EXPECT_EQ(course.samples[0].force, 0);
    const double deeper = approach * course.samples[0].step;
    EXPECT_NEAR(course.samples[1].force, thrown_nodes * stiffness * deeper, 1e-9);
    EXPECT_NEAR(0.8 - course.lowest(), way_in, share * way_in);
    EXPECT_NEAR(course.last().speed, approach, share * approach);
    EXPECT_NEAR(course.last().energy, 0, 2 * share * kinetic);
    EXPECT_GT(course.last().height, contact_distance);
    EXPECT_EQ(course.last().touching, 0u);
  }
  EXPECT_EQ(tracked.lowest(), warned.lowest());
}

// Released until it has left both sides of the plate; then it meets a second plate at -4 and, coming back, the first
// one from below.
TEST(Workshop, ReleasedShellReturnsFromOutside) {
  const Course course = calculate("penetration_mid_face");
  ASSERT_EQ(course.initial.penetrations.size(), std::size_t{thrown_nodes});
  EXPECT_EQ(course.initial.penetrations[0].outcome, Outcome::released);
  std::size_t i = 0;
  for (; i < course.samples.size() && course.samples[i].height > -contact_distance; ++i) {
    ASSERT_EQ(course.samples[i].force, 0);
    ASSERT_EQ(course.samples[i].released, std::uint64_t{thrown_nodes});
    ASSERT_EQ(course.samples[i].speed, -approach);
  }
  EXPECT_NEAR(-3 - course.lowest(), way_in, share * way_in) << "the second plate";
  double highest = -contact_distance;
  for (bool up = false; i < course.samples.size(); ++i) {
    up = up || course.samples[i].speed > 0;
    if (up) highest = std::max(highest, course.samples[i].height);
  }
  EXPECT_NEAR(highest + contact_distance, way_in, 2 * share * way_in) << "the first plate from below";
  EXPECT_NEAR(course.last().speed, -approach, 2 * share * approach);
  EXPECT_EQ(course.last().released, 0u);
}

// Moved out of the lower plate by 1.002 · 0.3 and into the upper one; the nearer plate pushes, and they change places
// half-way.
TEST(Workshop, SandwichGetsItsEnergyFromNothing) {
  const Course course = calculate("penetration_sandwich");
  ASSERT_EQ(course.initial.penetrations.size(), std::size_t{thrown_nodes});
  for (const Penetration& p : course.initial.penetrations) EXPECT_EQ(p.outcome, Outcome::moved);
  const double deep = 1 - (1.41 - 0.7 - 1.002 * 0.3), half_way = 1 - 1.41 / 2;
  double fastest = 0;
  for (const Sample& sample : course.samples) fastest = std::max(fastest, std::abs(sample.speed));
  // They change places within a step, whose force counts for the one or the other.
  const double within_a_step = frequency * frequency * half_way * course.samples[0].step;
  EXPECT_NEAR(fastest, frequency * std::sqrt(deep * deep - half_way * half_way), within_a_step);
}

}  // namespace
}  // namespace gapcheck::solver::workshop_test
