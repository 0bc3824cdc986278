#include "results/log/message_log.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace gapcheck::results::message_log_test {
namespace {

void add(MessageLog& log, std::int64_t code, std::uint64_t text, std::uint32_t file, std::uint32_t line = 1) {
  log.count_block(code);
  if (log.count(Severity::warning, code, "", text, file))
    log.keep({Severity::warning, code, "SOL", "", std::to_string(text), 1, file, line});
}

TEST(MessageLog, SameTextInSeveralFilesCountsAsOftenAsInOne) {
  MessageLog log;
  for (std::uint32_t file : {0u, 1u})
    for (int i = 0; i < 3; ++i) add(log, 7, 5, file);
  add(log, 7, 5, 2);
  const auto messages = log.take();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].count, 3u);
}

TEST(MessageLog, NothingIsDroppedWithoutBeingCounted) {
  std::mt19937 random(5);
  MessageLog log;
  std::map<std::int64_t, std::uint64_t> expected;
  for (int i = 0; i < 5000; ++i) {
    const std::int64_t code = 1 + static_cast<std::int64_t>(random() % 3);
    add(log, code, random() % 90, 0, static_cast<std::uint32_t>(i));
    ++expected[code];
  }
  std::map<std::int64_t, std::uint64_t> counted, texts;
  for (const SolverMessage& message : log.take()) {
    counted[message.code] += message.count;
    ++texts[message.code];
  }
  EXPECT_EQ(counted, expected);
  for (const auto& [code, number] : texts) EXPECT_EQ(number, MessageLog::kept_texts + 1);
}

TEST(MessageLog, ByCodeThenFileAndLine) {
  MessageLog log;
  add(log, 9, 1, 0, 5);
  add(log, 3, 2, 1, 7);
  add(log, 3, 3, 0, 9);
  const auto messages = log.take();
  ASSERT_EQ(messages.size(), 3u);
  EXPECT_EQ(messages[0].line, 9u);
  EXPECT_EQ(messages[1].line, 7u);
  EXPECT_EQ(messages[2].code, 9);
}

TEST(MessageLog, BlocksOfAFile) {
  MessageLog log;
  for (int i = 0; i < 50; ++i) add(log, 3, 1, 0);
  EXPECT_TRUE(log.any_block_counted(50));
  EXPECT_FALSE(log.any_block_counted(49));
  log.begin_file();
  EXPECT_FALSE(log.any_block_counted(50));
}

}  // namespace
}  // namespace gapcheck::results::message_log_test
