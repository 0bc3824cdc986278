#include "base/result.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <type_traits>

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

TEST(Result, HoldsAnErrorOfAnotherKind) {
  const Result<int, std::string> good = 3, bad = std::string("no number");
  EXPECT_TRUE(good.ok());
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error(), "no number");
}

TEST(Status, SucceedsOrSaysWhyNot) {
  const Status good, bad = Diagnostic{Severity::error, "a.k", 3, "wrong"};
  EXPECT_TRUE(good.ok());
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().message, "wrong");
  static_assert(!std::is_convertible_v<Status, bool> && !std::is_constructible_v<bool, Status>);
}

}  // namespace
}  // namespace gapcheck::result_test
