#include "report/write/base64.hpp"

#include <gtest/gtest.h>

namespace gapcheck::report::base64_test {
namespace {

std::string encoded(std::string_view bytes) {
  std::string out;
  append_base64(bytes, out);
  return out;
}

// The vectors of RFC 4648, section 10.
TEST(Base64, EncodesTheVectorsOfTheStandard) {
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foob"), "Zm9vYg==");
  EXPECT_EQ(encoded("fooba"), "Zm9vYmE=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

TEST(Base64, TakesEveryByteAndAppends) {
  EXPECT_EQ(encoded(std::string_view("\x00\xff\x80", 3)), "AP+A");
  std::string out = "x";
  append_base64("foo", out);
  EXPECT_EQ(out, "xZm9v");
}

}  // namespace
}  // namespace gapcheck::report::base64_test
