#include "report/item/fingerprint.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "report/sample.hpp"

namespace gapcheck::report::fingerprint_test {
namespace {

Penetration at(double x, double y, double z) {
  Penetration record;
  record.original = {x, y, z};
  return record;
}

TEST(Fingerprint, IsTheSameForeverAndEverywhere) {
  // Written down once: a change here makes every stored baseline worthless.
  EXPECT_EQ(fingerprint(at(0, 0, 0), 0), 0xecfd39a095cc3617);
  EXPECT_EQ(fingerprint(at(1234.5, -0.25, 3e-7), 42), 0x5b0e72497059d80f);
}

TEST(Fingerprint, IgnoresIdsLinesAndDepth) {
  Penetration a = at(1, 2, 3), b = a;
  b.node = 99;
  b.part = 98;
  b.element = 97;
  b.segment = {1, 2, 3, 4};
  b.line = 96;
  b.file = 1;
  b.depth = 0.5;
  b.outcome = Outcome::moved;
  EXPECT_EQ(fingerprint(a, 1), fingerprint(b, 1));
}

TEST(Fingerprint, TellsContactRuleAndPositionApart) {
  Penetration other = at(1, 2, 3);
  other.kind = PenetrationKind::released;
  const std::set<std::uint64_t> all{fingerprint(at(1, 2, 3), 1),   fingerprint(at(1, 2, 3), 2),
                                    fingerprint(other, 1),         fingerprint(at(1, 2, 3.0001), 1),
                                    fingerprint(at(2, 1, 3), 1),   fingerprint(at(10, 20, 30), 1),
                                    fingerprint(at(-1, -2, -3), 1)};
  EXPECT_EQ(all.size(), 7u);
}

TEST(Fingerprint, SixDigitsOfTheLargestCoordinate) {
  // The slow twin: the same number of decimals for all three, through text.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(100.0, 999.0);
  for (int i = 0; i < 1000; ++i) {
    const double x = value(random), y = value(random) * 1e-3, z = -value(random) * 1e-6;
    const auto rounded = [](double v) { return std::stod(fmt::format("{:.3f}", v)); };
    EXPECT_EQ(fingerprint(at(x, y, z), 5), fingerprint(at(rounded(x), rounded(y), rounded(z)), 5));
    EXPECT_NE(fingerprint(at(x, y, z), 5), fingerprint(at(x + 0.002, y, z), 5));
  }
}

TEST(Fingerprint, AnyNumberIsFine) {
  const double huge = 1.7e308, tiny = 5e-324, nan = std::nan("");
  for (const double x : {huge, -huge, tiny, -tiny, nan, HUGE_VAL})
    for (const double y : {0.0, huge, tiny, nan}) EXPECT_EQ(fingerprint(at(x, y, 0), 1), fingerprint(at(x, y, 0), 1));
  std::set<std::uint64_t> all;
  for (const double x : {huge, -huge, 1.0, 0.0}) all.insert(fingerprint(at(x, 0, 0), 1));
  EXPECT_EQ(all.size(), 4u);
  EXPECT_EQ(fingerprint(at(-0.0, -0.0, 0), 1), fingerprint(at(0, 0, 0), 1));
}

TEST(Fingerprint, RandomPositionsDoNotCollide) {
  std::set<std::uint64_t> seen;
  for (const Penetration& record : random_report(20000, 1, 12).penetrations) seen.insert(fingerprint(record, 1));
  EXPECT_EQ(seen.size(), 20000u);
}

TEST(Fingerprint, FindingsKeepItWhenLinesMove) {
  Finding a = make_finding("GC501", "duplicate-id", "node 12 is defined again (first in line 40 of a.k)");
  Finding b = a;
  b.message = "node 12 is defined again (first in line 4711 of a.k)";
  b.line = 9;
  EXPECT_EQ(fingerprint(a), fingerprint(b));
  b.message = "node 12 is defined again (first in line 40 of ../lib of (my line 3) parts/a (2).k)";
  EXPECT_EQ(fingerprint(a), fingerprint(b)) << "the path by which the deck was named";
  b.message = "node 13 is defined again (first in line 40 of a.k)";
  EXPECT_NE(fingerprint(a), fingerprint(b));
  b = a;
  b.contact = 3;
  EXPECT_NE(fingerprint(a), fingerprint(b));
  b = a;
  b.message = "ends with line ";
  EXPECT_NE(fingerprint(a), fingerprint(b));
}

TEST(Fingerprint, PlacesOfOtherThingsAreLeftOut) {
  EXPECT_EQ(without_place("node 1 again (first in line 66 of V/m.k)"), "node 1 again (first)");
  EXPECT_EQ(without_place("node 1 again (first in line of V/m.k)"), "node 1 again (first)");
  for (const char* other : {"", "x", "node 1 again (first in line 66 of V/m.k", "again (first in line 6)",
                            "again (first in line)", "again (first in lines 6 of a)", "again (first in line 6 or a)"})
    EXPECT_EQ(without_place(other), other);
}

}  // namespace
}  // namespace gapcheck::report::fingerprint_test
