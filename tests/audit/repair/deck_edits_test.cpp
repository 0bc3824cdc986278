#include "audit/repair/deck_edits.hpp"

#include <gtest/gtest.h>

namespace gapcheck::audit_test::deck_edits_test {
namespace {

TEST(DeckEdits, ReplaceAndInsert) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text("*KEYWORD\n*NODE\n$ here\n*END", "deck.k", {}, diagnostics);
  audit::DeckEdits edits(deck.value());
  const FileIndex file{0};
  EXPECT_TRUE(edits.check(file).ok());
  EXPECT_EQ(edits.lines(file), 4u);
  edits.insert_behind(file, 2, "behind");
  edits.insert_behind(file, 2, "behind it\nand more");
  edits.insert_before(file, 2, "before");
  EXPECT_EQ(edits.line(file, 2), "*NODE");
  edits.replace(file, 2, "*NODE_SCALAR");
  EXPECT_EQ(edits.line(file, 2), "*NODE_SCALAR");
  edits.insert_before(file, 4, "last");
  EXPECT_EQ(audit::changed_texts(deck.value(), edits.changed()).at("deck.k"),
            "*KEYWORD\nbefore\n*NODE_SCALAR\nbehind\nbehind it\nand more\n$ here\nlast\n*END");
  const auto listed = edits.listed();
  ASSERT_EQ(listed.size(), 2u);
  EXPECT_EQ(listed[0].line, 2u);
  EXPECT_EQ(listed[0].before, "*NODE");
  EXPECT_EQ(listed[1].after, "last\n*END");
  edits.clear();
  EXPECT_TRUE(edits.listed().empty());
  EXPECT_EQ(edits.line(file, 2), "*NODE");
}

// Lines that are added end as those of their file do, also behind a last line without an end.
TEST(DeckEdits, LineEndsOfTheFile) {
  const auto taken = [](const std::string& bytes, std::uint32_t line) {
    Diagnostics diagnostics;
    const auto deck = keyword::read_deck_text(bytes, "deck.k", {}, diagnostics);
    RepairPlan plan;
    plan.pairs.emplace_back().repairs.emplace_back().lines = {
        {"deck.k", line, "", "a\nb\nc"}, {"deck.k", line, "", "alone"}, {"other.k", line, "", "a\nb"}};
    audit::take_line_ends(deck.value(), plan);
    const std::vector<RepairLine>& lines = plan.pairs[0].repairs[0].lines;
    EXPECT_EQ(lines[1].after, "alone");
    EXPECT_EQ(lines[2].after, "a\nb") << "a file that the deck does not have";
    return lines[0].after;
  };
  EXPECT_EQ(taken("*KEYWORD\n*NODE\n*END", 1), "a\nb\nc");
  EXPECT_EQ(taken("*KEYWORD\n*NODE\n*END", 3), "a\nb\nc");
  EXPECT_EQ(taken("*KEYWORD\r\n*NODE\r\n*END", 1), "a\r\nb\r\nc");
  EXPECT_EQ(taken("*KEYWORD\r\n*NODE\r\n*END", 3), "a\r\nb\r\nc");
}

}  // namespace
}  // namespace gapcheck::audit_test::deck_edits_test
