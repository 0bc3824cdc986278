#include "report/write/stream.hpp"

#include <gtest/gtest.h>

#include <string>

namespace gapcheck::report {
namespace {

/// "0;1;2;…", the slow way.
std::string numbers(std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += std::to_string(i) + ";";
  return text;
}

std::string written(std::size_t count, std::size_t jobs) {
  const JobLimit limit(jobs);
  std::string text;
  const Sink sink = [&text](std::string_view piece) {
    text += piece;
    return true;
  };
  Stream stream(sink);
  stream.text("<");
  stream.entries(count, [](std::size_t i, Buffer& out) { out.append(std::to_string(i) + ";"); });
  stream.text(">");
  stream.flush();
  return text;
}

TEST(Stream, EntriesComeInOrderOnAnyNumberOfThreads) {
  for (const std::size_t count : {0, 1, 511, 512, 513, 1024, 8191, 8192, 8193, 50000})
    for (const std::size_t jobs : {1, 2, 7}) EXPECT_EQ(written(count, jobs), "<" + numbers(count) + ">") << count;
}

TEST(Stream, LinesOfAListHaveSeparatorsBetweenThem) {
  for (const std::size_t count : {std::size_t{3}, std::size_t{2000}}) {
    std::string text, expected;
    const Sink sink = [&text](std::string_view piece) {
      text += piece;
      return true;
    };
    Stream stream(sink);
    const auto digit = [](std::size_t i, Buffer& out) { out.push_back(static_cast<char>('0' + i % 10)); };
    stream.lines(0, true, digit);
    stream.lines(count, true, digit);
    stream.lines(count, false, digit);
    stream.flush();
    for (std::size_t i = 0; i < 2 * count; ++i)
      expected += (i == 0 ? "\n  " : ",\n  ") + std::to_string(i % count % 10);
    EXPECT_EQ(text, expected);
  }
}

TEST(Stream, NothingFollowsASinkThatHasEnough) {
  std::size_t pieces = 0, entries = 0;
  const JobLimit limit(1);
  const Sink sink = [&pieces](std::string_view) { return ++pieces < 3; };
  Stream stream(sink);
  stream.entries(1'000'000, [&entries](std::size_t, Buffer& out) {
    ++entries;
    out.push_back('x');
  });
  stream.text("more");
  stream.flush();
  EXPECT_EQ(pieces, 3U);
  EXPECT_FALSE(stream.open());
  EXPECT_LT(entries, 20'000U);
}

}  // namespace
}  // namespace gapcheck::report
