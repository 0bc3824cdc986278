#include "solver/airbag/control_volume.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gapcheck::solver::control_volume_test {
namespace {

using Segments = std::vector<model::SegmentNodes>;

model::SegmentNodes segment(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  return {NodeIndex{a}, NodeIndex{b}, NodeIndex{c}, NodeIndex{d}};
}

/// Six quads, outward; nodes 0 … 3 below, 4 … 7 above them.
Segments box() {
  return {segment(0, 3, 2, 1), segment(4, 5, 6, 7), segment(0, 1, 5, 4),
          segment(1, 2, 6, 5), segment(2, 3, 7, 6), segment(3, 0, 4, 7)};
}
std::vector<Vector> box_nodes(const Vector& size) {
  std::vector<Vector> x;
  for (const double z : {0.0, size.z()})
    for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) x.emplace_back(u * size.x(), v * size.y(), z);
  return x;
}

/// The mean of both ways to cut each quad into triangles: what a bilinear patch bounds.
double volume_twin(const Segments& segments, const std::vector<Vector>& x) {
  const auto tetrahedron = [&](NodeIndex a, NodeIndex b, NodeIndex c) {
    return x[a.value].dot(x[b.value].cross(x[c.value])) / 6;
  };
  double sum = 0;
  for (const auto& [a, b, c, d] : segments)
    sum += (tetrahedron(a, b, c) + tetrahedron(a, c, d) + tetrahedron(a, b, d) + tetrahedron(b, c, d)) / 2;
  return sum;
}

TEST(ControlVolume, Box) {
  const ControlVolume bag(box());
  const std::vector<Vector> x = box_nodes({2, 3, 5});
  EXPECT_NEAR(bag.volume(x), 30, 1e-13);
  EXPECT_NEAR(bag.area(x), 2 * (6 + 10 + 15), 1e-13);
  EXPECT_EQ(bag.open_edges().count, 0u);
  EXPECT_EQ(bag.nodes().size(), 8u);
  const std::vector<Vector> forces = bag.forces(x);
  EXPECT_NEAR((forces[6] - Vector(15, 10, 6) / 4).norm(), 0, 1e-13);
  EXPECT_NEAR((forces[0] + Vector(15, 10, 6) / 4).norm(), 0, 1e-13);
}

// A pyramid of a quad and triangles, and an octahedron.
TEST(ControlVolume, Triangles) {
  const ControlVolume pyramid(
      {segment(0, 3, 2, 1), segment(0, 1, 4, 4), segment(1, 2, 4, 4), segment(2, 3, 4, 4), segment(3, 0, 4, 4)});
  std::vector<Vector> x = box_nodes({2, 3, 0});
  x[4] = {0.3, 0.7, 6};
  EXPECT_NEAR(pyramid.volume(x), 2 * 3 * 6 / 3.0, 1e-13);
  EXPECT_EQ(pyramid.open_edges().count, 0u);
  Segments faces;
  for (const std::uint32_t top : {4u, 5u})
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t next = (k + 1) % 4;
      faces.push_back(top == 4 ? segment(k, next, top, top) : segment(next, k, top, top));
    }
  const std::vector<Vector> corners{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  EXPECT_NEAR(ControlVolume(faces).volume(corners), 4 / 3.0, 1e-14);
  EXPECT_NEAR(ControlVolume(faces).area(corners), 8 * std::sqrt(3.0) / 2, 1e-13);
}

// Warped: the volume of the twin, wherever it is; the forces are the volume's derivatives and have no resultant.
TEST(ControlVolume, WarpedBoxes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  const ControlVolume bag(box());
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Vector> x = box_nodes({1, 1.5, 2});
    for (Vector& point : x) point += Vector(shift(random), shift(random), shift(random));
    const double volume = bag.volume(x);
    EXPECT_NEAR(volume, volume_twin(box(), x), 1e-13);
    std::vector<Vector> far = x;
    for (Vector& point : far) point += Vector(1e6, -2e6, 3e6);
    EXPECT_NEAR(bag.volume(far), volume, 1e-7);
    const std::vector<Vector> forces = bag.forces(x);
    Vector sum = Vector::Zero(), moment = Vector::Zero();
    for (std::size_t i = 0; i < 8; ++i) {
      sum += forces[i];
      moment += x[i].cross(forces[i]);
      for (int axis = 0; axis < 3; ++axis) {
        constexpr double step = 1e-3;  // the volume is linear in each coordinate
        std::vector<Vector> more = x, less = x;
        more[i][axis] += step;
        less[i][axis] -= step;
        EXPECT_NEAR(forces[i][axis], (bag.volume(more) - bag.volume(less)) / (2 * step), 1e-11);
      }
    }
    EXPECT_NEAR(sum.norm(), 0, 1e-13);
    EXPECT_NEAR(moment.norm(), 0, 1e-13);
  }
}

TEST(ControlVolume, InwardAndOpen) {
  Segments inward = box();
  for (model::SegmentNodes& one : inward) std::swap(one[1], one[3]);
  const std::vector<Vector> x = box_nodes({1, 1, 1});
  EXPECT_NEAR(ControlVolume(inward).volume(x), -1, 1e-14);
  EXPECT_EQ(ControlVolume(inward).open_edges().count, 0u);
  Segments open = box();
  open.erase(open.begin() + 1);
  EXPECT_EQ(ControlVolume(open).open_edges().count, 4u);
  EXPECT_EQ(ControlVolume(open).open_edges().first, (std::array<std::uint32_t, 2>{4, 5}));
  Segments turned = box();
  std::swap(turned[1][1], turned[1][3]);
  EXPECT_EQ(ControlVolume(turned).open_edges().count, 4u);
  Segments walled = box();
  walled.push_back(segment(0, 2, 6, 4));
  EXPECT_EQ(ControlVolume(walled).open_edges().count, 4u);
  EXPECT_EQ(ControlVolume({}).volume(x), 0);
}

}  // namespace
}  // namespace gapcheck::solver::control_volume_test
