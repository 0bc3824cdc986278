#include "lsp/line_cards.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace gapcheck::app::lsp {
namespace {

TEST(LspLineCards, LinesOfAText) {
  const Text text("$\n*PART\n$ c\nname\n 1\n*END\n 1\n");
  const auto keywords = outline(text);
  ASSERT_EQ(keywords.size(), 2U);
  EXPECT_EQ(card_at(text, keywords, 0).keyword, nullptr);
  EXPECT_EQ(card_at(text, keywords, 1).layout, nullptr);
  EXPECT_EQ(card_at(text, keywords, 2).layout, nullptr);
  ASSERT_NE(card_at(text, keywords, 4).layout, nullptr);
  EXPECT_EQ(card_at(text, keywords, 4).layout->fields.front().name, "pid");
  EXPECT_EQ(card_at(text, keywords, 6).layout, nullptr);
}

/// The first fields of the cards of a keyword's lines, "-" where none is known.
std::string cards(const std::string& name, const std::vector<std::string>& rows) {
  std::string bytes = "*" + name + "\n";
  for (const std::string& row : rows) bytes += row + "\n";
  const Text text(bytes);
  const auto keywords = outline(text);
  LineCards lines(text, keywords.front());
  std::string names;
  for (const std::string& row : rows) {
    const keyword::CardLayout* card = lines.next(row);
    names += (names.empty() ? "" : " ") + (card == nullptr ? std::string("-") : card->fields.front().name);
  }
  return names + (lines.sure() ? "" : " ?");
}

/// A line of ids, eight columns each.
std::string ids(const std::vector<int>& numbers) {
  std::string line;
  for (const int number : numbers) {
    const std::string text = std::to_string(number);
    line += std::string(8 - text.size(), ' ') + text;
  }
  return line;
}

const std::string quad = ids({1, 1, 1, 2, 3, 4}), eight = ids({1, 1, 1, 2, 3, 4, 5, 6, 7, 8}), head = ids({1, 1});
const std::string reals = "             1.0             2.0             3.0", ply = "         1       0.5       45.";

TEST(LspLineCards, Shells) {
  EXPECT_EQ(cards("ELEMENT_SHELL", {quad, quad}), "eid eid");
  EXPECT_EQ(cards("ELEMENT_SHELL_THICKNESS", {quad, reals, quad, reals}), "eid thic1 eid thic1");
  // With nodes in the middle of the edges there is a line more.
  EXPECT_EQ(cards("ELEMENT_SHELL_THICKNESS", {eight, reals, reals, quad, reals, quad}),
            "eid thic1 thic5 eid thic1 eid");
  EXPECT_EQ(cards("ELEMENT_SHELL_BETA_OFFSET", {quad, reals, "1.", quad}), "eid thic1 offset eid");
  EXPECT_EQ(cards("ELEMENT_SHELL_MCID", {quad, reals, quad}), "eid thic1 eid");
  EXPECT_EQ(cards("ELEMENT_SHELL_OFFSET", {quad, "1.", "", quad, "1."}), "eid offset - eid offset");
  EXPECT_EQ(cards("ELEMENT_SHELL_DOF", {quad, quad, quad}), "eid unused eid");
  EXPECT_EQ(cards("ELEMENT_SHELL_COMPOSITE", {quad, ply, ply, quad, ply}), "eid mid1 mid1 eid mid1");
  EXPECT_EQ(cards("ELEMENT_SHELL_COMPOSITE", {"1,1,1,2,3,4", "1,0.5,45.", "&e,1,1,2,3,4"}), "eid mid1 eid");
}

TEST(LspLineCards, Solids) {
  // The lines of one element or of two may follow each other in one keyword.
  EXPECT_EQ(cards("ELEMENT_SOLID", {eight, head, eight, eight, head, eight}), "eid eid n1 eid eid n1");
  EXPECT_EQ(cards("ELEMENT_SOLID", {"1,1", "1,2,3,4,5,6,7,8", "2,1,1,2,3,4,5,6,7,8"}), "eid n1 eid");
  EXPECT_EQ(cards("ELEMENT_SOLID_ORTHO", {head, eight, reals, reals, eight, reals, reals, head}),
            "eid n1 a1 d1 eid a1 d1 eid");
  EXPECT_EQ(cards("ELEMENT_SOLID_H20", {head, eight, eight, head}), "eid n1 n1 eid");
  EXPECT_EQ(cards("ELEMENT_SOLID_H27", {head, eight, eight, eight, head}), "eid n1 n1 n1 eid");
  EXPECT_EQ(cards("ELEMENT_SOLID_DOF", {eight, eight, eight}), "eid unused eid");
  EXPECT_EQ(cards("ELEMENT_SOLID_TET4TOTET10", {eight, eight}), "eid eid");
}

TEST(LspLineCards, OtherElements) {
  EXPECT_EQ(cards("ELEMENT_TSHELL", {eight, eight}), "eid eid");
  EXPECT_EQ(cards("ELEMENT_TSHELL_BETA", {eight, reals, eight}), "eid unused eid");
  EXPECT_EQ(cards("ELEMENT_TSHELL_COMPOSITE", {eight, ply, ply, eight}), "eid mid1 mid1 eid");
  EXPECT_EQ(cards("ELEMENT_BEAM", {quad, quad}), "eid eid");
  EXPECT_EQ(cards("ELEMENT_BEAM_ORIENTATION_OFFSET", {quad, reals, reals, quad}), "eid wx1 vx eid");
  EXPECT_EQ(cards("ELEMENT_BEAM_THICKNESS_PID", {quad, reals, head, quad}), "eid parm1 pid1 eid");
  EXPECT_EQ(cards("ELEMENT_BEAM_SCALR", {quad, reals, quad}), "eid - eid");
  EXPECT_EQ(cards("ELEMENT_DISCRETE_LCO", {quad, head, quad}), "eid lcid eid");
  EXPECT_EQ(cards("ELEMENT_INERTIA_OFFSET", {head, reals, reals, head}), "eid ixx - eid");
  EXPECT_EQ(cards("ELEMENT_SPH", {head, head}), "nid nid");
  EXPECT_EQ(cards("ELEMENT_BEAM_OF_A_KIND_TO_COME", {quad, quad}), "- - ?");
}

/// A blank line does not begin an element.
TEST(LspLineCards, BlankLines) {
  EXPECT_EQ(cards("ELEMENT_SOLID", {"", head, eight, "", head, eight}), "eid eid n1 n1 eid n1");
}

TEST(LspLineCards, FormatsOfColumns) {
  const Text text("*ELEMENT_SOLID+\n" + std::string(19, ' ') + "1" + std::string(19, ' ') + "1\n" +
                  std::string(19, ' ') + "7\n*END\n");
  const auto keywords = outline(text);
  ASSERT_EQ(keywords.front().format, keyword::Format::long_fields);
  EXPECT_EQ(card_at(text, keywords, 1).layout->fields.front().name, "eid");
  EXPECT_EQ(card_at(text, keywords, 2).layout->fields.front().name, "n1");
}

}  // namespace
}  // namespace gapcheck::app::lsp
