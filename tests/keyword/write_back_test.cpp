#include "keyword/write_back.hpp"

#include <random>

#include "base/number.hpp"
#include "support.hpp"

namespace gapcheck::keyword::write_back_test {
namespace {

CardLayout node_layout() {
  CardLayout layout = card_layout("NODE", "card1");
  layout.fields.resize(4);
  return layout;
}

/// The first line of *NODE (with the suffix) after y has been replaced.
std::string replaced(const std::string& suffix, const std::string& line, double y) {
  TextDeck text("*KEYWORD\n*NODE" + suffix + "\n" + line + "\n*END\n");
  const CardLayout layout = node_layout();
  const Card card(text.deck, text.block("NODE"), layout, line, 3, text.diagnostics);
  EXPECT_TRUE(check_replaceable(card, 2).ok());
  const std::string result = with_number(card, 2, y);
  const Card again(text.deck, text.block("NODE"), layout, result, 3, text.diagnostics);
  EXPECT_NEAR(again.real(2), y, 1e-12 * std::abs(y)) << result;
  for (const std::size_t other : {0, 1, 3}) EXPECT_EQ(again.written(other), card.written(other)) << result;
  EXPECT_EQ(count_errors(text.diagnostics), 0u) << reports(text.diagnostics);
  return result;
}

TEST(WriteBack, KeepsTheColumnsOfTheLine) {
  EXPECT_EQ(replaced("", "    1001              0.              5.              7.  0  0", 1.25),
            "    1001              0.            1.25              7.  0  0");
  EXPECT_EQ(replaced("", "    1001              0.              5.              7.", 1.25),
            "    1001              0.            1.25              7.");
  EXPECT_EQ(replaced("", "    1001", 1.25), "    1001                            1.25");
  EXPECT_EQ(replaced("%", "      1001              0.              5.              7.", 1.25),
            "      1001              0.            1.25              7.");
  EXPECT_EQ(replaced("+", "                1001                  0.                  5.                  7.", 1.25),
            "                1001                  0.                1.25                  7.");
}

TEST(WriteBack, KeepsCommasAndBlanksOfFreeFormat) {
  EXPECT_EQ(replaced("", "1001, 0.5 , 5.0 ,7.", 1.25), "1001, 0.5 , 1.25 ,7.");
  EXPECT_EQ(replaced("", "1001,,,7.", 1.25), "1001,,1.25,7.");
  EXPECT_EQ(replaced("", "1001,0.5", 1.25), "1001,0.5,1.25");
  EXPECT_EQ(replaced("", "1001,0.5,", 1.0 / 3), "1001,0.5,0.3333333333333333");
}

TEST(WriteBack, RefusesWhatIsNoNumber) {
  TextDeck text("*KEYWORD\n*PARAMETER\nR y             1.0\n*NODE\n    1001              0.              &y\n*END\n");
  const CardLayout layout = node_layout();
  const auto why = [&](const std::string& line) {
    const Card card(text.deck, text.block("NODE"), layout, line, 5, text.diagnostics);
    const Status status = check_replaceable(card, 2);
    return status.ok() ? "" : status.error().message;
  };
  EXPECT_EQ(why("    1001              0.              &y"), "&y is a parameter");
  EXPECT_EQ(why("1001,0.,-&y"), "-&y is a parameter");
  EXPECT_EQ(why("1001,0.,<y*2>"), "<y*2> is a parameter");
  EXPECT_EQ(why("\t1001\t0."), "the line has tabs in fixed columns");
  EXPECT_EQ(why("1001,\t0.,5."), "");
  EXPECT_EQ(why(std::string(Card::max_line + 5, ' ')), "the line is too long");
}

TEST(NumberText, ReadsBackAsNearAsTheWidthAllows) {
  EXPECT_EQ(number_text(0.1, 16), "0.1");
  EXPECT_EQ(number_text(0, 16), "0.");
  EXPECT_EQ(number_text(-0.0, 16), "0.");
  EXPECT_EQ(number_text(1500, 8), "1500.");
  EXPECT_EQ(number_text(-1.0 / 3, 8), "-0.33333");
  EXPECT_EQ(number_text(1e-20 / 3, 8), "3.33e-21");
  EXPECT_EQ(number_text(2e25, 8), "2e25");
  EXPECT_EQ(number_text(123456789.0, 8), "1.2346e8");
  EXPECT_EQ(number_text(123456789.0, 2), "");
  EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN(), 16), "");
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())),
                                    -63 - static_cast<int>(random() % 40) + 20);
    for (const std::size_t width : {8u, 16u, 20u}) {
      const std::string text = number_text(value, width);
      ASSERT_FALSE(text.empty());
      ASSERT_LE(text.size(), width);
      const auto read = parse_real(text);
      ASSERT_TRUE(read) << text;
      // Sign, point, leading zero and exponent leave so many digits.
      const double digits = static_cast<double>(width) - 6;
      ASSERT_NEAR(*read, value, 0.5 * std::pow(10, 1 - digits) * std::abs(value)) << text;
    }
    ASSERT_EQ(parse_real(number_text(value, 0)), value);
  }
}

TEST(WithLines, ChangesNothingElse) {
  const std::string bytes = "one\r\ntwo\n\nfour";
  const LineIndex index(bytes);
  EXPECT_EQ(index.size(), 4u);
  EXPECT_EQ(index.line(1), "one");
  EXPECT_EQ(index.line(3), "");
  EXPECT_EQ(index.line(4), "four");
  EXPECT_EQ(index.line(5), "");
  EXPECT_EQ(with_lines(bytes, index, {}), bytes);
  const std::vector<LineEdit> edits{{1, "ONE!"}, {3, "3"}, {4, ""}, {9, "none"}};
  EXPECT_EQ(with_lines(bytes, index, edits), "ONE!\r\ntwo\n3\n");
  EXPECT_EQ(LineIndex("").size(), 0u);
  EXPECT_EQ(with_lines("", LineIndex(""), edits), "");
}

}  // namespace
}  // namespace gapcheck::keyword::write_back_test
