#include "solver/start/start_elements.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "contact/stiffness/element_sizes.hpp"
#include "model/read.hpp"

namespace gapcheck::solver::start_elements_test {
namespace {

/// A unit cube, its material's speed of sound squared being E (1 - nu) / ((1 + nu) (1 - 2 nu) rho).
const char* const cube =
    "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,0.,0.,1.\n6,1.,0.,1.\n7,1.,1.,1.\n8,0.,1.,1.\n"
    "*ELEMENT_SOLID\n9,1\n1,2,3,4,5,6,7,8\n*PART\np\n1,1,1\n*SECTION_SOLID\n1,2\n*MAT_ELASTIC\n1,1.,1.,0.\n";

std::vector<NodeIndex> nodes(std::initializer_list<std::uint32_t> list) {
  std::vector<NodeIndex> all;
  for (const std::uint32_t i : list) all.push_back(NodeIndex{i});
  return all;
}

TEST(StartElements, AFlattenedCube) {
  const model::Model model = model::read_text(cube).model;
  std::vector<Vector> x = model.mesh.nodes.x;
  for (std::size_t i = 4; i < 8; ++i) x[i].z() = 0.25;
  StartElements elements(model, x);
  const auto moved = nodes({4, 5, 6, 7});
  const std::vector<StartElement> list = elements.list_changed(moved, {{NodeIndex{4}, 3}});
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].kind, "solid");
  EXPECT_EQ(list[0].id, 9);
  EXPECT_EQ(list[0].contact, 3);
  EXPECT_NEAR(list[0].before.size, 1, 1e-15);
  EXPECT_NEAR(list[0].after.size, 0.25, 1e-15);
  EXPECT_NEAR(list[0].after.edge_ratio, 4, 1e-15);
  // Volume over largest face: 1 before, 0.25 after; the speed of sound is 1.
  EXPECT_NEAR(list[0].before.step, 1, 1e-15);
  EXPECT_NEAR(list[0].after.step, 0.25, 1e-15);
  EXPECT_FALSE(list[0].collapsed());
  const StartShapes shapes = elements.shapes_at(moved);
  EXPECT_EQ(shapes.touched, 1u);
  EXPECT_EQ(shapes.changed, 1u);
  EXPECT_EQ(shapes.collapsed, 0u);
  EXPECT_EQ(shapes.step, 0u);
  EXPECT_EQ(shapes.edge_ratio, 0u);
  EXPECT_FALSE(shapes.warp);
  EXPECT_NEAR(elements.smallest_step(x), 0.25, 1e-15);
  EXPECT_NEAR(elements.smallest_step(model.mesh.nodes.x), 1, 1e-15);
}

TEST(StartElements, ACubeTurnedInsideOut) {
  const model::Model model = model::read_text(cube).model;
  std::vector<Vector> x = model.mesh.nodes.x;
  for (std::size_t i = 4; i < 8; ++i) x[i].z() = -0.5;
  StartElements elements(model, x);
  const std::vector<StartElement> list = elements.list_changed(nodes({4, 5, 6, 7}), {});
  ASSERT_EQ(list.size(), 1u);
  EXPECT_TRUE(list[0].inverted);
  EXPECT_NEAR(list[0].after.size, -0.5, 1e-15);
}

// One corner of a unit square lifted by 1: the triangles on either side of a diagonal then form an angle whose cosine
// is that of their normals, (0, 0, 1) and (-1, -1, 1) / sqrt 3 for the diagonal beside the corner.
TEST(StartElements, AWarpedShell) {
  const model::Model model = model::read_text(
                                 "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n*ELEMENT_SHELL\n7,1,1,2,3,4\n"
                                 "*PART\np\n1,1,1\n*SECTION_SHELL\n1,2\n1.,1.,1.,1.\n*MAT_ELASTIC\n1,1.,1.,0.\n")
                                 .model;
  std::vector<Vector> x = model.mesh.nodes.x;
  x[2].z() = 1;
  StartElements elements(model, x);
  const std::vector<StartElement> list = elements.list_changed(nodes({2}), {});
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].before.warp, 0);
  const double beside = std::acos(1 / std::sqrt(3.0)) * 180 / M_PI;
  // Across the other diagonal the normals are (0, -1, 1) / sqrt 2 and (-1, 0, 1) / sqrt 2: 60 degrees, the larger one.
  EXPECT_GT(60, beside);
  EXPECT_NEAR(list[0].after.warp, 60, 1e-4);
  EXPECT_NEAR(list[0].after.edge_ratio, std::sqrt(2.0), 1e-14);
  EXPECT_EQ(elements.shapes_at(nodes({2})).warp, 0u);
}

// The steps of single elements are those that the audit lists.
TEST(StartElements, StepsAreThoseOfTheList) {
  std::size_t decks = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(GAPCHECK_ROOT) / "data")) {
    if (entry.path().extension() != ".k") continue;
    Diagnostics diagnostics;
    const auto deck = keyword::read_deck(entry.path().string(), {}, diagnostics);
    ASSERT_TRUE(deck.ok());
    const auto model = model::read_model(deck.value(), diagnostics);
    ASSERT_TRUE(model.ok());
    const double listed =
        contact::smallest_element_timestep(model.value(), contact::element_sizes(model.value())).timestep;
    const std::vector<Vector>& x = model.value().mesh.nodes.x;
    const double least = StartElements(model.value(), x).smallest_step(x);
    // Of steps that are equal but for rounding the list has the first.
    if (listed > 0) {
      EXPECT_NEAR(least, listed, 1e-12 * listed) << entry.path();
    }
    ++decks;
  }
  EXPECT_GT(decks, 30u);
}

TEST(StartElements, AShiftAsAWholeChangesNothing) {
  const model::Model model = model::read_text(cube).model;
  std::vector<Vector> x = model.mesh.nodes.x;
  for (Vector& each : x) each += Vector(1, 2, 3);
  StartElements elements(model, x);
  const auto moved = nodes({0, 1, 2, 3, 4, 5, 6, 7});
  EXPECT_TRUE(elements.list_changed(moved, {}).empty());
  EXPECT_EQ(elements.shapes_at(moved).touched, 1u);
}

}  // namespace
}  // namespace gapcheck::solver::start_elements_test
