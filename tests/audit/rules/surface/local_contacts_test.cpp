#include <functional>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::local_contacts_test {
namespace {

/// Plates 1 … count in a row, 10 above each other.
RuleDeck plates(int count) {
  RuleDeck deck;
  for (int p = 1; p <= count; ++p) deck.shell_part(p, 1).plate(100 * p, p, 1, 1, Vector(0, 0, 10 * p), 5, 5);
  return deck;
}

struct Cards {
  std::string keyword = "AUTOMATIC_SURFACE_TO_SURFACE", cards = "0.2\n1.,1.\n";
  std::string card1 = {};  ///< empty: parts i and i + 1
};

/// Contacts 1 … count of neighbours; `different(i)` is what contact i has instead.
RuleDeck chain(
    int count, const std::function<Cards(int)>& different = [](int) { return Cards(); }) {
  RuleDeck deck = plates(count + 1);
  for (int i = 1; i <= count; ++i) {
    const Cards c = different(i);
    deck.contact(i, c.keyword, c.card1.empty() ? fmt::format("{},{},3,3", i, i + 1) : c.card1, c.cards);
  }
  return deck;
}

std::function<Cards(int)> third(const Cards& cards) {
  return [cards](int i) { return i == 3 ? cards : Cards(); };
}

std::size_t found(const RuleDeck& deck) { return listed(run_rule("GC425", deck)); }

TEST(LocalContacts, FiveInARow) {
  const Report report = run_rule("GC425", chain(5));
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.severity, Severity::note);
  EXPECT_EQ(f.contact, 1);
  EXPECT_EQ(f.count, 5U);
  EXPECT_EQ(f.message.find("5 contacts (1, 2, 3, 4, 5) with the same settings hold 6 parts that hang together: one "
                           "*CONTACT_AUTOMATIC_SINGLE_SURFACE"),
            0U)
      << f.message;
  EXPECT_EQ(found(chain(4)), 0U);
}

TEST(LocalContacts, SinglesCountToo) {
  // Contact 3 holds parts 3 and 4 as one set.
  RuleDeck deck = chain(5, third({.keyword = "AUTOMATIC_SINGLE_SURFACE", .card1 = "7,0,2,0"}));
  EXPECT_EQ(found(deck.raw("SET_PART_LIST", "7\n3,4\n")), 1U);
}

TEST(LocalContacts, PartsMustHangTogether) {
  // Without contact 3, which now holds plates of its own, 2 and 2 contacts are left.
  RuleDeck deck = chain(5, third({.card1 = "11,12,3,3"}));
  deck.shell_part(11, 1).plate(2001, 11, 1, 1, Vector(50, 0, 0), 5, 5);
  deck.shell_part(12, 1).plate(2101, 12, 1, 1, Vector(50, 0, 10), 5, 5);
  EXPECT_EQ(found(deck), 0U);
}

TEST(LocalContacts, OtherSettingsAreAReason) {
  EXPECT_EQ(found(chain(5, third({.cards = "0.3\n1.,1.\n"}))), 0U);                            // friction
  EXPECT_EQ(found(chain(5, third({.cards = "0.2\n1.,1.,0.5,0.5\n"}))), 0U);                    // thickness
  EXPECT_EQ(found(chain(5, third({.cards = "0.2\n1.,1.\n1\n"}))), 0U);                         // SOFT
  EXPECT_EQ(found(chain(5, third({.cards = "0.2\n2.,2.\n"}))), 0U);                            // stiffness
  EXPECT_EQ(found(chain(5, third({.cards = "0.2,,,,,,1.,2.\n1.,1.\n"}))), 0U);                 // times
  EXPECT_EQ(found(chain(5, third({.keyword = "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE"}))), 0U);  // one way
  EXPECT_EQ(found(chain(5, third({.keyword = "SURFACE_TO_SURFACE"}))), 0U);
  EXPECT_EQ(found(chain(5, third({.keyword = "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR"}))), 0U);
  EXPECT_EQ(found(chain(5, third({.keyword = "AUTOMATIC_SURFACE_TO_SURFACE_SMOOTH"}))), 0U);
  EXPECT_EQ(found(chain(5, third({.keyword = "AUTOMATIC_SURFACE_TO_SURFACE_THERMAL", .cards = "0.2\n1.,1.\n0.\n"}))),
            0U);
  EXPECT_EQ(found(chain(5, third({.keyword = "AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", .cards = "0.2\n1.,1.\n2,1.\n"}))),
            0U);
  const auto soft = [](int) { return Cards{.cards = "0.2\n1.,1.\n1\n"}; };
  EXPECT_EQ(found(chain(5, soft)), 1U);  // the same for all
  const auto sides = [](int) { return Cards{.cards = "0.2\n1.,1.,0.5,0.6\n"}; };
  EXPECT_EQ(found(chain(5, sides)), 0U);  // a single-surface contact has one SST
}

TEST(LocalContacts, NumericalDetailsMayDifferAndAreNamed) {
  const Report report = run_rule("GC425", chain(5, third({.cards = "0.2,0.,0.,0.,20.\n1.,1.\n"})));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("; they differ in VDC (0, 20): one"), std::string::npos)
      << report.findings[0].message;
}

TEST(LocalContacts, PiecesOfPartsAreAReason) {
  RuleDeck deck = chain(5, third({.card1 = "5,4,1,3"}));
  EXPECT_EQ(found(deck.raw("SET_SHELL_LIST", "5\n300\n")), 0U);
  RuleDeck boxed = chain(5, third({.card1 = "3,4,3,3,6"}));
  EXPECT_EQ(found(boxed.raw("DEFINE_BOX", "6,-1.,6.,-1.,6.,0.,90.\n")), 0U);
}

TEST(LocalContacts, NotBesideAGlobalContact) {
  RuleDeck deck = chain(5);
  EXPECT_EQ(found(deck.contact(9, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", "0.1\n1.,1.\n")), 0U);
  // One of a few of the parts changes nothing.
  RuleDeck partly = chain(5);
  partly.raw("SET_PART_LIST", "7\n3,4\n");
  EXPECT_EQ(found(partly.contact(9, "AUTOMATIC_SINGLE_SURFACE", "7,0,2,0", "0.1\n1.,1.\n")), 1U);
}

TEST(LocalContacts, ExclusionsAreAReason) {
  RuleDeck deck = chain(5);
  EXPECT_EQ(found(deck.raw("CONTACT_EXCLUDE_INTERACTION", "1,3\n3,4,3,3\n")), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::local_contacts_test
