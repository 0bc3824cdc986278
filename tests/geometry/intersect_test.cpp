#include "geometry/intersect.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "families.hpp"

namespace gapcheck::geometry::test::intersect_test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int many = 30'000;
#else
constexpr int many = 1'000'000;
#endif

Kernel::Point_3 point(const Vector& x) { return {x.x(), x.y(), x.z()}; }
Kernel::Triangle_3 triangle(const Triangle& t) { return {point(t[0]), point(t[1]), point(t[2])}; }

struct Twin {
  Triangle a, b;
};

std::string describe(const Twin& twin) {
  return test::describe({{{twin.a[0], twin.a[1], twin.a[2], twin.b[0]}, false}, twin.b[1]}) + " and " +
         test::describe({{{twin.b[2], twin.b[2], twin.b[2], twin.b[2]}, false}, twin.b[2]});
}

/// Both modes; they must agree.
bool meet(const Twin& t) {
  DecisionCounters counters;
  const bool fast = triangles_meet(t.a, t.b, Mode::filtered, counters);
  EXPECT_EQ(fast, triangles_meet(t.a, t.b, Mode::exact, counters)) << describe(t);
  return fast;
}
bool meet_fast(const Twin& t) {
  static DecisionCounters counters;
  return triangles_meet(t.a, t.b, Mode::filtered, counters);
}
bool cross(const Twin& t) {
  DecisionCounters counters;
  const bool fast = triangles_cross(t.a, t.b, Mode::filtered, counters);
  EXPECT_EQ(fast, triangles_cross(t.a, t.b, Mode::exact, counters)) << describe(t);
  return fast;
}

bool has_area(const Triangle& t) { return !CGAL::collinear(point(t[0]), point(t[1]), point(t[2])); }

Vector lattice_point(Maker& maker, int reach) {
  return {static_cast<double>(maker.integer(-reach, reach)), static_cast<double>(maker.integer(-reach, reach)),
          static_cast<double>(maker.integer(-reach, reach))};
}

Triangle lattice(Maker& maker, int reach) {
  return {lattice_point(maker, reach), lattice_point(maker, reach), lattice_point(maker, reach)};
}

/// A point of the triangle, rounded to doubles: inside, on an edge, or a corner.
Vector point_of(Maker& maker, const Triangle& t) {
  const double u = maker.uniform(0, 1), v = maker.integer(0, 1) * maker.uniform(0, 1 - u);
  return maker.integer(0, 4) == 0 ? t[0] : Vector(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
}

/// Pairs that touch, lie in one plane, share corners or edges, or miss each other by rounding.
Twin special(Maker& maker) {
  Twin twin{lattice(maker, 3), lattice(maker, 3)};
  switch (maker.integer(0, 6)) {
    case 0:
      break;
    case 1:  // in one plane
      for (Triangle* t : {&twin.a, &twin.b})
        for (Vector& x : *t) x.z() = x.x() - 2 * x.y();
      break;
    case 2:
      twin.b[0] = twin.a[maker.integer(0, 2)];
      break;
    case 3:
      twin.b[0] = twin.a[0];
      twin.b[2] = twin.a[1];
      break;
    case 4:  // a corner or an edge on the other, up to rounding
      for (Vector& x : twin.a) x = maker.point(1);
      twin.b = {point_of(maker, twin.a), maker.point(2),
                maker.integer(0, 1) == 0 ? maker.point(2) : point_of(maker, twin.a)};
      break;
    case 5:  // rounded into one plane
      for (Vector& x : twin.a) x = maker.point(1);
      for (Vector& x : twin.b)
        x = twin.a[0] + maker.uniform(-2, 2) * (twin.a[1] - twin.a[0]) + maker.uniform(-2, 2) * (twin.a[2] - twin.a[0]);
      break;
    default: {  // far away: few digits are left
      const Vector offset = maker.power_of_ten(3, 9) * maker.point(1);
      for (Triangle* t : {&twin.a, &twin.b})
        for (Vector& x : *t) x = 0.1 * x + offset;
    }
  }
  return twin;
}

TEST(Intersect, AMillionRandomPairsAsCgalSees) {
  Maker maker(601);
  int met = 0;
  for (int i = 0; i < many; ++i) {
    Twin twin;
    for (Triangle* t : {&twin.a, &twin.b})
      for (Vector& x : *t) x = maker.point(1);
    const bool expected = CGAL::do_intersect(triangle(twin.a), triangle(twin.b));
    met += expected ? 1 : 0;
    ASSERT_EQ(meet_fast(twin), expected) << describe(twin);
  }
  EXPECT_GT(met, many / 10);
  EXPECT_LT(met, many / 2);
}

TEST(Intersect, AMillionSpecialPairsAsCgalSees) {
  Maker maker(607);
  int met = 0, compared = 0;
  for (int i = 0; i < many; ++i) {
    const Twin twin = special(maker);
    if (!has_area(twin.a) || !has_area(twin.b)) continue;
    const bool expected = CGAL::do_intersect(triangle(twin.a), triangle(twin.b));
    ++compared;
    met += expected ? 1 : 0;
    ASSERT_EQ(meet_fast(twin), expected) << describe(twin);
  }
  EXPECT_GT(compared, many * 9 / 10);
  EXPECT_GT(met, compared / 4);
  EXPECT_LT(met, compared * 3 / 4);
}

using Whole = std::array<std::int64_t, 3>;
Whole whole(const Vector& v) {
  return {static_cast<std::int64_t>(v.x()), static_cast<std::int64_t>(v.y()), static_cast<std::int64_t>(v.z())};
}
Whole operator-(const Whole& a, const Whole& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
std::int64_t dot(const Whole& a, const Whole& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Whole cross(const Whole& a, const Whole& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// In whole numbers, and on another way: two convex bodies are apart exactly if the direction between their nearest
/// points separates them. It joins two corners, a corner and an edge, two edges, or a corner and a face.
bool whole_triangles_meet(const Triangle& ta, const Triangle& tb) {
  std::array<Whole, 3> a{}, b{}, edges_a{}, edges_b{};
  for (std::size_t i = 0; i < 3; ++i) a[i] = whole(ta[i]), b[i] = whole(tb[i]);
  for (std::size_t i = 0; i < 3; ++i) edges_a[i] = a[(i + 1) % 3] - a[i], edges_b[i] = b[(i + 1) % 3] - b[i];
  std::vector<Whole> directions{cross(edges_a[0], edges_a[1]), cross(edges_b[0], edges_b[1])};
  for (const Whole& e : edges_a)
    for (const Whole& f : edges_b) directions.push_back(cross(e, f));
  for (const Whole& p : a)
    for (const Whole& q : b) {
      directions.push_back(p - q);
      for (const auto* edges : {&edges_a, &edges_b})
        for (const Whole& e : *edges) directions.push_back(cross(e, cross(p - q, e)));
    }
  return std::none_of(directions.begin(), directions.end(), [&](const Whole& n) {
    const auto low = [&](const auto& t) { return std::min({dot(t[0], n), dot(t[1], n), dot(t[2], n)}); };
    const auto high = [&](const auto& t) { return std::max({dot(t[0], n), dot(t[1], n), dot(t[2], n)}); };
    return high(a) < low(b) || high(b) < low(a);
  });
}

TEST(Intersect, TrianglesWithAndWithoutAreaAsWholeNumbersSay) {
  Maker maker(613);
  int met = 0, without_area = 0;
  for (int i = 0; i < many / 5; ++i) {
    Twin twin{lattice(maker, 2), lattice(maker, 2)};
    switch (maker.integer(0, 4)) {
      case 0:
        twin.a[1] = twin.a[0];
        break;
      case 1:
        twin.a[2] = 2 * twin.a[1] - twin.a[0];
        break;
      case 2:
        twin.a[1] = twin.a[2] = twin.a[0];
        break;
      case 3:
        twin.b[2] = 2 * twin.b[0] - twin.b[1];
        [[fallthrough]];
      default:
        break;
    }
    if (maker.integer(0, 2) == 0) std::swap(twin.a, twin.b);
    const bool expected = whole_triangles_meet(twin.a, twin.b);
    met += expected ? 1 : 0;
    without_area += has_area(twin.a) && has_area(twin.b) ? 0 : 1;
    ASSERT_EQ(meet(twin), expected) << describe(twin);
    // A triangle that is a segment, and the segment itself.
    DecisionCounters counters;
    if (twin.a[1] == twin.a[2]) {
      ASSERT_EQ(segment_meets(twin.a[0], twin.a[1], twin.b, Mode::filtered, counters), expected) << describe(twin);
    }
    if (twin.a[1] == twin.a[2] && twin.b[1] == twin.b[2]) {
      ASSERT_EQ(segments_meet(twin.a[0], twin.a[1], twin.b[0], twin.b[1], Mode::filtered, counters), expected);
    }
  }
  EXPECT_GT(without_area, many / 10);
  EXPECT_GT(met, many / 100);
}

TEST(Intersect, SegmentsAsWholeNumbersSay) {
  Maker maker(617);
  DecisionCounters counters;
  int met = 0, crossed = 0;
  for (int i = 0; i < many / 5; ++i) {
    const Triangle t = lattice(maker, 2), s = lattice(maker, 2);
    const bool expected = whole_triangles_meet({s[0], s[1], s[1]}, t);
    met += expected ? 1 : 0;
    ASSERT_EQ(segment_meets(s[0], s[1], t, Mode::filtered, counters), expected) << describe({t, s});
    ASSERT_EQ(segments_meet(s[0], s[1], t[0], t[1], Mode::filtered, counters),
              whole_triangles_meet({s[0], s[1], s[1]}, {t[0], t[1], t[1]}))
        << describe({t, s});
    const Whole n = cross(whole(t[1]) - whole(t[0]), whole(t[2]) - whole(t[0]));
    const bool opposite = dot(n, whole(s[0]) - whole(t[0])) * dot(n, whole(s[1]) - whole(t[0])) < 0;
    crossed += expected && opposite ? 1 : 0;
    ASSERT_EQ(segment_crosses(s[0], s[1], t, Mode::filtered, counters), expected && opposite) << describe({t, s});
    bool on_an_edge = false;
    for (std::size_t e = 0; e < 3; ++e)
      on_an_edge = on_an_edge || segments_meet(s[0], s[1], t[e], t[(e + 1) % 3], Mode::exact, counters);
    const Passage way = !expected ? Passage::none : opposite && !on_an_edge ? Passage::through : Passage::touching;
    ASSERT_EQ(passage(s[0], s[1], t, Mode::filtered, counters), way) << describe({t, s});
  }
  EXPECT_GT(met, many / 200);
  EXPECT_GT(crossed, many / 1000);
}

/// A fraction with a positive denominator.
struct Fraction {
  std::int64_t above, below;
  friend bool operator<(const Fraction& a, const Fraction& b) { return a.above * b.below < b.above * a.below; }
};

/// Crossing in whole numbers: both pieces of the common line, end by end.
bool whole_triangles_cross(const Triangle& ta, const Triangle& tb) {
  std::array<Whole, 3> a{}, b{};
  for (std::size_t i = 0; i < 3; ++i) a[i] = whole(ta[i]), b[i] = whole(tb[i]);
  const Whole na = cross(a[1] - a[0], a[2] - a[0]), nb = cross(b[1] - b[0], b[2] - b[0]), along = cross(na, nb);
  bool both_sides = true;
  const auto piece = [&](const std::array<Whole, 3>& t, const Whole& n, const Whole& on) {
    std::vector<Fraction> ends;
    std::array<std::int64_t, 3> h{};
    for (std::size_t i = 0; i < 3; ++i) h[i] = dot(n, t[i] - on);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (h[i] == 0) ends.push_back({dot(along, t[i]), 1});
      if (h[i] * h[j] < 0) {
        const std::int64_t from = std::abs(h[i]), to = std::abs(h[j]);
        ends.push_back({to * dot(along, t[i]) + from * dot(along, t[j]), from + to});
      }
    }
    both_sides = both_sides && *std::min_element(h.begin(), h.end()) < 0 && *std::max_element(h.begin(), h.end()) > 0;
    return ends;
  };
  const auto ends_a = piece(a, nb, b[0]), ends_b = piece(b, na, a[0]);
  if (!both_sides) return false;
  const auto low = [](const auto& e) { return *std::min_element(e.begin(), e.end()); };
  const auto high = [](const auto& e) { return *std::max_element(e.begin(), e.end()); };
  return low(ends_a) < high(ends_b) && low(ends_b) < high(ends_a);
}

TEST(Intersect, CrossingsAsWholeNumbersSayInEveryOrderOfTheCorners) {
  Maker maker(619);
  int crossed = 0, touched = 0;
  for (int i = 0; i < many / 20; ++i) {
    Twin twin{lattice(maker, 2), lattice(maker, 2)};
    const bool expected = whole_triangles_cross(twin.a, twin.b);
    crossed += expected ? 1 : 0;
    touched += !expected && meet(twin) ? 1 : 0;
    ASSERT_TRUE(!expected || meet(twin)) << describe(twin);
    for (int turn = 0; turn < 4; ++turn) {
      ASSERT_EQ(cross(twin), expected) << describe(twin);
      if (turn % 2 == 0) std::swap(twin.a, twin.b);
      std::rotate(twin.a.begin(), twin.a.begin() + 1, twin.a.end());
      std::swap(twin.b[0], twin.b[2]);
    }
  }
  EXPECT_GT(crossed, many / 200);
  EXPECT_GT(touched, many / 200);
}

TEST(Intersect, TheCommonLineLiesOnBoth) {
  Maker maker(631);
  int crossed = 0;
  for (int i = 0; i < many / 20; ++i) {
    Twin twin;
    for (Triangle* t : {&twin.a, &twin.b})
      for (Vector& x : *t) x = maker.point(1);
    if (!cross(twin)) continue;
    ++crossed;
    const Line line = common_line(twin.a, twin.b);
    EXPECT_GT(line.length(), 0);
    for (const Vector& end : {line.from, line.to, line.middle()})
      for (const Triangle& t : {twin.a, twin.b})
        EXPECT_LT(closest_point({{t[0], t[1], t[2], t[2]}, true}, end).squared_distance, 1e-16) << describe(twin);
  }
  EXPECT_GT(crossed, many / 400);
}

TEST(Intersect, TheCommonLineByHand) {
  // A triangle in the plane z = 0, and one in x = 0.25 from y = 0.25 to beyond the first one's slanted edge y = 0.75.
  const Triangle flat{Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0)};
  const Triangle upright{Vector(0.25, 0.25, -1), Vector(0.25, 0.25, 1), Vector(0.25, 4.25, 1)};
  const Line line = common_line(flat, upright);
  EXPECT_NEAR(line.length(), 0.5, 1e-15);
  EXPECT_LT((line.middle() - Vector(0.25, 0.5, 0)).norm(), 1e-15);
  EXPECT_EQ(common_line(flat, {Vector(0.25, 0.25, 1), Vector(0.25, 0.5, 1), Vector(0.25, 0.5, 2)}).length(), 0);
}

TEST(Intersect, StandingTouchingAndLyingIsNoCrossing) {
  const Triangle flat{Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 4, 0)};
  const auto expect = [&](const Triangle& other, bool meets, bool crosses) {
    EXPECT_EQ(meet({flat, other}), meets);
    EXPECT_EQ(cross({flat, other}), crosses);
  };
  expect({Vector(1, 1, -1), Vector(1, 1, 1), Vector(2, 1, 1)}, true, true);
  expect({Vector(1, 1, 0), Vector(2, 1, 0), Vector(1, 1, 1)}, true, false);     // stands on it with an edge
  expect({Vector(1, 1, 0), Vector(2, 1, 1), Vector(1, 1, 1)}, true, false);     // with a corner
  expect({Vector(1, 1, 0), Vector(2, 1, 0), Vector(1, 2, 0)}, true, false);     // in its plane
  expect({Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 0, 4)}, true, false);     // at a common edge
  expect({Vector(2, 2, -1), Vector(2, 2, 1), Vector(3, 3, 0)}, true, false);    // touches its edge from outside
  expect({Vector(-1, 2, 1), Vector(-1, 2, -1), Vector(0, 2, 0)}, true, false);  // tip on its edge
  expect({Vector(1, 1, 1e-300), Vector(2, 1, 1e-300), Vector(1, 1, 1)}, false, false);
  expect({Vector(1, 1, -1e-300), Vector(2, 1, 1e-300), Vector(1, 1, 1)}, true, true);
}

TEST(Intersect, NumbersThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Triangle flat{Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 4, 0)};
  for (const double bad : {nan, infinity, -infinity}) {
    const Triangle other{Vector(1, 1, -1), Vector(1, 1, bad), Vector(2, 1, 1)};
    EXPECT_FALSE(meet({flat, other}));
    EXPECT_FALSE(cross({other, flat}));
  }
  // The largest and smallest doubles.
  const Triangle huge{Vector(-1e308, -1e308, 0), Vector(1e308, -1e308, 0), Vector(0, 1e308, 0)};
  EXPECT_TRUE(cross({huge, {Vector(0, 0, -5e-324), Vector(1, 0, 5e-324), Vector(0, 1, 5e-324)}}));
}

TEST(Intersect, CountsEachAnswerOnce) {
  const Triangle flat{Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 4, 0)};
  DecisionCounters counters;
  EXPECT_TRUE(triangles_meet(flat, {Vector(1, 1, -1), Vector(1, 1, 1), Vector(2, 1, 1)}, Mode::filtered, counters));
  EXPECT_EQ(counters.filter, 1u);
  EXPECT_TRUE(triangles_meet(flat, {Vector(1, 1, 0), Vector(1, 1, 1), Vector(2, 1, 1)}, Mode::filtered, counters));
  EXPECT_EQ(counters.exact, 1u);
  EXPECT_EQ(counters.filter, 1u);
}

}  // namespace
}  // namespace gapcheck::geometry::test::intersect_test
