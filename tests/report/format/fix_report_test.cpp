#include "report/format/fix_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace gapcheck::report::fix_report_test {
namespace {

FixReport sample() {
  FixReport report;
  report.input = "model.k";
  report.files = {"model.k", "mesh\x1b.k"};
  FixContact contact;
  contact.id = 7;
  contact.keyword = "CONTACT_AUTOMATIC_SINGLE_SURFACE";
  contact.before = {3, 1, 0.5};
  contact.after = {0, 1, 0};
  report.contacts = {contact};
  MovedNode small{11, {0, 0, 0}, {0, 0, 0.1}, false, 0, 5}, large{12, {1, 0, 0}, {1, 0, -0.3}, true, 1, 6};
  report.moved = {small, large};
  report.largest_move = 0.3;
  report.total_move = 0.4;
  UnfixedNode unfixed;
  unfixed.node = 13;
  unfixed.element = 4;
  unfixed.depth = 0.9;
  unfixed.released = true;
  unfixed.reason = HoldReason::shape;
  report.unfixed = {unfixed};
  FixProposal proposal;
  proposal.contact = 7;
  proposal.part = 1;
  proposal.other_part = 2;
  proposal.penetrations = 4;
  proposal.thickness = 0.5;
  proposal.alternatives = {{"SST = 0.5", "$ card 3\n        1.\n"}};
  report.proposals = {proposal};
  report.changed = {{"mesh.k", "out/mesh.k", 2}};
  report.separated_ties_before = 1;
  return report;
}

TEST(FixReport, TextNamesMovesAndWhatRemains) {
  const std::string text = fix_text(sample(), {});
  for (const char* part :
       {"2 nodes moved: at most 0.3, on average 0.2, together 0.4", "an element would lose its shape",
        "mesh?.k:6  (tied)", "tied nodes off their segments: 1 before, 0 after", "SST = 0.5", "      $ card 3\n",
        "mesh.k: 2 lines changed, written to out/mesh.k",
        "4 nodes penetrating before, 1 after; 2 nodes moved in 1 file\n"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  EXPECT_LT(text.find("    12   0.3"), text.find("    11   0.1")) << text;  // the largest move first
}

TEST(FixReport, TopAndQuietShorten) {
  const std::string text = fix_text(sample(), {.top = 1});
  EXPECT_NE(text.find("  1 more\n"), std::string::npos) << text;
  EXPECT_EQ(fix_text(sample(), {.quiet = true}), "4 nodes penetrating before, 1 after; 2 nodes moved in 1 file\n");
}

TEST(FixReport, JsonIsComplete) {
  const auto json = nlohmann::json::parse(fix_json(sample()));
  EXPECT_EQ(json["contacts"][0]["before"]["released"], 1);
  EXPECT_EQ(json["moved"][1]["onto_tie"], true);
  EXPECT_EQ(json["moved"][1]["line"], 6);
  EXPECT_EQ(json["unfixed"][0]["reason"], "shape");
  EXPECT_EQ(json["proposals"][0]["alternatives"][0]["card"], "$ card 3\n        1.\n");
  EXPECT_EQ(json["files"][0]["written"], "out/mesh.k");
  EXPECT_EQ(json["summary"]["complete"], false);
}

TEST(FixReport, SaysWhatWasNotSearched) {
  FixReport report = sample();
  report.proposals.push_back({7, 1, 3, 2, 0.1, 0, false, {}});
  report.proposals.push_back({7, 1, 4, 2, 0.1, 0, true, {}});
  report.cut_short = true;
  const std::string text = fix_text(report, {});
  EXPECT_NE(text.find("part 3: 2 penetrations, at most 0.1 deep\n    no thickness was found that helps"),
            std::string::npos)
      << text;
  EXPECT_NE(
      text.find("part 4: 2 penetrations, at most 0.1 deep\n    a thickness was searched for the first pairs only"),
      std::string::npos)
      << text;
  const auto json = nlohmann::json::parse(fix_json(report));
  EXPECT_EQ(json["proposals"][2]["not_searched"], true);
  EXPECT_FALSE(json["proposals"][1].contains("not_searched"));
  EXPECT_EQ(json["summary"]["cut_short"], true);
}

TEST(FixReport, AnEmptyReportIsComplete) {
  const FixReport nothing;
  EXPECT_TRUE(complete(nothing));
  EXPECT_EQ(fix_text(nothing, {.quiet = true}), "0 nodes penetrating before, 0 after; 0 nodes moved in 0 files\n");
  EXPECT_TRUE(nlohmann::json::parse(fix_json(nothing))["moved"].empty());
}

}  // namespace
}  // namespace gapcheck::report::fix_report_test
