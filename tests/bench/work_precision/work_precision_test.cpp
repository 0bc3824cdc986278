// The measurement itself, on few pairs: what it says must be so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "accuracy.hpp"
#include "geometry/decide.hpp"

namespace gapcheck::bench::work_precision_test {
namespace {

const Method& method(const std::string& name, const std::string& precision = "double") {
  for (const Method& m : methods()) {
    if (m.name == name && m.precision == precision) return m;
  }
  throw std::runtime_error("no method " + name);
}

const std::vector<PairFamily>& families() {
  static const std::vector<PairFamily> made = [] {
    std::vector<PairFamily> list = made_families(60);
    int decks = 0;
    list.push_back(deck_family(std::string(GAPCHECK_ROOT) + "/data", decks));
    EXPECT_GT(decks, 30);
    return list;
  }();
  return made;
}

const PairFamily& family(const std::string& name) {
  for (const PairFamily& f : families()) {
    if (f.name == name) return f;
  }
  throw std::runtime_error("no family " + name);
}

TEST(WorkPrecision, ExactDecisionsAgreeWithTheReference) {
  for (const PairFamily& f : families()) {
    EXPECT_EQ(f.disagreements, 0U) << f.name;
    EXPECT_EQ(f.triangulated, 0U) << f.name;
    EXPECT_GE(f.pairs.size(), 60U) << f.name;
  }
}

TEST(WorkPrecision, CertifiedDecisionsAreNeverWrong) {
  for (const PairFamily& f : families()) {
    EXPECT_EQ(accuracy(f, method("certified")).wrong, 0U) << f.name;
    EXPECT_EQ(accuracy(f, method("decision alone")).wrong, 0U) << f.name;
    const Accuracy batch = accuracy(f, method("certified batches"));
    EXPECT_EQ(batch.wrong + batch.lost, 0U) << f.name;
    EXPECT_LT(std::max(batch.largest, accuracy(f, method("certified")).largest), 1e-13) << f.name;
  }
}

TEST(WorkPrecision, PlainDecisionsAreWrongAtTheLastBit) {
  const PairFamily& f = family("on the bound, flat");
  EXPECT_GT(accuracy(f, method("two triangles")).wrong, f.pairs.size() / 20);
  EXPECT_GT(accuracy(f, method("two triangles", "float")).wrong, f.pairs.size() / 5);
}

TEST(WorkPrecision, AllMethodsAgreeOnFlatFacets) {
  const PairFamily& f = family("flat");
  for (const Method& m : methods()) {
    if (m.name.starts_with("Newton")) continue;  // trapezoids take it several steps
    const Accuracy a = accuracy(f, m);
    EXPECT_EQ(a.lost, 0U) << m.name;
    EXPECT_LT(a.largest, m.precision == "float" ? 1e-5 : 1e-13) << m.name << " " << m.precision;
  }
  EXPECT_LT(accuracy(f, method("Newton 6")).largest, 1e-13);
}

/// A square of side 1 whose corners lie in turn `lift` above and below its mean plane: the angle between the triangles
/// of a diagonal is `degrees`, and the diagonal between the raised corners lies `lift` above the centre of the patch.
geometry::Facet warped_square(double lift) {
  return {{Vector(0, 0, lift), Vector(1, 0, -lift), Vector(1, 1, lift), Vector(0, 1, -lift)}, false};
}
double lift_of(double degrees) { return std::tan(degrees * std::numbers::pi / 360) / (2 * std::numbers::sqrt2); }

TEST(WorkPrecision, TwoTrianglesAreOffByTheWarp) {
  for (const double degrees : {1.0, 5.0, 10.0, 20.0, 40.0}) {
    const double lift = lift_of(degrees);
    const geometry::Facet facet = warped_square(lift);
    const Vector normal = (facet.x[1] - facet.x[0]).cross(facet.x[2] - facet.x[0]).normalized();
    const Vector other = (facet.x[2] - facet.x[0]).cross(facet.x[3] - facet.x[0]).normalized();
    EXPECT_NEAR(std::acos(normal.dot(other)) * 180 / std::numbers::pi, degrees, 1e-9);
    const double side = (facet.x[1] - facet.x[0]).norm();
    PairFamily f;
    add_pair(f, facet, Vector(0.5, 0.5, 0.3), 0.3 - 0.5 * lift);
    EXPECT_FALSE(f.truth[0].closer);
    EXPECT_NEAR(static_cast<double>(f.truth[0].distance), 0.3, 1e-15);
    const Accuracy two = accuracy(f, method("two triangles"));
    EXPECT_NEAR(two.largest * side, lift, 1e-12) << degrees;
    EXPECT_EQ(two.wrong, 1U) << "half the error inside the distance";
    // The four meet the patch at its centre, but rise beside it, along the diagonals by lift to half a diagonal.
    const double slope = std::atan(std::numbers::sqrt2 * lift);
    EXPECT_NEAR(accuracy(f, method("four triangles")).largest * side, 0.3 * (1 - std::cos(slope)), 1e-12);
    EXPECT_LT(accuracy(f, method("Newton 1")).largest, 1e-15);
  }
}

/// Triangle and patch differ by lift · s (1 - t) along the mean normal, at most a quarter of the lift.
TEST(WorkPrecision, FourTrianglesAreOffByAQuarterOfThat) {
  const double lift = lift_of(5);
  const geometry::Facet facet = warped_square(lift);
  PairFamily f;
  for (int i = 0; i <= 40; ++i) {
    for (int j = 0; j <= 40; ++j) add_pair(f, facet, Vector(i / 40.0, j / 40.0, 0.1), 0.1);
  }
  const double side = (facet.x[1] - facet.x[0]).norm();
  EXPECT_NEAR(accuracy(f, method("four triangles")).largest * side, lift / 4, 0.05 * lift);
  EXPECT_NEAR(accuracy(f, method("two triangles")).largest * side, lift, 0.05 * lift);
  EXPECT_LT(accuracy(f, method("Newton 6")).largest, 1e-15);
}

TEST(WorkPrecision, DurationsAreMeasuredForAllMethods) {
  const std::vector<Duration> times = durations(family("flat"), methods(), 3);
  ASSERT_EQ(times.size(), methods().size());
  for (const Duration& d : times) EXPECT_TRUE(d.low > 0 && d.low <= d.median && d.median <= d.high);
}

}  // namespace
}  // namespace gapcheck::bench::work_precision_test
