#include "contact/definition/same_surface.hpp"

#include <gtest/gtest.h>

#include "contact/scene.hpp"

namespace gapcheck::contact::same_surface_test {
namespace {

/// Parts 1 and 2; part sets 1 = {1}, 2 = {2, 1}, 3 = {}; node sets 1 = {n0, n1}, 2 = {n1, n0}.
Scene two_parts() {
  Scene scene;
  const PartIndex one = scene.part(1, 1), two = scene.part(2, 1);
  auto& parts = scene.model.sets.parts;
  parts[1].members = {one};
  parts[2].members = {two, one};
  parts[3].members = {};
  scene.model.sets.branches[2].members = {one};
  const NodeIndex a = scene.node({0, 0, 0}), b = scene.node({1, 0, 0});
  scene.model.sets.nodes[1].members = {a, b};
  scene.model.sets.nodes[2].members = {b, a};
  return scene;
}

bool same(std::int64_t id_a, std::int64_t type_a, std::int64_t id_b, std::int64_t type_b, std::int64_t box_b = 0) {
  return same_surface(two_parts().model, {id_a, type_a, 0, true}, {id_b, type_b, box_b, true});
}

TEST(SameSurface, PartsInAnyForm) {
  EXPECT_TRUE(same(1, 3, 1, 3));
  EXPECT_TRUE(same(1, 3, 1, 2));
  EXPECT_TRUE(same(2, 2, 0, 5));
  EXPECT_TRUE(same(1, 6, 2, 3));  // all but part 1
  EXPECT_TRUE(same(1, 3, 2, 7));  // branch 2 is part 1
  EXPECT_FALSE(same(2, 2, 2, 7));
  EXPECT_FALSE(same(3, 7, 3, 7));  // there is none
  EXPECT_FALSE(same(1, 3, 2, 3));
  EXPECT_FALSE(same(1, 2, 2, 2));
  EXPECT_FALSE(same(1, 3, 1, 3, 9));
}

TEST(SameSurface, OtherSetsByTheirMembers) {
  EXPECT_TRUE(same(1, 4, 2, 4));
  EXPECT_FALSE(same(1, 4, 1, 3));
}

TEST(SameSurface, NothingIsNotTheSame) {
  EXPECT_FALSE(same(3, 2, 3, 2));
  EXPECT_FALSE(same(99, 2, 99, 2));
  EXPECT_FALSE(same(99, 0, 99, 0));
  EXPECT_FALSE(same(99, 3, 99, 3));
  EXPECT_FALSE(same(0, -1, 0, -1));
  EXPECT_FALSE(same(0, 99, 0, 99));
}

}  // namespace
}  // namespace gapcheck::contact::same_surface_test
