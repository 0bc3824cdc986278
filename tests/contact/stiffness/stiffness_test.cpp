#include "contact/stiffness/stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapcheck::contact::stiffness_test {
namespace {

TEST(Stiffness, ModulusIsBulkAndMembraneForFabric) {
  model::Material material;
  material.young = 300;
  material.poisson = 0.5;
  material.bulk = 175000;
  EXPECT_EQ(contact_modulus(material), 175000);
  material.fabric = true;
  EXPECT_EQ(contact_modulus(material), 400);  // 300 / (1 - 0.25)
  const model::Model empty;
  EXPECT_EQ(contact_modulus(empty, none<PartIndex>), 0);
}

TEST(Stiffness, OfSegments) {
  EXPECT_EQ(solid_segment_stiffness(0.1, 1000, 6, 12), 0.1 * 1000 * 36 / 12);
  EXPECT_EQ(shell_segment_stiffness(0.1, 1000, 12, 5), 0.1 * 1000 * 12 / 5);
  EXPECT_EQ(solid_segment_stiffness(0.1, 1000, 6, 0), 0);
}

TEST(Stiffness, NodesWeighTheirSegments) {
  NodeStiffness node;
  EXPECT_EQ(node.value(), 0);
  node += {1, 1 * 10.0};
  node += {3, 3 * 2.0};
  EXPECT_EQ(node.value(), 4);  // (10 + 6) / 4
}

TEST(Stiffness, SpringFollowsPenopt) {
  const PairStiffness pair{.node = 5, .segment = 8, .node_weighted = 6, .thickness = 2};
  EXPECT_EQ(spring_stiffness(1, pair), 5);
  EXPECT_EQ(spring_stiffness(2, pair), 8);
  EXPECT_EQ(spring_stiffness(3, pair), 5);
  EXPECT_EQ(spring_stiffness(4, pair), 6);
  EXPECT_EQ(spring_stiffness(5, pair), 3);
  EXPECT_EQ(spring_stiffness(0, {.node = 9, .segment = 8}), 8);
}

TEST(Stiffness, SoftConstraintFromMassAndStep) {
  EXPECT_DOUBLE_EQ(soft_1_stiffness(2, 6, 0.5), 0.5 * 2 / 0.25);
  EXPECT_DOUBLE_EQ(soft_1_stiffness(6, 2, 0.5), 0.5 * 2 / 0.25);
  EXPECT_EQ(soft_1_spring(3, 0.1, 20), 3);
  EXPECT_EQ(soft_1_spring(1, 0.1, 20), 2);
  EXPECT_DOUBLE_EQ(soft_2_stiffness(0.1, 1, 3, 0.5), 0.5 * 0.1 * 0.75 / 0.25);
}

// With both masses equal, SOFSCL = 1 and the share 0.5 the spring is stable with twice the step: Δt = 2 √(m / 2 / k).
TEST(Stiffness, SoftOneIsStableAtItsStep) {
  const double dt = 1e-6, mass = 3e-7;
  const double k = soft_1_stiffness(mass, mass, dt);
  EXPECT_DOUBLE_EQ(2 * std::sqrt(mass / 2 / k), 2 * dt);
}

}  // namespace
}  // namespace gapcheck::contact::stiffness_test
