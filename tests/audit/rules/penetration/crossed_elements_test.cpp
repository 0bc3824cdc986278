#include <random>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::crossed_elements_test {
namespace {

const std::string single = "AUTOMATIC_SINGLE_SURFACE", everything = "0,0,5,0";

/// An upright plate in x = `at`, elements of 10 x 10: ny of them along y, nz along z.
RuleDeck& upright(RuleDeck& deck, std::int64_t first, std::int64_t part, int ny, int nz, const Vector& corner,
                  double lean = 0) {
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j) deck.node(first + k * (ny + 1) + j, corner + Vector(k * lean, j * 10, k * 10));
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j) {
      const std::int64_t n = first + k * (ny + 1) + j;
      deck.shell(first + k * ny + j, part, {n, n + 1, n + ny + 2, n + ny + 1});
    }
  return deck;
}

/// A plate of 2 x 2 elements from the origin in z = 0 (elements 1 to 4), and an upright one of 2 x 2 (101 to 104).
RuleDeck plates(const Vector& corner, double lean = 0) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  return upright(deck, 101, 2, 2, 2, corner, lean);
}

/// Elements whose corners lie up to `rough` off the plane z = 0, all to one side of it.
RuleDeck& rough_plate(RuleDeck& deck, std::int64_t first, std::int64_t part, int n, double size, const Vector& corner,
                      double rough, std::mt19937_64& random) {
  std::uniform_int_distribution<int> share(0, 2);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      deck.node(first + j * (n + 1) + i, corner + Vector(i * size, j * size, rough * share(random) / 2));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const std::int64_t a = first + j * (n + 1) + i, b = a + n + 1, e = first + 2 * (j * n + i);
      deck.shell(e, part, {a, a + 1, b + 1}).shell(e + 1, part, {a, b + 1, b});
    }
  return deck;
}

std::size_t found(RuleDeck deck, const std::string& keyword = single, const std::string& card = everything) {
  return listed(run_rule("GC103", deck.contact(1, keyword, card)));
}

TEST(CrossedElements, EachElementOfTheUprightPlateCutsOne) {
  RuleDeck deck = plates({5, 0, -5});
  const Report report = run_rule("GC103", deck.contact(1, single, everything));
  ASSERT_EQ(report.findings.size(), 2U);
  for (const Finding& f : report.findings) {
    EXPECT_EQ(f.contact, 1);
    EXPECT_EQ(f.element_part, 1);
    EXPECT_EQ(f.part, 2);
    ASSERT_TRUE(f.point);
    EXPECT_NE(f.message.find("cross along 10,"), std::string::npos) << f.message;
    EXPECT_EQ(f.line, line_of(deck, f.element == 1 ? "1,1,1,2,5,4" : "3,1,4,5,8,7"));
  }
  EXPECT_EQ(report.findings[0].element, 1);
  EXPECT_LT((*report.findings[0].point - Vector(5, 5, 0)).norm(), 1e-12);
  EXPECT_NE(report.findings[0].message.find("shell 101 (part 2)"), std::string::npos) << report.findings[0].message;
  EXPECT_EQ(report.findings[1].element, 3);
  EXPECT_LT((*report.findings[1].point - Vector(5, 15, 0)).norm(), 1e-12);
}

TEST(CrossedElements, StandingOnThePlateIsNone) {
  EXPECT_EQ(found(plates({5, 0, 0})), 0U);
  EXPECT_EQ(found(plates({5, 0, -20})), 0U) << "hanging from it";
  EXPECT_EQ(found(plates({5, 0, -9e-3})), 0U) << "within a thousandth of the elements";
  EXPECT_EQ(found(plates({5, 0, -1.1e-2})), 2U);
  EXPECT_EQ(found(plates({-0.1, 0, -5})), 0U) << "beside it";
  EXPECT_EQ(found(plates({10, 0, 0})), 0U) << "on a mesh line";
  EXPECT_EQ(found(plates({20, 0, -5})), 0U) << "along the rim, where nothing is beyond";
}

TEST(CrossedElements, MeshesThatCrossAlongTheirMeshLines) {
  // Both have a row of element edges where they cross: the four elements around each piece of it cross in pairs.
  EXPECT_EQ(found(plates({10, 0, -10})), 8U);
  // Only one of them has: the upright elements pass through the line between two flat ones.
  EXPECT_EQ(found(plates({10, 0, -5})), 4U);
  // The same where no number is whole, as after a rotation.
  EXPECT_EQ(found(plates({10 - 1.0 / 3, 0, -10}, 1.0 / 3)), 8U);
  // Through the diagonals of the quads: two triangles of one quad on either side.
  RuleDeck deck = plates({100, 0, 0});
  deck.node(201, {0, 0, -5})
      .node(202, {20, 20, -5})
      .node(203, {20, 20, 5})
      .node(204, {0, 0, 5})
      .shell(200, 2, {201, 202, 203, 204});
  EXPECT_EQ(found(deck), 2U);
}

TEST(CrossedElements, OneElementCutsSeveral) {
  // A long triangle along y = 5 through both elements of the first row.
  RuleDeck deck = plates({100, 0, 0});
  deck.node(201, {1, 5, -1}).node(202, {19, 5, -1}).node(203, {10, 5, 9}).shell(200, 2, {201, 202, 203});
  const Report report = run_rule("GC103", deck.contact(1, single, everything));
  ASSERT_EQ(report.findings.size(), 2U);
  // At z = 0 the triangle reaches from x = 1.9 to 18.1.
  for (const Finding& f : report.findings)
    EXPECT_NE(f.message.find("cross along 8.1,"), std::string::npos) << f.message;
}

TEST(CrossedElements, OnlyContactsThatKeepApart) {
  const RuleDeck deck = plates({5, 0, -5});
  EXPECT_EQ(found(deck, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3"), 2U);
  EXPECT_EQ(found(deck, "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR", "1,2,3,3"), 2U);
  EXPECT_EQ(found(deck, "SURFACE_TO_SURFACE", "1,2,3,3"), 2U);
  EXPECT_EQ(found(deck, "AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "1,2,3,3"), 0U);
  EXPECT_EQ(found(deck, "TIED_SURFACE_TO_SURFACE", "1,2,3,3"), 0U);
  EXPECT_EQ(found(deck, "FORCE_TRANSDUCER_PENALTY", "1,2,3,3"), 0U);
  EXPECT_EQ(found(deck, single, "1,0,3,0"), 0U) << "the other part is not in it";
  EXPECT_EQ(found(deck, "AUTOMATIC_SURFACE_TO_SURFACE", "1,1,3,3"), 0U);
}

TEST(CrossedElements, OncePerPairInTheFirstContact) {
  RuleDeck deck = plates({5, 0, -5});
  deck.contact(7, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3").contact(8, single, everything);
  const Report report = run_rule("GC103", deck);
  ASSERT_EQ(report.findings.size(), 2U);
  for (const Finding& f : report.findings) EXPECT_EQ(f.contact, 7);
  audit::AuditOptions options;
  options.contacts = {8};
  const Report second = run_rule("GC103", deck, options);
  ASSERT_EQ(second.findings.size(), 2U);
  for (const Finding& f : second.findings) EXPECT_EQ(f.contact, 8);
  options = {};
  options.parts = {2};
  EXPECT_EQ(listed(run_rule("GC103", deck, options)), 2U);
  options.parts = {3};
  EXPECT_EQ(listed(run_rule("GC103", deck, options)), 0U);
}

TEST(CrossedElements, ExcludedPartsAndOneRigidBodyDoNotCount) {
  RuleDeck excluded = plates({5, 0, -5});
  excluded.raw("CONTACT_EXCLUDE_INTERACTION", "1\n1,2,3,3\n");
  EXPECT_EQ(found(excluded), 0U);
  const auto rigid = [](const std::string& merged) {
    RuleDeck deck;
    deck.shell_part(1, 1, 2).shell_part(2, 1, 2).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
    upright(deck, 101, 2, 2, 2, {5, 0, -5});
    if (!merged.empty()) deck.raw("CONSTRAINED_RIGID_BODIES", merged);
    return found(deck);
  };
  EXPECT_EQ(rigid(""), 2U);
  EXPECT_EQ(rigid("1,2\n"), 0U);
}

TEST(CrossedElements, MergedNodesAreJoints) {
  // A cross of two plates with common nodes along y at x = 10.
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 1, Vector(0, 0, 0), 10, 10);
  deck.node(11, {10, 0, -10}).node(12, {10, 10, -10}).node(13, {10, 0, 10}).node(14, {10, 10, 10});
  deck.shell(11, 2, {11, 12, 5, 2}).shell(12, 2, {2, 5, 14, 13});
  EXPECT_EQ(found(deck), 0U);
}

TEST(CrossedElements, SolidsAndShells) {
  // A cube of one brick pokes through the plate with its lower half: four of its faces cut the quad they stand in.
  RuleDeck deck;
  deck.shell_part(1, 1).solid_part(2).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  RuleDeck apart = deck;
  deck.block(101, 2, 1, 1, 1, {2, 2, -2}, {4, 4, 4});
  apart.block(101, 2, 1, 1, 1, {2, 2, 2}, {4, 4, 4});
  EXPECT_EQ(found(deck), 1U) << "one pair of elements, though four faces cut";
  EXPECT_EQ(found(apart), 0U);
}

TEST(CrossedElements, BeamsInTypes26Only) {
  RuleDeck deck;
  deck.shell_part(1, 1).beam_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  deck.node(50, {3, 4, -5}).node(51, {3, 4, 5}).node(52, {3, 14, 0}).node(53, {3, 14, 5});
  deck.beam(50, 2, 50, 51).beam(51, 2, 52, 53);
  EXPECT_EQ(found(deck), 0U);
  const Report report = run_rule("GC103", deck.contact(1, "AUTOMATIC_GENERAL", everything));
  ASSERT_EQ(listed(report), 1U) << "the other one only touches";
  EXPECT_LT((*report.findings[0].point - Vector(3, 4, 0)).norm(), 1e-12);
}

/// A long plate with an upright one along it: as many pairs of elements as it is long.
RuleDeck long_plates(int length) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 4, length, Vector(0, 0, 0), 10, 10);
  return upright(deck, 1001, 2, length, 1, {5, 0, -5}).contact(1, single, everything);
}

TEST(CrossedElements, ManyPairsOfTwoPartsAreCounted) {
  const RuleDeck deck = long_plates(15);
  const Report report = run_rule("GC103", deck);
  ASSERT_EQ(report.findings.size(), 11U);
  EXPECT_EQ(report.findings.back().count, 5U);
  EXPECT_EQ(report.findings.back().message.find("5 more pairs of elements of part 1 "), 0U)
      << report.findings.back().message;
  EXPECT_EQ(run_rule("GC103", long_plates(12)).findings.back().message,
            "2 more pairs of elements of part 1 and part 2 cross");
  EXPECT_EQ(run_rule("GC103", long_plates(11)).findings.back().count, 1U)
      << "a single remaining pair is listed in full";
  audit::AuditOptions exact, slow;
  exact.exact = slow.brute_force = true;
  for (const auto& options : {exact, slow}) {
    const Report other = run_rule("GC103", deck, options);
    ASSERT_EQ(other.findings.size(), 11U);
    for (std::size_t i = 0; i < 11; ++i) EXPECT_EQ(other.findings[i].message, report.findings[i].message);
  }
}

// Coarse on fine, one all above a plane and the other all below it: they touch, and nothing crosses.
TEST(CrossedElements, NotSurfacesThatLieOnEachOther) {
  std::mt19937_64 random(5);
  for (const double rough : {1e-3, 2e-3, 4e-3, 1e-2})
    for (int scene = 0; scene < 60; ++scene) {
      std::uniform_real_distribution<double> shift(-1, 1);
      RuleDeck deck;
      deck.shell_part(1, 1).shell_part(2, 1);
      rough_plate(deck, 1, 1, 3, 3.5, Vector(0, 0, 0), rough, random);
      const Vector corner(1 + shift(random), scene % 2 == 0 ? 3.5 : shift(random), 0);
      rough_plate(deck, 1001, 2, 4, 1.3, corner, -rough, random);
      EXPECT_EQ(found(deck), 0U) << rough << ", scene " << scene;
    }
}

}  // namespace
}  // namespace gapcheck::audit_test::crossed_elements_test
