#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::uneven_mesh_test {
namespace {

Report strip(double width) { return run_rule("GC511", two_densities(width)); }

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

TEST(UnevenMesh, WhateverTheUnitOfLength) {
  for (const double size : {1e-4, 0.1, 1e4}) {
    RuleDeck even, uneven;
    even.shell_part(1, size / 100).plate(1, 1, 2, 2, {0, 0, 0}, size, size);
    EXPECT_EQ(listed(run_rule("GC511", even.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"))), 0U) << size;
    uneven.shell_part(1, size / 100).node(1, {0, 0, 0}).node(2, {size, 0, 0}).node(3, {size, size, 0});
    uneven.node(4, {0, size, 0}).node(5, {size, 1.03 * size, 0}).node(6, {0, 1.03 * size, 0});
    uneven.shell(1, 1, {1, 2, 3, 4}).shell(2, 1, {4, 3, 5, 6});
    EXPECT_EQ(listed(run_rule("GC511", uneven.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"))), 1U) << size;
  }
}

TEST(UnevenMesh, OnlyWithACommonEdge) {
  RuleDeck deck;
  deck.shell_part(1, 0.1).plate(1, 1, 1, 1, {0, 0, 0}, 10, 10).plate(11, 1, 1, 1, {10, 0, 0}, 0.5, 0.5);
  EXPECT_EQ(listed(run_rule("GC511", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"))), 0U);
}

TEST(UnevenMesh, NotTheSidesOfAThinBrick) {
  RuleDeck thin, stepped;
  thin.solid_part(1).block(1, 1, 2, 2, 1, {0, 0, 0}, {20, 20, 0.2});
  EXPECT_EQ(listed(run_rule("GC511", thin.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"))), 0U);
  // Bricks of 10 x 10 x 10, 0.3 x 10 x 10 beside them: 10 and sqrt(3).
  stepped.solid_part(1);
  const double x[] = {0, 10, 10.3};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 4; ++k) stepped.node(1 + 4 * i + k, {x[i], k % 3 == 0 ? 0. : 10., k < 2 ? 0. : 10.});
  for (int i = 0; i < 2; ++i) {
    const std::int64_t n = 1 + 4 * i;
    stepped.solid(i + 1, 1, {n, n + 4, n + 5, n + 1, n + 3, n + 7, n + 6, n + 2});
  }
  EXPECT_EQ(listed(run_rule("GC511", stepped.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"))), 4U);
}

TEST(UnevenMesh, NotWhereContactsOnlyTie) {
  RuleDeck deck;
  deck.shell_part(1, 0.1).shell_part(2, 0.1).plate(101, 2, 1, 1, {0, 0, 0.05}, 10, 10);
  deck.node(1, {0, 0, 0}).node(2, {10, 0, 0}).node(3, {10, 10, 0}).node(4, {0, 10, 0});
  deck.node(5, {10, 10.3, 0}).node(6, {0, 10.3, 0}).shell(1, 1, {1, 2, 3, 4}).shell(2, 1, {4, 3, 5, 6});
  RuleDeck touched = deck;
  EXPECT_EQ(listed(run_rule("GC511", deck.contact(1, "TIED_SURFACE_TO_SURFACE", "2,1,3,3"))), 0U);
  touched.contact(1, "TIED_SURFACE_TO_SURFACE", "2,1,3,3").contact(2, "AUTOMATIC_SINGLE_SURFACE", "0");
  EXPECT_EQ(listed(run_rule("GC511", touched)), 1U);
}

}  // namespace
}  // namespace gapcheck::audit_test::uneven_mesh_test
