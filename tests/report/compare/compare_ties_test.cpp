#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/compare/compare.hpp"
#include "report/sample.hpp"

namespace gapcheck::report::compare_ties_test {
namespace {

TieFailure failure(std::int64_t node, TieReason reason) {
  TieFailure result;
  result.node = node;
  result.reason = reason;
  return result;
}

/// A tied contact of a deck: its penetrations are not decided, its ties are.
Report tied(std::vector<TieFailure> failures) {
  Report report;
  report.source = "deck";
  report.input = "a.k";
  report.contacts = {make_contact(4, 1, "CONTACT_TIED", "2", 9, 9)};
  report.contacts[0].ties_judged = true;
  report.contacts[0].ties = 3;
  report.tie_failures = std::move(failures);
  return report;
}

using enum TieReason;

/// The deck's contact leaves these nodes out of reach.
void reach_not(Report& report, std::vector<std::int64_t> nodes) {
  report.contacts[0].out_of_reach = nodes.size();
  report.contacts[0].nodes_out_of_reach = std::move(nodes);
}

TEST(CompareTies, AgreeingOtherReasonOnlyHereOnlyThere) {
  const Report first = tied({failure(1, too_far), failure(2, too_far), failure(3, conflict), failure(9, offset)});
  const Report second = tied({failure(1, too_far), failure(2, not_found), failure(8, rigslav)});
  const Comparison comparison = compare(first, second, 0);
  const ContactComparison& c = comparison.contacts[0];
  EXPECT_TRUE(c.ties_compared);
  EXPECT_FALSE(c.not_checked);
  EXPECT_EQ(c.ties_agree, 1u);
  EXPECT_EQ(c.ties_other_reason, 1u);
  EXPECT_EQ(c.ties_only_first, 1u) << "a node that ties with an offset is not untied";
  EXPECT_EQ(c.ties_only_second, 1u);
  EXPECT_FALSE(comparison.equal());
  ASSERT_EQ(comparison.tie_differences.size(), 3u);
  EXPECT_EQ(comparison.tie_differences[0].node, 2);
  EXPECT_EQ(comparison.tie_differences[0].second, not_found);
  EXPECT_EQ(comparison.tie_differences[1].first, conflict);
  EXPECT_FALSE(comparison.tie_differences[1].second);
  EXPECT_TRUE(compare(first, first, 0).equal());
}

TEST(CompareTies, NodesOutOfReachAreCountedByADeckAndListedByTheSolver) {
  Report deck = tied({failure(1, too_far)});
  reach_not(deck, {5, 6});
  Report log = tied({failure(1, too_far), failure(5, too_far), failure(6, not_found)});
  log.source = "messag";
  EXPECT_TRUE(compare(deck, log, 0).equal());
  EXPECT_EQ(compare(deck, log, 0).contacts[0].ties_out_of_reach, 2u);
  log.tie_failures.push_back(failure(7, too_far));
  EXPECT_EQ(compare(deck, log, 0).contacts[0].ties_only_second, 1u);
  log.tie_failures.back().reason = conflict;
  reach_not(deck, {5, 6, 7});
  EXPECT_EQ(compare(deck, log, 0).contacts[0].ties_only_second, 1u);
}

TEST(CompareTies, ANodeThatADeckTiesIsNotOneOutOfItsReach) {
  Report deck = tied({});
  reach_not(deck, {20, 21, 22});
  Report log = tied({failure(1, too_far), failure(2, not_found), failure(21, not_found)});
  log.source = "messag";
  const Comparison comparison = compare(deck, log, 0);
  EXPECT_EQ(comparison.contacts[0].ties_out_of_reach, 1U);
  EXPECT_EQ(comparison.contacts[0].ties_only_second, 2U);
  ASSERT_EQ(comparison.tie_differences.size(), 2U);
  EXPECT_EQ(comparison.tie_differences[0].node, 1);
  EXPECT_EQ(comparison.tie_differences[1].node, 2);
}

TEST(CompareTies, NodesOutOfReachAreCountedForEachSideOnItsOwn) {
  Report first = tied({failure(1, too_far)}), second = tied({failure(2, too_far)});
  reach_not(first, {2});
  reach_not(second, {1});
  EXPECT_TRUE(compare(first, second, 0).equal());
  EXPECT_EQ(compare(first, second, 0).contacts[0].ties_out_of_reach, 2u);
}

TEST(CompareTies, ADeckThatDidNotJudgeSaysNothing) {
  Report deck = tied({});
  deck.contacts[0].ties = 0;
  deck.contacts[0].ties_judged = false;
  deck.contacts[0].not_checked = "no selected rule asks for it";
  Report log = tied({failure(1, too_far)});
  log.source = "messag";
  EXPECT_TRUE(compare(deck, log, 0).equal());
  EXPECT_FALSE(compare(deck, log, 0).contacts[0].ties_compared);
  deck.source = "messag";
  EXPECT_FALSE(compare(deck, log, 0).equal());
}

TEST(CompareTies, TextAndJson) {
  const Report first = tied({failure(1, too_far), failure(2, too_far)}), second = tied({failure(1, conflict)});
  const Comparison comparison = compare(first, second, 0);
  EXPECT_EQ(comparison_text(comparison, first, second, 1), R"(A: a.k
B: a.k

  contact  type  agree  depth differs  only A  only B  by at most
        4     2      0              0       0       0           0  tied

  untied nodes of contact  agree  other reason  only A  only B
                        4      0             1       1       0

contact 4: 2 untied nodes differ, first 1
  node  A    B
     1  far  conflict

the two differ, 0 nodes agree
)");
  const auto json = nlohmann::json::parse(comparison_json(comparison, first, second));
  EXPECT_EQ(json["equal"], false);
  EXPECT_EQ(json["contacts"][0]["ties"]["other_reason"], 1);
  EXPECT_EQ(json["tie_differences"][0]["second"], "conflict");
  EXPECT_FALSE(json["tie_differences"][1].contains("second"));
}

}  // namespace
}  // namespace gapcheck::report::compare_ties_test
