#include "audit/ignore_comment.hpp"

#include <gtest/gtest.h>

#include <string>

namespace gapcheck::audit::ignore_comment_test {
namespace {

std::string text_of(const std::vector<IdRange>& ids) {
  std::string text;
  for (const IdRange& range : ids) text += std::to_string(range.first) + "-" + std::to_string(range.last) + " ";
  return text;
}

std::string wrong(const std::string& text) {
  const IgnoreComment comment = read_ignore_comment(text);
  EXPECT_EQ(comment.entry.has_value(), comment.wrong.empty()) << text;
  return comment.wrong;
}

TEST(IgnoreComment, Everything) {
  const IgnoreComment comment = read_ignore_comment(
      " ignore GC101,untied-node contact=3 node=1-500,7 part=2 element=9223372036854775807 until=2027-01-31 "
      "because welded = on purpose, by node=5 ");
  ASSERT_TRUE(comment.entry) << comment.wrong;
  const IgnoreEntry& entry = *comment.entry;
  EXPECT_EQ(entry.rules, (std::vector<std::string>{"GC101", "untied-node"}));
  EXPECT_EQ(text_of(entry.contacts), "3-3 ");
  EXPECT_EQ(text_of(entry.nodes), "1-500 7-7 ");
  EXPECT_EQ(text_of(entry.parts), "2-2 ");
  EXPECT_EQ(text_of(entry.elements), "9223372036854775807-9223372036854775807 ");
  EXPECT_EQ(entry.until,
            std::chrono::year_month_day(std::chrono::year(2027), std::chrono::January, std::chrono::day(31)));
  EXPECT_EQ(entry.reason, "welded = on purpose, by node=5");
}

TEST(IgnoreComment, BlanksAndCaseDoNotMatter) {
  const IgnoreComment comment =
      read_ignore_comment("\tIGNORE gc1 , GC201  NODE = 1 , 3-4\tUntil = 2027-02-28 BECAUSE it is so\r");
  ASSERT_TRUE(comment.entry) << comment.wrong;
  EXPECT_EQ(comment.entry->rules, (std::vector<std::string>{"gc1", "GC201"}));
  EXPECT_EQ(text_of(comment.entry->nodes), "1-1 3-4 ");
  EXPECT_TRUE(comment.entry->until);
  EXPECT_EQ(comment.entry->reason, "it is so");
  EXPECT_TRUE(read_ignore_comment("ignore GC").entry);
}

TEST(IgnoreComment, SaysWhatIsWrongAndWhatToWrite) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "needs the word ignore"},
      {" skip GC101", "needs the word ignore"},
      {"ignore", "names the rules"},
      {"ignore contact=3", "names the rules"},
      {"ignore GC101,", "names the rules"},
      {"ignore GC801", "\"GC801\" is not a rule (gapcheck rules lists them)"},
      {"ignore inital-penetration", "did you mean initial-penetration?"},
      {"ignore nothing-like-any-of-them", "is not a rule (gapcheck rules"},
      {"ignore GC601", "judges what a run has written"},
      {"ignore GC513", "cannot be ignored by a comment"},
      {"ignore GC101 nodes=5", "\"nodes\" is not understood; did you mean node?"},
      {"ignore GC101 node", "node needs a value"},
      {"ignore GC101 node=", "node=3 or node=1-500,803"},
      {"ignore GC101 node=1,", "is not an id"},
      {"ignore GC101 node=x", "\"x\" is not an id"},
      {"ignore GC101 node=0", "\"0\" is not an id"},
      {"ignore GC101 node=-5", "\"-5\" is not an id"},
      {"ignore GC101 node=1-2-3", "is not an id"},
      {"ignore GC101 node=5-", "is not an id"},
      {"ignore GC101 node=9223372036854775808", "larger than any id"},
      {"ignore GC101 node=500-1", "runs backwards; write 1-500"},
      {"ignore GC101 node=1 node=2", "node= stands there twice"},
      {"ignore GC101 until=2027-02-29", "\"2027-02-29\" is not a day"},
      {"ignore GC101 until=1.1.2027", "until=YYYY-MM-DD"},
      {"ignore GC101 until=2027-1-1", "is not a day"},
      {"ignore GC101 because", "needs a reason"},
      {"ignore GC101 \x01\xff=3", "\"??\" is not understood"},
      {"ignore GC101 = 3", "\"=\" is not understood"},
  };
  for (const auto& [text, expected] : cases)
    EXPECT_NE(wrong(text).find(expected), std::string::npos) << text << ": " << wrong(text);
}

TEST(IgnoreComment, LongOnesTakeNoTimeAndGiveShortMessages) {
  const std::string megabyte(1 << 20, 'x');
  EXPECT_LT(wrong("ignore " + megabyte).size(), 200U);
  EXPECT_LT(wrong(megabyte).size(), 200U);
  EXPECT_LT(wrong("ignore GC101 " + megabyte + "=1").size(), 200U);
  EXPECT_LT(wrong("ignore GC101 node=" + megabyte).size(), 200U);
  EXPECT_LT(wrong("ignore GC101 until=" + megabyte).size(), 200U);
  EXPECT_EQ(read_ignore_comment("ignore GC101 because " + megabyte).entry->reason, megabyte);
  std::string ids = "ignore GC101 node=1";
  for (int i = 2; i < 100'000; ++i) ids += "," + std::to_string(2 * i);
  EXPECT_EQ(read_ignore_comment(ids).entry->nodes.size(), 99'999U);
  EXPECT_NE(wrong("ignore GC101" + std::string(1 << 20, ',')), "");
  EXPECT_NE(wrong("ignore GC101" + std::string(1 << 20, '=')), "");
  EXPECT_TRUE(read_ignore_comment("ignore GC101" + std::string(1 << 20, ' ')).entry);
}

}  // namespace
}  // namespace gapcheck::audit::ignore_comment_test
