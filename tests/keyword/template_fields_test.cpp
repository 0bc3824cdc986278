#include "keyword/template_fields.hpp"

#include "base/number.hpp"
#include "support.hpp"

namespace gapcheck::keyword::template_fields_test {
namespace {

/// A deck with parameters from outside, and everything that was said.
struct GivenDeck {
  Diagnostics diagnostics;
  Deck deck;
  GivenDeck(const std::string& text, const std::vector<std::string>& parameters) {
    ReadOptions options;
    options.parameters = parameters;
    auto result = read_deck_text(text, "deck.k", options, diagnostics);
    EXPECT_TRUE(result.ok());
    if (result) deck = std::move(result).value();
  }
  [[nodiscard]] std::string body(std::size_t block) const { return std::string(deck.blocks()[block].body); }
};

TEST(TemplateFields, TakeTheirColumns) {
  const GivenDeck deck("*A\n<<t:10>>       2.0\n<<t>>     2.0\n1.,<<t>>,<<n:i8>>\r\n$ <<no>>\n<<2*t+1:6>>\n",
                       {"T=1.25", "n=12"});
  EXPECT_EQ(deck.body(0), "      1.25       2.0\n 1.25     2.0\n1., 1.25,      12\r\n$ <<no>>\n   3.5\n");
  EXPECT_EQ(reports(deck.diagnostics), "");
}

TEST(TemplateFields, LongValuesAreRoundedOrTakeBlanks) {
  const GivenDeck deck("*A\n<<t:6>>7\n<<t>>       8\n<<w>>9\n", {"t=0.123456789", "w=1e300"});
  EXPECT_EQ(deck.body(0), "0.12357\n0.123456789 8\n1e3009\n");
}

TEST(TemplateFields, TextInAngleBracketsStays) {
  const std::string text = "<< a bolt >>\n<<>>\n<<open\n<1+2>\n";
  const GivenDeck deck("*A\n" + text, {});
  EXPECT_EQ(deck.body(0), text);
  EXPECT_EQ(reports(deck.diagnostics), "");
}

TEST(TemplateFields, ParametersOfTheDeckAreValuesToo) {
  const GivenDeck deck("*PARAMETER\n" + pair("R t", "2.0") + "\n*A\n<<t:10>>\n<<t*2:10>>\n", {});
  ASSERT_EQ(deck.body(1).size(), 22u) << deck.body(1);
  EXPECT_EQ(parse_real(deck.body(1).substr(0, 10)), 2);
  EXPECT_EQ(parse_real(deck.body(1).substr(11, 10)), 4);
}

TEST(TemplateFields, OneErrorForAllUsesOfAMissingOne) {
  GivenDeck deck("*PARAMETER\nR thick   <<th:10>>\n*SECTION_SHELL\n         1\n&thick    <<th:10>>\n*NODE\n<<th:8>>\n",
                 {});
  CardReader section(deck.deck, deck.deck.blocks()[1], deck.diagnostics);
  section.skip();
  const Card card = section.next(card_layout("SECTION_SHELL", "card2"));
  EXPECT_EQ(card.real("t1", 7), 7);
  EXPECT_EQ(card.real("t2", 7), 7);
  CardReader node(deck.deck, deck.deck.blocks()[2], deck.diagnostics);
  EXPECT_EQ(node.next(card_layout("NODE", "card1")).integer("nid"), 0);
  EXPECT_EQ(reports(deck.diagnostics),
            "deck.k:2: *PARAMETER: the parameter \"th\" is not defined before it is used, in 3 lines: deck.k:2, "
            "deck.k:5, deck.k:7; define it with *PARAMETER, or give it with --param th=VALUE\n");
}

TEST(TemplateFields, FaultsOfExpressionsAreErrors) {
  const GivenDeck deck("*A\n<<1/0:10>>\n<<1+:99999999>>\n", {});
  const std::string all = reports(deck.diagnostics);
  EXPECT_EQ(count_errors(deck.diagnostics), 2u) << all;
  EXPECT_NE(all.find("deck.k:2: *A, template field: expression \"1/0\": divides by zero"), std::string::npos) << all;
  EXPECT_LT(deck.body(0).size(), 400u);
}

}  // namespace
}  // namespace gapcheck::keyword::template_fields_test
