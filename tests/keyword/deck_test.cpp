#include "keyword/deck.hpp"

#include <random>

#include "support.hpp"

namespace gapcheck::keyword::deck_test {
namespace {

TEST(Deck, BlocksWithNamesLinesAndBodies) {
  TextDeck deck(
      "$ head\n*keyword\n*Node\n       1\n$ c\n       2\n*SECTION_SHELL_TITLE   rest\ntitle\n*END\n*NODE\n3\n");
  EXPECT_EQ(names(deck.deck), (std::vector<std::string>{"KEYWORD", "NODE", "SECTION_SHELL_TITLE", "END"}));
  const Block& node = deck.block("NODE");
  EXPECT_EQ(node.line, 3u);
  EXPECT_EQ(node.order, 1u);
  EXPECT_EQ(node.body, "       1\n$ c\n       2\n");
  EXPECT_EQ(deck.block("END").body, "");
  EXPECT_EQ(reports(deck.diagnostics), "");
  EXPECT_EQ(deck.deck.counters().files, 1u);
}

TEST(Deck, CarriageReturnsSuffixesAndByteOrderMark) {
  TextDeck deck("\xEF\xBB\xBF*KEYWORD\r\n*NODE+\r\n1\r\n*ELEMENT_SHELL%\r\n*PART-\r\n");
  EXPECT_EQ(names(deck.deck), (std::vector<std::string>{"KEYWORD", "NODE", "ELEMENT_SHELL", "PART"}));
  EXPECT_EQ(deck.block("NODE").format, Format::long_fields);
  EXPECT_EQ(deck.block("ELEMENT_SHELL").format, Format::i10);
  EXPECT_EQ(deck.block("PART").format, Format::standard);
  EXPECT_EQ(deck.block("NODE").body, "1\r\n");
}

TEST(Deck, SuffixesBehindBlanks) {
  TextDeck deck("*KEYWORD LONG=Y\n*NODE -\n*ELEMENT_SHELL \t% \n*PART  - a title\n*NODE_X +\n");
  EXPECT_EQ(names(deck.deck), (std::vector<std::string>{"KEYWORD", "NODE", "ELEMENT_SHELL", "PART", "NODE_X"}));
  EXPECT_EQ(deck.block("NODE").format, Format::standard);
  EXPECT_EQ(deck.block("ELEMENT_SHELL").format, Format::i10);
  EXPECT_EQ(deck.block("PART").format, Format::long_fields) << "a sign that begins something else";
  EXPECT_EQ(deck.block("NODE_X").format, Format::long_fields);
}

TEST(Deck, DataBeforeTheFirstKeyword) {
  TextDeck deck("$ fine\n\n 1 2 3\n more\n*NODE\n");
  EXPECT_EQ(count_errors(deck.diagnostics), 1u);
  EXPECT_NE(reports(deck.diagnostics).find("deck.k:3: data before the first keyword"), std::string::npos);
}

TEST(Deck, KeywordWithoutName) {
  TextDeck deck("*KEYWORD\n*\n* NODE\n*+\n");
  EXPECT_EQ(count_errors(deck.diagnostics), 3u);
}

TEST(Deck, FilesThatAreNoDecks) {
  const TemporaryDirectory directory;
  Diagnostics diagnostics;
  const auto problem = [&](const std::string& path) {
    const auto deck = read_deck(path, {}, diagnostics);
    EXPECT_FALSE(deck.ok()) << path;
    return deck.ok() ? "" : deck.error().message;
  };
  EXPECT_NE(problem(directory.write("empty.k", "")).find("empty"), std::string::npos);
  EXPECT_NE(problem(directory.write("d3plot", std::string("abc\0\0\1", 6))).find("not a keyword file"),
            std::string::npos);
  EXPECT_NE(problem(directory.path("missing.k")).find("cannot be opened"), std::string::npos);
  EXPECT_NE(problem(directory.path()).find("directory"), std::string::npos);
}

TEST(Deck, TextWithoutAKeyword) {
  for (const char* text : {"hello world\n", "$ only\n$ comments\n", " *NODE\n", "\n"}) {
    Diagnostics diagnostics;
    const auto deck = read_deck_text(text, "notes.txt", {}, diagnostics);
    ASSERT_FALSE(deck.ok()) << text;
    EXPECT_EQ(deck.error().message, "holds no keyword (no line of it starts with *); give an LS-DYNA keyword file");
    EXPECT_EQ(deck.error().file, "notes.txt");
  }
  const TemporaryDirectory directory;
  Diagnostics diagnostics;
  EXPECT_FALSE(read_deck(directory.write("notes.txt", "hello\n"), {}, diagnostics).ok());
  // An include may hold nothing but comments.
  directory.write("empty.k", "$ later\n");
  EXPECT_TRUE(read_deck(directory.write("main.k", "*INCLUDE\nempty.k\n*END\n"), {}, diagnostics).ok());
  EXPECT_EQ(reports(diagnostics), "");
}

TEST(Deck, ANoteIfTheMainFileHasNoEnd) {
  const auto note = [](const Deck& deck) {
    Diagnostics diagnostics;
    note_missing_end(deck, diagnostics);
    EXPECT_EQ(count_errors(diagnostics), 0U);
    return reports(diagnostics);
  };
  EXPECT_EQ(note(TextDeck("*KEYWORD\n*NODE\n1\n*END\n").deck), "");
  EXPECT_NE(note(TextDeck("*KEYWORD\n*NODE\n1\n").deck).find("ends without *END"), std::string::npos);
  EXPECT_EQ(note(TextDeck("*NODE\n-----BEGIN PGP MESSAGE-----\nx\n-----END PGP MESSAGE-----\n").deck), "");
  const TemporaryDirectory directory;
  directory.write("part.k", "*NODE\n1\n");
  directory.write("ended.k", "*NODE\n1\n*END\n");
  Diagnostics diagnostics;
  EXPECT_EQ(note(read_deck(directory.write("a.k", "*INCLUDE\npart.k\n*END\n"), {}, diagnostics).value()), "");
  EXPECT_NE(note(read_deck(directory.write("b.k", "*INCLUDE\nended.k\n"), {}, diagnostics).value()), "")
      << "the end of an include is not that of the deck";
}

TEST(Deck, EncryptedBlocksArePassedOver) {
  TextDeck deck(
      "*KEYWORD\n*NODE\n       1\n-----BEGIN PGP MESSAGE-----\nVersion: 1\n\nabcdef\n-----END PGP MESSAGE-----\n"
      "*PART\n-----BEGIN PGP MESSAGE-----\nabc\n-----END PGP MESSAGE-----\n 1 2 3\n*END\n");
  EXPECT_EQ(names(deck.deck), (std::vector<std::string>{"KEYWORD", "NODE", "PART", "END"}));
  EXPECT_EQ(deck.block("NODE").body, "       1\n");
  EXPECT_EQ(deck.deck.counters().encrypted_blocks, 2u);
  const std::string all = reports(deck.diagnostics);
  for (const char* part :
       {"deck.k:4: an encrypted block", "deck.k:10: an encrypted block", "deck.k:13: the lines between"})
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
  EXPECT_FALSE(deck.diagnostics.has_errors());
}

TEST(Deck, EncryptedBlockWithoutEnd) {
  TextDeck deck("*NODE\n1\n-----BEGIN PGP MESSAGE-----\nabc\n*PART\n");
  EXPECT_EQ(names(deck.deck), (std::vector<std::string>{"NODE"}));
  EXPECT_NE(reports(deck.diagnostics).find("without end"), std::string::npos);
}

TEST(Deck, CasesAreReadAsOneModel) {
  TextDeck deck("*CASE_BEGIN_1\n*NODE\n*CASE_END_1\n*CASE_BEGIN_2\n*PART\n*CASE_END_2\n");
  EXPECT_EQ(deck.deck.blocks().size(), 6u);
  EXPECT_EQ(deck.diagnostics.sorted().size(), 1u);
}

TEST(Deck, UnsupportedIncludesAreNamed) {
  TextDeck deck("*INCLUDE_STAMPED_PART\nforming.k\n         1\n*INCLUDE_BINARY\nbig.bin\n");
  const std::string all = reports(deck.diagnostics);
  EXPECT_NE(all.find("deck.k:1: *INCLUDE_STAMPED_PART is not supported: \"forming.k\""), std::string::npos) << all;
  EXPECT_NE(all.find("big.bin"), std::string::npos);
  EXPECT_FALSE(deck.diagnostics.has_errors());
}

TEST(Deck, RandomTextNeverCrashes) {
  std::mt19937 random(9);
  const std::vector<std::string> pieces{"*",
                                        "\n",
                                        "KEYWORD",
                                        " LONG=Y",
                                        "INCLUDE",
                                        "\n*PARAMETER\n",
                                        "R a",
                                        "1.5",
                                        ",",
                                        "&",
                                        "<",
                                        ">",
                                        "\n*PARAMETER_EXPRESSION\n",
                                        "*INCLUDE_TRANSFORM\n",
                                        "deck.k",
                                        " +",
                                        "$",
                                        "\n*DEFINE_TRANSFORMATION\n",
                                        "ROTATE",
                                        "\t",
                                        "\r\n",
                                        "-----BEGIN PGP MESSAGE-----",
                                        "-----END PGP MESSAGE-----",
                                        "\n*END",
                                        std::string(300, 'x'),
                                        "*INCLUDE_PATH\n",
                                        "/",
                                        "%"};
  for (int round = 0; round < 3000; ++round) {
    std::string text = "*KEYWORD\n";
    for (auto n = random() % 60; n > 0; --n) text += pieces[random() % pieces.size()];
    Diagnostics diagnostics;
    const auto deck = read_deck_text(text, "deck.k", {}, diagnostics);
    ASSERT_TRUE(deck.ok());
    for (const Block& block : deck.value().blocks()) {
      CardReader reader(deck.value(), block, diagnostics);
      while (!reader.at_end()) {
        const Card card = reader.next(card_layout("NODE", "card1"));
        for (std::size_t i = 0; i < card.size(); ++i)
          (void)(card.integer(i) + static_cast<std::int64_t>(card.real(i) > 0));
      }
    }
  }
}

}  // namespace
}  // namespace gapcheck::keyword::deck_test
