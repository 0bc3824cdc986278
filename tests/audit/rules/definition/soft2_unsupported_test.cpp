#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::soft2_unsupported_test {
namespace {

std::size_t found(const std::string& keyword, int soft) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.plate(101, 2, 2, 2, Vector(0, 0, 9), 5, 5);
  const std::string own = keyword.starts_with("ERODING") ? "1,1,1\n" : "";
  return listed(
      run_rule("GC412", deck.contact(1, keyword, "1,2,3,3", "0.\n1.,1.\n" + own + std::to_string(soft) + "\n")));
}

TEST(Soft2Unsupported, TypesThatSwitchToSoft1) {
  for (const char* keyword : {"AUTOMATIC_NODES_TO_SURFACE", "AUTOMATIC_GENERAL", "ERODING_NODES_TO_SURFACE"}) {
    EXPECT_EQ(found(keyword, 2), 1U) << keyword;
    EXPECT_EQ(found(keyword, 1), 0U) << keyword;
  }
  for (const char* keyword :
       {"AUTOMATIC_SURFACE_TO_SURFACE", "AUTOMATIC_SINGLE_SURFACE", "AIRBAG_SINGLE_SURFACE",
        "ERODING_SURFACE_TO_SURFACE", "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR", "TIED_SURFACE_TO_SURFACE"})
    EXPECT_EQ(found(keyword, 2), 0U) << keyword;
}

TEST(Soft2Unsupported, ValuesThatDoNotExist) {
  EXPECT_EQ(found("AUTOMATIC_SURFACE_TO_SURFACE", 3), 1U);
  EXPECT_EQ(found("TIED_SURFACE_TO_SURFACE", -1), 1U);
  EXPECT_EQ(found("AUTOMATIC_SURFACE_TO_SURFACE", 4), 1U);
  EXPECT_EQ(found("FORMING_SURFACE_TO_SURFACE", 4), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::soft2_unsupported_test
