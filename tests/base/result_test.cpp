#include "base/result.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace gapcheck::result_test {
namespace {

TEST(Result, HoldsAValue) {
  Result<int> result = 3;
  ASSERT_TRUE(result.ok());
  ASSERT_TRUE(result);
  result.value() = 4;
  EXPECT_EQ(result.value(), 4);
}

TEST(Result, HoldsAnError) {
  const Result<int> result = Diagnostic{Severity::error, "a.k", 3, "wrong"};
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().line, 3u);
}

TEST(Result, ADiagnosticCanBeAsked) {
  const Result<std::string> result = std::string("text");
  ASSERT_TRUE(result);
  EXPECT_EQ(result.value(), "text");
}

TEST(Result, MovesWhatCannotBeCopied) {
  Result<std::unique_ptr<int>> result = std::make_unique<int>(5);
  const std::unique_ptr<int> taken = std::move(result).value();
  EXPECT_EQ(*taken, 5);
}

}  // namespace
}  // namespace gapcheck::result_test
