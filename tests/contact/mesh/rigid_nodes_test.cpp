#include "contact/mesh/rigid_nodes.hpp"

#include <gtest/gtest.h>

#include "contact/scene.hpp"

namespace gapcheck::contact::rigid_nodes_test {
namespace {

TEST(RigidNodes, PartsBeforeGroupsAndTheFirstOfSeveral) {
  Scene scene;
  const auto soft = scene.plate(scene.part(1, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 1);
  const auto hard = scene.plate(scene.part(2, 1), {5, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 1);
  EXPECT_FALSE(RigidNodes(scene.model).owner(hard[0]));
  scene.model.materials.emplace_back().rigid = true;
  scene.model.parts[1].material = 0;
  for (const auto& nodes : {std::vector{soft[0], hard[0]}, std::vector{soft[0], soft[1]}}) {
    model::RigidGroup group;
    group.kind = model::RigidGroup::Kind::nodal_rigid_body;
    group.nodes = nodes;
    scene.model.rigid_groups.push_back(group);
  }
  const RigidNodes rigid(scene.model);
  EXPECT_EQ(rigid.owner(hard[0]).kind, RigidOwner::Kind::part);
  EXPECT_EQ(rigid.owner(hard[0]).index, 1U);
  EXPECT_EQ(rigid.owner(soft[0]).kind, RigidOwner::Kind::group);
  EXPECT_EQ(rigid.owner(soft[0]).index, 0U);
  EXPECT_EQ(rigid.owner(soft[1]).index, 1U);
  EXPECT_FALSE(rigid.owner(soft[2]));
}

}  // namespace
}  // namespace gapcheck::contact::rigid_nodes_test
