#include "base/diagnostic.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace gapcheck::diagnostic_test {
namespace {

TEST(Diagnostics, SortsErrorsFirstThenFileLineMessage) {
  Diagnostics diagnostics;
  diagnostics.warning("a.k", 1, "w");
  diagnostics.error("b.k", 2, "y");
  diagnostics.error("b.k", 2, "x");
  diagnostics.error("b.k", 1, "z");
  diagnostics.error("a.k", 9, "v");
  std::string order;
  for (const Diagnostic& diagnostic : diagnostics.sorted()) order += diagnostic.message;
  EXPECT_EQ(order, "vzxyw");
}

TEST(Diagnostics, OnlyErrorsCountAsErrors) {
  Diagnostics diagnostics;
  diagnostics.warning("a.k", 1, "w");
  EXPECT_FALSE(diagnostics.has_errors());
  diagnostics.error("a.k", 1, "e");
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(Diagnostics, KeepsTheFirstThousandAndCountsTheRest) {
  Diagnostics diagnostics;
  for (std::uint32_t i = 0; i < 1500; ++i) diagnostics.warning("a.k", i, "w");
  diagnostics.error("a.k", 1, "late");
  EXPECT_EQ(diagnostics.sorted().size(), 1000u);
  EXPECT_EQ(diagnostics.dropped(), 501u);
  EXPECT_TRUE(diagnostics.has_errors()) << "an error counts even where it is not kept";
}

TEST(Diagnostics, OneCauseIsOneDiagnostic) {
  Diagnostics diagnostics;
  for (const std::uint32_t line : {9u, 3u, 3u, 5u, 12u, 7u, 8u})
    diagnostics.error_of_cause("x is unknown", "define it", "b.k", line, "*NODE, field " + std::to_string(line));
  diagnostics.error_of_cause("y is unknown", "define it", "a.k", 1, "*PART");
  diagnostics.warning("a.k", 1, "w");
  EXPECT_TRUE(diagnostics.has_errors());
  const auto list = diagnostics.sorted();
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].message, "*PART: y is unknown; define it");
  EXPECT_EQ(list[1].message,
            "*NODE, field 3: x is unknown, in 6 lines: b.k:3, b.k:5, b.k:7, b.k:8, b.k:9, …; define it");
  EXPECT_EQ(list[1].line, 3u);
  EXPECT_TRUE(diagnostics.has_error_in("b.k", 10, 12));
  EXPECT_FALSE(diagnostics.has_error_in("b.k", 10, 11));
  EXPECT_FALSE(diagnostics.has_error_in("c.k", 1, 12));
  EXPECT_EQ(diagnostics.error_lines().size(), 7u);
  Diagnostics all;
  all.take(diagnostics);
  all.error_of_cause("x is unknown", "define it", "a.k", 4, "*NODE");
  EXPECT_EQ(all.sorted().size(), 3u);
  EXPECT_EQ(all.sorted()[1].message,
            "*NODE: x is unknown, in 7 lines: a.k:4, b.k:3, b.k:5, b.k:7, b.k:8, …; define it");
}

TEST(Diagnostics, CausesAreBounded) {
  Diagnostics diagnostics;
  for (std::uint32_t i = 0; i < 3000; ++i) diagnostics.error_of_cause("x", "y", "a.k", 5000 - i, "z");
  EXPECT_NE(diagnostics.sorted().at(0).message.find("in 3000 lines: a.k:2001,"), std::string::npos);
  for (std::uint32_t i = 0; i < 3000; ++i) diagnostics.error_of_cause(std::to_string(i), "y", "a.k", 1, "z");
  EXPECT_EQ(diagnostics.sorted().size(), 1000u);
  EXPECT_EQ(diagnostics.dropped(), 2001u);
}

TEST(Diagnostics, TakingKeepsCounts) {
  Diagnostics from, to;
  for (std::uint32_t i = 0; i < 1500; ++i) from.error("a.k", i, "e");
  to.warning("b.k", 1, "w");
  to.take(from);
  EXPECT_EQ(to.sorted().size(), 1000u);
  EXPECT_EQ(to.dropped(), 501u);
  EXPECT_TRUE(to.has_errors());
}

TEST(Diagnostics, AnyThreadMayAdd) {
  Diagnostics diagnostics;
  std::vector<std::thread> threads;
  for (std::uint32_t t = 0; t < 4; ++t)
    threads.emplace_back([&diagnostics, t] {
      for (std::uint32_t i = 0; i < 200; ++i) diagnostics.error("a.k", t * 200 + i + 1, "e");
    });
  for (std::thread& thread : threads) thread.join();
  const auto sorted = diagnostics.sorted();
  ASSERT_EQ(sorted.size(), 800u);
  for (std::uint32_t i = 0; i < 800; ++i) EXPECT_EQ(sorted[i].line, i + 1);
}

}  // namespace
}  // namespace gapcheck::diagnostic_test
