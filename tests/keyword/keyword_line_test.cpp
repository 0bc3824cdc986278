#include "keyword/keyword_line.hpp"

#include <gtest/gtest.h>

namespace gapcheck::keyword {
namespace {

TEST(KeywordLine, NamesAndFormats) {
  Format of_file = Format::standard;
  const auto read = [&of_file](std::string_view line) { return read_keyword_line(line, of_file); };
  EXPECT_EQ(read("*Node").name, "NODE");
  EXPECT_EQ(read("*NODE+").format, Format::long_fields);
  EXPECT_EQ(read("*NODE %").format, Format::i10);
  EXPECT_EQ(read("*NODE % more").format, Format::standard);
  EXPECT_EQ(read("*").name, "");
  EXPECT_EQ(read("*  NODE").name, "");
  EXPECT_EQ(of_file, Format::standard);
  EXPECT_EQ(read("*KEYWORD LONG=Y").name, "KEYWORD");
  EXPECT_EQ(of_file, Format::long_fields);
  EXPECT_EQ(read("*NODE").format, Format::long_fields);
  EXPECT_EQ(read("*NODE-").format, Format::standard);
  EXPECT_EQ(read("*KEYWORD LONG=S").format, Format::standard);
}

}  // namespace
}  // namespace gapcheck::keyword
