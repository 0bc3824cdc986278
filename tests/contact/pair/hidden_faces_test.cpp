#include "contact/pair/hidden_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "contact/scene.hpp"

namespace gapcheck::contact::hidden_faces_test {
namespace {

/// A block from x = 0 to 10 and y = 0 to 10, flat at z = 10, whose underside rises from z = 0 to z = 8. Above its
/// underside at x it is 10 - 0.8 x thick, yet as seen from its top it reaches 10 deep everywhere.
struct Wedge {
  Scene scene;
  std::array<NodeIndex, 8> nodes{};
  Wedge() {
    const auto at = [&](double x, double y, double z) { return scene.node({x, y, z}); };
    nodes = {at(0, 0, 0),  at(10, 0, 8),  at(10, 10, 8),  at(0, 10, 0),
             at(0, 0, 10), at(10, 0, 10), at(10, 10, 10), at(0, 10, 10)};
    scene.solid(scene.part(1, 0), nodes);
    scene.part(2, 0.2);
    scene.model.sets.parts[1].members = {PartIndex{0}, PartIndex{1}};
  }
  void cover_underside() { scene.shell(PartIndex{1}, {nodes[0], nodes[1], nodes[2], nodes[3]}); }
  void cover_top() { scene.shell(PartIndex{1}, {nodes[4], nodes[5], nodes[6], nodes[7]}); }

  InitialState with_node(const Vector& x) {
    scene.model.sets.nodes[5].members = {scene.node(x)};
    auto& c = scene.contact("AUTOMATIC_NODES_TO_SURFACE");
    c.a = {5, 4, 0, true};
    c.b = {1, 2, 0, true};
    return scene.run();
  }
};

TEST(HiddenFaces, BelowACoveredUndersideIsOutside) {
  for (const bool covered : {false, true}) {
    Wedge wedge;
    if (covered) wedge.cover_underside();
    EXPECT_TRUE(wedge.with_node({9, 5, 4}).penetrations.empty()) << covered;
  }
}

TEST(HiddenFaces, AboveACoveredUndersideIsInside) {
  // Nearer to the underside (0.78) than to any other face, beyond the reach of the shell on it.
  Wedge wedge;
  wedge.cover_underside();
  const InitialState state = wedge.with_node({5, 5, 5});
  ASSERT_EQ(state.penetrations.size(), 1U);
  EXPECT_NEAR(state.penetrations[0].depth, 5, 1e-9);
}

TEST(HiddenFaces, ACoveredTopHidesNothingElse) {
  // Inside, 0.5 from the side x = 10.
  Wedge wedge;
  wedge.cover_top();
  const InitialState state = wedge.with_node({9.5, 5, 9});
  ASSERT_EQ(state.penetrations.size(), 1U);
  EXPECT_NEAR(state.penetrations[0].depth, 0.5, 1e-9);
}

/// Penetrations of a node inside or below the body in a contact that has only its top as a segment.
std::size_t found_by_the_top(Wedge& wedge, bool inside) {
  wedge.scene.model.sets.segments[7].members = {{wedge.nodes[4], wedge.nodes[5], wedge.nodes[6], wedge.nodes[7]}};
  wedge.scene.model.sets.nodes[5].members = {wedge.scene.node({9, 5, inside ? 7.5 : 4})};
  auto& c = wedge.scene.contact("AUTOMATIC_NODES_TO_SURFACE");
  c.a = {5, 4, 0, true};
  c.b = {7, 0, 0, true};
  return wedge.scene.run().penetrations.size();
}

TEST(HiddenFaces, FacesThatTheContactDoesNotName) {
  for (const bool inside : {false, true}) {
    Wedge wedge;
    EXPECT_EQ(found_by_the_top(wedge, inside), inside ? 1U : 0U);
  }
}

// The same body as a thick shell.
TEST(HiddenFaces, OfThickShellsToo) {
  for (const bool inside : {false, true}) {
    Wedge wedge;
    model::Mesh& mesh = wedge.scene.model.mesh;
    mesh.thick_shells = std::exchange(mesh.solids, {});
    EXPECT_EQ(found_by_the_top(wedge, inside), inside ? 1U : 0U);
  }
}

TEST(HiddenFaces, ShellsThatCoatABodyAreOnItsSurface) {
  // As another surface: the top is a segment, of which the coat's nodes are corners, and the underside lies below them.
  for (const char* keyword : {"AUTOMATIC_SURFACE_TO_SURFACE", "AUTOMATIC_NODES_TO_SURFACE", "NODES_TO_SURFACE"}) {
    Wedge wedge;
    wedge.cover_top();
    auto& c = wedge.scene.contact(keyword);
    c.a = {2, 3, 0, true};
    c.b = {1, 3, 0, true};
    EXPECT_TRUE(wedge.scene.run().penetrations.empty()) << keyword;
  }
}

TEST(HiddenFaces, OtherBodiesDoNotCount) {
  // A second, covered block whose top the node is just above, inside the first one.
  Wedge wedge;
  wedge.scene.brick(PartIndex{0}, {3, 3, 3}, {2, 2, 2});
  const auto n = wedge.scene.model.mesh.solids.nodes[1];
  wedge.scene.shell(PartIndex{1}, {n[4], n[5], n[6], n[7]});
  const InitialState state = wedge.with_node({4, 4, 6});
  ASSERT_EQ(state.penetrations.size(), 1U);
  // From the first block's underside, z = 0.8 x.
  EXPECT_NEAR(state.penetrations[0].depth, (6 - 0.8 * 4) / std::hypot(1, 0.8), 1e-9);
}

}  // namespace
}  // namespace gapcheck::contact::hidden_faces_test
