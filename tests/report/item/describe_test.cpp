#include "report/item/describe.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "report/sample.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report::describe_test {
namespace {

std::string message(const Penetration& record) {
  fmt::memory_buffer out;
  append_message(record, out);
  return {out.data(), out.size()};
}

std::string cause(const Penetration& record) {
  fmt::memory_buffer out;
  append_cause(record, out);
  return {out.data(), out.size()};
}

TEST(Describe, InitialPenetration) {
  Penetration record;
  record.node = 14;
  record.part = 1;
  record.element = 500;
  record.element_part = 2;
  record.depth = 0.5;
  record.contact_distance = 1;
  record.node_rule = record.segment_rule = ThicknessRule::contact_card;
  EXPECT_EQ(message(record),
            "node 14 (part 1) is 0.5 inside the contact distance 1 of element 500 (part 2): thickness from SST/MST");
  record.element = 0;
  record.segment = {1, 2, 3, 3};
  record.node_rule = record.segment_rule = ThicknessRule::none;
  EXPECT_EQ(message(record), "node 14 (part 1) is 0.5 inside the contact distance 1 of segment 1-2-3-3 (part 2)");
}

TEST(Describe, OtherKindsSayWhatIsDifferent) {
  const Report report = sample_report();
  EXPECT_NE(message(report.penetrations[0]).find("too deep"), std::string::npos);
  EXPECT_NE(message(report.penetrations[1]).find("an edge of segment"), std::string::npos);
  EXPECT_NE(message(report.penetrations[1]).find("search band"), std::string::npos);
}

TEST(Describe, CauseNamesBothSidesWhereTheyDiffer) {
  Penetration record;
  EXPECT_EQ(cause(record), "");
  record.node_rule = ThicknessRule::element;
  record.segment_rule = ThicknessRule::part_contact;
  EXPECT_EQ(cause(record), "node: element thickness, segment: OPTT of *PART_CONTACT");
  record.segment_rule = ThicknessRule::element;
  EXPECT_EQ(cause(record), "element thickness");
}

TEST(Describe, MessagesNeedNoEscapes) {
  for (const Penetration& record : random_report(2000, 1, 7).penetrations) {
    const std::string both = message(record) + cause(record);
    EXPECT_FALSE(message(record).empty());
    EXPECT_TRUE(
        std::all_of(both.begin(), both.end(), [](char c) { return c >= 0x20 && c < 0x7f && c != '"' && c != '\\'; }));
  }
}

TEST(Describe, PrintableKeepsTextAndReplacesControls) { EXPECT_EQ(printable("Tür\tA\x1b[0m\x7f"), "Tür?A?[0m?"); }

TEST(Describe, DepthsWithinRoundingAreNotes) {
  Report report = sample_report();
  const Penetration& record = report.penetrations[0];
  EXPECT_EQ(rule_of(report, record).severity, Severity::error);
  report.penetrations[0].depth = 1e-7;
  EXPECT_EQ(rule_of(report, record).severity, Severity::note);
  EXPECT_EQ(totals(report).errors, 2U);  // the two findings
  EXPECT_EQ(totals(report).notes, 2U);
  report.penetrations[0].depth = 0;  // a log that does not say how deep
  EXPECT_EQ(rule_of(report, record).severity, Severity::error);
}

}  // namespace
}  // namespace gapcheck::report::describe_test
