#include "contact/pair/record_pair.hpp"

#include <gtest/gtest.h>

#include "contact/scene.hpp"

namespace gapcheck::contact::record_pair_test {
namespace {

/// Two plates, 0.5 apart, of thickness 1.
Scene plates(const std::string& type) {
  Scene scene;
  const PartIndex a = scene.part(1, 1), b = scene.part(2, 1);
  scene.plate(a, Vector(0, 0, 0), Vector(5, 0, 0), Vector(0, 5, 0), 2, 2);
  scene.plate(b, Vector(0, 0, 0.5), Vector(5, 0, 0), Vector(0, 5, 0), 2, 2);
  model::Contact& contact = scene.contact(type);
  if (type != "AUTOMATIC_SINGLE_SURFACE") contact.a = {1, 3, 0, true}, contact.b = {2, 3, 0, true};
  contact.ignore = 1;
  scene.model.mesh.nodes.lookup.build(scene.model.mesh.nodes.id);
  return scene;
}

TEST(RecordPair, EveryRecordIsFoundOnItsSides) {
  for (const char* type : {"AUTOMATIC_SINGLE_SURFACE", "AUTOMATIC_SURFACE_TO_SURFACE"}) {
    Scene scene = plates(type);
    const InitialState state = scene.run();
    ASSERT_EQ(state.penetrations.size(), 18U);
    SurfaceStore store(scene.model);
    const ContactSurfaces& s = store.at(ContactIndex{0});
    for (const Penetration& p : state.penetrations) {
      const auto pair = find_pair(s, scene.model.mesh, p);
      ASSERT_TRUE(pair);
      if (s.two_sided()) {
        EXPECT_EQ(pair->node_on_b, p.node > 9);
        EXPECT_NE(pair->node_on_b, pair->segment_on_b);
      }
      const ContactSide& nodes = pair->node_on_b ? s.b : s.a;
      const ContactSide& segments = pair->segment_on_b ? s.b : s.a;
      EXPECT_EQ(scene.model.mesh.nodes.id[nodes.nodes.node[pair->slot.value].value], p.node);
      EXPECT_EQ(element_id(scene.model.mesh, segments.selection.segments, pair->segment.value), p.element);
    }
  }
}

TEST(RecordPair, NothingForRecordsOfOtherSurfaces) {
  Scene scene = plates("AUTOMATIC_SINGLE_SURFACE");
  InitialState state = scene.run();
  SurfaceStore store(scene.model);
  Penetration& p = state.penetrations.front();
  for (const std::uint32_t number : {0U, 9U}) {
    p.segment_number = number;
    EXPECT_FALSE(find_pair(store.at(ContactIndex{0}), scene.model.mesh, p));
  }
  p = state.penetrations.back();
  p.node = 99;
  EXPECT_FALSE(find_pair(store.at(ContactIndex{0}), scene.model.mesh, p));
}

}  // namespace
}  // namespace gapcheck::contact::record_pair_test
