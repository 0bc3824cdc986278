#include "solver/output/node_areas.hpp"

#include <cmath>

#include "solver/output/run_states.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::node_areas_test {
namespace {

/// Two quads of 0.3 by 0.6 move down onto a square of side 1 that is two triangles.
const std::string plates =
    "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,0.2,0.2,0.11\n6,0.5,0.2,0.11\n7,0.8,0.2,0.11\n"
    "8,0.2,0.8,0.11\n9,0.5,0.8,0.11\n10,0.8,0.8,0.11\n*ELEMENT_SHELL\n1,1,1,2,3,3\n2,1,1,3,4,4\n3,2,5,6,9,8\n"
    "4,2,6,7,10,9\n" +
    elastic_deck(shell_section, 1000, 0.3, 1) +
    "*PART\nq\n2,1,1\n*SET_NODE_LIST\n4\n5,6,7,8,9,10\n*INITIAL_VELOCITY\n4\n0.,0.,-1.\n*CONTROL_TERMINATION\n0.02\n";

RunSettings small_steps() {
  RunSettings settings;
  settings.step.greatest_step = 1e-3;
  return settings;
}

// In flat plates the normal is z: the force on a node over a quarter of its quads, or a third of its triangles.
TEST(NodeAreas, ForceOverTheShareOfTheNode) {
  RunScene scene(plates + "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n7,a pair\n2,1,3,3,0,0,1,1\n\n\n", small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const NodeAreas areas(scene.read().model, scene.surfaces());
  const auto share = [](std::int64_t node) {
    if (node <= 4) return node % 2 == 1 ? 2 * 0.5 / 3 : 0.5 / 3;
    return node == 6 || node == 9 ? 0.09 : 0.045;
  };
  std::size_t seen = 0;
  scene.go([&](const solver::Run& run) {
    const auto nodes = node_forces(run, ContactIndex{0}, areas);
    ASSERT_TRUE(nodes);
    double sum = 0, total = 0;
    for (const results::NodeForce& node : *nodes) {
      EXPECT_EQ(node.side, node.node > 4 ? 0u : 1u);
      EXPECT_NEAR(node.pressure, std::abs(node.force.z()) / share(node.node), 1e-2 * node.pressure) << node.node;
      sum += node.pressure * share(node.node);
      total += std::abs(node.force.z());
      seen += node.pressure > 0 ? 1 : 0;
    }
    EXPECT_NEAR(sum, total, 1e-2 * total);
  });
  EXPECT_GT(seen, 20u);
}

// The whole is one surface: a node of both plates' sides has the segments of its own plate.
TEST(NodeAreas, SingleSurfacesHaveOneSide) {
  RunScene scene(plates + "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n7,all\n0,0,5,0,0,0,1,0\n\n\n", small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const NodeAreas areas(scene.read().model, scene.surfaces());
  const std::vector<Vector>& x = scene.state().x;
  const auto node = [&](std::int64_t id) { return NodeIndex{*scene.read().model.mesh.nodes.lookup.find(id)}; };
  EXPECT_NEAR(areas.pressure(ContactIndex{0}, 0, node(6), {0, 0, -9}, x), 100, 1e-10);
  EXPECT_NEAR(areas.pressure(ContactIndex{0}, 0, node(2), {5, 0, 1}, x), 6, 1e-12);
  EXPECT_EQ(areas.pressure(ContactIndex{0}, 1, node(6), {0, 0, 9}, x), 0);
}

}  // namespace
}  // namespace gapcheck::solver::node_areas_test
