#include "report/format/sarif_fix.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/format/formats.hpp"
#include "report/sample.hpp"

namespace gapcheck::report::sarif_fix_test {
namespace {

using Json = nlohmann::json;

/// The repairs of a finding are its fixes: lines that are taken out and put in, file by file.
TEST(SarifFix, FixesOfFindings) {
  const std::vector<Report> reports(2, sample_report());
  const std::size_t items =
      reports[0].penetrations.size() + reports[0].tie_failures.size() + reports[0].findings.size();
  Repair thinner, tie;
  thinner.id = "1-sst";
  thinner.text = "SST = \"0.7\"";
  thinner.lines = {{"a b.k", 3, "old", "new"}};
  tie.id = "1-tie";
  tie.text = "tied";
  tie.lines = {{"b.k", 9, "*END", "*A\r\n*END"}, {"a.k", 1, "x", "y"}, {"b.k", 1, "x", "\xff"}};
  const std::vector<FindingFixes> fixes{{}, {{2, {&thinner, &tie}}}};
  const auto log_of = [&](std::span<const FindingFixes> of_reports) {
    std::string text;
    const Sink sink = [&text](std::string_view piece) {
      text += piece;
      return true;
    };
    sarif(Reports(reports, {}), "1.2", {}, sink, of_reports);
    return Json::parse(text);
  };
  Json log = log_of(fixes);
  const std::size_t with = items + 1;
  Json& results = log["runs"][0]["results"];
  ASSERT_EQ(results.size(), 2 * items);
  EXPECT_EQ(results[with]["fixes"], Json::parse(R"([
      {"description": {"text": "1-sst: SST = \"0.7\""}, "artifactChanges": [{
        "artifactLocation": {"uri": "a%20b.k"},
        "replacements": [{"deletedRegion": {"startLine": 3}, "insertedContent": {"text": "new"}}]}]},
      {"description": {"text": "1-tie: tied"}, "artifactChanges": [
        {"artifactLocation": {"uri": "a.k"},
         "replacements": [{"deletedRegion": {"startLine": 1}, "insertedContent": {"text": "y"}}]},
        {"artifactLocation": {"uri": "b.k"},
         "replacements": [{"deletedRegion": {"startLine": 9}, "insertedContent": {"text": "*A\r\n*END"}},
                          {"deletedRegion": {"startLine": 1}, "insertedContent": {"text": "\ufffd"}}]}]}])"));
  results[with].erase("fixes");
  EXPECT_EQ(log, log_of({})) << "all else is as without them";
}

}  // namespace
}  // namespace gapcheck::report::sarif_fix_test
