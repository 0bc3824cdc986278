#include "keyword/text/blanks_in_number.hpp"

#include <gtest/gtest.h>

namespace gapcheck::keyword::blanks_in_number_test {
namespace {

/// Field `position` of a card of eight fields, ten columns each.
NumberField fixed(std::string_view line, std::size_t position) {
  std::string_view text = line.substr(std::min(line.size(), 10 * position), 10);
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  text = text.substr(0, text.find_last_not_of(' ') + 1);
  return {line, text, position, 8, 10 * position, 10, false};
}

TEST(BlanksInNumber, ShiftedColumns) {
  const std::string_view line = "       1    1.0  2       3.0";
  EXPECT_EQ(about_blanks(fixed(line, 1)),
            "\"1.0  2\" is 2 numbers in one field (columns 11 to 20): the numbers of the line do not stand in their "
            "columns; number 2 of the line is 1.0, which is probably meant; move them");
  EXPECT_EQ(marked_line(fixed(line, 1)), "       1    1.0  2       3.0\n          ^^^^^^^^^^");
  EXPECT_EQ(about_blanks(fixed(line, 0)), "") << "one number";
}

TEST(BlanksInNumber, NoGuessWhereOtherFieldsAreNoNumbers) {
  EXPECT_EQ(about_blanks(fixed("     12 34 a word", 0)),
            "\"12 34\" is 2 numbers in one field (columns 1 to 10): the numbers of the line do not stand in their "
            "columns; move them");
  EXPECT_EQ(about_blanks(fixed("1 2 3 4 5 6 7 8 9", 0)).find("probably"), std::string::npos) << "more than fields";
}

TEST(BlanksInNumber, BlanksInsideOneNumber) {
  EXPECT_EQ(about_blanks(fixed("     - 5.0", 0)), "\"- 5.0\" has blanks inside; probably -5.0 is meant; remove them");
  EXPECT_EQ(about_blanks(fixed("  1.5 E+3 ", 0)),
            "\"1.5 E+3\" has blanks inside; probably 1.5E+3 is meant; remove them");
  EXPECT_EQ(about_blanks(fixed("  two words", 0)), "");
  EXPECT_EQ(about_blanks(fixed("          ", 0)), "");
}

TEST(BlanksInNumber, FreeFormat) {
  const std::string_view line = "1, 2 3,4";
  const NumberField field{line, line.substr(3, 3), 1, 8, 10, 10, true};
  EXPECT_EQ(about_blanks(field), "\"2 3\" is 2 numbers without a comma between them; add it");
  EXPECT_EQ(marked_line(field), "1, 2 3,4\n   ^^^");
}

TEST(BlanksInNumber, TabsAndLongLines) {
  EXPECT_EQ(marked_line(fixed("1\t2 3", 1)), "1       2 3\n          ^^^^^^^^^^");
  const std::string line = std::string(9000, 'x') + " 1 2";
  const NumberField field{line, std::string_view(line).substr(9001), 0, 8, 9000, 10, false};
  const std::string marked = marked_line(field);
  EXPECT_LT(marked.size(), 330u);
  EXPECT_EQ(marked.find("1 2"), marked.find('^') - marked.find('\n') - 1 + 1) << marked;
}

}  // namespace
}  // namespace gapcheck::keyword::blanks_in_number_test
