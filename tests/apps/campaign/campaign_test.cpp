// Campaigns as users run them: shares, merged results, calls that go on after an interruption.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "apps/program.hpp"

namespace gapcheck::campaign_test {
namespace {

class Campaign : public Program {
 protected:
  /// Decks with findings, without, with shared includes, and two that cannot be read.
  void SetUp() override {
    Program::SetUp();
    std::filesystem::create_directories(folder_ / "models");
    for (const std::string name : {"two_plates", "clean", "beam_on_shell", "deep_node_released", "t_joint"})
      std::filesystem::copy_file(project / ("data/" + name + ".k"), folder_ / ("models/" + name + ".k"));
    file("models/plate.inc", body());
    for (const std::string name : {"first", "second"})
      file("models/" + name + ".k", "*KEYWORD\n*INCLUDE\nplate.inc\n*END\n");
    file("models/binary.k", std::string("\0\1\2\3\0\0\1", 7));
    file("models/missing.k", "*KEYWORD\n*INCLUDE\nnot_there.inc\n*NODE\n1,0,0,0\n*END\n");
  }
  /// Two plates without the frame of a main file.
  static std::string body() {
    std::string text = content(project / "data/two_plates.k");
    for (const std::string word : {"*KEYWORD", "*END"})
      if (const auto at = text.find(word); at != std::string::npos) text.erase(at, word.size());
    return text;
  }
  static std::string without_times(const std::string& text) {
    return std::regex_replace(text, std::regex("(_s\": ?| time=\")[0-9.e+-]+"), "$1t");
  }
  static constexpr const char* all = "audit 'models/*.k' --quiet --fail-on never";
  [[nodiscard]] Ended share(int number, int count) const {
    const std::string own = std::to_string(number);
    return gapcheck(std::string(all) + " --shard " + own + "/" + std::to_string(count) + " --results share" + own);
  }
};

const std::vector<std::string> formats{"text", "json", "sarif", "junit", "github", "gitlab", "csv"};

TEST_F(Campaign, MergedSharesEqualOneCall) {
  for (int number = 1; number <= 3; ++number) (void)share(number, 3);
  for (const std::string& format : formats) {
    const std::string written = " --format " + format + " --html-index index.html --summary rules.md --output ";
    const Ended one = gapcheck("audit 'models/*.k' --fail-on never" + written + "one");
    const std::string index = content(folder_ / "index.html"), rules = content(folder_ / "rules.md");
    EXPECT_NE(rules.find("| GC101 initial-penetration | warning | 4 |"), std::string::npos) << rules;
    const Ended merged = gapcheck("merge share2 share3 share1 --fail-on never" + written + "merged");
    EXPECT_EQ(without_times(content(folder_ / "merged")), without_times(content(folder_ / "one"))) << format;
    EXPECT_GT(content(folder_ / "one").size(), 200) << format;
    EXPECT_EQ(content(folder_ / "index.html"), index);
    EXPECT_EQ(content(folder_ / "rules.md"), rules);
    EXPECT_EQ(one.code, 2);
    EXPECT_EQ(merged.code, 2) << "two decks could not be read";
  }
}

TEST_F(Campaign, TheTableOfRulesIsThatOfThePage) {
  std::filesystem::copy(folder_ / "models", folder_ / "data");
  EXPECT_EQ(examples_hold("formats.md", "summary"), 1);
}

TEST_F(Campaign, OneStoredCallIsMergedByteForByte) {
  (void)gapcheck("audit 'models/*.k' --fail-on never --format json --output one --results all");
  (void)gapcheck("merge all --fail-on never --format json --output merged");
  EXPECT_EQ(content(folder_ / "merged"), content(folder_ / "one"));
  EXPECT_NE(content(folder_ / "one").find("two_plates"), std::string::npos);
}

TEST_F(Campaign, ExitCodesAreThoseOfOneCall) {
  (void)gapcheck("audit models/two_plates.k models/clean.k --results good --quiet");
  EXPECT_EQ(gapcheck("merge good --quiet").code, 0);
  EXPECT_EQ(gapcheck("merge good --quiet --fail-on warning").code, 1);
}

TEST_F(Campaign, WhatIsDoneIsNotDoneAgain) {
  const std::string call = "audit 'models/*.k' --fail-on never --format json --results all --output ";
  (void)gapcheck(call + "first");
  const auto size = std::filesystem::file_size(folder_ / "all");
  (void)gapcheck(call + "second");
  // The times of the reports are those of the first call; only the decks that failed are audited again.
  const std::string first = content(folder_ / "first"), second = content(folder_ / "second");
  EXPECT_EQ(without_times(second), without_times(first));
  const auto times = [](const std::string& text, const std::string& deck) {
    const auto from = text.find("models/" + deck + ".k\"");
    const auto at = text.find("\"timing\"", from);
    return text.substr(at, text.find('}', at) - at);
  };
  for (const std::string deck : {"two_plates", "clean", "first"}) {
    EXPECT_EQ(times(second, deck), times(first, deck)) << deck;
    EXPECT_GT(times(first, deck).size(), 20) << deck;
  }
  EXPECT_LT(std::filesystem::file_size(folder_ / "all") - size, size / 2);
}

TEST_F(Campaign, ChangesAreAuditedAgain) {
  const std::string call = "audit models/first.k models/clean.k --fail-on never --quiet --results all";
  const auto grows = [&](const std::string& options) {
    const auto before = std::filesystem::file_size(folder_ / "all");
    EXPECT_EQ(gapcheck(call + options).code, 0);
    return std::filesystem::file_size(folder_ / "all") > before;
  };
  EXPECT_EQ(gapcheck(call).code, 0);
  EXPECT_FALSE(grows(""));
  EXPECT_FALSE(grows(" --jobs 1 --format json --top 3")) << "changes no result";
  EXPECT_TRUE(grows(" --ptol 0.01"));
  EXPECT_FALSE(grows(" --ptol 0.01"));
  EXPECT_TRUE(grows(" --select GC1"));
  EXPECT_TRUE(grows(""));
  file("models/plate.inc", body() + "$ a comment\n");
  EXPECT_TRUE(grows("")) << "an include changed";
  EXPECT_FALSE(grows(""));
  EXPECT_TRUE(grows(" --html '{deck}.html'"));
  EXPECT_FALSE(grows(" --html '{deck}.html'"));
  std::filesystem::remove(folder_ / "models/first.html");
  EXPECT_TRUE(grows(" --html '{deck}.html'")) << "a page is missing";
  EXPECT_TRUE(std::filesystem::exists(folder_ / "models/first.html"));
}

TEST_F(Campaign, AStoppedCallGoesOn) {
  (void)gapcheck(std::string(all) + " --results all --output one --format csv");
  const std::string stored = content(folder_ / "all");
  for (const std::size_t left : {std::size_t{5}, stored.size() / 3, stored.size() / 2, stored.size() - 1}) {
    file("all", stored.substr(0, left));
    (void)gapcheck(std::string(all) + " --results all --output again --format csv");
    EXPECT_EQ(content(folder_ / "again"), content(folder_ / "one")) << left;
    (void)gapcheck("merge all --fail-on never --quiet --output merged --format csv");
    EXPECT_EQ(content(folder_ / "merged"), content(folder_ / "one")) << left;
  }
}

TEST_F(Campaign, MergeSaysWhatDoesNotFit) {
  for (int number = 1; number <= 2; ++number) (void)share(number, 2);
  (void)gapcheck("audit models/clean.k --results other --quiet");
  file("empty", "");
  file("deck.k", "*KEYWORD\n*END\n");
  const auto says = [&](const std::string& arguments, const std::string& words) {
    const Ended run = gapcheck("merge " + arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_NE(run.err.find(words), std::string::npos) << arguments << ": " << run.err;
  };
  says("share1", "of 9 decks have no result");
  says("share1 share2 share2", "and so has");
  says("share1 share2 other", "holds results of another call");
  says("empty", "hold no result");
  says("deck.k", "is not a file of --results");
  says("missing", "cannot be opened");
  says("share1 share2 --output share1", "share1");
  says("", "FILE");
  EXPECT_EQ(gapcheck("merge share1 share2 --quiet").code, 2) << "two decks could not be read";
}

TEST_F(Campaign, MoreSharesThanDecks) {
  for (int number = 1; number <= 3; ++number) {
    const std::string own = std::to_string(number);
    const Ended run = gapcheck("audit models/clean.k models/two_plates.k --shard " + own + "/3 --results share" + own);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err.find("share 3 of 3 has no decks") != std::string::npos, number == 3) << run.err;
  }
  EXPECT_EQ(gapcheck("merge share1 share2 share3 --quiet").code, 0);
}

TEST_F(Campaign, IdsThatNoDeckHasAreFoundWhenMerging) {
  for (const std::string own : {"1", "2"}) {
    const Ended run = gapcheck("audit models/clean.k models/two_plates.k --quiet --part 4711 --shard " + own +
                               "/2 --results share" + own);
    EXPECT_EQ(run.code, 0) << run.err;
  }
  const Ended merged = gapcheck("merge share1 share2");
  EXPECT_EQ(merged.code, 2);
  EXPECT_NE(merged.err.find("--part 4711: none of the decks has such a part"), std::string::npos) << merged.err;
}

}  // namespace
}  // namespace gapcheck::campaign_test
