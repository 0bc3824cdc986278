#include "contact/surface/contact_mesh.hpp"

#include <gtest/gtest.h>

#include "contact/scene.hpp"

namespace gapcheck::contact::contact_mesh_test {
namespace {

std::vector<ContactIndex> all_contacts(const model::Model& model) {
  return positions<ContactIndex>(model.contacts.size()).list();
}

TEST(ContactMesh, EverySegmentOnce) {
  Scene scene;
  const PartIndex plate = scene.part(1, 1), block = scene.part(2, 0);
  scene.plate(plate, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 3, 2);
  scene.brick(block, {0, 0, 5}, {1, 1, 1});
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  scene.contact("AUTOMATIC_SURFACE_TO_SURFACE").a = {2, 3, 0, true};
  scene.model.contacts.back().b = {1, 3, 0, true};
  SurfaceStore surfaces(scene.model);
  const ContactMesh both(scene.model, surfaces, all_contacts(scene.model));
  EXPECT_EQ(both.size(), 6U + 6U);
  for (std::size_t i = 0; i < both.size(); ++i) EXPECT_EQ(both.contact(i), ContactIndex{0});
  const std::vector second{ContactIndex{1}};
  const ContactMesh alone(scene.model, surfaces, second);
  ASSERT_EQ(alone.size(), 12U);
  EXPECT_EQ(alone.kind(0), model::ElementKind::solid);
  EXPECT_EQ(alone.part(0), block);
  EXPECT_EQ(alone.part(6), plate);
}

TEST(ContactMesh, EdgesByTheirLowerNode) {
  Scene scene;
  const auto n = scene.plate(scene.part(1, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2, 1);  // 0 1 2 / 3 4 5
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  SurfaceStore surfaces(scene.model);
  ContactMesh mesh(scene.model, surfaces, all_contacts(scene.model));
  mesh.build_edges();
  std::size_t uses = 0;
  for (const NodeIndex a : n) uses += mesh.edges_at(a.value).size();
  EXPECT_EQ(uses, 8U);
  std::vector<std::uint32_t> shared;
  for (const EdgeUse& use : mesh.edges_at(1))
    if (use.other == NodeIndex{4}) shared.push_back(use.segment);
  EXPECT_EQ(shared, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(mesh.corners().size(), 6U);
  EXPECT_EQ(mesh.quality().size(), 2U);
}

TEST(ContactMesh, OfASingleSegment) {
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 1);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  SurfaceStore surfaces(scene.model);
  const ContactMesh mesh(scene.model, surfaces, all_contacts(scene.model));
  ASSERT_EQ(mesh.size(), 1U);
  EXPECT_EQ(mesh.part(0), PartIndex{0});
}

TEST(ContactMesh, WithoutContactsThereIsNothing) {
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2, 1);
  SurfaceStore surfaces(scene.model);
  ContactMesh mesh(scene.model, surfaces, {});
  EXPECT_EQ(mesh.size(), 0U);
  EXPECT_TRUE(mesh.corners().empty());
}

}  // namespace
}  // namespace gapcheck::contact::contact_mesh_test
