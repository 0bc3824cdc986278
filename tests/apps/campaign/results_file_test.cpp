#include "campaign/results_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "apps/program.hpp"
#include "folder_test.hpp"

namespace gapcheck::app {
namespace {

DeckResult result(const std::string& deck, std::uint64_t position, std::string report = "found") {
  DeckResult entry;
  entry.version = "1";
  entry.call = {{1, 2}, 3};
  entry.deck = deck;
  entry.position = position;
  entry.diagnostics = {{Severity::warning, "a.k", 7, "odd", ""}};
  entry.report = std::move(report);
  return entry;
}

class ResultsFileTest : public FolderTest {
 protected:
  [[nodiscard]] std::string path() const { return (folder_ / "results").string(); }
  void write(const std::vector<DeckResult>& entries) const {
    auto file = ResultsFile::open(path());
    ASSERT_TRUE(file);
    for (const DeckResult& entry : entries) EXPECT_TRUE(file.value().add(entry).ok());
  }
  void put(const std::string& bytes) const { std::ofstream(path(), std::ios::binary) << bytes; }
  [[nodiscard]] std::vector<std::string> decks() const {
    const auto entries = ResultsFile::read(path());
    std::vector<std::string> names;
    if (entries)
      for (const DeckResult& entry : entries.value()) names.push_back(entry.deck + ":" + entry.report);
    return names;
  }
};

using Names = std::vector<std::string>;

TEST_F(ResultsFileTest, LaterEntriesReplaceEarlierOnes) {
  write({result("a", 0), result("b", 1)});
  write({result("a", 0, "again")});
  EXPECT_EQ(decks(), (Names{"a:again", "b:found"}));
  const auto file = ResultsFile::open(path());
  ASSERT_TRUE(file);
  EXPECT_EQ(file.value().find("a")->report, "again");
  EXPECT_EQ(file.value().find("b")->diagnostics.at(0).message, "odd");
  EXPECT_FALSE(file.value().find("c"));
}

TEST_F(ResultsFileTest, AnEntryThatWasNotFinishedIsCutOffWhereverItEnds) {
  write({result("a", 0)});
  const std::string one = content(path());
  write({result("b", 1)});
  const std::string two = content(path());
  for (std::size_t length = 0; length < two.size(); length += 7) {
    put(two.substr(0, length));
    write({result("c", 2)});
    const Names expected = length < one.size() ? Names{"c:found"} : Names{"a:found", "c:found"};
    EXPECT_EQ(decks(), expected) << length;
  }
}

TEST_F(ResultsFileTest, DamagedEntriesAreNotTaken) {
  write({result("a", 0), result("b", 1)});
  const std::string sound = content(path());
  for (std::size_t at = 19; at < sound.size(); at += 5) {
    std::string damaged = sound;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x40);
    put(damaged);
    for (const std::string& name : decks()) EXPECT_TRUE(name == "a:found" || name == "b:found") << at;
    EXPECT_LT(decks().size(), 2) << at;
  }
}

TEST_F(ResultsFileTest, OtherFilesAreLeftAlone) {
  put("*KEYWORD\n*END\n");
  const auto file = ResultsFile::open(path());
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("is not a file of --results"), std::string::npos);
  EXPECT_FALSE(ResultsFile::read(path()));
  EXPECT_EQ(content(path()), "*KEYWORD\n*END\n");
  EXPECT_FALSE(ResultsFile::read((folder_ / "missing").string()));
  EXPECT_FALSE(ResultsFile::open((folder_ / "no/such/folder").string()));
}

TEST_F(ResultsFileTest, OnlyOneCallHasItOpen) {
  const auto first = ResultsFile::open(path());
  ASSERT_TRUE(first);
  const auto second = ResultsFile::open(path());
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message.find("another call"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::app
