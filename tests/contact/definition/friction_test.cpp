#include "contact/definition/friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/scene.hpp"

namespace gapcheck::contact::friction_test {
namespace {

model::Contact named(const std::string& keyword) {
  model::Contact contact;
  set_name("CONTACT_" + keyword, contact);
  return contact;
}

TEST(Friction, TypesThatTakeIt) {
  for (const char* keyword : {"AUTOMATIC_NODES_TO_SURFACE", "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE",
                              "AUTOMATIC_SURFACE_TO_SURFACE", "AUTOMATIC_SINGLE_SURFACE", "AUTOMATIC_GENERAL",
                              "SINGLE_SURFACE", "ERODING_SINGLE_SURFACE", "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR"}) {
    EXPECT_TRUE(takes_part_friction(named(keyword))) << keyword;
    EXPECT_TRUE(takes_friction_table(named(keyword))) << keyword;
  }
  EXPECT_TRUE(takes_part_friction(named("AIRBAG_SINGLE_SURFACE")));
  EXPECT_FALSE(takes_friction_table(named("AIRBAG_SINGLE_SURFACE")));
  for (const char* keyword : {"SURFACE_TO_SURFACE", "ERODING_SURFACE_TO_SURFACE", "FORMING_SURFACE_TO_SURFACE"})
    EXPECT_FALSE(takes_part_friction(named(keyword))) << keyword;
}

TEST(Friction, NoneInTiesAndTransducers) {
  EXPECT_TRUE(has_friction(named("SURFACE_TO_SURFACE")));
  EXPECT_FALSE(has_friction(named("TIED_SURFACE_TO_SURFACE")));
  EXPECT_FALSE(has_friction(named("FORCE_TRANSDUCER_PENALTY")));
}

TEST(Friction, CoefficientDecaysFromStaticToSliding) {
  const model::FrictionLaw law{0.3, 0.1, 2, 0};
  EXPECT_DOUBLE_EQ(friction_coefficient(law, 0), 0.3);
  EXPECT_DOUBLE_EQ(friction_coefficient(law, 0.5), 0.1 + 0.2 * std::exp(-1.0));
  EXPECT_DOUBLE_EQ(friction_coefficient({0.3, 0.1, 0, 0}, 5), 0.3);  // without a decay there is FS alone
  EXPECT_DOUBLE_EQ(friction_limit(law, 0, 10, 2), 3);
  EXPECT_DOUBLE_EQ(friction_limit({0.3, 0.1, 2, 1.25}, 0, 10, 2), 2.5);
  EXPECT_DOUBLE_EQ(friction_limit({0.3, 0.1, 2, 1.25}, 0, 5, 2), 1.5);
}

struct FrictionOf : Scene {
  PartIndex a = part(1, 1), b = part(2, 1), c = part(3, 1);
  FrictionOf() { contact("AUTOMATIC_SINGLE_SURFACE"); }
  model::Contact& card() { return model.contacts[0]; }
  model::FrictionLaw between(PartIndex node, PartIndex segment) {
    return Friction(model, card()).between(node, segment);
  }
};

TEST(Friction, OfTheContactCard) {
  FrictionOf scene;
  EXPECT_FALSE(Friction(scene.model, scene.card()).any());
  scene.card().fs = 0.2;
  scene.card().fd = 0.1;
  scene.card().vc = 3;
  scene.card().fsf = 0.5;
  scene.card().vsf = 2;
  EXPECT_TRUE(Friction(scene.model, scene.card()).any());
  const model::FrictionLaw law = scene.between(scene.a, scene.b);
  EXPECT_DOUBLE_EQ(law.fs, 0.1);
  EXPECT_DOUBLE_EQ(law.fd, 0.05);
  EXPECT_DOUBLE_EQ(law.vc, 6);
}

TEST(Friction, OfTheParts) {
  FrictionOf scene;
  scene.card().fs = friction_of_parts;
  EXPECT_FALSE(Friction(scene.model, scene.card()).any());
  scene.model.parts[1].contact = model::PartContact{.fs = 0.4, .fd = 0.3, .dc = 1};
  scene.model.controls.sfric = 0.05;
  EXPECT_TRUE(Friction(scene.model, scene.card()).any());
  EXPECT_EQ(scene.between(scene.a, scene.b).fs, 0.4);  // of the segment's part
  EXPECT_EQ(scene.between(scene.b, scene.a).fs, 0.4);  // of the node's, since the segment's has none
  EXPECT_EQ(scene.between(scene.a, scene.c).fs, 0.05);
  EXPECT_EQ(scene.between(none<PartIndex>, none<PartIndex>).fs, 0.05);
}

TEST(Friction, OfTheTable) {
  FrictionOf scene;
  scene.card().fs = friction_by_table;
  scene.card().fd = 7;
  EXPECT_FALSE(Friction(scene.model, scene.card()).any());
  model::FrictionTable table;
  table.others = {0.1, 0.1, 0, 0};
  table.rows = {{1, 2, false, false, {0.2, 0.2, 0, 0}}, {5, 3, true, false, {0.3, 0.3, 0, 0}}};
  scene.model.friction_tables[7] = table;
  scene.model.friction_tables[8] = {};
  scene.model.sets.parts[5].members = {scene.a, scene.b};
  EXPECT_EQ(scene.between(scene.b, scene.a).fs, 0.2);
  EXPECT_EQ(scene.between(scene.c, scene.b).fs, 0.3);
  EXPECT_EQ(scene.between(scene.a, scene.a).fs, 0.1);
  // Rows that name what the deck does not have say nothing, whichever side that is; the last row that names a pair
  // counts.
  auto& rows = scene.model.friction_tables[7].rows;
  rows.push_back({1, 99, false, false, {0.4, 0.4, 0, 0}});
  rows.push_back({99, 1, true, false, {0.4, 0.4, 0, 0}});
  rows.push_back({2, 1, false, false, {0.5, 0.5, 0, 0}});
  EXPECT_EQ(scene.between(scene.a, scene.a).fs, 0.1);
  EXPECT_EQ(scene.between(scene.a, scene.c).fs, 0.3);
  EXPECT_EQ(scene.between(scene.a, scene.b).fs, 0.5);
  for (const double fd : {9., 1e29, -1e29}) {  // no such table, and two to choose from
    scene.card().fd = fd;
    EXPECT_FALSE(Friction(scene.model, scene.card()).any());
  }
}

// Rows of sets whose pairs are too many to write out say the same as rows of single parts, in the same order.
TEST(Friction, RowsOfManyParts) {
  FrictionOf scene;
  scene.card().fs = friction_by_table;
  scene.card().fd = 7;
  const auto first = static_cast<std::uint32_t>(scene.model.parts.size());
  constexpr std::uint32_t many = 1200;
  scene.model.parts.resize(first + many);
  const auto part = [&](std::uint32_t i) { return PartIndex{first + i}; };
  for (std::uint32_t i = many; i-- > 0;) scene.model.sets.parts[5].members.push_back(part(i));
  for (std::uint32_t i = 0; i < many; i += 2) scene.model.sets.parts[6].members.push_back(part(i));
  scene.model.sets.parts[8].members = {scene.a};
  model::FrictionTable& table = scene.model.friction_tables[7];
  table.others = {0.1, 0.1, 0, 0};
  table.rows = {{8, 5, true, true, {0.6, 0.6, 0, 0}},
                {5, 6, true, true, {0.2, 0.2, 0, 0}},
                {8, 5, true, true, {0.3, 0.3, 0, 0}},
                {6, 6, true, true, {0.4, 0.4, 0, 0}}};
  EXPECT_EQ(scene.between(part(3), part(1)).fs, 0.1) << "set 6 has even parts only";
  EXPECT_EQ(scene.between(part(3), part(2)).fs, 0.2);
  EXPECT_EQ(scene.between(part(2), part(3)).fs, 0.2);
  EXPECT_EQ(scene.between(part(1198), part(4)).fs, 0.4) << "the last row counts";
  EXPECT_EQ(scene.between(scene.a, part(7)).fs, 0.3);
  EXPECT_EQ(scene.between(scene.b, part(7)).fs, 0.1);
  table.others = {};
  table.rows = {{5, 6, true, true, {0.2, 0.2, 0, 0}}, {8, 5, true, true, {}}};
  EXPECT_TRUE(Friction(scene.model, scene.card()).any());
  table.rows.push_back({6, 5, true, true, {}});
  EXPECT_EQ(scene.between(part(3), part(2)).fs, 0);
}

}  // namespace
}  // namespace gapcheck::contact::friction_test
