#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::inconsistent_normals_test {
namespace {

/// Part 2 is a plate of 3 x 3 shells above part 1; `turned` ones run the other way round.
Report plate_with(const std::vector<int>& turned, const std::string& keyword, const std::string& card1 = "1,2,3,3",
                  const std::string& more = "") {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) deck.node(101 + 4 * j + i, Vector(5 * i, 5 * j, 9));
  for (int e = 0; e < 9; ++e) {
    const std::int64_t a = 101 + 4 * (e / 3) + e % 3;
    const bool turn = std::find(turned.begin(), turned.end(), e) != turned.end();
    deck.shell(201 + e, 2, turn ? std::vector{a, a + 4, a + 5, a + 1} : std::vector{a, a + 1, a + 5, a + 4});
  }
  deck.contact(6, keyword, card1, "0.\n1.,1.\n" + more);
  return run_rule("GC416", deck);
}

TEST(InconsistentNormals, CountsTheFewer) {
  const Report report = plate_with({4, 5}, "SURFACE_TO_SURFACE");
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.contact, 6);
  EXPECT_EQ(f.part, 2);
  EXPECT_EQ(f.element, 205);
  EXPECT_EQ(f.count, 2U);
  EXPECT_NE(f.message.find("side B, part 2: 2 segments are oriented against their neighbours"), std::string::npos)
      << f.message;
  EXPECT_EQ(listed(plate_with({}, "SURFACE_TO_SURFACE")), 0U);
  EXPECT_EQ(listed(plate_with({0, 1, 2, 3, 4, 5, 6, 7, 8}, "SURFACE_TO_SURFACE")), 0U);
}

TEST(InconsistentNormals, SegmentsWithoutAnElementByTheirNumber) {
  // A strip of four segments between nodes that no element has, the third one the other way round.
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  for (int i = 0; i < 5; ++i) deck.node(101 + i, {5.0 * i, 0, 9}).node(201 + i, {5.0 * i, 5, 9});
  deck.raw("SET_SEGMENT", "4\n101,102,202,201\n102,103,203,202\n103,203,204,104\n104,105,205,204\n");
  const Report report = run_rule("GC416", deck.contact(6, "SURFACE_TO_SURFACE", "1,4,3,0", "0.\n1.,1.\n"));
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.element, 0);
  EXPECT_NE(f.message.find("side B: 1 segment is oriented against its neighbours (first: segment 3)"),
            std::string::npos)
      << f.message;
  ASSERT_TRUE(f.point);
  EXPECT_EQ(*f.point, Vector(12.5, 2.5, 9));
}

TEST(InconsistentNormals, OrientedTypesAndReferenceSidesOnly) {
  for (const char* keyword : {"ONE_WAY_SURFACE_TO_SURFACE", "FORMING_ONE_WAY_SURFACE_TO_SURFACE"}) {
    EXPECT_EQ(listed(plate_with({4}, keyword)), 1U) << keyword;
    EXPECT_EQ(listed(plate_with({4}, keyword, "2,1,3,3")), 0U) << keyword;
  }
  EXPECT_EQ(listed(plate_with({4}, "SURFACE_TO_SURFACE", "2,1,3,3")), 1U);
  EXPECT_EQ(listed(plate_with({4}, "TIEBREAK_SURFACE_TO_SURFACE", "1,2,3,3", "1.,1.\n")), 1U);
  EXPECT_EQ(listed(plate_with({4}, "AUTOMATIC_SURFACE_TO_SURFACE")), 0U);
  EXPECT_EQ(listed(plate_with({4}, "AUTOMATIC_SINGLE_SURFACE", "0,0,5")), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::inconsistent_normals_test
