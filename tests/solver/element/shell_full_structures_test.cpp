// Structures of fully integrated shells (ELFORM 16): static ones by their stiffness, moving ones by whole runs.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/element/shell_strip.hpp"
#include "solver/output/plot.hpp"
#include "solver/output/state_balance.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::shell_full_structures_test {
namespace {

// P L³/3 E I + P L/κ G A. A linear curvature misses 1/(4 n²) of the bending, whatever the thickness and the sides.
TEST(FullShellCantilever, DoesNotLockInShear) {
  constexpr double length = 10, width = 1;
  for (const double thickness : {1.0, 0.1, 0.01})
    for (const int n : {1, 4, 10}) {  // sides 10:1 to 1:1
      const double bending = std::pow(length, 3) / (3 * 1000 * width * std::pow(thickness, 3) / 12);
      const double shear = length / (5.0 / 6 * 500 * width * thickness);
      const double tip = straight(n, length, width, thickness).tip({0, 0, 1});
      EXPECT_NEAR(tip / (bending * (1 - 0.25 / (n * n)) + shear), 1, 1e-4) << thickness << " " << n;
    }
}

// The same strip of skewed and unequal quads, L/t = 1000.
TEST(FullShellCantilever, SkewedQuads) {
  Strip strip = straight(8, 10, 1, 0.01);
  for (std::size_t i = 1; i < 8; ++i) {
    const double skew = i % 2 == 0 ? 0.2 : -0.25;
    strip.x[2 * i].x() += skew;
    strip.x[2 * i + 1].x() -= skew;
  }
  const double exact = 1000 / (3 * 1000 * std::pow(0.01, 3) / 12);
  EXPECT_NEAR(strip.tip({0, 0, 1}) / exact, 1, 0.03);
}

// In its plane, sides 1:1 and 10:1: P L³/3 E I + 6/5 P L/G A; the bending of a linear moment misses 1/(4 n²) here too.
TEST(FullShellCantilever, InItsPlane) {
  constexpr double length = 10, width = 1, thickness = 0.1;
  for (const int n : {4, 10}) {
    const double bending = std::pow(length, 3) / (3 * 1000 * thickness * std::pow(width, 3) / 12);
    const double shear = length / (500 * thickness * width);
    const double tip = straight(n, length, width, thickness).tip({0, 1, 0});
    EXPECT_NEAR(tip / (bending * (1 - 0.25 / (n * n)) + shear), 1, 1e-4) << n;
  }
}

// MacNeal and Harder (1985): twisted by 90°, 12 x 2 quads, t = 0.32; t = 0.0032 with the values commonly quoted for it,
// where a shell that locks in the membrane fails.
TEST(FullShellCantilever, TwistedBeam) {
  const auto near = [](const char* name, double found, double reference, double tolerance) {
    EXPECT_NEAR(found / reference, 1, tolerance) << name;
    testing::Test::RecordProperty(name, fmt::format("{:.4f}", found / reference));
  };
  near("thick_in_plane", twisted(12, 0.32).tip({0, 0, 1}), 5.424e-3, 0.01);
  near("thick_out_of_plane", twisted(12, 0.32).tip({0, 1, 0}), 1.754e-3, 0.02);
  near("thin_in_plane", twisted(12, 0.0032).tip({0, 0, 1}), 5256, 0.025);
  near("thin_out_of_plane", twisted(12, 0.0032).tip({0, 1, 0}), 1294, 0.025);
}

// Steel in mm, ms, kg.
const std::string steel = "*MAT_ELASTIC\n1,7.85e-6,210.,0.3\n";

/// n² quads of side 5, whose nodes are moved by up to `skew` and out of the plane by up to `warp`; `first`: which
/// corner.
std::string free_plate(int n, double skew, double warp, int first = 0, bool triangles = false) {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  const auto id = [&](int i, int j) { return 1 + i + (n + 1) * j; };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      nodes += fmt::format("{},{},{},{}\n", id(i, j), 5 * i + skew / 2 * ((7 * i + 3 * j) % 5 - 2),
                           5 * j + skew / 2 * ((3 * i + 11 * j) % 5 - 2), warp / 2 * ((5 * i + 2 * j) % 5 - 2));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const std::array<int, 4> corner{id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)};
      const auto at = [&](int k) { return corner[static_cast<std::size_t>((k + first) % 4)]; };
      const int element = 2 * (i + n * j) + 1;
      if (triangles) {
        shells += fmt::format("{},1,{},{},{},{}\n", element, at(0), at(1), at(2), at(2));
        shells += fmt::format("{},1,{},{},{},{}\n", element + 1, at(0), at(2), at(3), at(3));
      } else {
        shells += fmt::format("{},1,{},{},{},{}\n", element, at(0), at(1), at(2), at(3));
      }
    }
  return nodes + shells + "*PART\nplate\n1,1,1\n*SECTION_SHELL\n1,16\n1.\n" + steel;
}

RunScene plate_run(const std::string& deck, std::uint64_t cycles, double amplitude, const Vector& spin = {0, 0, 0}) {
  RunSettings settings;
  settings.cycles = cycles;
  settings.step.energy_tolerance = 0;
  std::string velocities = fmt::format("*INITIAL_VELOCITY_GENERATION\n1,2,{},0.,0.,0.\n5.,5.,0.,{},{},{}\n",
                                       spin.norm(), spin.x(), spin.y(), spin.z());
  if (amplitude > 0)
    velocities = fmt::format("*INITIAL_VELOCITY_NODE\n1,0.,0.,{0}\n3,{0},0.,0.\n5,0.,0.,{1}\n9,0.,{1},{0}\n", amplitude,
                             -amplitude);
  return RunScene(deck + velocities + "*CONTROL_TERMINATION\n1e9\n", settings);
}

// Nothing supplies energy: a vibrating plate keeps what it has, flat, skewed or warped.
TEST(FullShellRuns, VibratingPlateKeepsItsEnergy) {
  for (const double skew : {0.0, 1.0})
    for (const double warp : {0.0, 1.0}) {
      RunScene scene = plate_run(free_plate(2, skew, warp), 10000, 0.5);
      ASSERT_TRUE(scene.prepared()) << scene.message();
      double greatest = 0, worst = 0;
      scene.go([&](const solver::Run& run) {
        const Energies& e = run.stepper().energies();
        greatest = std::max(greatest, e.printed_kinetic / e.printed_initial);
        worst = std::max(worst, std::abs(e.ratio() - 1));
        EXPECT_EQ(e.hourglass, 0);
      });
      const StateBalance balance = state_balance(scene.run());
      EXPECT_LT(greatest, 1.01) << skew << " " << warp;
      EXPECT_LT(worst, 2e-3) << skew << " " << warp;
      EXPECT_NEAR(balance.created() / balance.largest, 0, 2e-3) << skew << " " << warp;
      RecordProperty(fmt::format("ratio_skew_{}_warp_{}", skew, warp), fmt::format("{:.2e} {:.2e}", worst, greatest));
    }
}

TEST(FullShellRuns, TurningPlateKeepsItsEnergy) {
  RunScene scene = plate_run(free_plate(2, 1, 1), 10000, 0, Vector(1, 2, 3).normalized() * 2);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double least = 1, greatest = 1;
  scene.go([&](const solver::Run& run) {
    const Energies& e = run.stepper().energies();
    least = std::min(least, e.printed_kinetic / e.printed_initial);
    greatest = std::max(greatest, e.printed_kinetic / e.printed_initial);
  });
  EXPECT_GT(least, 0.99);
  EXPECT_LT(greatest, 1.001);
  RecordProperty("kinetic_energy", fmt::format("{:.6f} {:.6f}", least, greatest));
}

// The axes follow the side 1-2, so the first corner matters only as far as quads shear while they turn.
TEST(FullShellRuns, FirstCornerHardlyMatters) {
  const auto place = [](int first, double amplitude) {
    RunScene scene = plate_run(free_plate(2, 1, 1, first), 500, amplitude);
    scene.go();
    return Vector((scene.state().x[4] - scene.state().x[0]) / amplitude);
  };
  const double small = (place(0, 1e-5) - place(1, 1e-5)).norm(), large = (place(0, 1) - place(1, 1)).norm();
  EXPECT_LT(small * 1e-5, 1e-9);
  EXPECT_LT(large, 1e-3);
  RecordProperty("difference", fmt::format("{:.1e} {:.1e}", small * 1e-5, large));
}

// Quads with two equal corners (ESORT 0) and C0 triangles (ESORT 1): what they pull on each node is in balance.
TEST(FullShellRuns, TrianglesKeepEnergyAndMomentum) {
  for (const int esort : {0, 1}) {
    RunScene scene =
        plate_run(free_plate(2, 1, 0, 0, true) + fmt::format("*CONTROL_SHELL\n20.,{}\n", esort), 5000, 0.5);
    ASSERT_TRUE(scene.prepared()) << scene.message();
    EXPECT_EQ(scene.run().stepper().structure().shells.points(0).size(), esort == 0 ? 8u : 2u);
    const Vector momentum = scene.momentum();
    double worst = 0;
    scene.go([&](const solver::Run& run) { worst = std::max(worst, std::abs(run.stepper().energies().ratio() - 1)); });
    EXPECT_LT(worst, 2e-3) << esort;
    EXPECT_LT((scene.momentum() - momentum).norm(), 1e-12 * momentum.norm()) << esort;
  }
}

// A factor on the manual's step that leaves the bound of the frequency alone to keep single elements stable.
TEST(FullShellRuns, TheBoundAloneIsStable) {
  for (const double warp : {0.0, 2.0})
    for (const double skew : {0.0, 1.0}) {
      RunSettings settings;
      settings.cycles = 5000;
      settings.step.time_step_factor = 100;
      settings.step.energy_tolerance = 0;
      RunScene scene(
          free_plate(1, skew, warp) +
              "*INITIAL_VELOCITY_NODE\n1,0.,0.,.02\n3,.02,0.,0.,.01\n4,0.,-.02,0.,0.,.01\n*CONTROL_TERMINATION\n1e9\n",
          settings);
      ASSERT_TRUE(scene.prepared()) << scene.message();
      double greatest = 0;
      scene.go([&](const solver::Run& run) {
        greatest =
            std::max(greatest, run.stepper().energies().printed_kinetic / run.stepper().energies().printed_initial);
      });
      EXPECT_LT(greatest, 1.05) << warp << " " << skew;
    }
}

// Pulled evenly until it fails: all its points at the same time and after the same work as a one-point shell. (Clamped,
// it would differ: its points near the clamp yield under two stresses.)
TEST(FullShellRuns, PulledElementFails) {
  const auto pulled = [](int elform) {
    RunSettings fine;
    fine.step.greatest_step = 5e-3;
    RunScene scene(
        plate(1, 1, {1, 1, 0}) + fmt::format("*PART\np\n1,1,1\n*SECTION_SHELL\n1,{}\n0.1\n", elform) +
            "*MAT_PLASTIC_KINEMATIC\n1,1.,1000.,0.,10.,0.,0.\n0.,0.,0.2\n*CONTROL_TERMINATION\n4.\n"
            "*DEFINE_CURVE\n1\n0.,0.1\n1.,0.1\n*BOUNDARY_PRESCRIBED_MOTION_SET\n2,1,0,1\n*SET_NODE_LIST\n1\n1,3\n"
            "*SET_NODE_LIST\n2\n2,4\n*SET_NODE_LIST\n3\n1,2\n*BOUNDARY_SPC_SET\n1,0,1,0,1,1,1,1\n"
            "*BOUNDARY_SPC_SET\n3,0,0,1,1,1,1,1\n",
        fine);
    EXPECT_TRUE(scene.prepared()) << scene.message();
    scene.go();
    EXPECT_EQ(scene.state().failed.count, 1u);
    return std::pair{scene.run().stepper().failures().at(0).time, scene.energies().internal};
  };
  const auto [one_time, one_work] = pulled(2);
  const auto [time, work] = pulled(16);
  EXPECT_NEAR(std::log(1 + 0.1 * time), 0.21, 1e-3);
  EXPECT_NEAR(time, one_time, 1e-9);
  EXPECT_NEAR(work / one_work, 1, 1e-7);
}

// What d3plot gets is the mean of the four points of each layer: of a shell bent in its plane, that of the stretch
// alone.
TEST(FullShellRuns, StatesAverageThePoints) {
  RunSettings settings;
  settings.cycles = 1;
  RunScene scene(plate(1, 1, {1, 1, 0}) +
                     "*PART\np\n1,1,1\n*SECTION_SHELL\n1,16,1.,3\n0.1\n*MAT_ELASTIC\n1,1.,1000.,0.3\n" +
                     "*INITIAL_VELOCITY_NODE\n1,.001\n2,.003\n3,-.001\n4,.005\n*CONTROL_TERMINATION\n1.\n",
                 settings);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  const Structure& structure = scene.run().stepper().structure();
  const std::span<const PointState> points = structure.shells.points(0);
  ASSERT_EQ(points.size(), 12u);
  EXPECT_GT(std::abs(points[0].stress[xx] - points[6].stress[xx]), 1e-3);
  const std::vector<PartMotion> motion(1);
  const results::D3plotState plot =
      plot_state(scene.read().model, structure, contact::element_sizes(scene.read().model), motion);
  for (std::size_t layer = 0; layer < 3; ++layer)
    for (const std::size_t c : {xx, yy, xy}) {
      const std::size_t own = layer == 0 ? 1 : layer == 1 ? 0 : 2;  // of the plot: middle, lower, upper
      double mean = 0;
      for (std::size_t g = 0; g < 4; ++g) mean += points[3 * g + own].stress[c] / 4;
      EXPECT_NEAR(plot.shell_points[layer].stress[c], mean, 1e-12);
    }
  double force = 0;  // per length: all layers have the same stress
  for (std::size_t g = 0; g < 4; ++g) force += 0.1 * points[3 * g].stress[xx] / 4;
  EXPECT_NEAR(plot.shells[0].resultants[5], force, 1e-12);
}

}  // namespace
}  // namespace gapcheck::solver::shell_full_structures_test
