#include "results/log/message_block.hpp"

#include <gtest/gtest.h>

namespace gapcheck::results::message_block_test {
namespace {

MessageBlock block_of(const std::string& text, std::string* next = nullptr) {
  MessageBlock block;
  Lines lines(text);
  read_message_block(lines, block);
  if (next != nullptr) *next = lines.done() ? "(end)" : std::string(lines.line());
  return block;
}

TEST(MessageBlock, Headers) {
  EXPECT_TRUE(is_message_header(" *** Warning 40565 (SOL+565)"));
  EXPECT_TRUE(is_message_header("*** Error 10246 (KEY+246)"));
  EXPECT_TRUE(is_message_header(" *** WARNING 1"));
  EXPECT_FALSE(is_message_header(" *** termination due to sense switch: stop ***"));
  EXPECT_FALSE(is_message_header(" *** t h e r m a l  m a t e r i a l  d a t a ***"));
  EXPECT_FALSE(is_message_header(" ***********************************************************************"));
}

TEST(MessageBlock, PartsOfTheHeader) {
  const std::string text = " *** Error 10246 (KEY+246)\n     text\n";
  const auto block = block_of(text);
  EXPECT_EQ(block.severity, Severity::error);
  EXPECT_EQ(block.code, 10246);
  EXPECT_EQ(block.group, "KEY");
  EXPECT_EQ(block.line_of(0), 2u);
  const std::string bare = " *** Warning Penetration is close to maximum before release\n";
  const auto words = block_of(bare);
  EXPECT_EQ(words.code, 0);
  EXPECT_EQ(joined_text(words, 100), "Penetration is close to maximum before release");
  EXPECT_EQ(words.line_of(0), 1u);
}

TEST(MessageBlock, EndsWhereTheSolverGoesOn) {
  const std::string head = " *** Warning 1 (SOL+1)\n     text\n";
  for (const char* after : {" \n", "\n", " expanding   memory to 1 d 2 x\n", " *** Warning 2 (SOL+2)\n",
                            "       1 t 0.0000E+00 dt 2.12E-04 flush i/o buffers\n", "LSTC\n"}) {
    std::string next;
    const std::string text = head + after;
    EXPECT_EQ(joined_text(block_of(text, &next), 100), "text") << after;
    EXPECT_EQ(next + "\n", after);
  }
}

TEST(MessageBlock, TextThatHasLostItsIndent) {
  std::string next;
  const std::string text = "*** Warning 40538 (SOL+538)\n Slave node is not constrained\n slave node # = 14\n\nafter\n";
  EXPECT_EQ(joined_text(block_of(text, &next), 200), "Slave node is not constrained slave node # = 14");
  EXPECT_EQ(next, "");
  const std::string said = " *** Warning Penetration is close\n at 3 s\n";
  EXPECT_EQ(joined_text(block_of(said, &next), 200), "Penetration is close");
}

TEST(MessageBlock, FieldsOfALine) {
  const auto list = fields("not found on a segment. tied interface # = 92 tracked node # = 1");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].label, "not found on a segment. tied interface #");
  EXPECT_EQ(list[0].value, "92");
  EXPECT_EQ(list[1].label, "tracked node #");
  EXPECT_EQ(list[1].value, "1");
  const auto pair = fields("s,t = -2.3E-01-8.0E-02 x =");
  ASSERT_EQ(pair.size(), 2u);
  EXPECT_EQ(pair[0].value, "-2.3E-01-8.0E-02");
  EXPECT_EQ(pair[1].value, "");
  EXPECT_EQ(fields("file = a b c").at(0).value, "a b c");
  EXPECT_TRUE(fields("no value").empty());
  EXPECT_EQ(fields("===").size(), 3u);
}

TEST(MessageBlock, IdListsAndDeeperTextBelong) {
  const std::string text =
      " *** Warning 30128 (INI+128)\n     Massless nodes\n 1002057 1002058\n 12 ********\n   normal check in   4 "
      "iterations\n total\n";
  EXPECT_EQ(joined_text(block_of(text), 200),
            "Massless nodes 1002057 1002058 12 ******** normal check in 4 iterations");
}

TEST(MessageBlock, QuotedCardOfAnInputError) {
  const std::string text =
      " *** Error 10246 (KEY+246)\n     line contains improperly formatted data\n          At line# 91 of file\n"
      " C:\\models\\b.k\n ------------\n        100           &dtPreStr\n\n ------------\n after\n";
  std::string next;
  const auto block = block_of(text, &next);
  EXPECT_EQ(next, " after");
  EXPECT_NE(joined_text(block, 500).find("C:\\models\\b.k"), std::string::npos);
  EXPECT_NE(joined_text(block, 500).find("&dtPreStr"), std::string::npos);
}

TEST(MessageBlock, QuoteThatNeverEndsIsBounded) {
  std::string text = " *** Error 1\n     of file\n p\n ------\n";
  for (int i = 0; i < 1000; ++i) text += " x\n";
  Lines lines(text);
  MessageBlock block;
  read_message_block(lines, block);
  EXPECT_LT(block.lines.size(), 200u);
  EXPECT_FALSE(lines.done());
}

TEST(MessageBlock, LongListsAreKeptInPartAndCounted) {
  std::string text = " *** Warning 30128 (INI+128)\n";
  for (int i = 0; i < 10000; ++i) text += " 1 2 3 4 5 6\n";
  const auto block = block_of(text);
  EXPECT_EQ(block.lines.size() + block.left_out, 10000u);
  const std::string joined = joined_text(block, 100);
  EXPECT_LT(joined.size(), 150u);
  EXPECT_NE(joined.find("more lines]"), std::string::npos);
}

TEST(MessageBlock, EndOfFile) {
  EXPECT_TRUE(block_of(" *** Warning 1\n     a").open);
  EXPECT_FALSE(block_of(" *** Warning 1\n     a\n").open);
  EXPECT_TRUE(block_of(" *** Warning 1\n     a\n").ends_file);
  EXPECT_FALSE(block_of(" *** Warning 1\n     a\n \n").ends_file);
}

TEST(MessageBlock, Fields) {
  const auto entry = field("tied interface #           = 92");
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->label, "tied interface #");
  EXPECT_EQ(entry->value, "92");
  EXPECT_FALSE(field("no value"));
}

TEST(MessageBlock, HashLooksAtTheWholeText) {
  const std::string a = " *** Warning 1\n     a\n     b\n", b = " *** Warning 1\n    a  \n      b\n",
                    c = " *** Warning 1\n     a\n     c\n";
  EXPECT_EQ(text_hash(block_of(a)), text_hash(block_of(b)));
  EXPECT_NE(text_hash(block_of(a)), text_hash(block_of(c)));
}

}  // namespace
}  // namespace gapcheck::results::message_block_test
