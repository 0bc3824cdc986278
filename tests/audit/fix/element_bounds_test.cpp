#include "audit/fix/element_bounds.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "model/read.hpp"

namespace gapcheck::audit::element_bounds_test {
namespace {

/// One shell in the plane z = 0, or one brick, with edges of 1.
struct One {
  model::Model model;
  std::vector<Vector> x;
  std::vector<NodeIndex> nodes;

  explicit One(bool solid) {
    const std::vector<Vector> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                      {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    x.assign(corners.begin(), corners.begin() + (solid ? 8 : 4));
    for (std::uint32_t i = 0; i < x.size(); ++i) nodes.push_back(NodeIndex{i});
    model.mesh.nodes.id.resize(x.size());
    model.mesh.nodes.x = x;
    if (solid) {
      auto& solids = model.mesh.solids;
      solids.id = {1};
      solids.part = {PartIndex{0}};
      solids.nodes.emplace_back();
      std::copy(nodes.begin(), nodes.end(), solids.nodes[0].begin());
    } else {
      auto& shells = model.mesh.shells;
      shells.id = {1};
      shells.part = {PartIndex{0}};
      shells.nodes.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
    }
    model.parts.resize(1);
  }
  [[nodiscard]] std::vector<NodeIndex> offenders(std::uint32_t node, const Vector& move) {
    ElementBounds bounds(model, x);
    std::vector<Vector> now = x;
    now[node] += move;
    return bounds.offenders(now, nodes);
  }
};

TEST(ElementBounds, SmallMovesAreFine) {
  One shell(false), brick(true);
  EXPECT_TRUE(shell.offenders(0, {0.1, 0, 0.05}).empty());
  EXPECT_TRUE(brick.offenders(0, {0.2, 0.1, 0.1}).empty());
}

TEST(ElementBounds, NamesTheNodeThatTurnsAnElementInsideOut) {
  One shell(false), brick(true);
  const std::vector<NodeIndex> first{NodeIndex{0}};
  EXPECT_EQ(shell.offenders(0, {0.9, 0.9, 0}), first);  // a dart
  EXPECT_EQ(shell.offenders(0, {0, 0, 0.9}), first);    // warp
  EXPECT_EQ(shell.offenders(0, {-1.5, 0, 0}), first);   // an edge longer than twice
  EXPECT_EQ(brick.offenders(0, {0, 0, 1.2}), first);    // through the opposite face
  EXPECT_EQ(brick.offenders(0, {0, 0, 0.6}), first);    // an edge shorter than half
}

TEST(ElementBounds, NumbersThatAreNoneAreHeld) {
  One shell(false);
  EXPECT_FALSE(shell.offenders(0, Vector::Constant(1e300)).empty());
}

TEST(ElementBounds, WhatWasWorseMayStay) {
  One shell(false);
  shell.x[0].z() = 0.9;  // warped in the deck
  EXPECT_TRUE(shell.offenders(1, {0.01, 0.01, 0.1}).empty());
}

TEST(ElementBounds, AnElementThatIsTooSlenderMayMoveAsItIs) {
  One shell(false);
  shell.x[2].y() = shell.x[3].y() = 1.0 / 64;  // below the limit of 0.1
  ElementBounds bounds(shell.model, shell.x);
  std::vector<Vector> now = shell.x;
  for (Vector& x : now) x += Vector(4, 2, 1);
  EXPECT_TRUE(bounds.offenders(now, shell.nodes).empty());
  now[2].y() = now[3].y() = 2 + 0.9 / 64;
  EXPECT_EQ(bounds.offenders(now, shell.nodes).size(), 4u) << "thinner still";
}

TEST(ElementBounds, NodesThatHardlyMoveAreNotToBlame) {
  One shell(false);
  ElementBounds bounds(shell.model, shell.x);
  std::vector<Vector> now = shell.x;
  now[0] += Vector(0, 0, 0.9);
  now[1] += Vector(0, 0, 0.44);
  EXPECT_EQ(bounds.offenders(now, shell.nodes), (std::vector{NodeIndex{0}}));
  now[1] += Vector(0, 0, 0.02);
  EXPECT_EQ(bounds.offenders(now, shell.nodes), (std::vector{NodeIndex{0}, NodeIndex{1}})) << "half as far";
}

TEST(ElementBounds, WhateverTheUnitOfLength) {
  for (const double size : {1e-3, 1.0, 1e3}) {
    One shell(false);
    for (Vector& x : shell.x) x *= size;
    EXPECT_EQ(shell.offenders(0, size * Vector(0.9, 0.9, 0)), std::vector{NodeIndex{0}}) << size;
    EXPECT_TRUE(shell.offenders(0, size * Vector(0.1, 0, 0.05)).empty()) << size;
  }
}

// The edges of one shell say nothing of the next one.
TEST(ElementBounds, EachElementByItself) {
  One shell(false);
  for (std::uint32_t i = 0; i < 4; ++i) {
    shell.x.push_back(shell.x[i] + Vector(5, 0, 0));
    shell.nodes.push_back(NodeIndex{4 + i});
  }
  shell.model.mesh.nodes.id.resize(8);
  shell.model.mesh.nodes.x = shell.x;
  auto& shells = shell.model.mesh.shells;
  shells.id.push_back(2);
  shells.part.push_back(PartIndex{0});
  shells.nodes.push_back({NodeIndex{4}, NodeIndex{5}, NodeIndex{6}, NodeIndex{7}});
  ElementBounds bounds(shell.model, shell.x);
  std::vector<Vector> now = shell.x;
  now[2] += Vector(0.1, 0, 0);
  now[4] += Vector(-1.5, 0, 0);
  const auto broken = bounds.broken(now, shell.nodes);
  ASSERT_EQ(broken.size(), 1u);
  EXPECT_EQ(broken[0].second, 1u);
}

// Bricks of 1 x 1 x 1 and 1 x 1 x 4, the sound travels 1 in 0.1: steps of a tenth of the shortest height.
TEST(ElementBounds, TheStepKeepsFourFifths) {
  std::string deck =
      "*KEYWORD\n*PART\na\n1,1,1\n*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,1.,100.,0.\n"
      "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n2,1,11,12,13,14,15,16,17,18\n*NODE\n";
  for (int box = 0; box < 2; ++box)
    for (int i = 0; i < 8; ++i)
      deck += fmt::format("{},{},{},{}\n", 10 * box + i + 1, 9 * box + (i % 4 == 1 || i % 4 == 2 ? 1 : 0),
                          i % 4 > 1 ? 1 : 0, (i > 3 ? 1 : 0) * (box == 0 ? 1 : 4));
  const model::Model model = model::read_text(deck + "*END\n").model;
  const std::vector<Vector>& x = model.mesh.nodes.x;
  std::vector<NodeIndex> top[2];
  for (std::uint32_t n = 0; n < x.size(); ++n)
    if (x[n].z() > 0) top[x[n].x() > 5 ? 1 : 0].push_back(NodeIndex{n});
  const auto broken = [&](int box, double lower) {
    ElementBounds bounds(model, x);
    std::vector<Vector> now = x;
    for (const NodeIndex n : top[box]) now[n.value].z() -= lower;
    return !bounds.broken(now, top[box]).empty();
  };
  EXPECT_FALSE(broken(0, 0.19));
  EXPECT_TRUE(broken(0, 0.21)) << "0.79 of the smallest step";
  // The tall one has the step of its height of 1 along x and y until it is lower than that: edges of half are allowed.
  EXPECT_FALSE(broken(1, 1.99));
  EXPECT_TRUE(broken(1, 2.01));
  ElementBounds bounds(model, x);
  EXPECT_NEAR(bounds.limits_of({model::ElementKind::solid, 0}).edge_from, 0.8, 1e-12);
  ShapeLimits free;
  free.step = 0;
  EXPECT_TRUE(ElementBounds(model, x, free).broken(x, top[0]).empty());
  EXPECT_EQ(ElementBounds(model, x, free).limits_of({model::ElementKind::solid, 0}).edge_from, 0.5);
}

TEST(ElementBounds, CountsWhatHasChanged) {
  One shell(false);
  ElementBounds bounds(shell.model, shell.x);
  std::vector<Vector> now = shell.x;
  now[0] += Vector(1e-6, 0, 0);
  const std::vector<NodeIndex> moved{NodeIndex{0}};
  EXPECT_EQ(bounds.change(now, moved).touched, 1u);
  EXPECT_EQ(bounds.change(now, moved).worsened, 0u);
  now[0] += Vector(0, 0, 0.1);
  EXPECT_EQ(bounds.change(now, moved).worsened, 1u);
}

}  // namespace
}  // namespace gapcheck::audit::element_bounds_test
