#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::uneven_mesh_test {
namespace {

/// Two shells of 10 x 10 (1, 2) and behind each one of 10 x `width` (3, 4).
Report strip(double width) {
  RuleDeck deck;
  deck.shell_part(1, 0.1);
  for (int i = 0; i < 3; ++i)
    deck.node(1 + i, {10.0 * i, 0, 0}).node(11 + i, {10.0 * i, 10, 0}).node(21 + i, {10.0 * i, 10 + width, 0});
  for (int i = 0; i < 2; ++i)
    deck.shell(1 + i, 1, {1 + i, 2 + i, 12 + i, 11 + i}).shell(3 + i, 1, {11 + i, 12 + i, 22 + i, 21 + i});
  return run_rule("GC511", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"));
}

// sqrt(100) / sqrt(3) = 5.77; 5.02 and 4.98 at widths of 0.397 and 0.403.
TEST(UnevenMesh, MoreThanFiveTimes) {
  const Report report = strip(0.3);
  ASSERT_EQ(listed(report), 2U);
  EXPECT_EQ(report.findings[0].element, 1);
  EXPECT_EQ(report.findings[1].element, 2);
  EXPECT_NE(report.findings[0].message.find("shell 1 of part 1 is 5.77 times as large as shell 3"), std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(strip(0.397)), 2U);
  EXPECT_EQ(listed(strip(0.403)), 0U);
}

TEST(UnevenMesh, OnlyWithACommonEdge) {
  RuleDeck deck;
  deck.shell_part(1, 0.1).plate(1, 1, 1, 1, {0, 0, 0}, 10, 10).plate(11, 1, 1, 1, {10, 0, 0}, 0.5, 0.5);
  EXPECT_EQ(listed(run_rule("GC511", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"))), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::uneven_mesh_test
