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
}

}  // namespace
}  // namespace gapcheck::audit_test::deck_edits_test
