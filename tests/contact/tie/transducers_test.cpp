#include "contact/tie/transducers.hpp"

#include <gtest/gtest.h>

#include "contact/scene.hpp"

namespace gapcheck::contact::transducers_test {
namespace {

/// A row of five shells; sides are runs of shells, or nodes.
struct Row {
  Scene scene;
  std::vector<Selection> sides;

  Row() { scene.plate(scene.part(1, 1), {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 5, 1); }
  Selection shells(std::uint32_t first, std::uint32_t count) const {
    Selection side;
    for (std::uint32_t e = first; e < first + count; ++e) {
      side.segments.nodes.push_back(scene.model.mesh.shells.nodes[e]);
      side.segments.element.push_back(e);
      side.segments.element_kind.push_back(model::ElementKind::shell);
      side.segments.kind.push_back(SegmentKind::shell);
    }
    return side;
  }
  Selection node(std::uint32_t n) const {
    Selection side;
    side.nodes.push_back(NodeIndex(n));
    return side;
  }
  [[nodiscard]] std::optional<std::uint32_t> second_of(const Selection& a, const Selection& b, const Selection& c,
                                                       const Selection& d) const {
    return overlapping_transducers(scene.model.mesh, {{&a, &b}, {&c, &d}}).at(1);
  }
};

TEST(Transducers, ShareBothSides) {
  const Row row;
  EXPECT_EQ(row.second_of(row.shells(0, 2), row.shells(3, 1), row.shells(1, 1), row.shells(3, 2)), 0u);
  EXPECT_EQ(row.second_of(row.shells(0, 2), row.shells(3, 1), row.shells(3, 2), row.shells(1, 1)), 0u);
  EXPECT_EQ(row.second_of(row.shells(0, 2), row.shells(3, 1), row.shells(1, 1), row.shells(4, 1)), std::nullopt);
  // Shells 1 and 2 share nodes, but no force acts on both.
  EXPECT_EQ(row.second_of(row.shells(0, 2), row.shells(4, 1), row.shells(2, 1), row.shells(4, 1)), std::nullopt);
}

TEST(Transducers, NodesMeetTheSegmentsTheyBelongTo) {
  const Row row;
  EXPECT_EQ(row.second_of(row.node(1), row.shells(3, 1), row.shells(0, 1), row.shells(3, 1)), 0u);
  EXPECT_EQ(row.second_of(row.node(1), row.shells(3, 1), row.shells(2, 1), row.shells(3, 1)), std::nullopt);
}

TEST(Transducers, MoreThanAreCompared) {
  const Row row;
  const Selection a = row.shells(0, 1), b = row.shells(4, 1);
  const auto earlier =
      overlapping_transducers(row.scene.model.mesh, std::vector<Transducer>(max_transducers + 3, {&a, &b}));
  ASSERT_EQ(earlier.size(), max_transducers + 3);
  EXPECT_EQ(earlier[max_transducers - 1], 0u);
  EXPECT_EQ(earlier[max_transducers], std::nullopt);
}

}  // namespace
}  // namespace gapcheck::contact::transducers_test
