// gapcheck messag as users and scripts see it.
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "program.hpp"

namespace gapcheck::messag_test {
namespace {

namespace fs = std::filesystem;

class Messag : public Program {};

TEST_F(Messag, Text) {
  use("smp");
  const Ended run = gapcheck("messag messag --deck '" + (project / "data/two_plates.k").string() + "'");
  EXPECT_EQ(run.code, 0) << "warnings alone; " << run.err;
  expect_golden("messag", run.out);
  expect_golden("messag_list", gapcheck("messag messag --list").out);
}

TEST_F(Messag, TextOfAnMppRun) {
  use("mpp");
  expect_golden("messag_mpp", gapcheck("messag mes0000 mes0001").out);
}

TEST_F(Messag, ExitCodesFollowFailOn) {
  use("smp");
  EXPECT_EQ(gapcheck("messag messag").code, 0);
  EXPECT_EQ(gapcheck("messag messag --fail-on warning").code, 1);
  EXPECT_EQ(gapcheck("messag messag --fail-on never").code, 0);
  EXPECT_EQ(gapcheck("messag no-such-file").code, 2);
  EXPECT_EQ(gapcheck("messag messag --deck no-such-file").code, 2);
  EXPECT_EQ(gapcheck("messag messag --ptol nan").code, 2);
  EXPECT_EQ(gapcheck("messag").code, 2);
}

TEST_F(Messag, CountsWithoutAListAreWarnings) {
  use("mpp");
  EXPECT_EQ(gapcheck("messag mes0000 --contact 2 --fail-on warning").code, 1);
  EXPECT_EQ(gapcheck("messag mes0000 --contact 7 --fail-on warning").code, 0);
}

TEST_F(Messag, JsonLeavesOutWhatTheFilesDoNotSay) {
  use("smp");
  const Ended run = gapcheck("messag messag --format json");
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["schema"], "gapcheck/1");
  EXPECT_EQ(json["source"], "messag");
  EXPECT_FALSE(json.contains("model"));
  EXPECT_EQ(json["run"]["version"], "smp d R13");
  EXPECT_EQ(json["run"]["termination"], "normal");
  EXPECT_EQ(json["run"]["surface_timesteps"].size(), 3u);
  EXPECT_EQ(json["run"]["rigidwalls"].size(), 2u);
  EXPECT_EQ(json["contacts"].size(), 5u);
  EXPECT_FALSE(json["contacts"][0].contains("tracked_nodes"));
  ASSERT_EQ(json["findings"].size(), 10u);
  const auto& first = json["findings"][0];
  EXPECT_EQ(first["id"], "GC101");
  EXPECT_EQ(first["node"], 1006);
  EXPECT_EQ(first["penetration"], 0.3);
  EXPECT_EQ(first["outcome"], "moved");
  for (const char* key : {"part", "element", "element_part", "cause"}) EXPECT_FALSE(first.contains(key)) << key;
  const auto& tie = json["findings"][7];
  EXPECT_EQ(tie["id"], "GC201");
  EXPECT_EQ(tie["rule"], "untied-node");
  EXPECT_EQ(tie["reason"], "far");
  EXPECT_EQ(tie["segment_number"], 31);
  EXPECT_FALSE(tie.contains("separation"));
  EXPECT_EQ(json["summary"]["warnings"], 12) << "ten findings, two nodes in rigid walls";
}

TEST_F(Messag, OffsetsAreARuleOfTheirOwn) {
  use("soft2");
  const auto json = nlohmann::json::parse(gapcheck("messag messag --format json --contact 4").out);
  std::map<std::string, std::string> rules;
  for (const auto& finding : json["findings"]) rules[finding["reason"]] = finding["id"];
  EXPECT_EQ(rules, (std::map<std::string, std::string>{{"sep", "GC204"},
                                                       {"offset", "GC202"},
                                                       {"short", "GC201"},
                                                       {"rigslav", "GC201"},
                                                       {"rigmast", "GC201"},
                                                       {"conflict", "GC201"}}));
}

TEST_F(Messag, Selection) {
  use("smp");
  const auto findings = [&](const std::string& options) {
    return nlohmann::json::parse(gapcheck("messag messag --format json " + options).out)["findings"].size();
  };
  EXPECT_EQ(findings(""), 10u);
  EXPECT_EQ(findings("--contact 1"), 6u);
  EXPECT_EQ(findings("--contact 1,4"), 9u);
  EXPECT_EQ(findings("--contact 1 --ptol 0.2"), 4u);
  EXPECT_EQ(findings("--contact 1 --rtol 0.7"), 1u);
}

TEST_F(Messag, FilesForPostProcessors) {
  use("smp");
  EXPECT_EQ(gapcheck("messag messag --quiet --key b.key --ani b.ses --a4sel c.ses --medina d.prt --mnode 77").code, 0);
  EXPECT_NE(content(folder_ / "b.key").find("*ELEMENT_BEAM"), std::string::npos);
  EXPECT_NE(content(folder_ / "b.ses").find("ide nod"), std::string::npos);
  EXPECT_NE(content(folder_ / "c.ses").find("sel nod"), std::string::npos);
  EXPECT_NE(content(folder_ / "d.prt").find("77"), std::string::npos);
  EXPECT_EQ(gapcheck("messag messag --key no/where").code, 2);
}

TEST_F(Messag, AD3plotThatNobodyAskedForIsNoError) {
  use("smp");
  file("d3plot", "this is no d3plot");
  const Ended run = gapcheck("messag messag");
  EXPECT_EQ(run.code, 0);
  EXPECT_NE(run.err.find("gapcheck: warning: "), std::string::npos) << run.err;
  EXPECT_EQ(gapcheck("messag messag -g d3plot").code, 2);
}

/// Ids of the rules that found something.
std::set<std::string> rules_in(const Ended& run) {
  std::set<std::string> ids;
  const auto json = nlohmann::json::parse(run.out);
  for (const auto& finding : json["findings"]) ids.insert(finding["id"].get<std::string>());
  return ids;
}

TEST_F(Messag, JudgesTheRunBesideItsLog) {
  for (const char* name : {"0", "1"}) {
    const fs::path deck = project / ("data/workshop/penetration_snlog_" + std::string(name) + ".k");
    ASSERT_EQ(gapcheck("run '" + deck.string() + "' --quiet -o run" + name).code, 0);
  }
  const Ended clean = gapcheck("messag run0 --format json"), bad = gapcheck("messag run1 --format json");
  EXPECT_EQ(clean.code, 0) << clean.out;
  EXPECT_EQ(bad.code, 1) << "an error of GC601";
  EXPECT_FALSE(rules_in(clean).contains("GC601")) << clean.out;
  EXPECT_TRUE(rules_in(bad).contains("GC601"));
  EXPECT_TRUE(rules_in(bad).contains("GC606"));
  EXPECT_NE(bad.err.find("gapcheck: note: run1: not judged: GC604"), std::string::npos) << bad.err;
  EXPECT_EQ(rules_in(gapcheck("messag run1/messag --format json")), rules_in(bad)) << "its neighbours are read too";
  EXPECT_EQ(rules_in(gapcheck("messag run1 --format json --ignore GC6")), std::set<std::string>{"GC101"});
  EXPECT_EQ(rules_in(gapcheck("messag run1 --format json --select GC601")), (std::set<std::string>{"GC101", "GC601"}));
  EXPECT_EQ(gapcheck("messag run1 --quiet").err, "");
  EXPECT_EQ(check_c("run1/messag").out.find("GC6"), std::string::npos);
  EXPECT_EQ(gapcheck("messag run1 --select GC101").code, 2) << "no rule on runs";
  EXPECT_EQ(gapcheck("audit '" + (project / "data/two_plates.k").string() + "' --select GC6").code, 2);
}

TEST_F(Messag, ResultFilesThatAreDamagedOrBeingWritten) {
  use("smp");
  EXPECT_EQ(gapcheck("messag messag").err, "") << "no files to judge, none expected";
  file("glstat", " time...........................   1.00000E+00\n kinetic energy");
  const Ended open = gapcheck("messag messag");
  EXPECT_EQ(open.code, 0);
  EXPECT_NE(open.err.find("gapcheck: warning: glstat:"), std::string::npos) << open.err;
  file("glstat", " time...........................   1.00000E+00\n total energy...................   **********\n");
  EXPECT_EQ(gapcheck("messag messag").code, 2);
  fs::create_directory(folder_ / "empty");
  EXPECT_EQ(gapcheck("messag empty").code, 2);
}

TEST_F(Messag, BeamsOfAnAuditCanBeAuditedAgain) {
  const std::string deck = (project / "data/two_plates.k").string();
  EXPECT_EQ(gapcheck("audit --quiet --key beams.key '" + deck + "'").code, 0);
  const auto json = nlohmann::json::parse(gapcheck("audit beams.key --format json").out);
  EXPECT_EQ(json["model"]["beams"], 18);
}

}  // namespace
}  // namespace gapcheck::messag_test
