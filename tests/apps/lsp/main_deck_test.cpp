#include "lsp/main_deck.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "folder_test.hpp"
#include "lsp/uri.hpp"

namespace gapcheck::app::lsp {
namespace {

class LspMainDeck : public FolderTest {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return canonical((folder_ / name).string()); }
  [[nodiscard]] std::string main_of(const std::string& name, const std::set<std::string>& preferred = {}) {
    decks_.scan({folder_.string()}, [] { return true; });
    return std::filesystem::path(decks_.main_of(path(name), preferred)).lexically_relative(canonical(folder_.string()));
  }
  MainDecks decks_;
};

TEST_F(LspMainDeck, ThroughFilesInBetween) {
  write("run/a.k", "*INCLUDE\nparts/all.k\n");
  write("run/parts/all.k", "*INCLUDE\n$ comment\n../mesh/door +\n.k\n");
  write("run/mesh/door.k", "*NODE\n");
  write("run/other.k", "*NODE\n");
  EXPECT_EQ(main_of("run/mesh/door.k"), "run/a.k");
  EXPECT_EQ(main_of("run/parts/all.k"), "run/a.k");
  EXPECT_EQ(main_of("run/a.k"), "run/a.k");
  EXPECT_EQ(main_of("run/other.k"), "run/other.k");
}

TEST_F(LspMainDeck, TheOneThatIsOpen) {
  write("a.k", "*INCLUDE\nmesh.k\n");
  write("b.key", "*INCLUDE_TRANSFORM\nmesh.k\n1,2,3\n");
  write("mesh.k", "*NODE\n");
  EXPECT_EQ(main_of("mesh.k"), "a.k");
  EXPECT_EQ(main_of("mesh.k", {path("b.key")}), "b.key");
}

TEST_F(LspMainDeck, PathsAndNamesOfOtherMachines) {
  write("a.k", "*INCLUDE_PATH\nlibrary\n*INCLUDE\nsteel.k\n*INCLUDE\nD:\\job\\mesh.k\n");
  write("library/steel.k", "*MAT_ELASTIC\n");
  write("elsewhere/mesh.k", "*NODE\n");
  EXPECT_EQ(main_of("library/steel.k"), "a.k");
  EXPECT_EQ(main_of("elsewhere/mesh.k"), "a.k");
}

TEST_F(LspMainDeck, FilesThatIncludeEachOther) {
  write("a.k", "*INCLUDE\nb.k\n");
  write("b.k", "*INCLUDE\na.k\n");
  EXPECT_EQ(main_of("b.k"), "b.k");
}

TEST_F(LspMainDeck, ADeletedDeckHasNoIncludes) {
  write("a.k", "*INCLUDE\nmesh.k\n");
  write("b.k", "*INCLUDE\nmesh.k\n");
  write("mesh.k", "*NODE\n");
  EXPECT_EQ(main_of("mesh.k"), "a.k");
  std::filesystem::remove(folder_ / "a.k");
  EXPECT_EQ(main_of("mesh.k"), "b.k");
  std::filesystem::remove(folder_ / "b.k");
  EXPECT_EQ(main_of("mesh.k"), "mesh.k");
}

TEST_F(LspMainDeck, AChangedFileIsReadAgain) {
  write("a.k", "*INCLUDE\nmesh.k\n");
  write("mesh.k", "*NODE\n");
  EXPECT_EQ(main_of("mesh.k"), "a.k");
  write("a.k", "*KEYWORD\n*END\n*INCLUDE\nmesh.k\n");
  EXPECT_EQ(main_of("mesh.k"), "mesh.k");
}

}  // namespace
}  // namespace gapcheck::app::lsp
