#include <filesystem>

#include "support.hpp"

namespace gapcheck::keyword::includes_test {
namespace {

class Includes : public testing::Test {
 protected:
  void read(const std::string& main, const ReadOptions& options = {}) {
    auto result = read_deck(directory.path(main), options, diagnostics);
    ASSERT_TRUE(result.ok()) << result.error().message;
    deck = std::move(result).value();
  }
  TemporaryDirectory directory;
  Diagnostics diagnostics;
  Deck deck;
};

TEST_F(Includes, StandWhereTheyAreIncluded) {
  directory.write("a.k", "*NODE\n*END\n*PART\n");
  directory.write("sub/b.k", "*INCLUDE\nc.k\n*ELEMENT_SHELL\n");
  directory.write("sub/c.k", "*SET_NODE\n");
  directory.write("main.k", "*KEYWORD\n*INCLUDE\na.k\n$ comment\n\nsub/b.k\n*TITLE\n");
  read("main.k");
  EXPECT_EQ(names(deck), (std::vector<std::string>{"KEYWORD", "INCLUDE", "NODE", "END", "INCLUDE", "SET_NODE",
                                                   "ELEMENT_SHELL", "TITLE"}));
  EXPECT_EQ(reports(diagnostics), "");
  ASSERT_EQ(deck.files().size(), 4u);
  EXPECT_EQ(deck.files()[3].includer, FileIndex(2));
  EXPECT_EQ(deck.files()[2].include_line, 6u);
  EXPECT_EQ(deck.files()[0].includer, none<FileIndex>);
  for (std::size_t i = 0; i < deck.blocks().size(); ++i) EXPECT_EQ(deck.blocks()[i].order, i);
}

TEST_F(Includes, DirectivesOfAllFilesThatAreRead) {
  directory.write("a.k", "$ Gapcheck: three\n*NODE\n*END\n$gapcheck: behind the end\n");
  directory.write("main.k",
                  "$ gapcheck: one\n*KEYWORD\n*INCLUDE_TRANSFORM\na.k\n      1000\n\n\n\n\n*NODE\n$gapcheck:two\r\n"
                  "       1\n*END\n$ gapcheck: behind the end\n");
  read("main.k");
  std::string all;
  for (const Directive& directive : deck.directives())
    all += std::to_string(directive.file.value) + ":" + std::to_string(directive.line) + " " +
           std::to_string(deck.transform(directive.transform).offset[1]) + std::string(directive.text) + "\n";
  EXPECT_EQ(all, "0:1 0 one\n0:11 0two\n1:1 1000 three\n");
  EXPECT_EQ(reports(diagnostics), "");
}

TEST_F(Includes, DirectivesWithoutMeasureAreAnError) {
  std::string many;
  for (int i = 0; i < 1'000'001; ++i) many += "$gapcheck:\n";
  directory.write("main.k", "*KEYWORD\n" + many);
  read("main.k");
  EXPECT_EQ(deck.directives().size(), 1'000'000u);
  EXPECT_NE(reports(diagnostics).find("the rest was not read"), std::string::npos);
}

TEST_F(Includes, ContinuedNames) {
  directory.write("some/deep/directory/mesh.k", "*NODE\n");
  directory.write("main.k", "*INCLUDE\nsome/deep +\n/directory/ +\nmesh.k\n");
  read("main.k");
  EXPECT_EQ(names(deck).back(), "NODE") << reports(diagnostics);
}

TEST_F(Includes, SearchPaths) {
  directory.write("x/one.k", "*NODE\n");
  directory.write("y/two.k", "*PART\n");
  directory.write("z/three.k", "*TITLE\n");
  directory.write("main.k", "*INCLUDE_PATH\n" + directory.path("x") + "\n*INCLUDE\none.k\n*INCLUDE_PATH_RELATIVE\ny\n" +
                                "*INCLUDE\ntwo.k\nthree.k\n*INCLUDE\nx\\one.k\n");
  ReadOptions options;
  options.include_directories = {directory.path("z")};
  read("main.k", options);
  EXPECT_EQ(reports(diagnostics), "");
  EXPECT_EQ(deck.files().size(), 5u);
}

TEST_F(Includes, NamesOfAnotherMachineByTheirEnd) {
  directory.write("mesh.k", "*NODE\n");
  directory.write("sub/inner.k", "*INCLUDE\n\\\\server\\share\\other.k\n");
  directory.write("sub/other.k", "*PART\n");
  directory.write("far/folder/part.k", "*TITLE\n");
  directory.write("far/part.k", "*END\n");
  directory.write("main.k",
                  "*INCLUDE\nC:\\project\\mesh.k\nc:/Project/mesh.k\n/home/nobody/sub/inner.k\nfolder\\part.k\n"
                  "D:x\\folder\\part.k\n");
  ReadOptions options;
  options.include_directories = {directory.path("far")};
  read("main.k", options);
  EXPECT_EQ(names(deck), (std::vector<std::string>{"INCLUDE", "NODE", "NODE", "INCLUDE", "PART", "TITLE", "TITLE"}))
      << reports(diagnostics);
  const std::string all = reports(diagnostics);
  EXPECT_EQ(count_errors(diagnostics), 0u) << all;
  EXPECT_EQ(diagnostics.sorted().size(), 5u) << "found where its name says: no note\n" << all;
  EXPECT_NE(all.find("main.k:2: include \"C:\\project\\mesh.k\" does not exist here; \"" + directory.path("mesh.k") +
                     "\" was read in its place\n"),
            std::string::npos)
      << all;
}

TEST_F(Includes, OneFileForTwoNamesOfAnotherMachine) {
  directory.write("mat.k", "*NODE\n");
  directory.write("more/mat.k", "*PART\n");
  ReadOptions options;
  options.include_directories = {directory.path("more")};
  directory.write("main.k", "*INCLUDE\nC:\\steel\\mat.k\nC:\\foam\\mat.k\nC:\\glass\\mat.k\n");
  read("main.k", options);
  const std::string all = reports(diagnostics);
  EXPECT_EQ(names(deck), (std::vector<std::string>{"INCLUDE", "NODE", "PART"})) << all;
  EXPECT_NE(all.find("(not \"" + directory.path("more/mat.k") + "\", which has the same name)"), std::string::npos)
      << all;
  EXPECT_NE(all.find("main.k:4: include \"C:\\glass\\mat.k\" was not found"), std::string::npos) << all;
}

TEST_F(Includes, AdviceThatHelps) {
  directory.write("sub/deep.k", "*NODE\n");
  directory.write("main.k", "*INCLUDE\nC:\\x\\y.k\n../lib/z.k\nsub/w.k\nplain.k\n/usr/\nC:\n/abs/sub/../deep.k\n");
  read("main.k");
  const std::string all = reports(diagnostics);
  EXPECT_EQ(count_errors(diagnostics), 7u) << all;
  EXPECT_NE(all.find(":2: include \"C:\\x\\y.k\" was not found, and neither"), std::string::npos) << all;
  EXPECT_NE(all.find("have a \"y.k\" for it; put it beside the deck, or give its folder with -I"), std::string::npos)
      << all;
  EXPECT_NE(all.find(":4: include \"sub/w.k\" was not found; correct the name, or give with -I or *INCLUDE_PATH the "
                     "folder that \"sub/w.k\" starts from"),
            std::string::npos)
      << all;
  EXPECT_NE(all.find(":5: include \"plain.k\" was not found; correct the name, or give its directory"),
            std::string::npos)
      << all;
}

TEST_F(Includes, AFileOfTheSameNameIsNamed) {
  directory.write("controls.k", "*NODE\n");
  directory.write("main.k", "*INCLUDE\n../shared/controls.k\n");
  read("main.k");
  EXPECT_EQ(count_errors(diagnostics), 1u);
  const std::string all = reports(diagnostics);
  EXPECT_NE(all.find(":2: include \"../shared/controls.k\" was not found, but there is \"" +
                     directory.path("controls.k") + "\": correct the name\n"),
            std::string::npos)
      << all;
  EXPECT_EQ(names(deck), std::vector<std::string>{"INCLUDE"}) << "it is not read";
}

TEST_F(Includes, WhatAnEarlierCaseWritesIsMissingWithoutAnError) {
  directory.write("main.k",
                  "*CASE_BEGIN_1\n*CASE_END_1\n*CASE_BEGIN_2\n*INCLUDE\ncase1.dynain.lsda\ncase3.dynain.lsda\n"
                  "old/case1.dynain\ncase1\nCASE_1.k\n*CASE_END_2\n");
  read("main.k");
  const std::string all = reports(diagnostics);
  EXPECT_NE(all.find(directory.path("main.k") + ":5: include \"case1.dynain.lsda\" was not found: the "
                                                "run of *CASE 1 writes it"),
            std::string::npos)
      << all;
  ASSERT_EQ(deck.missing_includes().size(), 5u);
  const std::vector<std::int64_t> writers{1, 0, 1, 0, 0};
  for (std::size_t i = 0; i < writers.size(); ++i) EXPECT_EQ(deck.missing_includes()[i].written_by, writers[i]) << i;
  EXPECT_EQ(count_errors(diagnostics), 3u) << all;
}

TEST_F(Includes, AllMissingOnesAreReported) {
  directory.write("main.k", "*KEYWORD\n*INCLUDE\nno.k\nneither.k\n*NODE\n");
  read("main.k");
  EXPECT_EQ(count_errors(diagnostics), 2u);
  const std::string all = reports(diagnostics);
  EXPECT_NE(all.find("main.k:3: include \"no.k\" was not found"), std::string::npos) << all;
  EXPECT_NE(all.find("main.k:4: include \"neither.k\""), std::string::npos) << all;
  EXPECT_EQ(deck.counters().missing_includes, 2u);
  EXPECT_EQ(names(deck).back(), "NODE");
}

TEST_F(Includes, MissingOnesMayBeSkipped) {
  directory.write("main.k", "*INCLUDE\nno.k\n");
  ReadOptions options;
  options.skip_missing_includes = true;
  read("main.k", options);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.sorted().size(), 1u);
  EXPECT_EQ(deck.counters().missing_includes, 1u);
}

TEST_F(Includes, BadFiles) {
  directory.write("empty.k", "");
  directory.write("binary.k", std::string("\0\0\0\0", 4));
  std::filesystem::create_directories(directory.path("folder.k"));
  directory.write("main.k", "*INCLUDE\nempty.k\nbinary.k\nfolder.k\n" + std::string(400, 'n') + "\n/dev/zero\n");
  read("main.k");
  const std::string all = reports(diagnostics);
  EXPECT_EQ(count_errors(diagnostics), 4u) << all;
  for (const char* part : {":2: include", "is empty", ":3: include", "not a keyword file", "folder.k", "236"})
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
}

TEST_F(Includes, CyclesAreCut) {
  directory.write("a.k", "*INCLUDE\nb.k\n");
  directory.write("b.k", "*INCLUDE\n./a.k\n*NODE\n");
  directory.write("main.k", "*INCLUDE\na.k\nmain.k\n");
  read("main.k");
  EXPECT_EQ(count_errors(diagnostics), 2u) << reports(diagnostics);
  EXPECT_NE(reports(diagnostics).find("includes itself"), std::string::npos);
}

TEST_F(Includes, DepthAndNumberAreBounded) {
  for (int i = 0; i < 40; ++i) {
    const std::string next = std::to_string(i + 1) + ".k\n";
    directory.write(std::to_string(i) + ".k", "*INCLUDE\n" + next + next);
  }
  directory.write("40.k", "*NODE\n");
  ReadOptions options;
  options.max_include_depth = 5;
  read("0.k", options);
  EXPECT_NE(reports(diagnostics).find("nested more than 5 deep"), std::string::npos);
  EXPECT_EQ(deck.files().size(), 63u);
  Diagnostics more;
  options.max_include_depth = 64;
  options.max_files = 100;
  const auto many = read_deck(directory.path("0.k"), options, more);
  ASSERT_TRUE(many.ok());
  EXPECT_EQ(many.value().files().size(), 100u);
  EXPECT_EQ(count_errors(more), 1u) << reports(more);
}

// A file included again and again is a mistake that small files can make large.
TEST_F(Includes, BytesOfRepeatedFilesAreBounded) {
  const std::string leaf = "*NODE\n" + std::string(990, '$') + "\n";
  directory.write("leaf.k", leaf);
  std::string ten;
  for (int i = 0; i < 10; ++i) ten += "*INCLUDE\nleaf.k\n";
  directory.write("ten.k", ten);
  std::string main;
  for (int i = 0; i < 10; ++i) main += "*INCLUDE\nten.k\n";
  directory.write("main.k", main);
  ReadOptions options;
  options.max_repeated_bytes = 50'000;
  read("main.k", options);
  EXPECT_EQ(deck.files().size(), 57u) << "reading ends at the bound";
  const std::string all = reports(diagnostics);
  EXPECT_NE(all.find("ten.k:2: include \"leaf.k\" was not read: the includes repeat files: 0.0 MB of different files "
                     "have become 0.1 MB, and at most 0.05 MB are read again; nothing more was read; include each file "
                     "once"),
            std::string::npos)
      << all;
  EXPECT_EQ(count_errors(diagnostics), 1u) << all;
  // Ten times the bytes of the different files are no mistake.
  directory.write("large.k", "*NODE\n" + std::string(20'000, '$') + "\n");
  directory.write("main.k", "*INCLUDE\nlarge.k\n" + main);
  options.max_repeated_bytes = 0;
  Diagnostics none;
  const auto whole = read_deck(directory.path("main.k"), options, none);
  ASSERT_TRUE(whole.ok());
  EXPECT_EQ(whole.value().files().size(), 112u) << reports(none);
  EXPECT_EQ(count_errors(none), 0u) << reports(none);
}

TEST_F(Includes, ManyMissingOnesAndPathsAreBounded) {
  std::string text = "*INCLUDE_PATH\n";
  for (int i = 0; i < 1000; ++i) text += "path" + std::to_string(i) + "\n";
  text += "*INCLUDE\n";
  for (int i = 0; i < 1000; ++i) text += "no" + std::to_string(i) + ".k\n";
  directory.write("main.k", text + "*NODE\n");
  ReadOptions options;
  options.max_files = 50;
  read("main.k", options);
  EXPECT_EQ(deck.counters().missing_includes, 49u);
  const std::string all = reports(diagnostics);
  EXPECT_NE(all.find(":202: more than 200 include paths"), std::string::npos) << all;
  EXPECT_NE(all.find("more than 50 files"), std::string::npos) << all;
}

TEST_F(Includes, InheritTheFormatAndKeepTheirOwn) {
  directory.write("plain.k", "*NODE\n");
  directory.write("own.k", "*KEYWORD LONG=S\n*PART\n");
  directory.write("main.k", "*KEYWORD LONG=Y\n*INCLUDE\nplain.k\nown.k\n*TITLE\n");
  read("main.k");
  std::string formats;
  for (const Block& block : deck.blocks())
    if (block.name == "NODE" || block.name == "PART" || block.name == "TITLE")
      formats += block.name + (block.format == Format::long_fields ? " long " : " standard ");
  EXPECT_EQ(formats, "NODE long PART standard TITLE long ");
}

TEST_F(Includes, AutoOffset) {
  directory.write("mesh.k",
                  "*NODE\n       3\n*ELEMENT_SHELL\n       2       1       3\n*SET_NODE\n         7\n         3\n");
  directory.write("main.k",
                  "*NODE\n      40\n      12\n*ELEMENT_BEAM\n       9\n*INCLUDE_AUTO_OFFSET\nmesh.k\nmesh.k\n"
                  "*INCLUDE_AUTO_OFFSET_USER\nmesh.k\n       100       200\n");
  read("main.k");
  const std::string all = reports(diagnostics);
  EXPECT_EQ(diagnostics.sorted().size(), 2u) << all;
  EXPECT_EQ(count_errors(diagnostics), 0u) << all;
  EXPECT_NE(all.find("main.k:7: *INCLUDE_AUTO_OFFSET: in \"mesh.k\" the ids of nodes are shifted by 40 and those of "
                     "elements by 9"),
            std::string::npos)
      << all;
  EXPECT_NE(all.find("main.k:8: *INCLUDE_AUTO_OFFSET: in \"mesh.k\" the ids of nodes are shifted by 43 and those of "
                     "elements by 11"),
            std::string::npos)
      << all;
  std::string ids;
  const CardLayout set_line{"line", {{"nid", 0, 10, FieldType::integer, IdKind::node}}};
  for (const Block& block : deck.blocks()) {
    CardReader reader(deck, block, diagnostics);
    if (block.name == "NODE") ids += " n" + std::to_string(reader.next(card_layout("NODE", "card1")).integer("nid"));
    if (block.name == "ELEMENT_SHELL") {
      const Card card = reader.next(card_layout("ELEMENT_SHELL", "card1"));
      ids += " e" + std::to_string(card.integer("eid")) + ":" + std::to_string(card.integer("n1"));
    }
    if (block.name == "SET_NODE") {
      reader.skip();
      ids += " s" + std::to_string(reader.next(set_line).integer(std::size_t{0}));
    }
  }
  EXPECT_EQ(ids, " n40 n43 e11:43 s3 n46 e13:46 s3 n103 e202:103 s103");
  EXPECT_EQ(deck.id_in_file(FileIndex(1), IdKind::node, 43), 3);
  EXPECT_EQ(deck.id_in_file(FileIndex(2), IdKind::element, 13), 2);
  EXPECT_EQ(deck.id_in_file(FileIndex(0), IdKind::node, 40), 0) << "not shifted";
  EXPECT_EQ(deck.id_in_file(FileIndex(3), IdKind::node, 103), 0) << "the deck says by how much";
}

TEST_F(Includes, AutoOffsetInOthers) {
  directory.write("mesh.k", "*NODE\n       3\n*SET_NODE\n         7\n         3\n");
  directory.write("outer.k",
                  "*NODE\n       2\n*INCLUDE_AUTO_OFFSET\nmesh.k\n*INCLUDE_TRANSFORM\ninner.k\n      5000\n\n\n\n");
  directory.write("inner.k", "$ gapcheck: here\n*NODE\n       1\n*SET_NODE\n         8\n         1\n");
  directory.write("main.k",
                  "*NODE\n      10\n*INCLUDE_TRANSFORM\nouter.k\n      1000\n\n\n\n\n*INCLUDE_AUTO_OFFSET\nouter.k\n");
  read("main.k");
  EXPECT_EQ(count_errors(diagnostics), 0u) << reports(diagnostics);
  std::string offsets;
  for (const Block& block : deck.blocks())
    if (block.name == "NODE" || block.name == "SET_NODE")
      offsets += " " + block.name.substr(0, 1) + std::to_string(deck.transform(block.transform).offset[1]);
  // outer.k itself, mesh.k in it above 1002, inner.k; then the same above all of these.
  EXPECT_EQ(offsets, " N0 N1000 N2002 S1000 N6000 S6000 N6001 N12004 S0 N11001 S5000");
  ASSERT_EQ(deck.directives().size(), 2u);
  EXPECT_EQ(deck.transform(deck.directives()[1].transform).offset[1], 11001) << "comments name nodes of the mesh";
}

TEST_F(Includes, AutoOffsetOfAMissingFileIsOnlyAnError) {
  directory.write("main.k", "*NODE\n      40\n*INCLUDE_AUTO_OFFSET\nmesh.k\n");
  read("main.k");
  EXPECT_EQ(diagnostics.sorted().size(), 1u) << reports(diagnostics);
  EXPECT_EQ(count_errors(diagnostics), 1u);
}

}  // namespace
}  // namespace gapcheck::keyword::includes_test
