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
