#include "records/penetration.hpp"

#include <gtest/gtest.h>

#include <set>

namespace gapcheck::penetration_test {
namespace {

template <class Enum>
std::set<std::string_view> names(int count) {
  std::set<std::string_view> result;
  for (int i = 0; i < count; ++i) result.insert(name(static_cast<Enum>(i)));
  return result;
}

TEST(Penetration, EveryValueHasItsOwnName) {
  EXPECT_EQ(names<Feature>(3), (std::set<std::string_view>{"face", "edge", "corner"}));
  EXPECT_EQ(names<Outcome>(5), (std::set<std::string_view>{"moved", "kept", "forced", "released", "reported"}));
  EXPECT_EQ(names<ThicknessRule>(8).size(), 8u);
  EXPECT_FALSE(names<ThicknessRule>(8).contains("?"));
}

TEST(Penetration, ValuesOutOfRangeHaveAName) {
  EXPECT_EQ(name(static_cast<Feature>(200)), "?");
  EXPECT_EQ(name(static_cast<Outcome>(200)), "?");
  EXPECT_EQ(name(static_cast<ThicknessRule>(200)), "?");
}

TEST(Penetration, RemainingIsWhatIsLeftOfTheContactDistance) {
  Penetration record;
  record.contact_distance = 1;
  record.depth = 0.25;
  EXPECT_EQ(record.remaining(), 0.75);
  record.depth = 1.5;  // beyond the mid-surface of an oriented segment
  EXPECT_EQ(record.remaining(), -0.5);
}

TEST(Penetration, WithinTheRoundingOfCoordinatesOrOfTheDistance) {
  Penetration record;
  record.contact_distance = 1;
  record.original = {0.5, -100, 20};
  const double digit = 100.0 / 8388608;  // 2^23
  record.depth = digit;
  EXPECT_TRUE(within_rounding(record));
  record.depth = 1.01 * digit;
  EXPECT_FALSE(within_rounding(record));
  record.original = {0, 0, 0};
  EXPECT_FALSE(within_rounding(record));
  record.depth = 1e-6;
  EXPECT_TRUE(within_rounding(record));
  record.depth = 1.01e-6;
  EXPECT_FALSE(within_rounding(record));
}

}  // namespace
}  // namespace gapcheck::penetration_test
