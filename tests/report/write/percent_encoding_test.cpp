#include "report/write/percent_encoding.hpp"

#include <gtest/gtest.h>

namespace gapcheck::report::percent_encoding_test {
namespace {

TEST(PercentEncoding, OnlyPlainBytesStay) {
  EXPECT_EQ(percent_encoded("a-Z_0.9~/b"), "a-Z_0.9~/b");
  EXPECT_EQ(percent_encoded("a b#?%\"<\n\xc3\xbc"), "a%20b%23%3F%25%22%3C%0A%C3%BC");
  EXPECT_EQ(percent_encoded("javascript:x"), "javascript%3Ax");
}

TEST(PercentEncoding, UrisOfFiles) {
  EXPECT_EQ(file_uri("./models/../a b.k"), "a%20b.k");
  EXPECT_EQ(file_uri("/models/a.k"), "file:///models/a.k");
}

}  // namespace
}  // namespace gapcheck::report::percent_encoding_test
