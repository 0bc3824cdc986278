#include "solver/contact/push_list.hpp"

#include <gtest/gtest.h>

#include <random>

namespace gapcheck::solver::push_list_test {
namespace {

constexpr std::uint32_t nodes = 9000;  // several ranges of nodes, which threads share

struct Scene {
  contact::Segments segments;
  std::vector<PushList> lists;
  std::vector<Vector> x;
};

/// `lists` lists of pushes on segments whose corners lie within `reach` of each other; the last list is empty.
Scene random_scene(unsigned seed, std::uint32_t reach) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  std::uniform_int_distribution<std::uint32_t> any(0, nodes - reach), near(0, reach - 1);
  const auto vector = [&] { return Vector(number(random), number(random), number(random)); };
  Scene scene;
  for (std::uint32_t i = 0; i < nodes; ++i) scene.x.push_back(vector());
  std::vector<std::uint32_t> free(nodes);
  for (std::uint32_t i = 0; i < nodes; ++i) free[i] = i;
  std::shuffle(free.begin(), free.end(), random);
  for (int l = 0; l < 20; ++l) {
    PushList& list = scene.lists.emplace_back();
    const std::uint32_t first = any(random);
    for (int p = 0; p < 30 && l < 19; ++p) {
      const auto segment = static_cast<std::uint32_t>(scene.segments.nodes.size());
      model::SegmentNodes& corners = scene.segments.nodes.emplace_back();
      for (NodeIndex& corner : corners) corner = NodeIndex{first + near(random)};
      list.add({vector(), {number(random), number(random), number(random), number(random)}, free.back(), segment},
               corners);
      free.pop_back();
    }
  }
  return scene;
}

// Every node gets what a loop over all pushes gives it, whether lists reach over few nodes or over all.
TEST(PushList, ForcesAreThoseOfALoopOverAllPushes) {
  for (const std::uint32_t reach : {10u, 1000u, 3000u, nodes}) {
    const Scene scene = random_scene(reach, reach);
    Forces forces;
    forces.resize(nodes);
    add_pushes(scene.lists, scene.segments, forces);
    std::vector<Vector> expected(nodes, Vector::Zero());
    for (const PushList& list : scene.lists)
      for (const NodePush& push : list.pushes) {
        expected[push.node] += push.force;
        for (std::size_t c = 0; c < 4; ++c)
          expected[scene.segments.nodes[push.segment][c].value] -= push.weights[c] * push.force;
      }
    for (std::uint32_t i = 0; i < nodes; ++i) ASSERT_LT((forces.force[i] - expected[i]).norm(), 1e-13) << i;
  }
}

// Force and moment about the origin on each side; forces on the segments act at their weighted corners.
TEST(PushList, TotalsBySide) {
  const Scene scene = random_scene(5, 100);
  Vector force = Vector::Zero(), on_tracked = Vector::Zero(), on_corners = Vector::Zero();
  for (const PushList& list : scene.lists)
    for (const NodePush& push : list.pushes) {
      force += push.force;
      on_tracked += scene.x[push.node].cross(push.force);
      for (std::size_t c = 0; c < 4; ++c)
        on_corners -= scene.x[scene.segments.nodes[push.segment][c].value].cross(push.weights[c] * push.force);
    }
  for (const bool exchanged : {false, true}) {
    ContactState state;
    add_totals(scene.lists, scene.segments, scene.x, exchanged, state);
    EXPECT_LT(((exchanged ? state.force_b : state.force_a) - force).norm(), 1e-11);
    EXPECT_LT(((exchanged ? state.force_a : state.force_b) + force).norm(), 1e-11);
    EXPECT_LT(((exchanged ? state.moment_b : state.moment_a) - on_tracked).norm(), 1e-11);
    EXPECT_LT(((exchanged ? state.moment_a : state.moment_b) - on_corners).norm(), 1e-11);
  }
}

}  // namespace
}  // namespace gapcheck::solver::push_list_test
