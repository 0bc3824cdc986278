#include "audit/fix/node_lines.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "audit/fix/plates.hpp"
#include "audit/fix/run_fix.hpp"

namespace gapcheck::audit_test::node_lines_test {
namespace {

struct Read {
  Diagnostics diagnostics;
  keyword::Deck deck;
  model::Model model;
  std::vector<Vector> x;
  explicit Read(Result<keyword::Deck> from) {
    EXPECT_TRUE(from.ok());
    deck = std::move(from).value();
    auto read = model::read_model(deck, diagnostics);
    EXPECT_TRUE(read.ok());
    model = std::move(read).value();
    x = model.mesh.nodes.x;
  }
  explicit Read(const std::string& text) : Read(keyword::read_deck_text(text, "deck.k", {}, ignored)) {}
  static inline Diagnostics ignored;
};

TEST(NodeLines, WritesOnlyWhatMoves) {
  Read read("*KEYWORD\n*NODE\n       1              1.              2.            3.00       0       0\n*END\n");
  audit::NodeLines lines(read.deck, read.model, read.x);
  const Vector to(1, 2, 3.25);
  EXPECT_TRUE(lines.check(NodeIndex{0}).ok());
  EXPECT_EQ(lines.edit(NodeIndex{0}, to).text,
            "       1              1.              2.            3.25       0       0");
  EXPECT_EQ(lines.edit(NodeIndex{0}, to).line, 3u);
  EXPECT_EQ(lines.written(NodeIndex{0}, to), to);
  EXPECT_EQ(lines.written(NodeIndex{0}, read.x[0]), read.x[0]);
}

TEST(NodeLines, EachBlockInItsOwnFormat) {
  Read read(
      "*KEYWORD\n*NODE\n       1              1.              2.            3.00\n"
      "*NODE%\n         2              1.              2.            3.00\n"
      "*NODE+\n                   3                  1.                  2.                "
      "3.00\n*NODE\n4,1,2,3.00\n*END\n");
  audit::NodeLines lines(read.deck, read.model, read.x);
  const std::vector<std::string> expected{
      "       1              1.              2.            3.25",
      "         2              1.              2.            3.25",
      "                   3                  1.                  2.                3.25", "4,1,2,3.25"};
  ASSERT_EQ(read.x.size(), expected.size());
  for (std::uint32_t i = 0; i < expected.size(); ++i) {
    EXPECT_TRUE(lines.check(NodeIndex{i}).ok());
    EXPECT_EQ(lines.edit(NodeIndex{i}, Vector(1, 2, 3.25)).text, expected[i]);
  }
}

TEST(NodeLines, SaysWhatCannotBeRewritten) {
  Read read(
      "*KEYWORD\n*PARAMETER\nR h              3.0\n*NODE\n1,0.,0.,&h\n2,0.,0.,1.\n2,0.,0.,1.\n3,0.,0.,1.\n*END\n");
  audit::NodeLines lines(read.deck, read.model, read.x);
  EXPECT_EQ(lines.check(NodeIndex{0}).error().message, "&h is a parameter");
  EXPECT_EQ(lines.check(NodeIndex{1}).error().message, "it is defined more than once");
  EXPECT_TRUE(lines.check(NodeIndex{2}).ok());
}

class NodeLinesInFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "gapcheck-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  std::filesystem::path folder_;
};

TEST_F(NodeLinesInFiles, UndoesThePlacementOfTheInclude) {
  write("part.k", "*KEYWORD\n*NODE\n       1              1.              2.              3.\n*END\n");
  const std::string path = write("main.k",
                                 "*KEYWORD\n*DEFINE_TRANSFORMATION\n         7\n"
                                 "ROTATE            0.        0.        1.        0.        0.        0.       30.\n"
                                 "TRANSL          100.       20.        5.\n"
                                 "*INCLUDE_TRANSFORM\npart.k\n       100\n\n"
                                 "     1000.        1.        1.                   1\n         7\n*END\n");
  Diagnostics diagnostics;
  Read read(keyword::read_deck(path, {}, diagnostics));
  ASSERT_EQ(read.x.size(), 1u);
  audit::NodeLines lines(read.deck, read.model, read.x);
  ASSERT_TRUE(lines.check(NodeIndex{0}).ok());
  const Vector to = read.x[0] + Vector(0.3, -0.2, 0.1);
  EXPECT_NEAR((lines.written(NodeIndex{0}, to) - to).norm(), 0, 1e-9);
  EXPECT_NE(lines.edit(NodeIndex{0}, to).text, "       1              1.              2.              3.");
}

TEST_F(NodeLinesInFiles, FilesReadTwiceStay) {
  write("part.k", "*KEYWORD\n*NODE\n       1              1.              2.              3.\n*END\n");
  const std::string path = write(
      "main.k", "*KEYWORD\n*INCLUDE\npart.k\n*INCLUDE_TRANSFORM\npart.k\n       100\n\n\n\n*NODE\n5,1.,1.,1.\n*END\n");
  Diagnostics diagnostics;
  Read read(keyword::read_deck(path, {}, diagnostics));
  audit::NodeLines lines(read.deck, read.model, read.x);
  EXPECT_EQ(lines.check(NodeIndex{0}).error().message, "its file is included more than once");
  EXPECT_TRUE(lines.check(NodeIndex{*read.model.mesh.nodes.lookup.find(5)}).ok());
}

}  // namespace
}  // namespace gapcheck::audit_test::node_lines_test
