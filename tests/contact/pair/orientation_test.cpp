#include "contact/pair/orientation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "contact/pair/side_scene.hpp"
#include "contact/scene.hpp"

namespace gapcheck::contact::orientation_test {
namespace {

const Vector ex{1, 0, 0}, ey{0, 1, 0};

/// How many segments of the reference plate, which looks up, are turned: the tracked plate lies at `above`.
std::size_t turned(const Vector& above) {
  Scene scene;
  scene.plate(scene.part(1, 1), above, ex, ey, 3, 3);
  scene.plate(scene.part(2, 1), {0, 0, 0}, ex, ey, 3, 3);
  model::Contact& contact = scene.contact("ONE_WAY_SURFACE_TO_SURFACE");
  contact.a = {1, 3, 0, true};
  contact.b = {2, 3, 0, true};
  SurfaceStore surfaces(scene.model);
  const ContactIndex first{0};
  const SideScene side(scene.model, first, surfaces.at(first), false, scene.model.mesh.nodes.x);
  const std::vector<bool> flipped = flipped_segments(side.scene(), *make_brute_force());
  return static_cast<std::size_t>(std::count(flipped.begin(), flipped.end(), true));
}

TEST(Orientation, SegmentsTurnToTheSideOfTheNodes) {
  EXPECT_EQ(turned({0.3, 0.3, 0.5}), 0U);
  EXPECT_EQ(turned({0.3, 0.3, -0.5}), 9U);
}

// With like meshes every node is straight below a corner, inside no segment.
TEST(Orientation, NodesStraightBelowCornersCount) {
  EXPECT_EQ(turned({0, 0, -0.5}), 9U);
  EXPECT_EQ(turned({0.5, 0, -0.5}), 9U) << "below edges";
}

// What rounding leaves of a distance is no side.
TEST(Orientation, NodesOnTheSurfaceDoNotCount) { EXPECT_EQ(turned({0.3, 0.3, -1e-16}), 0U); }

}  // namespace
}  // namespace gapcheck::contact::orientation_test
