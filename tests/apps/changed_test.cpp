// Which decks `gapcheck audit --changed` takes.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "apps/program.hpp"

namespace gapcheck::changed_test {
namespace {

/// Two decks that share a mesh, one of them through an assembly; an include of one deck; files that belong to no deck.
class Changed : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    std::filesystem::create_directories(folder_ / "parts");
    const std::string end = "*CONTROL_TERMINATION\n1.\n";
    file("parts/mesh.inc", "*NODE\n1,0,0,0\n");
    file("parts/assembly.k", "*KEYWORD\n*INCLUDE\nparts/mesh.inc\n*END\n");
    file("parts/door.k", "*KEYWORD\n*NODE\n2,0,0,0\n*END\n");
    file("parts/spare.k", "*KEYWORD\n*NODE\n3,0,0,0\n*END\n");
    file("parts/control.k", "*KEYWORD\n" + end + "*END\n");
    file("front.k", "*KEYWORD\n" + end + "*INCLUDE\nparts/assembly.k\n*END\n");
    file("side.k", "*KEYWORD\n" + end + "*INCLUDE\nparts/mesh.inc\n*INCLUDE\nparts/door.k\n*END\n");
    file("empty.k", "");
    file("README.md", "text\n");
  }
  /// The decks that are audited when these files change.
  [[nodiscard]] std::set<std::string> audited(const std::string& changed, const std::string& decks = "'**/*.k'") const {
    const Ended run = gapcheck("audit " + decks + " --format csv --html '{deck}.html' " + changed);
    EXPECT_EQ(run.code, 0) << run.err;
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
      if (entry.path().extension() == ".html") {
        found.insert(std::filesystem::relative(entry.path(), folder_).replace_extension().string());
        std::filesystem::remove(entry.path());
      }
    return found;
  }
};

using Decks = std::set<std::string>;

TEST_F(Changed, AnIncludeLeadsToItsDecks) {
  EXPECT_EQ(audited("--changed parts/door.k"), Decks{"side"});
  EXPECT_EQ(audited("--changed parts/assembly.k"), Decks{"front"});
  EXPECT_EQ(audited("--changed parts/mesh.inc"), (Decks{"front", "side"}));
  EXPECT_EQ(audited("--changed ./parts/../front.k"), Decks{"front"});
  EXPECT_EQ(audited("--changed front.k --changed parts/door.k"), (Decks{"front", "side"}));
}

TEST_F(Changed, NamedFilesAreNotDecksIfOthersIncludeThem) {
  EXPECT_EQ(audited("--changed parts/door.k", "parts/door.k side.k front.k"), Decks{"side"});
  EXPECT_EQ(audited("--changed parts/door.k", "front.k"), Decks{});
}

TEST_F(Changed, FilesWithWhichNoRunBeginsAreNotDecks) {
  for (const std::string name : {"parts/spare.k", "parts/control.k", "empty.k"}) {
    EXPECT_EQ(audited("--changed " + name), Decks{}) << name;
    const Ended run = gapcheck("audit '**/*.k' --changed " + name);
    EXPECT_EQ(run.code, 0);
    EXPECT_NE(run.err.find("1 file was found that no deck includes, without nodes or *CONTROL_TERMINATION, and not "
                           "audited; the first is " +
                           name),
              std::string::npos)
        << run.err;
  }
}

TEST_F(Changed, WithoutADeckThereIsNothingToDo) {
  EXPECT_EQ(audited("--changed README.md"), Decks{});
  EXPECT_EQ(audited("--deleted gone.k"), Decks{});
  EXPECT_NE(gapcheck("audit '**/*.k' --changed README.md").err.find("no deck has one of the changed files"),
            std::string::npos);
  EXPECT_EQ(gapcheck("audit '**/*.k' --changed README.md --quiet").err, "");
}

TEST_F(Changed, ADeletedIncludeLeadsToTheDecksThatStillHaveIt) {
  std::filesystem::remove(folder_ / "parts/door.k");
  for (const std::string option : {"--changed", "--deleted"}) {
    const Ended run = gapcheck("audit '**/*.k' --quiet " + option + " parts/door.k");
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find("side.k:7: include \"parts/door.k\" was not found"), std::string::npos) << run.err;
    EXPECT_EQ(run.out.find("front.k"), std::string::npos) << run.out;
  }
  EXPECT_EQ(audited("--deleted other/door.k"), Decks{}) << "another one of that name";
  file("side.k", "*KEYWORD\n*CONTROL_TERMINATION\n1.\n*INCLUDE\nD:\\job\\door.k\n*END\n");
  EXPECT_EQ(gapcheck("audit '**/*.k' --deleted parts/door.k").code, 2) << "its folder was another one";
  // With the line that included it gone, too, nothing is wrong.
  file("side.k", "*KEYWORD\n*CONTROL_TERMINATION\n1.\n*INCLUDE\nparts/mesh.inc\n*END\n");
  EXPECT_EQ(audited("--deleted parts/door.k"), Decks{});
  EXPECT_EQ(audited("--deleted parts/door.k --changed side.k"), Decks{"side"});
}

TEST_F(Changed, ANameThatNoFileHasIsAnError) {
  const Ended run = gapcheck("audit '**/*.k' --changed front.k --changed parts/dor.k --quiet");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err,
            "gapcheck: error: parts/dor.k: is not there, and no deck includes it; correct the name, or give a deleted "
            "file with --deleted\n");
}

TEST_F(Changed, ADeckWithFaultsStillFails) {
  file("lost.k", "*KEYWORD\n*CONTROL_TERMINATION\n1.\n*INCLUDE\nlost.inc\n*END\n");
  EXPECT_EQ(gapcheck("audit '**/*.k' --changed lost.k").code, 2) << "the include may have nodes";
  file("front.k", "*KEYWORD\n*CONTROL_TERMINATION\n1.\n*INCLUDE\nparts/assembly.k\n*INCLUDE\nlost.inc\n*END\n");
  EXPECT_EQ(gapcheck("audit '**/*.k' --changed parts/assembly.k").code, 2);
}

}  // namespace
}  // namespace gapcheck::changed_test
