// A cantilever of two halves that are tied to one another: tip deflection and first frequency by each kind of tie,
// against the same beam in one piece and the closed form. E = density = 1, no lateral contraction.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "solver/tie/tie_scene.hpp"

namespace gapcheck::solver::tie_cantilever_test {
namespace {

using Grid = TieDeck::Grid;

constexpr double length = 10, width = 1, force = 1e-7;

/// A beam along x, held at x = 0, loaded or thrown at its tip; thickness in z.
struct Cantilever {
  TieDeck deck;
  double thickness = 0;
  std::vector<int> tip;
  std::vector<Grid> grids;

  [[nodiscard]] double moment_of_area() const { return width * std::pow(thickness, 3) / 12; }
  /// Of the first mode of a slender beam.
  [[nodiscard]] double frequency() const {
    return std::pow(1.8751040687, 2) / (length * length) * thickness / std::sqrt(12.0);
  }
  [[nodiscard]] double deflection() const { return force * std::pow(length, 3) / (3 * moment_of_area()); }

  /// Tip deflection at rest: by damping, critical for the first mode.
  [[nodiscard]] double static_deflection() const {
    TieDeck loaded = deck;
    loaded.load(tip, 3, force).also(fmt::format("*DAMPING_GLOBAL\n0,{:.17g}\n", 2 * frequency()));
    RunScene scene(loaded.text(14 / frequency()));
    if (!scene.prepared()) {
      ADD_FAILURE() << scene.message();
      return 0;
    }
    scene.go();
    return mean_of(scene, scene.state().x, tip).z() - mean_of(scene, scene.run().initial().x, tip).z();
  }

  /// First frequency: twice the time until the beam, thrown in its first mode, comes back.
  [[nodiscard]] double free_frequency() const {
    TieDeck thrown = deck;
    std::string velocities = "*INITIAL_VELOCITY_NODE\n";
    const double k = 1.8751040687 / length, s = 0.7340955;
    for (const Grid& grid : grids)
      for (int i = 0; i <= grid.nx; ++i) {
        const double x = k * (grid.corner.x() + i * grid.size.x() / grid.nx);
        if (x == 0) continue;
        const double speed = std::cosh(x) - std::cos(x) - s * (std::sinh(x) - std::sin(x));
        const double slope = k * (std::sinh(x) + std::sin(x) - s * (std::cosh(x) - std::cos(x)));
        for (const int node : TieDeck::nodes(grid, i))
          velocities += grid.nz > 0
                            ? fmt::format("{},0.,0.,{:.17g}\n", node, 1e-6 * speed)
                            : fmt::format("{},0.,0.,{:.17g},0.,{:.17g},0.\n", node, 1e-6 * speed, -1e-6 * slope);
      }
    thrown.also(velocities);
    const double half = std::numbers::pi / frequency();
    RunScene scene(thrown.text(1.5 * half));
    if (!scene.prepared()) return 0;
    double before = 0, time = 0, back = 0;
    const double start = mean_of(scene, scene.run().initial().x, tip).z();
    scene.go([&](const solver::Run& run) {
      const State& state = run.stepper().state();
      if (back > 0 || state.cycle < 10) return;
      const double now = mean_of(scene, state.x, tip).z() - start;
      if (before > 0 && now <= 0) back = time + (state.time - time) * before / (before - now);
      before = now;
      time = state.time;
    });
    return back > 0 ? std::numbers::pi / back : 0;
  }
};

Cantilever beam(double thickness, const std::vector<Grid>& grids) {
  Cantilever beam;
  beam.thickness = thickness;
  beam.grids = grids;
  for (const Grid& grid : grids) beam.deck.add(grid);
  beam.deck.hold(TieDeck::nodes(grids.front(), 0));
  beam.tip = TieDeck::nodes(grids.back(), grids.back().nx);
  return beam;
}

/// Shells in one plane; the second half's edge lies in the last row of elements of the first one.
Cantilever shells(const std::string& keyword) {
  constexpr double thickness = 0.12, half = 5, overlap = 0.1;
  if (keyword.empty()) return beam(thickness, {Grid{1, {0, 0, 0}, {length, width, thickness}, 20, 2, 0}});
  const Grid first{1, {0, 0, 0}, {half + overlap, width, thickness}, 10, 2, 0},
      second{2, {half, 0, 0}, {length - half, width, thickness}, 10, 3, 0};
  Cantilever both = beam(thickness, {first, second});
  both.deck.tie(keyword, TieDeck::nodes(second, 0), 1, thickness);
  return both;
}

/// Bricks, end face on end face, with meshes that do not match.
Cantilever bricks(const std::string& keyword, double scale = 1) {
  constexpr double thickness = 1, half = 5;
  if (keyword.empty()) return beam(thickness, {Grid{1, {0, 0, 0}, {length, width, thickness}, 12, 1, 3}});
  const Grid first{1, {0, 0, 0}, {half, width, thickness}, 6, 1, 3},
      second{2, {half, 0, 0}, {length - half, width, thickness}, 6, 2, 4};
  Cantilever both = beam(thickness, {first, second});
  both.deck.tie(keyword, TieDeck::nodes(second, 0), 1, 0.1, "", scale);
  return both;
}

struct Case {
  const char* name;
  const char* keyword;
  bool bending;      ///< the tie carries it
  double scale = 1;  ///< SFS and SFM
};

std::string test_name(const testing::TestParamInfo<Case>& info) { return info.param.name; }

class TiedShells : public testing::TestWithParam<Case> {};

TEST_P(TiedShells, BendsLikeOnePiece) {
  static const double in_one_piece = shells("").static_deflection(), frequency = shells("").free_frequency();
  EXPECT_NEAR(in_one_piece / shells("").deflection(), 1, 0.01);
  EXPECT_NEAR(frequency / shells("").frequency(), 1, 0.01);
  const Cantilever tied = shells(GetParam().keyword);
  const double deflection = tied.static_deflection() / in_one_piece;
  RecordProperty("scale", fmt::format("{:g}", GetParam().scale));
  RecordProperty("deflection", fmt::format("{:.4f}", deflection));
  if (!GetParam().bending) {
    // A hinge: nothing but inertia and damping holds the second half.
    EXPECT_GT(deflection, 5);
    return;
  }
  const double ratio = tied.free_frequency() / frequency;
  RecordProperty("frequency", fmt::format("{:.4f}", ratio));
  EXPECT_NEAR(deflection, 1, 0.02);
  EXPECT_NEAR(ratio, 1, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Cantilever, TiedShells,
                         testing::Values(Case{"type_2", "TIED_SURFACE_TO_SURFACE", false},
                                         Case{"type_6", "TIED_NODES_TO_SURFACE", false},
                                         Case{"type_7", "TIED_SHELL_EDGE_TO_SURFACE", true},
                                         Case{"type_o2", "TIED_SURFACE_TO_SURFACE_OFFSET", false},
                                         Case{"type_o6", "TIED_NODES_TO_SURFACE_OFFSET", false},
                                         Case{"type_o7", "TIED_SHELL_EDGE_TO_SURFACE_OFFSET", true},
                                         Case{"type_b2", "TIED_SURFACE_TO_SURFACE_BEAM_OFFSET", false},
                                         Case{"type_b7", "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET", true},
                                         Case{"type_c2", "TIED_SURFACE_TO_SURFACE_CONSTRAINED_OFFSET", false},
                                         Case{"type_c6", "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET", false},
                                         Case{"type_c7", "TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET", true},
                                         Case{"spotweld", "SPOTWELD", true}),
                         test_name);

class TiedBricks : public testing::TestWithParam<Case> {};

TEST_P(TiedBricks, BendsLikeOnePiece) {
  static const double in_one_piece = bricks("").static_deflection(), frequency = bricks("").free_frequency();
  const Cantilever tied = bricks(GetParam().keyword, GetParam().scale);
  const double deflection = tied.static_deflection() / in_one_piece, ratio = tied.free_frequency() / frequency;
  RecordProperty("scale", fmt::format("{:g}", GetParam().scale));
  RecordProperty("deflection", fmt::format("{:.4f}", deflection));
  RecordProperty("frequency", fmt::format("{:.4f}", ratio));
  if (!GetParam().bending) {
    EXPECT_GT(deflection, 1.05);  // springs as soft as those of a contact yield
    return;
  }
  EXPECT_NEAR(deflection, 1, 0.02);
  EXPECT_NEAR(ratio, 1, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Cantilever, TiedBricks,
                         testing::Values(Case{"type_2", "TIED_SURFACE_TO_SURFACE", true},
                                         Case{"type_6", "TIED_NODES_TO_SURFACE", true},
                                         Case{"type_7", "TIED_SHELL_EDGE_TO_SURFACE", true},
                                         Case{"type_o2", "TIED_SURFACE_TO_SURFACE_OFFSET", true, 20},
                                         Case{"type_o6", "TIED_NODES_TO_SURFACE_OFFSET", true, 20},
                                         Case{"type_b2", "TIED_SURFACE_TO_SURFACE_BEAM_OFFSET", true, 20},
                                         Case{"type_b6", "TIED_NODES_TO_SURFACE_BEAM_OFFSET", true, 20},
                                         Case{"type_b6_by_default", "TIED_NODES_TO_SURFACE_BEAM_OFFSET", false},
                                         Case{"type_b7", "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET", true, 20},
                                         Case{"type_c2", "TIED_SURFACE_TO_SURFACE_CONSTRAINED_OFFSET", true},
                                         Case{"type_c6", "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET", true}),
                         test_name);

/// Why b6 bends by an eighth more at SFS = SFM = 1: each spring has the documented stiffness SLSFAC K A²/V of the face
/// that it is tied to, here K = 1/3 and V = 5/18; nodes on the rim of the end lie as near to the faces beside it, and
/// are tied to those. By Castigliano the springs move the tip by twice their energy over the load; the rest of the
/// eighth is what they bend in the bricks that they pull at.
TEST(TiedBricksByDefault, YieldAsTheirSpringsMust) {
  const Cantilever one = bricks(""), tied = bricks("TIED_NODES_TO_SURFACE_BEAM_OFFSET");
  TieDeck loaded = tied.deck;
  loaded.load(tied.tip, 3, force).also(fmt::format("*DAMPING_GLOBAL\n0,{:.17g}\n", 2 * tied.frequency()));
  RunScene scene(loaded.text(14 / tied.frequency()));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  ASSERT_EQ(scene.run().contacts().size(), 1u);
  const ContactView view = scene.run().contacts()[0];
  std::vector<ContactLink> links;
  view.source->links(view.position, links);
  ASSERT_EQ(links.size(), 15u);
  const std::vector<Vector>& x = scene.state().x;
  double energy = 0;
  std::set<int> areas;
  for (const ContactLink& link : links) {
    const auto& n = link.reference.nodes;
    const double area = (x[n[2].value] - x[n[0].value]).cross(x[n[3].value] - x[n[1].value]).norm() / 2;
    const double stiffness = 0.1 / 3 * area * area / (5.0 / 18);
    const Vector stretch = x[link.tracked.nodes[0].value] - link.reference.of(x);
    EXPECT_NEAR((link.force + stiffness * stretch).norm() / (stiffness * 1e-6), 0, 0.02);
    energy += link.force.squaredNorm() / stiffness / 2;
    areas.insert(static_cast<int>(std::lround(36 * area)));
  }
  EXPECT_EQ(areas, (std::set<int>{10, 12, 30})) << "faces beside the end, the end itself, above and below";
  EXPECT_NEAR(*view.stored() / energy, 1, 1e-4);
  const double share = 2 * energy / force / one.static_deflection();
  RecordProperty("share", fmt::format("{:.4f}", share));
  EXPECT_NEAR(share, 0.0765, 0.002);
}

/// A shell whose edge stands `gap` before the end face of a block that hardly gives way.
Cantilever shell_on_block(const std::string& keyword, double gap, double scale) {
  constexpr double thickness = 0.12;
  const Grid block{1, {-0.5, 0, -0.5}, {0.5 - gap, width, 1}, 2, 2, 4},
      shell{2, {0, 0, 0.05}, {length, width, thickness}, 12, 3, 0};
  Cantilever both = beam(thickness, {block, shell});
  both.deck.tie(keyword, TieDeck::nodes(shell, 0), 1, 0.1, "", scale);
  return both;
}

class ShellOnBlock : public testing::TestWithParam<Case> {};

TEST_P(ShellOnBlock, IsClamped) {
  // Types 7 move the edge onto the face: the gap is closed before the first cycle.
  constexpr double gap = 0.05;
  const Cantilever tied = shell_on_block(GetParam().keyword, gap, GetParam().scale);
  const bool moved = std::string(GetParam().name) == "type_7";
  const double deflection = tied.static_deflection() / tied.deflection() / std::pow(1 + (moved ? gap / length : 0), 3);
  RecordProperty("scale", fmt::format("{:g}", GetParam().scale));
  RecordProperty("deflection", fmt::format("{:.4f}", deflection));
  if (GetParam().bending)
    EXPECT_NEAR(deflection, 1, 0.03);  // the face gives way by 0.02
  else
    EXPECT_GT(deflection, 4);
}

INSTANTIATE_TEST_SUITE_P(Cantilever, ShellOnBlock,
                         testing::Values(Case{"type_6", "TIED_NODES_TO_SURFACE", false},
                                         Case{"type_7", "TIED_SHELL_EDGE_TO_SURFACE", true},
                                         Case{"type_b7", "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET", true, 10},
                                         Case{"type_c7", "TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET", true}),
                         test_name);

class LapJoint : public testing::TestWithParam<Case> {};

/// The second half lies above the first one and is pulled: the first one gets the moment force · offset over its whole
/// length, by w = P d (a²/2 + a b)/EI.
TEST_P(LapJoint, OffsetBendsTheFirstHalf) {
  constexpr double thickness = 0.12, half = 5, offset = 0.2;
  const Grid first{1, {0, 0, 0}, {half + 0.1, width, thickness}, 10, 2, 0},
      second{2, {half, 0, offset}, {length - half, width, thickness}, 10, 3, 0};
  Cantilever both = beam(thickness, {first, second});
  both.deck.tie(GetParam().keyword, TieDeck::nodes(second, 0), 1, 0.5);
  constexpr double pull = 1e-9;  // tension must not straighten the beam
  both.deck.load(both.tip, 1, pull).also(fmt::format("*DAMPING_GLOBAL\n0,{:.17g}\n", 2 * both.frequency()));
  RunScene scene(both.deck.text(14 / both.frequency()));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  const double stiffness = both.moment_of_area(), other = length - half;
  const double deflection = -(mean_of(scene, scene.state().x, both.tip).z() - offset) /
                            (pull * offset * (half * half / 2 + half * other) / stiffness);
  RecordProperty("scale", fmt::format("{:g}", GetParam().scale));
  RecordProperty("deflection", fmt::format("{:.4f}", deflection));
  EXPECT_NEAR(deflection, GetParam().bending ? 1 : 0, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Cantilever, LapJoint,
                         testing::Values(Case{"type_o7", "TIED_SHELL_EDGE_TO_SURFACE_OFFSET", false},
                                         Case{"type_b7", "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET", true},
                                         Case{"type_c7", "TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET", true}),
                         test_name);

}  // namespace
}  // namespace gapcheck::solver::tie_cantilever_test
