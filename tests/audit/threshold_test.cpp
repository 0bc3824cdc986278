#include <cmath>
#include <map>

#include "audit/registry.hpp"
#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::threshold_test {
namespace {

/// One threshold on a deck that its rule leaves alone, with a value at which it is listed.
struct Case {
  RuleDeck deck;
  double listed_at;
  double millimetre = 0;  ///< --units
};

const std::string single_surface = "AUTOMATIC_SINGLE_SURFACE";

RuleDeck in_contact(RuleDeck deck, const std::string& card_3 = "1.,1.", const std::string& card_a = "") {
  return deck.contact(1, single_surface, "0,0,5,0", "0.\n" + card_3 + "\n" + card_a);
}

RuleDeck plate(double thickness, double dx, double dy) {
  RuleDeck deck;
  deck.raw("MAT_ELASTIC", "3,1.,1.,0.3");  // tells no unit
  return deck.shell_part(1, thickness, 3).plate(1, 1, 2, 2, Vector(0, 0, 0), dx, dy);
}

/// One corner of a square of 10 is lifted: 2 are 15.8 degrees between the triangles.
RuleDeck warped() {
  RuleDeck deck;
  deck.shell_part(1, 1).node(1, Vector(0, 0, 0)).node(2, Vector(10, 0, 0)).node(3, Vector(10, 10, 2));
  return deck.node(4, Vector(0, 10, 0)).shell(1, 1, {1, 2, 3, 4});
}

/// Two squares with a common edge and 45 degrees between them.
RuleDeck folded() {
  RuleDeck deck;
  deck.shell_part(1, 1).node(1, Vector(0, 0, 0)).node(2, Vector(0, 10, 0)).node(3, Vector(10, 10, 0));
  deck.node(4, Vector(10, 0, 0)).node(5, Vector(7, 10, 7)).node(6, Vector(7, 0, 7));
  return deck.shell(1, 1, {1, 4, 3, 2}).shell(2, 1, {1, 2, 5, 6});
}

/// Two rectangles with a common edge of 10, 10 and 4 wide.
RuleDeck uneven() {
  RuleDeck deck;
  deck.shell_part(1, 1).node(1, Vector(0, 0, 0)).node(2, Vector(10, 0, 0)).node(3, Vector(14, 0, 0));
  deck.node(4, Vector(0, 10, 0)).node(5, Vector(10, 10, 0)).node(6, Vector(14, 10, 0));
  return deck.shell(1, 1, {1, 2, 5, 4}).shell(2, 1, {2, 3, 6, 5});
}

/// The same in one part, with shells of thickness 1 and 1.5.
RuleDeck two_thicknesses() {
  RuleDeck deck;
  deck.shell_part(1, 1).node(1, Vector(0, 0, 0)).node(2, Vector(10, 0, 0));
  deck.node(3, Vector(20, 0, 0)).node(4, Vector(0, 10, 0)).node(5, Vector(10, 10, 0)).node(6, Vector(20, 10, 0));
  deck.shell(1, 1, {1, 2, 5, 4});
  return deck.raw("ELEMENT_SHELL_THICKNESS", "2,1,2,3,6,5\n1.5,1.5,1.5,1.5\n");
}

/// A plate and two nodes that nothing uses.
RuleDeck plate_and_nodes() {
  RuleDeck deck;
  return deck.shell_part(1, 1).plate(1, 1, 20, 20, Vector(0, 0, 0), 5, 5).node(901, {0, 0, 9}).node(902, {1, 0, 9});
}

/// A brick of 2 x 2 x 2 that releases at 0.4, and shells of 0.9 that hold to 0.72.
RuleDeck brick_and_shells() {
  RuleDeck deck;
  deck.solid_part(1).block(1, 1, 1, 1, 1, Vector(0, 0, 0), Vector(2, 2, 2));
  return deck.shell_part(2, 0.9).plate(101, 2, 1, 1, Vector(0, 0, 50), 20, 20);
}

/// A brick of 4 that ties 0.8 above one of 20, whose face has a diagonal of 28.3.
RuleDeck brick_on_a_large_one() {
  RuleDeck deck;
  deck.solid_part(1).solid_part(2).block(1, 1, 1, 1, 1, Vector(0, 0, -20), Vector(20, 20, 20));
  deck.block(101, 2, 1, 1, 1, Vector(5, 5, 0.8), Vector(4, 4, 4));
  return deck.contact(1, "TIED_SURFACE_TO_SURFACE", "2,1,3,3");
}

/// Plates 1 to 4, 10 above each other, with a contact from each to the next.
RuleDeck chain() {
  RuleDeck deck;
  for (int p = 1; p <= 4; ++p) deck.shell_part(p, 1).plate(100 * p, p, 1, 1, Vector(0, 0, 10 * p), 5, 5);
  for (int p = 1; p <= 3; ++p)
    deck.contact(p, "AUTOMATIC_SURFACE_TO_SURFACE", fmt::format("{},{},3,3", p, p + 1), "0.2\n1.,1.\n");
  return deck;
}

std::map<std::string, Case> cases() {
  return {{"GC504.angle", {in_contact(warped()), 15}},
          {"GC506.height", {in_contact(plate(0.5, 10, 1)), 0.2}},
          {"GC508.share", {in_contact(plate_and_nodes()), 0.001}},
          {"GC512.angle", {in_contact(folded()), 50}},
          {"GC511.ratio", {in_contact(uneven()), 1.2}},
          {"GC302.share", {in_contact(plate(1.1, 2.5, 2.5)), 0.95}},
          {"GC303.edges", {in_contact(plate(0.1, 5, 5)), 0.03}},
          {"GC303.millimetres", {in_contact(plate(0.8, 5, 5)), 1, 1}},
          {"GC304.edges", {in_contact(plate(1, 5, 5), "1.,1.,4."), 0.7}},
          {"GC306.share-of-shells", {in_contact(brick_and_shells()), 0.7}},
          {"GC307.ratio", {in_contact(two_thicknesses()), 1.4}},
          {"GC207.edges", {brick_on_a_large_one(), 7}},
          {"GC411.highest", {in_contact(plate(1, 5, 5), "1.,1.", "1,0.08\n"), 0.07}},
          {"GC411.lowest", {in_contact(plate(1, 5, 5), "1.,1.", "1,0.08\n"), 0.09}},
          {"GC425.contacts", {chain(), 3}}};
}

TEST(Threshold, EachOneDecides) {
  std::size_t tried = 0;
  const auto all = cases();
  for (const RuleIdentity& rule : audit::rules())
    for (const audit::Threshold& threshold : audit::thresholds(rule)) {
      const std::string key = fmt::format("{}.{}", rule.id, threshold.name);
      const auto found = all.find(key);
      ASSERT_NE(found, all.end()) << key << " is not tried";
      ++tried;
      const Case& one = found->second;
      EXPECT_TRUE(threshold.least <= threshold.value && threshold.value <= threshold.most) << key;
      EXPECT_FALSE(threshold.meaning.empty()) << key;
      audit::AuditOptions options;
      options.millimetre = one.millimetre;
      EXPECT_EQ(listed(run_rule(std::string(rule.id), one.deck, options)), 0U) << key;
      options.thresholds[key] = one.listed_at;
      EXPECT_GT(listed(run_rule(std::string(rule.id), one.deck, options)), 0U) << key;
      options.thresholds[key] = threshold.value;
      EXPECT_EQ(listed(run_rule(std::string(rule.id), one.deck, options)), 0U) << key << " as it is";
    }
  EXPECT_EQ(tried, all.size());
}

}  // namespace
}  // namespace gapcheck::audit_test::threshold_test
