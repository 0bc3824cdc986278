#include "keyword/cases.hpp"

#include <gtest/gtest.h>

namespace gapcheck::keyword::cases_test {
namespace {

// Line 1 is *KEYWORD.
bool never_together(const std::string& text, std::uint32_t a, std::uint32_t b) {
  Diagnostics diagnostics;
  const auto deck = read_deck_text("*KEYWORD\n" + text, "deck.k", {}, diagnostics);
  EXPECT_TRUE(deck.ok());
  return deck.ok() && Cases(deck.value()).never_together({FileIndex{0}, a}, {FileIndex{0}, b});
}

TEST(Cases, OnlyLinesOfDifferentCases) {
  const std::string text =
      "*PART\n*CASE_BEGIN_1\n*NODE\n*CASE_END_1\n*SET_NODE\n*CASE_BEGIN_2\n*NODE\n*CASE_END_2\n*NODE\n";
  EXPECT_TRUE(never_together(text, 4, 8));
  EXPECT_TRUE(never_together(text, 8, 4));
  EXPECT_FALSE(never_together(text, 4, 4));
  EXPECT_FALSE(never_together(text, 2, 4)) << "before all cases";
  EXPECT_FALSE(never_together(text, 6, 8)) << "between them";
  EXPECT_FALSE(never_together(text, 4, 10)) << "behind them";
}

TEST(Cases, MayOverlap) {
  const std::string text =
      "*CASE_BEGIN_1\n*CASE_BEGIN_2\n*NODE\n*CASE_END_1\n*NODE\n*CASE_END_2\n*CASE_BEGIN_3\n*NODE\n*CASE_BEGIN_1\n*"
      "NODE\n";
  EXPECT_FALSE(never_together(text, 4, 6)) << "both in case 2";
  EXPECT_TRUE(never_together(text, 4, 9));
  EXPECT_FALSE(never_together(text, 4, 11)) << "both in case 1";
  EXPECT_TRUE(never_together(text, 6, 11));
}

TEST(Cases, WithoutOrWithWrongNumbersThereAreNone) {
  EXPECT_FALSE(never_together("*NODE\n*PART\n", 2, 3));
  EXPECT_FALSE(never_together("*CASE_BEGIN_x\n*NODE\n*CASE_END_x\n*CASE_BEGIN_2\n*NODE\n", 3, 6));
  EXPECT_FALSE(never_together("*CASE_BEGIN_-1\n*NODE\n*CASE_BEGIN_99999999999999999999\n*NODE\n", 3, 5));
}

}  // namespace
}  // namespace gapcheck::keyword::cases_test
