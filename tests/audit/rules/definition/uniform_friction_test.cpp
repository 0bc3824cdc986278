#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::uniform_friction_test {
namespace {

/// Materials behind steel (1) and rigid steel (2).
constexpr int rubber = 3, foam = 4, fabric = 5, plastic = 6, null_material = 7;

/// One plate for each material, parts 1, 2, …, above each other.
RuleDeck plates(const std::vector<int>& materials) {
  RuleDeck deck;
  deck.raw("MAT_MOONEY-RIVLIN_RUBBER", "3,1.1e-9,0.499,0.6,0.15").raw("MAT_LOW_DENSITY_FOAM", "4,5.e-11,1.");
  deck.raw("MAT_FABRIC", "5,8.e-10,300.,300.,0.,0.3").raw("MAT_ELASTIC", "6,1.1e-9,2000.,0.35");
  deck.raw("MAT_NULL", "7,7.85e-9,0.,0.,0.,0.,210000.,0.3");
  for (int i = 1; i <= static_cast<int>(materials.size()); ++i)
    deck.shell_part(i, 1, materials[i - 1]).plate(100 * i, i, 1, 1, Vector(0, 0, 10 * i), 5, 5);
  return deck;
}

Report global(const std::vector<int>& materials, const std::string& card2 = "0.2",
              const std::string& keyword = "AUTOMATIC_SINGLE_SURFACE") {
  return run_rule("GC426", plates(materials).contact(4, keyword, "0,0,5,0", card2 + "\n1.,1.\n"));
}

std::size_t found(const std::vector<int>& materials, const std::string& card2 = "0.2",
                  const std::string& keyword = "AUTOMATIC_SINGLE_SURFACE") {
  return listed(global(materials, card2, keyword));
}

TEST(UniformFriction, MetalAndRubber) {
  const Report report = global({1, 1, rubber});
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.severity, Severity::note);
  EXPECT_EQ(f.contact, 4);
  EXPECT_EQ(f.count, 2U);
  EXPECT_NE(
      f.message.find("FS = 0.2, FD = 0 for all pairs of parts, among them metal on metal (parts 1 and 2), metal on "
                     "rubber (parts 1 and 3); where"),
      std::string::npos)
      << f.message;
}

TEST(UniformFriction, OneKindOfPairIsEnoughForOneValue) {
  EXPECT_EQ(found({1, 1, 1}), 0U);
  EXPECT_EQ(found({1, rubber}), 0U);
  EXPECT_EQ(found({1, 2, rubber}), 1U);  // a rigid part is of metal too
  EXPECT_EQ(found({rubber, rubber, foam}), 1U);
  EXPECT_EQ(found({1, foam, fabric}), 1U);
}

TEST(UniformFriction, OtherMaterialsAreNotJudged) {
  EXPECT_EQ(found({1, 1, plastic}), 0U);
  EXPECT_EQ(found({1, 1, null_material}), 0U);
  EXPECT_EQ(found({plastic, plastic, rubber}), 0U);
}

TEST(UniformFriction, FrictionByPartsOrPairs) {
  EXPECT_EQ(found({1, 1, rubber}, "-1."), 0U);
  EXPECT_EQ(found({1, 1, rubber}, "-2."), 0U);
}

TEST(UniformFriction, WithoutFrictionInGlobalContactsOnly) {
  EXPECT_EQ(found({1, 1, rubber}, "0."), 1U);
  const auto local = [](const std::string& card2) {
    RuleDeck deck = plates({1, 1, rubber}).raw("SET_PART_LIST", "9\n2,3\n");
    return listed(run_rule("GC426", deck.contact(4, "AUTOMATIC_SURFACE_TO_SURFACE", "1,9,3,2", card2 + "\n1.,1.\n")));
  };
  EXPECT_EQ(local("0."), 0U);
  EXPECT_EQ(local("0.,0.1"), 1U);
  EXPECT_EQ(local("0.2"), 1U);
}

TEST(UniformFriction, OnlyTheTwoSidesMeet) {
  RuleDeck deck = plates({rubber, 1, 1}).raw("SET_PART_LIST", "9\n2,3\n");
  EXPECT_EQ(listed(run_rule("GC426", deck.contact(4, "AUTOMATIC_SURFACE_TO_SURFACE", "1,9,3,2", "0.2\n1.,1.\n"))), 0U);
}

TEST(UniformFriction, ExcludedPairsDoNotMeet) {
  RuleDeck deck = plates({1, 1, rubber}).raw("CONTACT_EXCLUDE_INTERACTION", "1,4\n1,2,3,3\n");
  EXPECT_EQ(listed(run_rule("GC426", deck.contact(4, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", "0.2\n1.,1.\n"))), 0U);
}

TEST(UniformFriction, TypesWithoutATableOfFriction) {
  EXPECT_EQ(found({1, 1, rubber}, "0.2", "AIRBAG_SINGLE_SURFACE"), 0U);
  EXPECT_EQ(found({1, 1, rubber}, "0.2", "AUTOMATIC_GENERAL"), 1U);
}

}  // namespace
}  // namespace gapcheck::audit_test::uniform_friction_test
