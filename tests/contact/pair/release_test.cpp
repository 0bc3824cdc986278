#include "contact/pair/release.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapcheck::contact::release_test {
namespace {

double depth(const std::string& keyword, const ReleasePair& pair, model::Contact c = {},
             model::Controls controls = {}) {
  set_name("CONTACT_" + keyword, c);
  const ContactType type = classify(c);
  return release_depth(c, type, settings(c, type, controls), controls, pair);
}

const ReleasePair shells{.solid_segment = false, .node_thickness = 1, .segment_thickness = 2, .min_diagonal = 10};
const ReleasePair solid{.solid_segment = true, .solid_depth = 5, .min_diagonal = 10};

TEST(Release, AutomaticTypes) {
  EXPECT_DOUBLE_EQ(depth("AUTOMATIC_SINGLE_SURFACE", shells), 0.4 * 3);
  EXPECT_DOUBLE_EQ(depth("AUTOMATIC_SINGLE_SURFACE", solid), 0.5 * 0.4 * 5);
  EXPECT_DOUBLE_EQ(depth("AUTOMATIC_SURFACE_TO_SURFACE", solid), 0.5 * 5);
  EXPECT_DOUBLE_EQ(depth("SINGLE_SURFACE", shells), 0.4 * 3);
  EXPECT_DOUBLE_EQ(depth("AUTOMATIC_GENERAL", shells), 200 * 3);
  model::Contact c;
  c.penmax = 0.1;
  EXPECT_DOUBLE_EQ(depth("AUTOMATIC_SINGLE_SURFACE", shells, c), 0.1 * 3);
  EXPECT_DOUBLE_EQ(depth("AUTOMATIC_GENERAL", shells, c), 0.1 * 3);
  EXPECT_DOUBLE_EQ(depth("SINGLE_SURFACE", shells, c), 0.4 * 3) << "type 4 has no PENMAX";
}

TEST(Release, OldTypesByPenchk) {
  model::Contact c;
  EXPECT_TRUE(std::isinf(depth("SURFACE_TO_SURFACE", shells, c)));
  c.penmax = 0.7;
  EXPECT_DOUBLE_EQ(depth("SURFACE_TO_SURFACE", shells, c), 0.7);
  c.penchk = 2;
  EXPECT_DOUBLE_EQ(depth("SURFACE_TO_SURFACE", shells, c), 0.5);
}

TEST(Release, XpeneCountsTheSegmentsThickness) {
  model::Contact c;
  c.penchk = 1;
  EXPECT_DOUBLE_EQ(depth("SURFACE_TO_SURFACE", shells, c), 4 * 2);
  EXPECT_DOUBLE_EQ(depth("SURFACE_TO_SURFACE", solid, c), 4 * 5);
  model::Controls controls;
  controls.shlthk = 1;
  EXPECT_DOUBLE_EQ(depth("NODES_TO_SURFACE", shells, {}, controls), 4 * 2);
  EXPECT_DOUBLE_EQ(depth("CONSTRAINT_NODES_TO_SURFACE", shells), 4 * 2);
  // A rigid tool has no contact thickness, but its element has one; without any nothing is released.
  ReleasePair tool{.node_thickness = 1, .element_thickness = 3};
  EXPECT_DOUBLE_EQ(depth("FORMING_ONE_WAY_SURFACE_TO_SURFACE", tool), 4 * 3);
  tool.element_thickness = 0;
  EXPECT_TRUE(std::isinf(depth("FORMING_ONE_WAY_SURFACE_TO_SURFACE", tool)));
}

}  // namespace
}  // namespace gapcheck::contact::release_test
