#include "base/nearest_name.hpp"

#include <gtest/gtest.h>

#include <array>

namespace gapcheck::nearest_name_test {
namespace {

constexpr std::array<std::string_view, 4> names{"initial-penetration", "released-node", "tie-moved", "ptol"};

TEST(NearestName, TheFewestChanges) {
  EXPECT_EQ(nearest_name("initial-penetraton", names), "initial-penetration");
  EXPECT_EQ(nearest_name("INITIAL_PENETRATION", names), "initial-penetration");
  EXPECT_EQ(nearest_name("relased_nodes", names), "released-node");
  EXPECT_EQ(nearest_name("pol", names), "ptol");
}

TEST(NearestName, NothingThatIsAnotherWord) {
  EXPECT_EQ(nearest_name("contact", names), "");
  EXPECT_EQ(nearest_name("", names), "");
  EXPECT_EQ(nearest_name("x", names), "");
  EXPECT_EQ(nearest_name("ptol", {}), "");
  EXPECT_EQ(nearest_name("pt", names), "ptol");
  // As many changes as the name has letters.
  EXPECT_EQ(nearest_name("ab", std::array<std::string_view, 1>{"xy"}), "");
}

TEST(NearestName, OfEquallyNearNamesTheFirst) {
  EXPECT_EQ(nearest_name("cat", std::array<std::string_view, 2>{"bat", "hat"}), "bat");
  EXPECT_EQ(nearest_name("cat", std::array<std::string_view, 2>{"hat", "bat"}), "hat");
}

// Only the beginning of long words counts, so that no input costs more than 64 x 64 steps.
TEST(NearestName, LongWordsAreCut) {
  EXPECT_EQ(nearest_name("tie-moved" + std::string(1000, 'x'), names), "");
  const std::string long_name(100, 'a');
  EXPECT_EQ(nearest_name(std::string(1000, 'a'), std::array<std::string_view, 1>{long_name}), long_name);
}

TEST(NearestName, Words) {
  EXPECT_EQ(did_you_mean("ptol"), "; did you mean ptol?");
  EXPECT_EQ(did_you_mean(""), "");
}

}  // namespace
}  // namespace gapcheck::nearest_name_test
