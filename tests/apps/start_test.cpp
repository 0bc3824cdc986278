// `gapcheck start` as users and scripts see it.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "apps/program.hpp"

namespace gapcheck::start_program_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class StartProgram : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    fs::copy(project / "data", folder_ / "data", fs::copy_options::recursive);
  }
  [[nodiscard]] Json json(const std::string& arguments) const {
    return Json::parse(gapcheck("start " + arguments + " --format json --quiet").out);
  }
};

/// Lines that differ between two texts with equally many lines.
std::vector<std::string> changed_lines(const std::string& a, const std::string& b) {
  std::istringstream first(a), second(b);
  std::vector<std::string> changed;
  for (std::string x, y; std::getline(first, x) && std::getline(second, y);)
    if (x != y) changed.push_back(y);
  EXPECT_EQ(std::count(a.begin(), a.end(), '\n'), std::count(b.begin(), b.end(), '\n'));
  return changed;
}

TEST_F(StartProgram, ExitCodesSayWhetherItStartsClean) {
  const Ended clean = gapcheck("start data/clean.k");
  EXPECT_EQ(clean.code, 0) << clean.err << clean.out;
  EXPECT_NE(clean.out.find("starts clean"), std::string::npos) << clean.out;
  EXPECT_EQ(gapcheck("start data/ignore_0.k").code, 1);
  EXPECT_EQ(gapcheck("start data/none.k").code, 2);
  EXPECT_EQ(gapcheck("start").code, 2);
}

TEST_F(StartProgram, TextHasAScoreForEachContact) {
  const Ended moved = gapcheck("start data/ignore_0.k");
  EXPECT_NE(moved.out.find("starts moved by at most 0.3006\n"), std::string::npos) << moved.out;
  EXPECT_NE(gapcheck("start data/ignore_1.k").out.find("starts with 70 % of its thickness\n"), std::string::npos);
  EXPECT_NE(gapcheck("start data/deep_node_released.k").out.find("loses 18 nodes"), std::string::npos);
  // 0.1 K A / diagonal = 0.1 * 175000 * 25 / (5 sqrt 2) for each of 18 nodes, 0.3 deep.
  EXPECT_NE(gapcheck("start data/snlog_1.k").out.find("starts with an energy of 50116.2 from nothing"),
            std::string::npos)
      << gapcheck("start data/snlog_1.k").out;
  const Ended quiet = gapcheck("start data/ignore_0.k --quiet");
  EXPECT_EQ(std::count(quiet.out.begin(), quiet.out.end(), '\n'), 1) << quiet.out;
}

TEST_F(StartProgram, ThePageShowsWhatIsPrinted) { EXPECT_EQ(examples_hold("start.md", "example"), 2); }

TEST_F(StartProgram, WhatWillBeLostIsInTextAndJsonIfSomethingMoves) {
  EXPECT_FALSE(json("data/ignore_0.k").contains("expected"));
  EXPECT_EQ(gapcheck("start data/ignore_0.k").out.find("expected"), std::string::npos);
  const Json expected = json("data/workshop/rebound_thin.k")["expected"];
  ASSERT_EQ(expected["contacts"].size(), 1u) << expected;
  const Json& row = expected["contacts"][0];
  EXPECT_EQ(row["nodes"], 4);
  EXPECT_EQ(row["speed"], 20);
  // 0.8 of 0.15 over v / w, 20 over 142.4 / ms.
  EXPECT_NEAR(row["margin"].get<double>(), 0.8 * 0.15 * 142.4 / 20, 1e-3);
  EXPECT_LT(row["low"], row["margin"]);
  EXPECT_LT(row["margin"], row["high"]);
  EXPECT_EQ(row["lost"], true);
  EXPECT_EQ(row["held"], false);
  EXPECT_FALSE(row.contains("alone"));
  EXPECT_NE(gapcheck("start data/workshop/rebound_thin.k").out.find("  lost; 2: SST 0.351"), std::string::npos);
  const Ended counted = gapcheck("start data/workshop/rebound_thin.k --stats --quiet");
  EXPECT_NE(counted.err.find("candidates"), std::string::npos) << counted.err;
  EXPECT_EQ(std::count(counted.out.begin(), counted.out.end(), '\n'), 1) << counted.out;
}

TEST_F(StartProgram, JsonHasEveryMove) {
  const Json report = json("data/ignore_0.k");
  EXPECT_EQ(report["schema"], "gapcheck-start/1");
  EXPECT_EQ(report["first_cycle"], true);
  EXPECT_EQ(report["summary"]["moved"], report["moves"].size());
  EXPECT_EQ(report["contacts"][0]["moved"], report["moves"].size());
  EXPECT_EQ(report["summary"]["clean"], false);
  for (const Json& move : report["moves"]) EXPECT_EQ(move["cause"], "shot");
}

TEST_F(StartProgram, TheWrittenDeckStartsClean) {
  const Ended written = gapcheck("start data/ignore_0.k --write-deck out");
  EXPECT_EQ(written.code, 1) << written.err;
  const std::string before = content(folder_ / "data/ignore_0.k"), after = content(folder_ / "out/ignore_0.k");
  EXPECT_EQ(changed_lines(before, after).size(), json("data/ignore_0.k")["summary"]["moved"]);
  const Json again = json("out/ignore_0.k");
  EXPECT_EQ(again["summary"]["moved"], 0) << again["summary"];
  EXPECT_EQ(gapcheck("start out/ignore_0.k").code, 0);
}

TEST_F(StartProgram, TheWrittenDeckHasAllFilesAndChangesOnlyNodes) {
  const Ended written = gapcheck("start data/include_parameter.k --write-deck out");
  EXPECT_EQ(written.code, 1) << written.err << written.out;
  EXPECT_EQ(content(folder_ / "out/include_parameter.k"), content(folder_ / "data/include_parameter.k"));
  std::size_t changed = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out"))
    if (entry.is_regular_file())
      changed += changed_lines(content(folder_ / "data" / entry.path().lexically_relative(folder_ / "out")),
                               content(entry.path()))
                     .size();
  EXPECT_EQ(changed, json("data/include_parameter.k")["summary"]["moved"]);
}

TEST_F(StartProgram, NeverWritesOverTheDeck) {
  const std::string before = content(folder_ / "data/ignore_0.k");
  const Ended refused = gapcheck("start data/ignore_0.k --write-deck data");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("is a file of the deck itself"), std::string::npos) << refused.err;
  EXPECT_EQ(gapcheck("start data/ignore_0.k --output data/ignore_0.k").code, 2);
  EXPECT_EQ(gapcheck("start data/ignore_0.k --write-deck out --output out/ignore_0.k").code, 2);
  EXPECT_EQ(content(folder_ / "data/ignore_0.k"), before);
}

TEST_F(StartProgram, AMoveOfNodesBehindTheirLinesIsNotWritten) {
  std::string deck = content(folder_ / "data/ignore_0.k");
  deck.insert(deck.find("*END"), "*PART_MOVE\n         2       0.0       0.0       0.0\n");
  std::ofstream(folder_ / "moved.k") << deck;
  const Ended refused = gapcheck("start moved.k --write-deck out");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("*PART_MOVE"), std::string::npos) << refused.err;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(StartProgram, AnyNumberOfJobsGivesTheSameBytes) {
  for (const char* deck : {"data/ignore_0.k", "data/snlog_1.k", "data/contact_chain.k", "data/tied_then_contact.k"}) {
    const std::string arguments = std::string("start ") + deck + " --format json --jobs ";
    EXPECT_EQ(gapcheck(arguments + "1").out, gapcheck(arguments + "2").out) << deck;
  }
}

TEST_F(StartProgram, ARefusedDeckSaysWhichKeyword) {
  std::string deck = content(folder_ / "data/ignore_0.k");
  deck.replace(deck.find("*MAT_ELASTIC"), 12, "*MAT_WOOD");
  std::ofstream(folder_ / "wood.k") << deck;
  const Ended told = gapcheck("start wood.k");
  EXPECT_EQ(told.code, 1) << told.err;
  EXPECT_NE(told.out.find("run refuses the deck: wood.k:"), std::string::npos) << told.out;
  EXPECT_NE(told.out.find("*MAT_WOOD"), std::string::npos) << told.out;
  EXPECT_NE(told.out.find("starts moved by at most 0.3006"), std::string::npos) << told.out;
}

}  // namespace
}  // namespace gapcheck::start_program_test
