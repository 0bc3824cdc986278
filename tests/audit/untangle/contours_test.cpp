#include "audit/untangle/contours.hpp"

#include "audit/untangle/surfaces.hpp"

namespace gapcheck::audit_test::contours_test {
namespace {

const Plate ground{.id = 1, .nx = 8, .ny = 6};

TEST(Contours, OneLineOfThroughPlatesIsOneContour) {
  ContactScene scene(upright_deck(ground, 17.0, 6.0, -2.0, 3, 2));
  const auto pairs = scene.crossings();
  const auto contours = audit::find_contours(scene.model->mesh, pairs);
  ASSERT_EQ(contours.size(), 1u);
  EXPECT_EQ(contours[0].pairs, pairs.size());
  // The upright plate's lowest row, and the elements of the ground from y = 5 to 25 at x = 15 … 20.
  const auto lowest = std::vector{scene.shell(2001), scene.shell(2002), scene.shell(2003)};
  const auto below = std::vector{scene.shell(1012), scene.shell(1020), scene.shell(1028), scene.shell(1036)};
  const bool turned = contours[0].elements[0] == lowest;
  EXPECT_EQ(contours[0].elements[turned ? 0 : 1], lowest);
  EXPECT_EQ(contours[0].elements[turned ? 1 : 0], below);
}

TEST(Contours, PlacesApartAreSeparate) {
  const Plate wide{.id = 1, .nx = 16, .ny = 4};
  std::string text = upright_deck(wide, 12.0, 6.0, -2.0, 1, 1);
  ContactScene one(text);
  ASSERT_EQ(audit::find_contours(one.model->mesh, one.crossings()).size(), 1u);
  // The same pairs and those of another line, in any order.
  const std::vector<audit::ElementPair> pairs{{one.shell(1003), one.shell(1060)},
                                              {one.shell(1019), one.shell(1044)},
                                              {one.shell(1013), one.shell(1001)},
                                              {one.shell(1060), one.shell(1020)}};
  const auto contours = audit::find_contours(one.model->mesh, pairs);
  ASSERT_EQ(contours.size(), 2u);
  EXPECT_EQ(contours[0].pairs, 3u);
  EXPECT_EQ(contours[1].pairs, 1u);
  // The last pair is turned: 1020 is beside 1003 and 1019.
  EXPECT_EQ(contours[0].elements[0], (std::vector{one.shell(1003), one.shell(1019), one.shell(1020)}));
  EXPECT_EQ(contours[0].elements[1], (std::vector{one.shell(1044), one.shell(1060)}));
}

TEST(Contours, NoneWithoutPairs) {
  ContactScene scene(plates_deck(ground));
  EXPECT_TRUE(audit::find_contours(scene.model->mesh, {}).empty());
}

}  // namespace
}  // namespace gapcheck::audit_test::contours_test
