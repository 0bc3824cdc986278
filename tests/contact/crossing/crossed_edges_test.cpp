#include "contact/crossing/crossed_edges.hpp"

#include <gtest/gtest.h>

#include <string>

#include "contact/scene.hpp"

namespace gapcheck::contact::crossed_edges_test {
namespace {

bool looks(const std::string& keyword, std::int64_t soft, std::int64_t depth) {
  Scene scene;
  model::Contact& c = scene.contact(keyword);
  c.soft = soft;
  c.depth = depth;
  return looks_at_edges(c, classify(c));
}

TEST(CrossedEdges, WhichContactsLookAtEdges) {
  const std::string pair = "AUTOMATIC_SURFACE_TO_SURFACE";
  for (const std::int64_t depth : {5, 15, 25, 35, 45, 55}) {
    EXPECT_TRUE(looks(pair, 2, depth)) << depth;
    EXPECT_FALSE(looks(pair, 1, depth)) << "DEPTH means that with SOFT = 2 only";
  }
  for (const std::int64_t depth : {-5, 0, 1, 2, 3, 13, 23, 33}) EXPECT_FALSE(looks(pair, 2, depth)) << depth;
  EXPECT_TRUE(looks("AUTOMATIC_GENERAL", 0, 2));
  EXPECT_FALSE(looks("TIED_SURFACE_TO_SURFACE", 2, 5));
}

/// Two plates of one element in planes at an angle whose rims cross at the origin, in no round numbers.
TEST(CrossedEdges, WithinTheToleranceOfADecimalDeck) {
  const auto count = [](double gap) {
    Scene scene;
    const Vector u(0.6, 0.7, 0.3), v(-0.2, 0.5, 0.9), lift = gap * u.cross(v).normalized();
    scene.plate(scene.part(1, 1), -0.4 * u, u, Vector(1, -1, 0.1), 1, 1);
    scene.plate(scene.part(2, 1), -0.3 * v + lift, v, Vector(-1, -0.3, 0.7), 1, 1);
    scene.contact("AUTOMATIC_GENERAL");
    CrossingCounters counters;
    SurfaceStore surfaces(scene.model);
    return find_crossed_edges(scene.model, ContactIndex{0}, surfaces.at(ContactIndex{0}), {}, counters).size();
  };
  EXPECT_EQ(count(0), 1U);
  EXPECT_EQ(count(5e-6), 1U);
  EXPECT_EQ(count(5e-5), 0U);
}

}  // namespace
}  // namespace gapcheck::contact::crossed_edges_test
