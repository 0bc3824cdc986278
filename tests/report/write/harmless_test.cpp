#include "report/write/harmless.hpp"

#include <gtest/gtest.h>

#include "report/write/xml_text.hpp"

namespace gapcheck::report::harmless_test {
namespace {

TEST(Harmless, ControlCharactersOfBothSets) {
  EXPECT_EQ(printable("Tür\tA\x1b[0m\x7f\r\n"), "Tür?A?[0m???");
  EXPECT_EQ(printable("a\xC2\x9B"
                      "31mb\xC2\x85\xC2\x80\xC2\xA0"),
            "a?31mb??\xC2\xA0");
  // The same controls where the text is not UTF-8; letters of Latin-1 stay.
  EXPECT_EQ(printable("a\x9b"
                      "31m T\xfcr"),
            "a?31m T\xfcr");
  EXPECT_EQ(printable("a\u2028b\u202Ec\u2026"), "a?b?c\u2026");
  EXPECT_EQ(plain_text("a\xC2\x9B"
                       "b\nc"),
            "a?b\nc");
}

TEST(Harmless, CommandsOfCiServices) {
  EXPECT_EQ(printable("::error file=a::b"), "?:error file=a::b");
  EXPECT_EQ(printable("  ::set-output"), "  ?:set-output");
  EXPECT_EQ(printable("std::vector"), "std::vector");
  EXPECT_EQ(printable("a ##[error]b ##vso[task]"), "a ?#[error]b ?#vso[task]");
}

TEST(Harmless, PathsStillNameTheirFile) {
  EXPECT_EQ(harmless_path("::error::x.k"), "./::error::x.k");
  EXPECT_EQ(harmless_path(" ::x.k"), "./ ::x.k");
  for (const char* path : {"=1+2.k", "+a.k", "-a.k", "@a.k"}) EXPECT_EQ(harmless_path(path), std::string("./") + path);
  for (const char* path : {"a=b.k", "/a.k", "", "a::b.k", "./=a"}) EXPECT_EQ(harmless_path(path), path);
  EXPECT_EQ(printable_path("::a\x1b.k"), "./::a?.k");
}

TEST(XmlText, NewlinesOfAttributes) {
  EXPECT_EQ(xml_attribute("a\n<b>\t\"c\""), "a&#10;&lt;b&gt;&#9;&quot;c&quot;");
  EXPECT_EQ(xml_text("a\nb"), "a\nb");
}

}  // namespace
}  // namespace gapcheck::report::harmless_test
