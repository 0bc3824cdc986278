#include "report/item/describe_tie.hpp"

#include <gtest/gtest.h>

#include "report/write/writers.hpp"

namespace gapcheck::report::describe_tie_test {
namespace {

TieFailure far_node() {
  return {.node = 14, .part = 2, .segment_number = 7, .distance = 3, .allowed = 0.6, .reason = TieReason::too_far};
}

TEST(DescribeTie, NamesNodePartSegmentAndDistances) {
  TieFailure failure = far_node();
  EXPECT_EQ(message(failure),
            "node 14 (part 2): too far from the segment (untied), segment 7, separation 3, tie distance 0.6");
  failure.part = failure.segment_number = 0;
  failure.distance = failure.allowed = -1;
  EXPECT_EQ(message(failure), "node 14: too far from the segment (untied)");
}

TEST(DescribeTie, AMoveBeyondBothThicknessesSaysSo) {
  const TieFailure moved{.node = 14, .distance = 3, .thickness = 2.5, .reason = TieReason::sep};
  EXPECT_EQ(message(moved),
            "node 14: separated from the segment, moved onto it, separation 3, both parts together are 2.5 thick");
}

TEST(DescribeTie, OneRulePerOutcome) {
  for (const TieReason reason : tie_reasons) {
    TieFailure failure{.reason = reason};
    const std::string_view expected = reason == TieReason::sep      ? "GC204"
                                      : reason == TieReason::offset ? "GC202"
                                                                    : "GC201";
    EXPECT_EQ(rule_of(failure).id, expected);
    failure.by_node_set = true;
    EXPECT_EQ(rule_of(failure).severity == Severity::error, untied(reason));
    const std::string_view words = what_happened(reason);
    EXPECT_EQ(words.find("(untied)") != words.npos, untied(reason));
  }
}

Report with_tie(const TieFailure& failure) {
  Report report;
  report.source = "deck";
  report.contacts.resize(1);
  report.contacts[0].out_of_reach = 12;
  report.tie_failures = {failure};
  return report;
}

TEST(DescribeTie, TheTieDistanceIsShownWhereItIsKnown) {
  const Report known = with_tie(far_node());
  EXPECT_NE(text(known, {.all = true}).find("tie distance"), std::string::npos);
  EXPECT_NE(text(known, {}).find("12 nodes out of reach, not meant to tie"), std::string::npos);
  EXPECT_NE(json(known).find("\"tie_distance\":0.6"), std::string::npos);
  EXPECT_NE(json(known).find("\"out_of_reach\":12"), std::string::npos);
  TieFailure printed = far_node();  // by the solver, which does not say it
  printed.allowed = -1;
  EXPECT_EQ(text(with_tie(printed), {.all = true}).find("tie distance"), std::string::npos);
  EXPECT_EQ(json(with_tie(printed)).find("tie_distance"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::report::describe_tie_test
