// Shell plates that hit each other: what is left in the contact afterwards. The impact is calculated for eight phases:
// how far the plates come within the step in which they first overlap.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::plate_impact_test {
namespace {

// Steel in mm, ms, kg; shells of 5 × 5, 1 thick.
constexpr double side = 5, thickness = 1;

struct Impact {
  std::string type = "SINGLE_SURFACE";
  int small = 3, large = 3;  ///< shells along the sides of the thrown plate and of the one at rest
  int snlog = 0, ignore = 0, soft = 0;
  double tssfac = 0.9, speed = 20, tilt = 0, shift = 0.3;  ///< tilt: of the thrown plate; shift: in its plane
};

struct Outcome {
  double contact = 0;  ///< energy left in the contact, of the initial kinetic energy
  double ratio = 0;    ///< of the whole run
  double steps = 0;    ///< cycles in which anything touches
  std::uint64_t moved = 0;
};

std::string plate(int part, int n, double origin, double z, double tilt) {
  const int first = 1000 * part;
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      nodes += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", first + j * (n + 1) + i, origin + side * i,
                           origin + side * j, z + tilt * (side * i + 0.7 * side * j));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = first + j * (n + 1) + i;
      shells += fmt::format("{},{},{},{},{},{}\n", first + j * n + i, part, a, a + 1, a + n + 2, a + n + 1);
    }
  return nodes + shells + fmt::format("*PART\nplate\n{},1,1\n", part);
}

std::string deck(const Impact& impact, double gap, double end) {
  const double middle = (impact.large - impact.small) * side / 2 + impact.shift;
  const bool single = impact.type == "SINGLE_SURFACE" || impact.type == "GENERAL";
  return plate(1, impact.large, 0, 0, 0) + plate(2, impact.small, middle, thickness + gap, impact.tilt) +
         fmt::format("*SECTION_SHELL\n1,2\n{0},{0},{0},{0}\n*MAT_ELASTIC\n1,7.85e-6,210.,0.3\n", thickness) +
         fmt::format("*INITIAL_VELOCITY_GENERATION\n2,2,0.,0.,0.,{}\n0.,0.,0.,0.,0.,1.\n", -impact.speed) +
         fmt::format("*CONTROL_TERMINATION\n{:.12g},\n*CONTROL_TIMESTEP\n0.,{}\n", end, impact.tssfac) +
         fmt::format("*CONTACT_AUTOMATIC_{}\n{}\n0.\n1.,1.\n{}\n0.,0,0,{}\n1,{}\n", impact.type,
                     single ? "1,0,2,0" : "2,1,3,3", impact.soft, impact.snlog, impact.ignore) +
         "*SET_PART_LIST\n1\n1,2\n";
}

Outcome calculate(const Impact& impact, double gap, double end) {
  RunScene scene(deck(impact, gap, end));
  EXPECT_TRUE(scene.prepared()) << scene.message();
  Outcome outcome;
  if (!scene.prepared()) return outcome;
  scene.go([&](const Run& run) { outcome.steps += run.contacts()[0].state().touching > 0; });
  const ContactState& state = scene.run().contacts()[0].state();
  const Energies& energies = scene.energies();
  outcome.contact = (state.energy_a + state.energy_b) / energies.printed_initial;
  outcome.ratio = energies.ratio();
  outcome.moved = state.moved;
  return outcome;
}

struct Sum {
  double mean = 0, least = 1e9, greatest = -1e9, steps = 0;
};

/// Eight phases: the gap before the impact grows by an eighth of the way of one step.
Sum over_phases(const Impact& impact) {
  // Until the last corner has come down, and the time of some impacts.
  const double first = 0.05 * impact.speed / 20;
  const double end = (first + 2 * side * impact.small * impact.tilt) / impact.speed + 0.05;
  RunScene probe(deck(impact, first, 1e-6));
  double step = 0;
  probe.go([&](const solver::Run& run) { step = run.stepper().next_step(); });
  constexpr int phases = 8;
  Sum sum;
  for (int phase = 0; phase < phases; ++phase) {
    const Outcome outcome = calculate(impact, first + impact.speed * step * phase / phases, end);
    sum.mean += outcome.contact / phases;
    sum.steps += outcome.steps / phases;
    sum.least = std::min(sum.least, outcome.contact);
    sum.greatest = std::max(sum.greatest, outcome.contact);
  }
  return sum;
}

/// One row of docs/theory/impact-energy.md: mean, least and greatest of what is left, and the cycles of an impact.
void record(const std::string& shape, const Impact& impact, const Sum& sum) {
  testing::Test::RecordProperty(
      fmt::format("impact_{}_{}_soft_{}_tssfac_{}_start_{}{}", shape, impact.type, impact.soft, impact.tssfac,
                  impact.snlog, impact.ignore),
      fmt::format("{:.4f} {:.4f} {:.4f} {:.1f}", sum.mean, sum.least, sum.greatest, sum.steps));
}

struct Shape {
  const char* name;
  int small, large;
  double tilt, shift, speed;
};

class PlateImpact : public testing::TestWithParam<Shape> {};

// Elastic plates give back what they take: on average over the phases nothing is left in the contact, whatever happens
// to nodes that are found suddenly, since these nodes are followed up to the surface.
TEST_P(PlateImpact, LeavesNothingInTheContact) {
  const Shape& shape = GetParam();
  for (const char* type : {"SINGLE_SURFACE", "SURFACE_TO_SURFACE", "NODES_TO_SURFACE", "GENERAL"})
    for (const int soft : {0, 1, 2})
      for (const double tssfac : {0.9, 0.5, 0.1}) {
        const bool segments = soft == 2 && std::string(type) != "SINGLE_SURFACE";
        if (segments && std::string(type) != "SURFACE_TO_SURFACE") continue;  // no segment-based form
        if (shape.large > 5 && tssfac < 0.5) continue;                        // takes long
        for (const auto& [snlog, ignore] : {std::pair{0, 0}, {1, 0}, {0, 1}, {0, 2}}) {
          Impact impact{type, shape.small, shape.large, snlog,      ignore,
                        soft, tssfac,      shape.speed, shape.tilt, shape.shift};
          const Sum sum = over_phases(impact);
          EXPECT_LT(std::abs(sum.mean), 0.03)
              << type << " SOFT " << soft << " TSSFAC " << tssfac << " SNLOG " << snlog << " IGNORE " << ignore;
          record(shape.name, impact, sum);
        }
      }
}

INSTANTIATE_TEST_SUITE_P(All, PlateImpact,
                         testing::Values(Shape{"flat", 3, 3, 0, 0.3, 20}, Shape{"slow", 3, 3, 0, 0.3, 1},
                                         Shape{"large", 8, 10, 0, 0.3, 20}, Shape{"tilted", 3, 3, 0.02, 0.3, 20},
                                         Shape{"offset", 3, 3, 0, 6.1, 20}),
                         [](const auto& one) { return std::string(one.param.name); });

// A plate so fast that it jumps into the contact distance is moved to the surface, or forced with SNLOG = 1.
TEST(PlateImpacts, ThatJumpAreMoved) {
  for (const int snlog : {0, 1}) {
    Impact impact;
    impact.snlog = snlog;
    impact.speed = 1.3e4;
    RunScene probe(deck(impact, 5, 1e-9));
    double step = 0;
    probe.go([&](const solver::Run& run) { step = run.stepper().next_step(); });
    // One step from beyond twice the contact distance to 0.1 inside.
    impact.speed = 1.2 * thickness / step;
    const Outcome outcome = calculate(impact, 1.1 * thickness, 1.5 * step);
    EXPECT_EQ(outcome.moved, snlog == 0 ? 32u : 0u);  // the nodes of both plates
  }
}

}  // namespace
}  // namespace gapcheck::solver::plate_impact_test
