#include "contact/surface/contact_side.hpp"

#include <gtest/gtest.h>

#include <set>

#include "contact/scene.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "contact/surface/neighbour_cache.hpp"

namespace gapcheck::contact::contact_side_test {
namespace {

/// Two plates; contacts between them as asked for.
struct Plates {
  Plates() {
    scene.plate(scene.part(1, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 3, 2);
    scene.plate(scene.part(2, 1), {0, 0, 2}, {1, 0, 0}, {0, 1, 0}, 3, 2);
  }
  model::Contact& contact(std::int64_t a, std::int64_t b) {
    scene.contact("AUTOMATIC_SURFACE_TO_SURFACE").a = {a, 3, 0, true};
    scene.model.contacts.back().b = {b, 3, 0, true};
    return scene.model.contacts.back();
  }
  Scene scene;
};

model::Box box(const Vector& low, const Vector& high) {
  model::Box box;
  box.low = low;
  box.high = high;
  return box;
}

TEST(ContactSide, ContactsWithTheSameSideShareIt) {
  Plates plates;
  plates.contact(1, 2);
  plates.contact(1, 2);
  plates.contact(2, 1);
  SurfaceStore store(plates.scene.model);
  const ContactSurfaces &first = store.at(ContactIndex{0}), &second = store.at(ContactIndex{1});
  EXPECT_EQ(&first.a, &second.a);
  EXPECT_EQ(&first.b, &second.b);
  EXPECT_NE(&first.a, &first.b);
  EXPECT_EQ(store.at(ContactIndex{2}).b.nodes.node, first.a.nodes.node);
}

// Whatever changes a side makes it one of its own.
TEST(ContactSide, OtherThicknessBoxOrTypeIsAnotherSide) {
  Plates plates;
  plates.contact(1, 2);
  plates.contact(1, 2).sst = 0.5;
  plates.contact(1, 2).sfst = 0.5;
  plates.contact(1, 2).a.box = 7;
  model::set_name("CONTACT_SURFACE_TO_SURFACE", plates.contact(1, 2));
  plates.contact(1, 2).sldthk = 1;
  model::set_name("CONTACT_TIED_SURFACE_TO_SURFACE", plates.contact(1, 2));
  plates.scene.model.contacts.back().sst = -0.5;
  model::set_name("CONTACT_AUTOMATIC_SINGLE_SURFACE", plates.contact(1, 0));
  plates.scene.model.boxes[7] = box({-1, -1, -1}, {1.5, 3, 1});
  SurfaceStore store(plates.scene.model);
  std::set<const ContactSide*> sides;
  for (const ContactIndex c : positions<ContactIndex>(plates.scene.model.contacts.size())) {
    sides.insert(&store.at(c).a);
    const ContactSurfaces alone = store.build(c, plates.scene.model.mesh.nodes.x);
    EXPECT_EQ(alone.a.nodes.half, store.at(c).a.nodes.half) << c.value;
    EXPECT_EQ(alone.a.selection.segments.nodes, store.at(c).a.selection.segments.nodes) << c.value;
  }
  EXPECT_EQ(sides.size(), plates.scene.model.contacts.size());
}

// Two contacts of type 26 of the same parts share no side if only one of them has CPARM8 = 2.
TEST(ContactSide, SpotweldBeamsMakeAnotherSide) {
  Plates plates;
  model::Model& model = plates.scene.model;
  const PartIndex welds = plates.scene.part(3, 0);
  model.parts[welds.value].material = static_cast<std::uint32_t>(model.materials.size());
  model.materials.emplace_back().spotweld = true;
  model.mesh.beams.id = {7};
  model.mesh.beams.nodes = {{plates.scene.node({0, 0, 0.5}), plates.scene.node({0, 0, 1.5})}};
  model.mesh.beams.part = {welds};
  model.mesh.beams.line = {0};
  for (const std::int64_t cparm8 : {0, 2}) {
    plates.scene.contact("AUTOMATIC_GENERAL").a = {0, 5, 0, true};
    model.contacts.back().cparm8 = cparm8;
  }
  SurfaceStore store(model);
  EXPECT_EQ(store.at(ContactIndex{0}).a.lines, 0U);
  EXPECT_EQ(store.at(ContactIndex{1}).a.lines, 1U);
}

// What a box leaves of a plate's nodes is no node set.
TEST(ContactSide, ABoxThatLeavesNoSegmentsLeavesNoNodeSet) {
  Plates plates;
  plates.contact(1, 2).a.box = 7;
  plates.contact(1, 2).a = {5, 4, 0, true};
  plates.scene.model.boxes[7] = box({-0.5, -0.5, -1}, {0.5, 0.5, 1});
  plates.scene.model.sets.nodes[5].members = {NodeIndex{0}};
  SurfaceStore store(plates.scene.model);
  const ContactSide &cut = store.at(ContactIndex{0}).a, &set = store.at(ContactIndex{1}).a;
  EXPECT_EQ(cut.selection.segments.size() + set.selection.segments.size(), 0U);
  EXPECT_EQ(cut.nodes.node, set.nodes.node);
  EXPECT_TRUE(cut.nodes_only && set.nodes_only);
  EXPECT_FALSE(cut.names_nodes);
  EXPECT_TRUE(set.names_nodes);
}

TEST(ContactSide, NobodyKeepsWhatNobodyUses) {
  Plates plates;
  plates.contact(1, 2);
  plates.contact(1, 2);
  SurfaceStore store(plates.scene.model);
  SideCache sides;
  const std::vector<Vector>& x = plates.scene.model.mesh.nodes.x;
  auto first = std::make_unique<const ContactSurfaces>(store.build(ContactIndex{0}, x, &sides));
  const ContactSide* const a = &first->a;
  const auto second = std::make_unique<const ContactSurfaces>(store.build(ContactIndex{1}, x, &sides));
  EXPECT_EQ(&second->a, a);
  const ContactSurfaces copy = *first;
  first.reset();
  EXPECT_EQ(&copy.a, a) << "a copy shares";
  sides.clear();
  EXPECT_NE(&store.build(ContactIndex{1}, x, &sides).a, a) << "other coordinates are other sides";
}

TEST(ContactSide, NeighboursAreSharedWhileTheyAreUsed) {
  Plates plates;
  plates.contact(1, 2);
  SurfaceStore store(plates.scene.model);
  const ContactSurfaces& surfaces = store.at(ContactIndex{0});
  const model::Mesh& mesh = plates.scene.model.mesh;
  NeighbourCache cache;
  auto first = cache.of(surfaces.a, mesh, NeighbourKind::with_cut);
  EXPECT_EQ(cache.of(surfaces.a, mesh, NeighbourKind::with_cut), first);
  EXPECT_NE(cache.of(surfaces.a, mesh, NeighbourKind::segments), first);
  EXPECT_NE(cache.of(surfaces.b, mesh, NeighbourKind::with_cut), first);
  const std::weak_ptr<const Neighbours> watched = first;
  first.reset();
  EXPECT_TRUE(watched.expired());
  EXPECT_EQ(cache.of(surfaces.a, mesh, NeighbourKind::with_cut)->at(surfaces.a.nodes.node[0]).size(), 1U);
}

}  // namespace
}  // namespace gapcheck::contact::contact_side_test
