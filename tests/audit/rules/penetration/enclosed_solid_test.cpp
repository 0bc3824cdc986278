#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::enclosed_solid_test {
namespace {

const std::string single = "AUTOMATIC_SINGLE_SURFACE", everything = "0,0,5,0";

/// A cube of 10 with 5 x 5 x 5 bricks from the origin (part 1), and two bricks beside each other (part 2) at a corner.
RuleDeck cubes(const Vector& corner) {
  RuleDeck deck;
  deck.solid_part(1).solid_part(2).block(1, 1, 5, 5, 5, {0, 0, 0}, {2, 2, 2});
  return deck.block(1001, 2, 2, 1, 1, corner, {0.5, 1, 1});
}

std::size_t found(RuleDeck deck, const std::string& keyword = single, const std::string& card = everything) {
  return listed(run_rule("GC105", deck.contact(1, keyword, card)));
}

TEST(EnclosedSolid, ABodyInsideAnother) {
  RuleDeck deck = cubes({4.3, 4.4, 4.6});
  const Report report = run_rule("GC105", deck.contact(1, single, everything));
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.element, 1001);
  EXPECT_EQ(f.element_part, 2);
  EXPECT_EQ(f.part, 1);
  EXPECT_EQ(f.contact, 1);
  EXPECT_LT((*f.point - Vector(4.3, 4.4, 4.6)).norm(), 1e-12);
  EXPECT_NE(f.message.find("2 solids of part 2"), std::string::npos) << f.message;
}

TEST(EnclosedSolid, OutsideHalfOutsideAndTouchingFromOutsideAreNot) {
  EXPECT_EQ(found(cubes({20, 0, 0})), 0U);
  EXPECT_EQ(found(cubes({9.5, 4.4, 4.6})), 0U) << "crosses";
  EXPECT_EQ(found(cubes({10, 4, 4})), 0U) << "touches";
}

TEST(EnclosedSolid, OnTheInnerMeshAndTouchingFromInside) {
  EXPECT_EQ(found(cubes({4, 4, 4})), 1U) << "nodes at the places of the other's nodes";
  EXPECT_EQ(found(cubes({0, 4.5, 4.5})), 1U) << "some nodes on the skin";
}

TEST(EnclosedSolid, InACavityIsOutside) {
  // 3 x 3 x 3 bricks of 2 without the middle one, in which the small body has room.
  const auto hollow = [](bool filled) {
    RuleDeck deck;
    deck.solid_part(1).solid_part(2);
    const auto id = [](int i, int j, int k) { return 1 + (k * 4 + j) * 4 + i; };
    for (int k = 0; k < 4; ++k)
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) deck.node(id(i, j, k), Vector(2 * i, 2 * j, 2 * k));
    std::int64_t element = 1;
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
          if (filled || i != 1 || j != 1 || k != 1)
            deck.solid(element++, 1,
                       {id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1),
                        id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1)});
    return deck.block(1001, 2, 1, 1, 1, {2.5, 2.5, 2.5}, {1, 1, 1});
  };
  EXPECT_EQ(found(hollow(false)), 0U);
  EXPECT_EQ(found(hollow(true)), 1U);
}

TEST(EnclosedSolid, OnlyWhereAContactActsOnBoth) {
  const RuleDeck deck = cubes({4.3, 4.4, 4.6});
  EXPECT_EQ(found(deck, "AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3"), 1U);
  EXPECT_EQ(found(deck, "AUTOMATIC_SURFACE_TO_SURFACE", "2,2,3,3"), 0U);
  EXPECT_EQ(found(deck, "TIED_SURFACE_TO_SURFACE", "2,1,3,3"), 0U);
  EXPECT_EQ(found(deck, single, "1,0,3,0"), 0U);
  RuleDeck excluded = deck;
  EXPECT_EQ(found(excluded.raw("CONTACT_EXCLUDE_INTERACTION", "1\n1,2,3,3\n")), 0U);
}

TEST(EnclosedSolid, EachBodyIsListedAndManyAreCounted) {
  RuleDeck deck = cubes({4.3, 4.4, 4.6});
  for (int i = 0; i < 12; ++i)
    deck.block(2001 + 100 * i, 2, 1, 1, 1, Vector(0.5 + 0.7 * i, 1.1, 1.2), {0.25, 0.25, 0.25});
  const Report report = run_rule("GC105", deck.contact(1, single, everything));
  ASSERT_EQ(listed(report), 11U);
  EXPECT_EQ(report.findings[0].element, 1001) << "the largest first";
  EXPECT_EQ(report.findings.back().count, 3U);
}

}  // namespace
}  // namespace gapcheck::audit_test::enclosed_solid_test
