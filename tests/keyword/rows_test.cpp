#include "keyword/rows.hpp"

#include <atomic>
#include <random>

#include "base/number.hpp"
#include "base/parallel.hpp"
#include "slow_twins.hpp"
#include "support.hpp"

namespace gapcheck::keyword::rows_test {
namespace {

void expect_same(TextDeck& deck, const Block& block, const CardLayout& layout) {
  Diagnostics fast_reports, slow_reports;
  const Rows fast = read_rows(deck.deck, block, layout, fast_reports);
  const Rows slow = read_by_card(deck.deck, block, layout, slow_reports);
  ASSERT_EQ(fast.count, slow.count);
  ASSERT_EQ(fast.lines, slow.lines);
  ASSERT_EQ(fast.integers, slow.integers);
  ASSERT_EQ(fast.reals, slow.reals);
  EXPECT_EQ(reports(fast_reports), reports(slow_reports));
  EXPECT_EQ(fast_reports.dropped(), slow_reports.dropped());
}

TEST(Rows, ReadNodes) {
  TextDeck deck("*NODE\n$ comment\n       1             1.5            -2.5             0.0       7\n\n2,1,2,3\n");
  const Rows rows = read_rows(deck.deck, deck.block("NODE"), card_layout("NODE", "card1"), deck.diagnostics);
  ASSERT_EQ(rows.count, 2u);
  EXPECT_EQ(rows.integer_columns, 3u);
  EXPECT_EQ(rows.real_columns, 3u);
  EXPECT_EQ(rows.integers, (std::vector<std::int64_t>{1, 7, 0, 2, 0, 0}));
  EXPECT_EQ(rows.reals, (std::vector<double>{1.5, -2.5, 0, 1, 2, 3}));
  EXPECT_EQ(rows.lines, (std::vector<std::uint32_t>{3, 5}));
}

TEST(Rows, EmptyBlock) {
  for (const char* text : {"*NODE\n", "*NODE", "*NODE\n$ only a comment\n\n", "*NODE\n\n\n*END\n"}) {
    TextDeck deck(text);
    EXPECT_EQ(read_rows(deck.deck, deck.block("NODE"), card_layout("NODE", "card1"), deck.diagnostics).count, 0u);
  }
}

TEST(Rows, LastLineWithoutEnd) {
  TextDeck deck("*NODE\n       1             1.5");
  const Rows rows = read_rows(deck.deck, deck.block("NODE"), card_layout("NODE", "card1"), deck.diagnostics);
  ASSERT_EQ(rows.count, 1u);
  EXPECT_EQ(rows.reals[0], 1.5);
}

/// One field as decks write it, mostly well formed.
std::string random_field(std::mt19937& random, const Field& field, std::size_t width) {
  static const std::vector<std::string> odd{"&p",
                                            "-&p",
                                            "<p*2>",
                                            "1.5-3",
                                            "1.0D+2",
                                            "x",
                                            "1 2",
                                            "inf",
                                            "nan",
                                            "0x10",
                                            "1e31",
                                            "1e-400",
                                            "-",
                                            "+5",
                                            "++5",
                                            "1.0",
                                            "1.2E1",
                                            "(1,2)",
                                            "1\t2",
                                            "\t3",
                                            "$",
                                            "-.",
                                            ".5",
                                            "5.",
                                            "1\r",
                                            "9999999999999999999",
                                            std::string("1\0", 2)};
  std::string text;
  const auto pick = random() % 40;
  if (pick == 0) {
    text = odd[random() % odd.size()];
  } else if (pick < 4) {
    text = "";
  } else if (field.type == FieldType::integer) {
    text = std::to_string(static_cast<std::int64_t>(random() % 100000000) * (random() % 10 == 0 ? -1 : 1));
  } else {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, random() % 2 == 0 ? "%.7g" : "%.9E",
                  (static_cast<double>(random()) - 2e9) * std::pow(10.0, static_cast<int>(random() % 20) - 15));
    text = buffer;
  }
  if (text.size() > width) text = text.substr(0, width);
  const std::string fill(width - text.size(), ' ');
  return random() % 4 == 0 ? text + fill : fill + text;
}

std::string random_line(std::mt19937& random, const CardLayout& layout, Format format) {
  if (random() % 30 == 0) return "$ a comment, with commas";
  if (random() % 30 == 0) return std::string(random() % 20, ' ');
  const bool free = random() % 4 == 0;
  const std::string padding = random() % 2 == 0 ? "" : " ";
  std::string line;
  for (std::size_t i = 0; i < layout.fields.size(); ++i) {
    const Cell cell = locate(layout, format, i);
    if (free)
      line += (i > 0 ? "," + padding : "") + std::string(trimmed(random_field(random, layout.fields[i], cell.width)));
    else
      line += std::string(cell.column > line.size() ? cell.column - line.size() : 0, ' ') +
              random_field(random, layout.fields[i], cell.width);
  }
  if (random() % 5 == 0) line = line.substr(0, random() % (line.size() + 1));
  if (random() % 20 == 0) line += "  remark, with comma";
  if (random() % 10 == 0 && !line.empty()) line[random() % line.size()] = ",\t&(x"[random() % 5];
  if (random() % 10 == 0) line += "\r";
  for (char& c : line)
    if (c == '\n') c = ' ';
  return line.starts_with("*") ? " " + line : line;
}

TEST(Rows, AgreeWithCardsOnRandomBlocks) {
  std::mt19937 random(5);
  const std::vector<std::pair<const char*, const char*>> cards{{"NODE", "card1"},         {"ELEMENT_SHELL", "card1"},
                                                               {"ELEMENT_BEAM", "card1"}, {"ELEMENT_DISCRETE", "card1"},
                                                               {"CONTACT", "C"},          {"ELEMENT_SOLID", "card2"}};
  for (int round = 0; round < 400; ++round) {
    const auto& [keyword, card] = cards[random() % cards.size()];
    const CardLayout& layout = card_layout(keyword, card);
    const auto format = static_cast<Format>(random() % 3);
    // A NUL further up would make it no keyword file.
    std::string text = "$" + std::string(4096, ' ') + "\n*PARAMETER\n" + pair("I p", "5") + "\n*NODE";
    text += format == Format::long_fields ? "+\n" : format == Format::i10 ? "%\n" : "\n";
    for (auto rows = random() % 60; rows > 0; --rows) text += random_line(random, layout, format) + "\n";
    TextDeck deck(text);
    expect_same(deck, deck.block("NODE"), layout);
    if (HasFatalFailure()) FAIL() << text;
  }
}

TEST(Rows, AgreeWithCardsUnderOffsets) {
  std::mt19937 random(12);
  const TemporaryDirectory directory;
  for (int round = 0; round < 60; ++round) {
    const CardLayout& layout = card_layout(random() % 2 == 0 ? "NODE" : "ELEMENT_SHELL", "card1");
    std::string text = "$" + std::string(4096, ' ') + "\n*NODE\n";
    for (auto rows = random() % 60; rows > 0; --rows) text += random_line(random, layout, Format::standard) + "\n";
    directory.write("mesh.k", text);
    const auto offsets =
        round % 10 == 0 ? "9000000000000000000,9000000000000000000,-9000000000000000000" : "10,-2000,300";
    const auto main = directory.write("main.k", "*INCLUDE_TRANSFORM\nmesh.k\n" + std::string(offsets) + "\n");
    TextDeck deck("*KEYWORD\n");
    auto result = read_deck(main, {}, deck.diagnostics);
    ASSERT_TRUE(result.ok());
    deck.deck = std::move(result).value();
    expect_same(deck, deck.block("NODE"), layout);
  }
}

TEST(Rows, ManyPiecesAndThreadsGiveTheSame) {
  std::mt19937 random(6);
  const CardLayout& layout = card_layout("NODE", "card1");
  std::string text = "$" + std::string(4096, ' ') + "\n*PARAMETER\n" + pair("I p", "5") + "\n*NODE\n";
  for (int i = 0; i < 30000; ++i) text += random_line(random, layout, Format::standard) + "\n";
  ASSERT_GT(text.size(), std::size_t{1} << 20);
  TextDeck deck(text);
  expect_same(deck, deck.block("NODE"), layout);
  Diagnostics one_reports, many_reports;
  std::optional<Rows> one, many;
  {
    const JobLimit jobs(1);
    one = read_rows(deck.deck, deck.block("NODE"), layout, one_reports);
  }
  {
    const JobLimit jobs(4);
    many = read_rows(deck.deck, deck.block("NODE"), layout, many_reports);
  }
  EXPECT_EQ(one->integers, many->integers);
  EXPECT_EQ(one->reals, many->reals);
  EXPECT_EQ(one->lines, many->lines);
  EXPECT_EQ(reports(one_reports), reports(many_reports));
}

/// Lines that end behind their fields, at them or before them, with all line ends; the first and the last ones stand at
/// the ends of the text.
TEST(Rows, AlignedLinesOfAllLengths) {
  const CardLayout& layout = card_layout("NODE", "card1");
  const std::string row = "      12   1.5000000E+00 -12.25         1.0D-03           7       0";
  for (const char* end : {"\n", "\r\n", "  \n", " remark\n", "\t\n"})
    for (std::size_t length = 0; length <= row.size(); ++length) {
      std::string text = "*NODE\n";
      for (int i = 0; i < 8; ++i) text += row.substr(0, i % 4 == 3 ? length : row.size()) + end;
      TextDeck deck(text + row.substr(0, length));
      expect_same(deck, deck.block("NODE"), layout);
      if (HasFatalFailure()) FAIL() << length << " columns";
    }
}

TEST(Rows, PiecesCoverTheBlockOnce) {
  std::mt19937 random(8);
  const CardLayout& layout = card_layout("NODE", "card1");
  std::string text = "$" + std::string(4096, ' ') + "\n*PARAMETER\n" + pair("I p", "5") + "\n*NODE\n";
  for (int i = 0; i < 10000; ++i) text += random_line(random, layout, Format::standard) + "\n";
  TextDeck deck(text);
  const Rows whole = read_rows(deck.deck, deck.block("NODE"), layout, deck.diagnostics);
  std::vector<std::uint32_t> lines;
  std::atomic<std::size_t> pieces = 0;
  const auto make_room = [&](std::size_t count) {
    EXPECT_EQ(count, whole.count);
    EXPECT_TRUE(lines.empty());
    lines.resize(count);
  };
  const auto take = [&](std::size_t first, const Rows& rows) {
    ++pieces;
    ASSERT_LE(first + rows.count, lines.size());
    for (std::size_t i = 0; i < rows.count; ++i) lines[first + i] += rows.lines[i];
    EXPECT_TRUE(std::equal(rows.reals.data(), rows.reals.data() + 3 * rows.count, whole.reals.data() + 3 * first));
  };
  Diagnostics again;
  read_rows_in_pieces(deck.deck, deck.block("NODE"), layout, again, make_room, take);
  EXPECT_GT(pieces, 5u);
  EXPECT_EQ(lines, whole.lines);
}

TEST(Rows, IdsTakeTheOffsetsOfTheirInclude) {
  const TemporaryDirectory directory;
  directory.write("mesh.k", "*ELEMENT_SHELL\n       1       2       3       4       5       0\n1,2,3,4,5,-6,0\n");
  const auto main = directory.write("main.k", "*INCLUDE_TRANSFORM\nmesh.k\n      1000      2000      3000\n");
  Diagnostics diagnostics;
  const auto deck = read_deck(main, {}, diagnostics);
  ASSERT_TRUE(deck.ok());
  const Block& block = deck.value().blocks().back();
  const Rows rows = read_rows(deck.value(), block, card_layout("ELEMENT_SHELL", "card1"), diagnostics);
  EXPECT_EQ(rows.integers, (std::vector<std::int64_t>{2001, 3002, 1003, 1004, 1005, 0,     0, 0, 0, 0,  //
                                                      2001, 3002, 1003, 1004, 1005, -1006, 0, 0, 0, 0}));
  EXPECT_EQ(reports(diagnostics), "");
}

}  // namespace
}  // namespace gapcheck::keyword::rows_test
