#include "audit/fix/element_bounds.hpp"

#include <gtest/gtest.h>

#include <numeric>

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
