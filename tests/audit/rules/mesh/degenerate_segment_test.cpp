#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::degenerate_segment_test {
namespace {

/// One shell in contact with these nodes of a 10 x 10 square 1 2 3 4, its middle 5, and 6 in the middle of edge 1 2.
Report shell_with(const std::vector<std::int64_t>& nodes) {
  RuleDeck deck;
  deck.shell_part(1, 1).node(1, {0, 0, 0}).node(2, {10, 0, 0}).node(3, {10, 10, 0}).node(4, {0, 10, 0});
  deck.node(5, {4, 4, 0}).node(6, {5, 0, 0}).shell(7, 1, nodes);
  return run_rule("GC505", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"));
}

void expect_one(const Report& report, Severity severity, const std::string& words) {
  ASSERT_EQ(listed(report), 1U) << words;
  EXPECT_EQ(report.findings[0].element, 7);
  EXPECT_EQ(report.findings[0].severity, severity) << words;
  EXPECT_NE(report.findings[0].message.find(words), std::string::npos) << report.findings[0].message;
}

TEST(DegenerateSegment, NamesWhatIsWrong) {
  expect_one(shell_with({1, 3, 2, 4}), Severity::error, "crosses itself");  // both lobes of one size
  expect_one(shell_with({1, 2, 4, 5}), Severity::warning, "arrowhead");
  expect_one(shell_with({1, 6, 2, 2}), Severity::error, "no area");
  expect_one(shell_with({1, 2, 1, 1}), Severity::error, "fewer than three");
  expect_one(shell_with({1, 2, 3, 1}), Severity::warning, "repeats a node");
}

TEST(DegenerateSegment, NotSoundQuadsAndTriangles) {
  EXPECT_EQ(listed(shell_with({1, 2, 3, 4})), 0U);
  EXPECT_EQ(listed(shell_with({4, 3, 2, 1})), 0U);
  EXPECT_EQ(listed(shell_with({1, 2, 3, 3})), 0U);
  EXPECT_EQ(listed(shell_with({1, 6, 2, 3})), 0U);  // a corner of 180 degrees is not folded
}

TEST(DegenerateSegment, FaultsOfOnePartDoNotHideEachOther) {
  RuleDeck deck;
  deck.shell_part(1, 1).node(1, {0, 0, 0}).node(2, {10, 0, 0}).node(3, {10, 10, 0}).node(4, {0, 10, 0});
  for (int i = 0; i < 12; ++i) deck.shell(i + 1, 1, {1, 3, 2, 4});
  deck.shell(20, 1, {1, 2, 3, 1});
  const Report report = run_rule("GC505", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"));
  ASSERT_EQ(listed(report), 12U);  // ten, the other two in one line, the repeated node
  std::size_t warnings = 0;
  for (const Finding& f : report.findings) warnings += f.severity == Severity::warning ? 1 : 0;
  EXPECT_EQ(warnings, 1U);
}

}  // namespace
}  // namespace gapcheck::audit_test::degenerate_segment_test
