#include "records/thickness_source.hpp"

#include <gtest/gtest.h>

#include <set>

namespace gapcheck::thickness_source_test {
namespace {

TEST(ThicknessSource, EveryRuleHasItsOwnWords) {
  std::set<std::string_view> words;
  for (int rule = 0; rule <= static_cast<int>(ThicknessRule::beam_section); ++rule)
    words.insert(thickness_source(static_cast<ThicknessRule>(rule)));
  EXPECT_EQ(words.size(), 8U);
  EXPECT_EQ(thickness_source(ThicknessRule::part_contact), "OPTT of *PART_CONTACT");
}

}  // namespace
}  // namespace gapcheck::thickness_source_test
