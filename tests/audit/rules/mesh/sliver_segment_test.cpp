#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::sliver_segment_test {
namespace {

Report plate_of(double dx, double dy) {
  RuleDeck deck;
  deck.shell_part(1, 0.1).plate(1, 1, 1, 2, Vector(0, 0, 0), dx, dy);
  return run_rule("GC506", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"));
}

// 10 x 0.4: 4 / 100 = 0.04; 10 x 0.6: 0.06.
TEST(SliverSegment, BelowATwentieth) {
  const Report report = plate_of(10, 0.4);
  ASSERT_EQ(listed(report), 2U);
  EXPECT_EQ(report.findings[0].element, 1);
  EXPECT_NE(report.findings[0].message.find("0.4 high and 10 long, a ratio of 0.04"), std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(plate_of(10, 0.6)), 0U);
}

TEST(SliverSegment, TrianglesByTheirAltitude) {
  const auto triangle = [](double altitude) {
    RuleDeck deck;
    deck.shell_part(1, 0.1).node(1, {0, 0, 0}).node(2, {10, 0, 0}).node(3, {5, altitude, 0}).shell(1, 1, {1, 2, 3});
    return listed(run_rule("GC506", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0")));
  };
  EXPECT_EQ(triangle(0.45), 1U);
  EXPECT_EQ(triangle(0.55), 0U);
}

TEST(SliverSegment, NotTheSidesOfAThinBrick) {
  const auto brick = [](double x, double y, double z) {
    RuleDeck deck;
    deck.solid_part(1).block(1, 1, 1, 1, 1, {0, 0, 0}, {x, y, z});
    return listed(run_rule("GC506", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0")));
  };
  EXPECT_EQ(brick(20, 20, 0.5), 0U);
  EXPECT_EQ(brick(20, 0.5, 0.5), 4U);  // a needle has no face that is sound beside its ends
}

}  // namespace
}  // namespace gapcheck::audit_test::sliver_segment_test
