#include "keyword/card.hpp"

#include <random>

#include "support.hpp"

namespace gapcheck::keyword::card_test {
namespace {

TEST(Card, FixedColumns) {
  TextDeck deck("*NODE\n       1             1.5            -2.5             0.0       7\n  100002     1.0E+00   \n");
  auto reader = deck.reader("NODE");
  const CardLayout& layout = card_layout("NODE", "card1");
  const Card first = reader.next(layout);
  EXPECT_TRUE(first.present());
  EXPECT_EQ(first.line(), 2u);
  EXPECT_EQ(first.integer("nid"), 1);
  EXPECT_EQ(first.real("y"), -2.5);
  EXPECT_EQ(first.integer("tc"), 7);
  EXPECT_TRUE(first.blank("rc"));
  EXPECT_EQ(first.integer("rc", -1), -1);
  EXPECT_EQ(first.integer("no such field", 5), 5);
  const Card second = reader.next(layout);
  EXPECT_EQ(second.integer("nid"), 100002);
  EXPECT_EQ(second.real("x"), 1);
  EXPECT_EQ(second.real("z", 9), 9);
  EXPECT_TRUE(reader.at_end());
  const Card none = reader.next(layout);
  EXPECT_FALSE(none.present());
  EXPECT_TRUE(none.blank("nid"));
  EXPECT_EQ(none.integer("nid", 3), 3);
  EXPECT_TRUE(Card().blank("nid"));
  EXPECT_EQ(reports(deck.diagnostics), "");
}

TEST(Card, IdsMayFillTheirFields) {
  TextDeck deck("*ELEMENT_SHELL\n12345678       1123456791234567012345671\n");
  const Card card = deck.reader("ELEMENT_SHELL").next(card_layout("ELEMENT_SHELL", "card1"));
  EXPECT_EQ(card.integer("eid"), 12345678);
  EXPECT_EQ(card.integer("pid"), 1);
  EXPECT_EQ(card.integer("n1"), 12345679);
  EXPECT_EQ(card.integer("n2"), 12345670);
}

TEST(Card, LongFormat) {
  const std::string row =
      "                   1                 1.5                -2.5                 0.5                   3";
  for (const std::string head : {"*KEYWORD LONG=Y\n*NODE\n", "*keyword long=y\n*node\n", "*NODE+\n",
                                 "*KEYWORD MEMORY=20M LONG = Y\n*NODE\n", "*KEYWORD\n*Node+  comment\n"}) {
    TextDeck deck(head + row + "\n");
    const Card card = deck.reader("NODE").next(card_layout("NODE", "card1"));
    EXPECT_EQ(card.integer("nid"), 1) << head;
    EXPECT_EQ(card.real("z"), 0.5) << head;
    EXPECT_EQ(card.integer("tc"), 3) << head;
  }
}

TEST(Card, StandardFormatWinsWithMinus) {
  TextDeck deck("*KEYWORD LONG=Y\n*NODE-\n       1             1.5            -2.5             0.0\n*NODE\n");
  EXPECT_EQ(deck.reader("NODE").next(card_layout("NODE", "card1")).real("y"), -2.5);
  for (const char* head : {"*KEYWORD LONG=S\n*NODE\n", "*KEYWORD LONG=K\n*NODE\n", "*KEYWORD ALONG=Y\n*NODE\n"})
    EXPECT_EQ(TextDeck(head).block("NODE").format, Format::standard) << head;
}

TEST(Card, I10Format) {
  const std::string row = "         1             1.5            -2.5             0.5         3";
  for (const std::string head : {"*KEYWORD I10=Y\n*NODE\n", "*KEYWORD i10=y\n*NODE\n", "*NODE%\n"}) {
    TextDeck deck(head + row + "\n");
    const Card card = deck.reader("NODE").next(card_layout("NODE", "card1"));
    EXPECT_EQ(card.integer("nid"), 1) << head;
    EXPECT_EQ(card.real("z"), 0.5) << head;
    EXPECT_EQ(card.integer("tc"), 3) << head;
  }
}

TEST(Card, FreeFormatCountsUnusedColumns) {
  TextDeck deck("*CONTACT\n1,2,3.5,4.5,5.5,6,7.5,8\n,9.5\n");
  auto reader = deck.reader("CONTACT");
  const Card c = reader.next(card_layout("CONTACT", "C"));
  EXPECT_EQ(c.integer("ignore"), 2);
  EXPECT_EQ(c.real("edgek"), 5.5);
  EXPECT_EQ(c.real("flangl"), 7.5);
  EXPECT_EQ(c.integer("cid_rcf"), 8);
  EXPECT_EQ(reader.next(card_layout("CONTACT", "G")).real("shloff"), 9.5);
}

TEST(Card, UnusedColumnsKeepTheirPlaceInLongFormat) {
  const CardLayout& c = card_layout("CONTACT", "C");
  const Cell flangl = locate(c, Format::long_fields, c.index("flangl"));
  EXPECT_EQ(flangl.column, 120u);
  EXPECT_EQ(flangl.width, 20u);
  EXPECT_EQ(flangl.slot, 6u);
}

TEST(Card, FreeFormatEmptyAndMissingValuesAreBlank) {
  TextDeck deck("*NODE\n 5 , ,2.5\n1,2,3,4,5,6,7,8\n");
  auto reader = deck.reader("NODE");
  const Card card = reader.next(card_layout("NODE", "card1"));
  EXPECT_EQ(card.integer("nid"), 5);
  EXPECT_TRUE(card.blank("x"));
  EXPECT_EQ(card.real("y"), 2.5);
  EXPECT_TRUE(card.blank("z"));
  EXPECT_EQ(reader.next(card_layout("NODE", "card1")).integer("rc"), 6);
}

TEST(Card, CommasInTextsAreText) {
  TextDeck deck(
      "*PART\nplate, front, left\n*CONTACT_ID\n         7bumper, left\n8,bumper, right\n*DEFINE_TRANSFORMATION\n"
      "TRANSL,1,2,3\n");
  EXPECT_EQ(deck.reader("PART").next(card_layout("PART", "card1.1")).text("heading"), "plate, front, left");
  auto reader = deck.reader("CONTACT_ID");
  const Card fixed = reader.next(card_layout("CONTACT", "ID"));
  EXPECT_EQ(fixed.integer("cid"), 7);
  EXPECT_EQ(fixed.text("heading"), "bumper, left");
  const Card free = reader.next(card_layout("CONTACT", "ID"));
  EXPECT_EQ(free.integer("cid"), 8);
  EXPECT_EQ(free.text("heading"), "bumper, right");
  const Card row = deck.reader("DEFINE_TRANSFORMATION").next(card_layout("DEFINE_TRANSFORMATION", "card2"));
  EXPECT_EQ(row.text("option"), "TRANSL");
  EXPECT_EQ(row.real("a3"), 3);
}

TEST(Card, CommasBehindTheCardAreRemarks) {
  TextDeck deck("*SET_TSHELL\n         5   a remark, with comma\n");
  EXPECT_EQ(deck.reader("SET_TSHELL").next(card_layout("SET_TSHELL", "card1")).integer("sid"), 5);
}

TEST(Card, ParametersAndExpressions) {
  TextDeck deck("*KEYWORD\n*PARAMETER\n" + pair("I n", "5") + pair("R x", "2.5") + pair("R whole", "4.0") +
                pair("C t", "abc") +
                "\n*NODE\n"
                "      &n              &X             -&x <x*2+sqrt(4)>   &whole\n&n,-&x,<max(x,9)>,1.0\n"
                "     -&n\n*PART\n&t\n& others\n*END\n");
  auto reader = deck.reader("NODE");
  const Card card = reader.next(card_layout("NODE", "card1"));
  EXPECT_EQ(card.integer("nid"), 5);
  EXPECT_EQ(card.real("x"), 2.5);
  EXPECT_EQ(card.real("y"), -2.5);
  EXPECT_EQ(card.integer("tc"), 4);
  const Card free = reader.next(card_layout("NODE", "card1"));
  EXPECT_EQ(free.integer("nid"), 5);
  EXPECT_EQ(free.real("x"), -2.5);
  EXPECT_EQ(free.real("y"), 9);
  EXPECT_EQ(reader.next(card_layout("NODE", "card1")).integer("nid"), -5);
  auto parts = deck.reader("PART");
  EXPECT_EQ(parts.next(card_layout("PART", "card1.1")).text("heading"), "abc");
  EXPECT_EQ(parts.next(card_layout("PART", "card1.1")).text("heading"), "& others");
  EXPECT_EQ(reports(deck.diagnostics), "");
}

TEST(Card, ExpressionInAFixedField) {
  TextDeck deck("*PARAMETER\n" + pair("R x", "2.5") + "\n*NODE\n       1       <2*x+2>     <x,1>\n");
  EXPECT_EQ(deck.reader("NODE").next(card_layout("NODE", "card1")).real("x"), 0);
  TextDeck fixed("*PARAMETER\n" + pair("R x", "2.5") + "\n*NODE\n       1         <2*x+2>     <max(x,1)>\n");
  const Card card = fixed.reader("NODE").next(card_layout("NODE", "card1"));
  EXPECT_EQ(card.real("x"), 7);
  EXPECT_EQ(card.real("y"), 2.5);
  EXPECT_EQ(reports(fixed.diagnostics), "");
}

TEST(Card, ExpressionsWithParametersInFields) {
  TextDeck deck("*PARAMETER\n" + pair("R t", "2.0") + pair("I n", "7") + pair("R odd-name", "4.") +
                "\n*SECTION_SHELL\n"
                "&t*0.99   -&t+1     2*&t      (&t+1)*2  sqrt(&n+2)-&t*-&t   &odd-name 1-&t/4\n"
                "&t * 0.5 , -&t, &n*100\n");
  CardReader reader = deck.reader("SECTION_SHELL");
  const CardLayout reals{"line", std::vector<Field>(8, Field{"x", 0, 10, FieldType::real, IdKind::plain})};
  CardLayout row = reals;
  for (std::size_t i = 0; i < 8; ++i) row.fields[i].column = static_cast<std::uint16_t>(10 * i);
  const Card card = reader.next(row);
  const double expected[] = {1.98, -1, 4, 6, 3, 4, 4, 0.5};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(card.real(i), expected[i]) << i;
  const Card free = reader.next(row);
  EXPECT_EQ(free.real(std::size_t{0}), 1);
  EXPECT_EQ(free.real(1), -2);
  EXPECT_EQ(free.integer(2), 700);
  EXPECT_EQ(reports(deck.diagnostics), "");
}

TEST(Card, ExpressionsForWholeNumbers) {
  TextDeck deck("*PARAMETER\n" + pair("R f", "0.07") + pair("I n", "7") +
                "\n*NODE\n&f*100  \n&n/2.    \n&n*1e30 \n&f/0    \n&n+     \n&n+&no  \n");
  CardReader reader = deck.reader("NODE");
  const CardLayout& node = card_layout("NODE", "card1");
  for (const std::int64_t expected : {7, 0, 0, 0, 0, 0}) EXPECT_EQ(reader.next(node).integer("nid"), expected);
  const std::string all = reports(deck.diagnostics);
  EXPECT_EQ(count_errors(deck.diagnostics), 5u) << all;
  for (const char* part : {":5: *NODE, field nid: \"&n/2.\" is not a whole number", ":6: ", ":7: ", "divides by zero",
                           ":8: ", ":9: *NODE, field nid: ", "\"no\" is not defined"})
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
}

TEST(Card, ExpressionsEndWithTheirColumns) {
  TextDeck deck("*PARAMETER\n" + pair("R thick", "2.0") +
                "\n*SECTION_SHELL\n&thick*0.99\n&thick*0.9&thick\n&thick*0.9  \n");
  CardReader reader = deck.reader("SECTION_SHELL");
  const CardLayout& row = card_layout("SECTION_SHELL", "card2");
  for (int i = 0; i < 3; ++i) EXPECT_EQ(reader.next(row).real("t1"), 1.8);
  const std::string all = reports(deck.diagnostics);
  EXPECT_EQ(deck.diagnostics.sorted().size(), 1u) << all;
  EXPECT_NE(all.find("deck.k:4: *SECTION_SHELL, field t1: the expression \"&thick*0.9\" fills its 10 columns"),
            std::string::npos)
      << all;
}

TEST(Card, BadParametersAreReported) {
  TextDeck deck("*PARAMETER\n" + pair("C t", "abc") + pair("R x", "2.5") +
                "\n*NODE\n     &no              &t           <1/0>              <1\n      &x\n");
  auto reader = deck.reader("NODE");
  const Card card = reader.next(card_layout("NODE", "card1"));
  EXPECT_EQ(card.integer("nid"), 0);
  EXPECT_EQ(card.real("x", 4), 4);
  EXPECT_EQ(card.real("y"), 0);
  EXPECT_EQ(card.real("z"), 0);
  EXPECT_EQ(card.integer("nid"), 0);  // reported once
  EXPECT_EQ(reader.next(card_layout("NODE", "card1")).integer("nid"), 0);
  EXPECT_EQ(count_errors(deck.diagnostics), 5u);
  const std::string all = reports(deck.diagnostics);
  for (const char* part : {"deck.k:4: *NODE, field nid: the parameter \"no\"", "field x: the parameter \"t\" is a text",
                           "divides by zero", "lacks the closing", "deck.k:5: *NODE, field nid: \"&x\""})
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
}

TEST(Card, AmpersandAloneIsText) {
  TextDeck deck("*CONTACT\n&                 1\n");
  auto reader = deck.reader("CONTACT");
  EXPECT_TRUE(reader.peek().starts_with("&"));
  const Card card = reader.next(card_layout("CONTACT", "MPP2"));
  EXPECT_EQ(card.text("mpp2"), "&");
  EXPECT_EQ(card.integer("chksegs"), 1);
  EXPECT_EQ(reports(deck.diagnostics), "");
}

TEST(Card, WhatIsNotANumberIsReportedOnceWithItsPlace) {
  TextDeck deck(
      "*KEYWORD\n$\n*NODE\n     abc             1 2           1e400          1.0E31\n99999999999999999999,1\n     "
      "1.5\n");
  auto reader = deck.reader("NODE");
  const Card card = reader.next(card_layout("NODE", "card1"));
  EXPECT_EQ(card.integer("nid", 42), 42);
  EXPECT_EQ(card.integer("nid", 42), 42);
  EXPECT_EQ(card.real("x", 7), 7);
  EXPECT_EQ(card.real("y"), 0);
  EXPECT_EQ(card.real("z"), 0);
  EXPECT_EQ(reader.next(card_layout("NODE", "card1")).integer("nid"), 0);
  EXPECT_EQ(reader.next(card_layout("NODE", "card1")).integer("nid"), 0);
  EXPECT_EQ(count_errors(deck.diagnostics), 6u);
  const std::string all = reports(deck.diagnostics);
  EXPECT_NE(all.find("deck.k:4: *NODE, field nid: \"abc\""), std::string::npos) << all;
  EXPECT_NE(all.find("\"1.0E31\" is larger"), std::string::npos) << all;
}

TEST(Card, BlanksInNumbersAreShownInTheirLine) {
  TextDeck deck("*SECTION_SHELL\n    1.0  2       3.0\n       1.0  2.0   xx\n");
  auto reader = deck.reader("SECTION_SHELL");
  const CardLayout& row = card_layout("SECTION_SHELL", "card2");
  EXPECT_EQ(reader.next(row).real("t1"), 0);
  EXPECT_EQ(reader.next(row).real("t2"), 0);
  const auto said = deck.diagnostics.sorted();
  ASSERT_EQ(said.size(), 2u);
  EXPECT_NE(said[0].message.find("*SECTION_SHELL, field t1: \"1.0  2\" is 2 numbers in one field (columns 1 to 10)"),
            std::string::npos)
      << said[0].message;
  EXPECT_EQ(said[0].excerpt, "    1.0  2       3.0\n^^^^^^^^^^");
  EXPECT_EQ(said[1].excerpt, "") << said[1].message;
}

// However the blanks are read, the field is 0: a shifted row of defaults stops nobody.
TEST(Card, ZerosInOneFieldAreZero) {
  TextDeck deck("*SECTION_SHELL\n  0     0.       3.0\n  0     1.       3.0\n");
  auto reader = deck.reader("SECTION_SHELL");
  const CardLayout& row = card_layout("SECTION_SHELL", "card2");
  const Card zeros = reader.next(row);
  EXPECT_EQ(zeros.real("t1", 7), 0);
  EXPECT_EQ(zeros.real("t2"), 3);
  EXPECT_EQ(reader.next(row).real("t1", 7), 7);
  const auto said = deck.diagnostics.sorted();
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(said[0].severity, Severity::error);
  EXPECT_EQ(said[1].severity, Severity::warning);
  EXPECT_NE(said[1].message.find("; read as 0"), std::string::npos) << said[1].message;
}

TEST(Card, TabsReachToTheNextMultipleOfEight) {
  TextDeck deck("*NODE\n1\t1.5\t\t2.5\t\t3.5\t\t4\n\t  7\n*NODE_SCALAR\n");
  auto reader = deck.reader("NODE");
  const Card card = reader.next(card_layout("NODE", "card1"));
  EXPECT_EQ(card.integer("nid"), 1);
  EXPECT_EQ(card.real("x"), 1.5);
  EXPECT_EQ(card.real("y"), 2.5);
  EXPECT_EQ(card.real("z"), 3.5);
  EXPECT_EQ(card.integer("tc"), 4);
  const Card second = reader.next(card_layout("NODE", "card1"));
  EXPECT_TRUE(second.blank("nid"));
  EXPECT_EQ(second.real("x"), 7);
}

TEST(Card, VeryLongLinesAreReported) {
  TextDeck deck("*NODE\n       1" + std::string(20000, ' ') + "x\n");
  EXPECT_EQ(deck.reader("NODE").next(card_layout("NODE", "card1")).integer("nid"), 1);
  EXPECT_NE(reports(deck.diagnostics).find("longer than 10000"), std::string::npos);
}

TEST(CardReader, PassesOverCommentsAndKeepsBlankLines) {
  TextDeck deck("*TITLE\r\n$ one\r\nfirst\r\n$\r\n\r\nthird\r\n$ end\r\n*END\r\n");
  auto reader = deck.reader("TITLE");
  std::vector<std::pair<std::uint32_t, std::string>> lines;
  for (; !reader.at_end(); reader.skip()) lines.emplace_back(reader.peek_line(), reader.peek());
  EXPECT_EQ(lines, (std::vector<std::pair<std::uint32_t, std::string>>{{3, "first"}, {5, ""}, {6, "third"}}));
  EXPECT_EQ(reader.peek(), "");
}

/// Any card layout, written and read again: what comes out is what went in, whatever the format.
TEST(Card, RandomCardsInEveryFormat) {
  std::mt19937 random(11);
  for (int round = 0; round < 3000; ++round) {
    const auto format = static_cast<Format>(random() % 3);
    const bool free = random() % 3 == 0;
    CardLayout layout{"card", {}};
    std::uint16_t column = 0;
    std::string line;
    std::vector<std::int64_t> values;
    for (std::size_t i = 0, n = 1 + random() % 8; i < n; ++i) {
      const auto width = static_cast<std::uint16_t>(random() % 2 == 0 ? 8 : 10);
      const std::size_t written = format == Format::long_fields ? 20 : format == Format::i10 ? 10 : width;
      if (random() % 5 == 0 && i > 0) {  // a place that no field uses
        column = static_cast<std::uint16_t>(column + width);
        line += free ? "," : std::string(written, ' ');
      }
      layout.fields.push_back({"f" + std::to_string(i), column, width, FieldType::integer, IdKind::plain});
      column = static_cast<std::uint16_t>(column + width);
      values.push_back(random() % 4 == 0 ? 0 : static_cast<std::int64_t>(random() % 10000000) - 5000000);
      const std::string text = values.back() == 0 ? "" : std::to_string(values.back());
      line += free ? text + (i + 1 < n ? "," : "") : std::string(written - text.size(), ' ') + text;
    }
    const char* suffix = format == Format::long_fields ? "+" : format == Format::i10 ? "%" : "";
    TextDeck deck(std::string("*NODE") + suffix + "\n" + line + "\n");
    const Card card = deck.reader("NODE").next(layout);
    for (std::size_t i = 0; i < values.size(); ++i) ASSERT_EQ(card.integer(i), values[i]) << line << " field " << i;
    ASSERT_EQ(reports(deck.diagnostics), "") << line;
  }
}

}  // namespace
}  // namespace gapcheck::keyword::card_test
