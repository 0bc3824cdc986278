// Impacts with a closed form, calculated from decks as a whole: rods of bricks against one another and against a wall.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::impact_test {
namespace {

// Rods of length 4 and ν = 0: c = √(E/ρ) = 10.
constexpr double young = 400, density = 4, wave = 10, length = 4, speed = 0.01;

/// A rod of n cubes along x from `start` on, as part and first node id `part` · 1000.
std::string rod(int part, int n, double start) {
  const double h = length / n;
  std::string text = "*NODE\n";
  const int first = part * 1000;
  for (int i = 0; i <= n; ++i)
    for (int c = 0; c < 4; ++c)
      text += fmt::format("{},{:.17g},{},{}\n", first + 4 * i + c, start + i * h, c == 1 || c == 2 ? h : 0.,
                          c >= 2 ? h : 0.);
  text += "*ELEMENT_SOLID\n";
  for (int i = 0; i < n; ++i) {
    text += fmt::format("{},{}", first + i, part);
    for (int c = 0; c < 8; ++c) text += fmt::format(",{}", first + 4 * i + c);
    text += "\n";
  }
  return text + fmt::format("*PART\nrod\n{},1,1\n", part);
}

std::string throws(int part, double velocity) {
  return fmt::format("*INITIAL_VELOCITY_GENERATION\n{},2,0.,{},0.,0.\n0.,0.,0.,0.,0.,1.\n", part, velocity);
}

/// Materials, sections and a run to `end`; the linear bulk viscosity is small enough to leave the plateau of a wave.
std::string rest(double end, double factor = 0.9) {
  return fmt::format(
      "*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,{},{},0.\n*CONTROL_TERMINATION\n{}\n*CONTROL_TIMESTEP\n0.,{}\n", density,
      young, end, factor);
}

const std::string contact_of_parts = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n0.\n";

/// Contact of the end faces alone: the sides of the rods are flush.
std::string contact_of_ends(int n) {
  const int a = 1000 + 4 * n, b = 2000;
  return fmt::format("*SET_SEGMENT\n1\n{},{},{},{}\n*SET_SEGMENT\n2\n{},{},{},{}\n", a, a + 1, a + 2, a + 3, b, b + 3,
                     b + 2, b + 1) +
         "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,0,0\n0.\n";
}

struct Impact {
  double plateau = 0;   ///< interface stress in the middle of the contact
  double duration = 0;  ///< from the first to the last contact force
  double error = 0;     ///< of the duration, relative
};

/// The stress is the force of the contact over the section of h².
Impact watch_impact(RunScene& scene, double section) {
  Impact impact;
  double first = 0, sum = 0;
  int samples = 0;
  const double whole = 2 * length / wave;
  scene.go([&](const solver::Run& run) {
    const double time = run.stepper().state().time, force = run.contacts()[0].state().force_a.norm();
    if (force > 0 && first == 0) first = time;
    if (force > 0) impact.duration = time - first;
    if (first > 0 && time > first + 0.4 * whole && time < first + 0.8 * whole) {
      sum += force;
      ++samples;
    }
  });
  impact.plateau = sum / samples / section;
  impact.error = impact.duration / whole - 1;
  return impact;
}

/// Mean velocity of a rod of n cubes, masses of its ends being half.
double mean_velocity(const RunScene& scene, int n, std::size_t first) {
  double momentum = 0, mass = 0;
  for (std::size_t i = first; i < first + 4 * static_cast<std::size_t>(n + 1); ++i) {
    momentum += scene.state().mass[i] * scene.state().v[i].x();
    mass += scene.state().mass[i];
  }
  return momentum / mass;
}

// A rod hits an equal one at rest: σ = ρ c v / 2 for 2 L / c, then the first rests and the second flies with v.
TEST(Impact, EqualRodsExchangeTheirVelocities) {
  std::array<double, 3> error{};
  for (std::size_t i = 0; i < 3; ++i) {
    const int n = 20 << i;
    const double h = length / n;
    RunScene scene(rod(1, n, 0) + rod(2, n, length + 1e-6) + throws(1, speed) + rest(1.1) + contact_of_ends(n) +
                   "1.,1.\n0\n0.,0,0,1\n");
    ASSERT_TRUE(scene.prepared()) << scene.message();
    const Impact impact = watch_impact(scene, h * h);
    EXPECT_NEAR(impact.plateau / (density * wave * speed / 2), 1, 0.01) << n;
    error[i] = impact.error;
    if (n == 80)
      RecordProperty("rods_stress_error_80", fmt::format("{:.4f}", impact.plateau / (density * wave * speed / 2) - 1));
    EXPECT_NEAR(scene.momentum().x(), density * length * h * h * speed, 1e-12 * density * length * h * h * speed);
    EXPECT_NEAR(mean_velocity(scene, n, 0) / speed, 0, 0.02) << n;
    EXPECT_NEAR(mean_velocity(scene, n, 4 * static_cast<std::size_t>(n + 1)) / speed, 1, 0.02) << n;
    EXPECT_NEAR(scene.energies().ratio(), 1, 0.005) << n;
  }
  EXPECT_LT(std::abs(error[2]), 0.02);
  const double order = std::log2(error[1] / error[2]);
  EXPECT_NEAR(order, 1, 0.4);
  RecordProperty("rods_contact_time_error_20", fmt::format("{:.4f}", error[0]));
  RecordProperty("rods_contact_time_error_40", fmt::format("{:.4f}", error[1]));
  RecordProperty("rods_contact_time_error_80", fmt::format("{:.4f}", error[2]));
  RecordProperty("rods_contact_time_order", fmt::format("{:.2f}", order));
}

/// A bar of 10 × n × n cubes along x, whose sides are shifted by `shift`.
std::string bar(int part, int n, double start, double shift) {
  constexpr double h = 0.4;
  const int first = part * 10000;
  const auto id = [&](int i, int j, int k) { return first + i * (n + 1) * (n + 1) + j * (n + 1) + k; };
  std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n";
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k)
        nodes += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", id(i, j, k), start + i * h, shift + j * h, shift + k * h);
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        solids += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", id(i, j, k), part, id(i, j, k), id(i + 1, j, k),
                              id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1),
                              id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1));
  return nodes + solids + fmt::format("*PART\nbar\n{},1,1\n", part);
}

/// The share of its momentum that a bar hands over to one at rest.
double handed_over(int n, double shift, bool single, const std::string& card_a, int ihq = 4, double tssfac = 0.9) {
  RunScene scene(
      bar(1, n, 0, 0) + bar(2, n, 4 + 1e-6, shift) + throws(1, speed) + rest(2, tssfac) +
      (single ? "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n" : "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n") +
      "0.\n1.,1.\n" + card_a + fmt::format("*CONTROL_HOURGLASS\n{},0.1\n", ihq));
  EXPECT_TRUE(scene.prepared()) << scene.message();
  if (!scene.prepared()) return 0;
  scene.go();
  EXPECT_NEAR(scene.energies().ratio(), 1, 0.01);
  double handed = 0;
  const State& state = scene.state();
  for (std::size_t i = state.x.size() / 2; i < state.x.size(); ++i) handed += state.mass[i] * state.v[i].x();
  return handed / scene.momentum().x();
}

/// The same in one dimension: rods of ten elements, and between their ends the springs of SOFT = 0, 0.1 K A² / V at
/// each of 2 (n + 1)² nodes with K = E / 3, without viscosity.
double handed_over_by_rods(int n) {
  constexpr int elements = 10, ends = elements + 1;
  const double ratio = 2.0 / 3 * (n + 1) * (n + 1) / (n * n);  // of the springs to a rod of stiffness 1 / elements
  std::array<double, 2 * ends> x{}, v{};
  for (int i = 0; i < ends; ++i) v[static_cast<std::size_t>(i)] = 1;
  const auto mass = [](std::size_t i) { return i % ends == 0 || i % ends == elements ? 0.5 : 1.0; };
  constexpr double dt = 0.05;
  for (int cycle = 0; cycle < 1000; ++cycle) {
    std::array<double, 2 * ends> force{};
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      const bool contact = i == elements;
      const double pull = contact ? ratio / elements * std::min(0.0, x[i + 1] - x[i]) : x[i + 1] - x[i];
      force[i] += pull;
      force[i + 1] -= pull;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
      v[i] += dt * force[i] / mass(i);
      x[i] += dt * v[i];
    }
  }
  double handed = 0;
  for (std::size_t i = ends; i < x.size(); ++i) handed += mass(i) * v[i];
  return handed / elements;
}

// Equal bars, end to end and flush: the nodes of their ends lie in the planes of the other's sides, but meet its end.
// The second flies on with the momentum of the first, by parts as by segments: with SOFT = 0 and 1 as in one dimension.
TEST(Impact, FlushBarsHandOverTheirMomentum) {
  for (const bool single : {false, true})
    for (const int soft : {0, 1, 2})
      for (const int n : {1, 2, 3})
        for (const double shift : {0.0, 1e-6, -1e-6}) {
          const double handed = handed_over(n, shift, single, fmt::format("{}\n", soft));
          const double expected = soft == 2 ? 0.995 : handed_over_by_rods(n);
          EXPECT_NEAR(handed, expected, soft == 2 ? 0.002 : 0.008)
              << "n " << n << " shift " << shift << " SOFT " << soft << " single " << single;
        }
}

// SOFT = 0 gives nodes of unequal mass equal springs, so for n > 1 the ends vibrate; viscous hourglass control takes
// it.
TEST(Impact, FlushBarsWithViscousHourglassControl) {
  for (const int n : {2, 3}) {
    const double handed = handed_over(n, 0, false, "0\n", 1), in_one_dimension = handed_over_by_rods(n);
    EXPECT_LT(handed, in_one_dimension) << n;
    EXPECT_NEAR(handed, in_one_dimension, 0.02) << n;
  }
}

// Springs in proportion to the masses of their nodes: all nodes of an end move alike, whatever n.
TEST(Impact, BarsOfAnyWidthAreAlikeWithSpringsByMass) {
  const std::string by_mass = "1,0.1\n";  // SOFT = 1: with a third of the step its springs are the stiffer ones
  const double one = handed_over(1, 0, false, by_mass, 1, 0.3);
  EXPECT_GT(one, 0.98);
  for (const int n : {2, 3}) EXPECT_NEAR(handed_over(n, 0, false, by_mass, 1, 0.3), one, 2e-3) << n;
}

// Rigid parts have no step of their own: the springs between them give one, or DTINIT or LCTM where they are smaller.
TEST(Impact, RigidPartsRunAtTheStepOfTheirContact) {
  // The lighter side: √(m / 2k) with m = ρ t A / 4 and k = 0.1 K A / diagonal, times TSSFAC.
  const double spring = 0.1 * 1000 / 1.2 * 0.36 / (0.6 * std::sqrt(2.0)),
               of_contact = 0.9 * std::sqrt(0.009 / 2 / spring);
  for (const auto& [card, step] : {std::pair{"0.,0.9", of_contact},
                                   {"1e-4,0.9", 1e-4},
                                   {"0.,0.9,0,0.,0.,7", 2e-4},
                                   {"1e-4,0.9,0,0.,0.,7", 1e-4}}) {
    RunScene scene(
        "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,0.2,0.2,0.11\n6,0.8,0.2,0.11\n"
        "7,0.8,0.8,0.11\n8,0.2,0.8,0.11\n*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,5,6,7,8\n"
        "*PART\na\n1,1,1\n*PART\nb\n2,1,1\n*SECTION_SHELL\n1,2\n0.1\n*MAT_RIGID\n1,1.,1000.,0.3\n"
        "*INITIAL_VELOCITY_GENERATION\n2,2,0.,0.,0.,-2.\n0.,0.,0.,0.,0.,1.\n"
        "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,1,3,3\n0.\n1.,1.\n0\n0.\n1,0\n*CONTROL_TERMINATION\n0.1,\n" +
        fmt::format("*CONTROL_TIMESTEP\n{}\n*DEFINE_CURVE\n7\n0.,2e-4\n9.,2e-4\n", card));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    const Vector before = scene.momentum();
    double greatest = 0;
    bool touched = false;
    scene.go([&](const solver::Run& run) {
      greatest = std::max(greatest, run.stepper().next_step());
      touched = touched || run.contacts()[0].state().touching > 0;
    });
    EXPECT_TRUE(touched);
    EXPECT_NEAR(greatest, step, 1e-12 * step) << card;
    EXPECT_NEAR((scene.momentum() - before).norm(), 0, 1e-9 * before.norm());
    EXPECT_NEAR(scene.energies().ratio(), 1, 0.02);
    EXPECT_GT(scene.state().v[4].z() - scene.state().v[0].z(), 1.9) << "they part as fast as they met";
  }
}

// Against a fixed wall: σ = ρ c v for 2 L / c, and the rod flies back with the speed it came with.
TEST(Impact, RodAgainstRigidWall) {
  constexpr int n = 40;
  const double h = length / n;
  RunScene scene(rod(1, n, 0) +
                 fmt::format("*NODE\n9001,{0},{1},{1}\n9002,{0},{2},{1}\n9003,{0},{2},{2}\n9004,{0},{1},{2}\n",
                             length + 0.05 + 1e-6, -h, 2 * h) +
                 "*ELEMENT_SHELL\n9001,2,9001,9004,9003,9002\n*PART\nwall\n2,2,2\n*SECTION_SHELL\n2,2\n0.1\n"
                 "*MAT_RIGID\n2,4.,400.,0.\n1.,7.,7.\n" +
                 throws(1, speed) + rest(1.1) + contact_of_parts + "4.,4.\n0\n0.,0,0,1\n");
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const Impact impact = watch_impact(scene, h * h);
  EXPECT_NEAR(impact.plateau / (density * wave * speed), 1, 0.01);
  EXPECT_NEAR(impact.error, 0, 0.035);
  EXPECT_NEAR(mean_velocity(scene, n, 0) / speed, -1, 0.02);
  EXPECT_NEAR(scene.energies().ratio(), 1, 0.005);
  RecordProperty("rod_on_wall_stress_error", fmt::format("{:.4f}", impact.plateau / (density * wave * speed) - 1));
  RecordProperty("rod_on_wall_contact_time_error", fmt::format("{:.4f}", impact.error));
}

// A block that flies about in a box of shells for 100,000 cycles.
struct LongImpact {
  const char* name;
  std::string contact;
  double left;  ///< greatest contact energy between impacts, in initial energies
};

/// The box has the sides 2.4, two shells along each; the block, a cube of 1, is part 2.
std::string block_in_box() {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  const auto id = [](int i, int j, int k) { return 1 + i + 3 * j + 9 * k; };
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
        if (i != 1 || j != 1 || k != 1) nodes += fmt::format("{},{},{},{}\n", id(i, j, k), 1.2 * i, 1.2 * j, 1.2 * k);
  int element = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 3; side += 2)
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
          const auto corner = [&](int da, int db) {
            std::array<int, 3> at{};
            at[static_cast<std::size_t>(axis)] = side;
            at[static_cast<std::size_t>((axis + 1) % 3)] = a + da;
            at[static_cast<std::size_t>((axis + 2) % 3)] = b + db;
            return id(at[0], at[1], at[2]);
          };
          shells +=
              fmt::format("{},1,{},{},{},{}\n", ++element, corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
        }
  for (int k = 0; k < 2; ++k)
    for (int c = 0; c < 4; ++c)
      nodes += fmt::format("{},{},{},{}\n", 101 + 4 * k + c, c == 1 || c == 2 ? 1.6 : 0.6, c >= 2 ? 1.7 : 0.7, 0.5 + k);
  return nodes + shells +
         "*ELEMENT_SOLID\n101,2,101,102,103,104,105,106,107,108\n*PART\nbox\n1,2,1\n*PART\nblock\n2,1,1\n"
         "*SECTION_SHELL\n2,2\n0.2\n";
}

class LongImpacts : public testing::TestWithParam<LongImpact> {};

TEST_P(LongImpacts, KeepEnergyAndMomentum) {
  RunSettings settings;
  settings.cycles = 100000;
  settings.step.greatest_step = 0.01;
  RunScene scene(block_in_box() + rest(1e9) +
                     "*INITIAL_VELOCITY_GENERATION\n2,2,0.,0.5,0.3,-0.4\n0.,0.,0.,0.,0.,1.\n"
                     "*CONTROL_BULK_VISCOSITY\n1e-30,1e-30\n*CONTROL_HOURGLASS\n4,0.05\n" +
                     GetParam().contact,
                 settings);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const Vector before = scene.momentum();
  double least = 2, most = 0;
  int impacts = 0;
  bool touches = false;
  double left = 0;  // of contact energy while nothing touches, in initial energies
  scene.go([&](const solver::Run& run) {
    const double ratio = run.stepper().energies().ratio();
    least = std::min(least, ratio);
    most = std::max(most, ratio);
    const bool now = run.contacts()[0].state().touching > 0;
    if (now && !touches) ++impacts;
    touches = now;
    const Energies& energies = run.stepper().energies();
    if (!now) left = std::max(left, std::abs(energies.absorbed.contact_normal) / energies.initial);
  });
  EXPECT_EQ(scene.state().cycle, 100000u);
  EXPECT_GE(impacts, 50);
  // Springs give back what they took; nodes that are moved lose a little of it each time.
  EXPECT_LT(left, GetParam().left);
  EXPECT_GT(least, 0.99);
  EXPECT_LT(most, 1.01);
  EXPECT_LT((scene.momentum() - before).norm(), 1e-12 * before.norm());
  RecordProperty(fmt::format("long_impact_{}_contact_energy_error", GetParam().name), fmt::format("{:.1e}", left));
  RecordProperty(fmt::format("long_impact_{}_least_energy_ratio", GetParam().name), fmt::format("{:.6f}", least));
  RecordProperty(fmt::format("long_impact_{}_largest_energy_ratio", GetParam().name), fmt::format("{:.6f}", most));
  RecordProperty(fmt::format("long_impact_{}_momentum_error", GetParam().name),
                 fmt::format("{:.1e}", (scene.momentum() - before).norm() / before.norm()));
}

const std::string two_way = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,1,3,3\n0.\n10.,10.\n0\n";
const std::string single = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.\n10.,10.\n0\n";
const std::string shooting = "0.,0,0,0\n", no_shooting = "0.,0,0,1\n";

INSTANTIATE_TEST_SUITE_P(All, LongImpacts,
                         testing::Values(LongImpact{"two_way_shooting", two_way + shooting, 0.02},
                                         LongImpact{"two_way_snlog", two_way + no_shooting, 0.005},
                                         LongImpact{"single_shooting", single + shooting, 0.02},
                                         LongImpact{"single_snlog", single + no_shooting, 0.005}),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace gapcheck::solver::impact_test
