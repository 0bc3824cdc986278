#include "contact/surface/thickness.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace gapcheck::contact::thickness_test {
namespace {

TEST(Thickness, PartContactThenCardThenGlobalThenElement) {
  ThicknessSide side;
  side.scale = 1.5;
  model::PartContact part;
  EXPECT_DOUBLE_EQ(shell_thickness(2, 10, &part, false, side).value, 3);
  side.global_value = 4;
  EXPECT_EQ(shell_thickness(2, 10, &part, false, side).rule, ThicknessRule::global);
  side.override_value = 0.5;
  EXPECT_DOUBLE_EQ(shell_thickness(2, 10, &part, false, side).value, 0.5);
  part.optt = 7;
  const Thickness t = shell_thickness(2, 10, &part, false, side);
  EXPECT_DOUBLE_EQ(t.value, 7);
  EXPECT_EQ(t.rule, ThicknessRule::part_contact);
}

TEST(Thickness, EdgeLimitBitesOnlyOnTheElementsOwn) {
  ThicknessSide side;
  side.edge_limit = true;
  EXPECT_DOUBLE_EQ(shell_thickness(3, 5, nullptr, false, side).value, 2);
  EXPECT_EQ(shell_thickness(3, 5, nullptr, false, side).rule, ThicknessRule::edge_limit);
  EXPECT_DOUBLE_EQ(shell_thickness(1.5, 5, nullptr, false, side).value, 1.5);
  side.override_value = 3;
  EXPECT_DOUBLE_EQ(shell_thickness(1, 5, nullptr, false, side).value, 3);
}

TEST(Thickness, ScaleOfThePartStandsInForThatOfTheContact) {
  ThicknessSide side;
  side.scale = 0.5;
  model::PartContact part;
  EXPECT_DOUBLE_EQ(shell_thickness(2, 10, &part, false, side).value, 1);
  part.sft = 0.8;
  EXPECT_DOUBLE_EQ(shell_thickness(2, 10, &part, false, side).value, 1.6);
  EXPECT_DOUBLE_EQ(beam_thickness(1, &part, side).value, 1.6);
}

// TH_SF multiplies what elements have, and no thickness of a card.
TEST(Thickness, GlobalScale) {
  model::Contact contact;
  contact.sfst = 2;
  ContactSettings settings;
  settings.shlthk = 2;
  model::Controls controls;
  model::PartContact part;
  const auto thickness = [&](bool b) {
    return shell_thickness(1.5, 10, &part, false, thickness_side(contact, settings, controls, b)).value;
  };
  EXPECT_DOUBLE_EQ(thickness(false), 1.5 * 2);
  controls.th_sf = 0.7;
  EXPECT_DOUBLE_EQ(thickness(false), 1.5 * 2 * 0.7);
  EXPECT_DOUBLE_EQ(thickness(true), 1.5 * 0.7);
  EXPECT_DOUBLE_EQ(beam_thickness(0.5, &part, thickness_side(contact, settings, controls, false)).value, 2 * 0.7);
  part.sft = 0.8;
  EXPECT_DOUBLE_EQ(thickness(false), 1.5 * 0.8 * 0.7);
  controls.th = 3;
  EXPECT_DOUBLE_EQ(thickness(false), 3);
  contact.mst = 0.25;
  EXPECT_DOUBLE_EQ(thickness(true), 0.25);
}

TEST(Thickness, SidesWhoseShellThicknessIsIgnored) {
  model::Contact contact;
  contact.sst = contact.mst = 2;
  ContactSettings settings;
  settings.shlthk = 2;
  const auto thickness = [&](bool b) {
    return shell_thickness(1, 10, nullptr, false, thickness_side(contact, settings, {}, b)).value;
  };
  for (const auto& [flag, a, b] :
       {std::tuple{0, 2., 2.}, std::tuple{1, 2., 0.}, std::tuple{2, 0., 2.}, std::tuple{3, 0., 0.}}) {
    contact.ignroff = flag;
    EXPECT_EQ(thickness(false), a) << flag;
    EXPECT_EQ(thickness(true), b) << flag;
  }
}

TEST(Thickness, ChangesForATrial) {
  ThicknessSide side;
  side.override_value = 0.5;
  side.global_value = 4;
  side.scale = 1.5;
  model::PartContact part;
  part.optt = 7;
  const ThicknessSide own = changed(side, {.own = true});
  EXPECT_DOUBLE_EQ(shell_thickness(2, 10, &part, false, own).value, 3);
  EXPECT_DOUBLE_EQ(beam_thickness(2, &part, own).value, 6);
  const ThicknessSide card = changed(side, {.card = 0.25});
  EXPECT_DOUBLE_EQ(shell_thickness(2, 10, nullptr, false, card).value, 0.25);
  EXPECT_DOUBLE_EQ(shell_thickness(2, 10, &part, false, card).value, 7);
  EXPECT_DOUBLE_EQ(shell_thickness(2, 10, nullptr, false, changed(side, {})).value, 0.5);
}

TEST(Thickness, ShlthkOfOldTypes) {
  ThicknessSide side;
  side.override_value = 1;
  side.shlthk = 0;
  EXPECT_EQ(shell_thickness(2, 10, nullptr, false, side).value, 0);
  side.shlthk = 1;
  EXPECT_EQ(shell_thickness(2, 10, nullptr, true, side).value, 0);
  EXPECT_EQ(shell_thickness(2, 10, nullptr, false, side).value, 1);
  side.shlthk = 2;
  EXPECT_EQ(shell_thickness(2, 10, nullptr, true, side).value, 1);
}

TEST(Thickness, ElementValueGoesBeforeSectionAndIsAveraged) {
  model::Model m;
  model::Section section;
  section.thickness = {2, 2, 2, 2};
  m.sections.push_back(section);
  model::Part part;
  part.section = 0;
  m.parts.push_back(part);
  auto& shells = m.mesh.shells;
  for (std::uint32_t e = 0; e < 3; ++e) {
    shells.id.push_back(e + 1);
    shells.part.push_back(PartIndex{0});
    shells.nodes.push_back({NodeIndex{0}, NodeIndex{1}, NodeIndex{2}, NodeIndex{e == 2 ? 2U : 3U}});
  }
  shells.own_thickness = {{1, {1, 1, 3, 3}}, {2, {1, 2, 3, 9}}};
  EXPECT_DOUBLE_EQ(element_thickness(m, 0), 2);
  EXPECT_DOUBLE_EQ(element_thickness(m, 1), 2);
  EXPECT_DOUBLE_EQ(element_thickness(m, 2), 2);  // a triangle has three corners
  m.parts[0].composite_thickness = 5;
  EXPECT_DOUBLE_EQ(element_thickness(m, 1), 5);
}

// NLOC = 1: the nodes are on top, so the mid-surface is half a thickness below them.
TEST(Thickness, MidSurfaceByNlocOrTheElementsOwnOffset) {
  model::Model m;
  model::Section section;
  section.thickness.fill(3);
  m.sections.push_back(section);
  model::Part part;
  part.section = 0;
  m.parts.push_back(part);
  auto& shells = m.mesh.shells;
  for (std::uint32_t e = 0; e < 2; ++e) {
    shells.id.push_back(e + 1);
    shells.part.push_back(e == 0 ? PartIndex{0} : none<PartIndex>);
    shells.nodes.push_back({NodeIndex{0}, NodeIndex{1}, NodeIndex{2}, NodeIndex{3}});
  }
  for (const double nloc : {1.0, -1.0, 0.5, 0.0}) {
    m.sections[0].nloc = nloc;
    EXPECT_EQ(mid_surface_offset(m, 0), -1.5 * nloc);
    EXPECT_EQ(mid_surface_offset(m, 1), 0) << "no part";
  }
  m.sections[0].nloc = 1;
  shells.own_offset = {{0, 0.25}};
  EXPECT_EQ(mid_surface_offset(m, 0), 0.25);
}

}  // namespace
}  // namespace gapcheck::contact::thickness_test
