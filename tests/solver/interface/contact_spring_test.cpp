#include "solver/interface/contact_spring.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/surface/contact_surfaces.hpp"
#include "model/read.hpp"

namespace gapcheck::solver::contact_spring_test {
namespace {

// VDC / 100 · 2 m ω with m the smaller mass and ω² = k (m1 + m2) / (m1 m2): ω = 2.5 for k = 5, m1 = 1, m2 = 4.
TEST(ContactSprings, DampingIsAPercentageOfTheCriticalOne) {
  for (const auto& [node, segment] : {std::pair{1., 4.}, {4., 1.}}) {
    const ContactSprings::Spring spring{5, node, segment};
    EXPECT_NEAR(ContactSprings::damping(spring, 20), 0.2 * 2 * 1 * 2.5, 1e-15);
    EXPECT_NEAR(ContactSprings::damping(spring, 100), 2 * 2.5, 1e-14);
    EXPECT_EQ(ContactSprings::damping(spring, 0), 0);
    EXPECT_EQ(ContactSprings::damping(spring, -20), 0);
  }
  EXPECT_EQ(ContactSprings::damping({5, 0, 4}, 20), 0);
  EXPECT_EQ(ContactSprings::damping({5, 1, 0}, 20), 0);
}

/// Part 1: a square of 2 by 2, beside it an oblong of 4 by 2 and a triangle of area 2; part 2 far below. K = 1000
/// / 1.5.
constexpr const char* two_parts =
    "*NODE\n1,0.,0.\n2,2.,0.\n3,2.,2.\n4,0.,2.\n5,6.,0.\n6,6.,2.\n7,8.,1.\n11,0.,0.,-9.\n12,1.,0.,-9.\n13,1.,1.,-9.\n"
    "14,0.,1.,-9.\n*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,2,5,6,3\n3,1,5,7,6,6\n4,2,11,12,13,14\n*PART\np\n1,1,1\n*"
    "PART\nq\n2,1,1\n"
    "*SECTION_SHELL\n1,2\n2.5\n*MAT_ELASTIC\n1,1e-9,1000.,0.25\n*SET_PART_LIST\n1\n1\n*SET_PART_LIST\n2\n2\n"
    "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,2,2\n0.\n1.,1.\n";

// By hand: k = 0.1 K A / l, with l the longest diagonal or, as printed, the larger of 2.5 and the shorter diagonal; a
// node then has the mean of its segments, by area over four for each time that they list it.
TEST(ContactSprings, DocumentedAndPrinted) {
  const model::Read read = model::read_text(two_parts);
  ASSERT_EQ(read.errors(), 0u) << read.text();
  contact::SurfaceStore surfaces(read.model);
  const contact::ContactSide& side = surfaces.at(ContactIndex{0}).a;
  const auto node_of = [&](const SideStiffness& table, std::int64_t id) {
    for (std::size_t slot = 0; slot < side.nodes.size(); ++slot)
      if (read.model.mesh.nodes.id[side.nodes.node[slot].value] == id) return table.nodes[slot].least;
    return -1.0;
  };
  const double modulus = 1000 / 1.5;
  const double square = 0.1 * modulus * 4, oblong = 0.1 * modulus * 8, triangle = 0.1 * modulus * 2;
  StiffnessCache documented_tables, printed_tables;
  const ContactMasses documented(read.model), printed(read.model, SpringFormula::printed);
  const auto old_nodes = documented_tables.nodes(documented, side, 0.1, 0, false);
  EXPECT_NEAR(node_of(*old_nodes, 1), square / std::sqrt(8), 1e-9);
  EXPECT_NEAR(node_of(*old_nodes, 2), std::min(square / std::sqrt(8), oblong / std::sqrt(20)), 1e-9);
  EXPECT_NEAR(node_of(*old_nodes, 7), triangle / std::sqrt(5), 1e-9);
  const auto new_nodes = printed_tables.nodes(printed, side, 0.1, 0, false);
  EXPECT_NEAR(node_of(*new_nodes, 1), square / std::sqrt(8), 1e-9) << "the diagonal is longer than 2.5";
  EXPECT_NEAR(node_of(*new_nodes, 2), (4 * square / std::sqrt(8) + 8 * oblong / std::sqrt(20)) / 12, 1e-9);
  EXPECT_NEAR(node_of(*new_nodes, 7), triangle / 2.5, 1e-9) << "the diagonals are 2 and the root of 5";
  EXPECT_NEAR(node_of(*new_nodes, 5), (8 * oblong / std::sqrt(20) + 2 * triangle / 2.5) / 10, 1e-9);
  EXPECT_NEAR(node_of(*new_nodes, 6), (8 * oblong / std::sqrt(20) + 2 * 2 * triangle / 2.5) / 12, 1e-9)
      << "the triangle lists it twice";
  const auto segments = printed_tables.segments(printed, side, 0.1, 0);
  ASSERT_EQ(segments->segments.size(), 3u);
  EXPECT_NEAR(*std::min_element(segments->segments.begin(), segments->segments.end()), triangle / 2.5, 1e-9);
}

}  // namespace
}  // namespace gapcheck::solver::contact_spring_test
