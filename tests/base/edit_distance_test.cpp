#include "base/edit_distance.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace gapcheck::edit_distance_test {
namespace {

double apart(std::string_view a, std::string_view b) {
  return edit_distance(a, b, [](char x, char y) { return x == y ? 0.0 : 1.0; });
}

TEST(EditDistance, InsertedRemovedAndReplaced) {
  EXPECT_EQ(apart("", ""), 0);
  EXPECT_EQ(apart("", "abc"), 3);
  EXPECT_EQ(apart("abc", ""), 3);
  EXPECT_EQ(apart("kitten", "sitting"), 3);
  EXPECT_EQ(apart("surface", "surface"), 0);
  EXPECT_EQ(apart("ab", "ba"), 2);
}

TEST(EditDistance, CostOfReplacing) {
  const auto dear = [](char x, char y) { return x == y ? 0.0 : 5.0; };
  EXPECT_EQ(edit_distance(std::string_view("abc"), std::string_view("axc"), dear), 2);  // removed and inserted
}

}  // namespace
}  // namespace gapcheck::edit_distance_test
