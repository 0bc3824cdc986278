#include "model/entity/curve.hpp"

#include "model/read.hpp"

namespace gapcheck::model::curve_test {
namespace {

TEST(Curves, OffsetsAndScales) {
  const Read read = read_text(
      "*DEFINE_CURVE_TITLE\na title\n         7         0       2.0       3.0       1.0      -1.0\n"
      "                 0.0                 5.0\n                 4.0                 9.0\n"
      "*DEFINE_CURVE\n8\n0.,1.\n1.,2.\n\n*DEFINE_CURVE_FUNCTION\n9\nsin(time)\n");
  EXPECT_EQ(read.text(), "");
  ASSERT_EQ(read.model.curves.size(), 2u);
  EXPECT_EQ(read.model.curves.at(7).points,
            (std::vector<std::array<double, 2>>{{0, 0}, {0.999 * 2, 0}, {2, 12}, {10, 24}}));
  EXPECT_EQ(read.model.curves.at(8).points, (std::vector<std::array<double, 2>>{{0, 1}, {1, 2}}));
  EXPECT_EQ(read.model.curves.at(7).place.line, 3u);
}

// Zero before the offset of a curve over time; general data (DATTYP 1) and curves that begin earlier only move.
TEST(Curves, OffsetOfTimes) {
  using Points = std::vector<std::array<double, 2>>;
  const auto points = [](const std::string& fields, const std::string& first) {
    return read_text("*DEFINE_CURVE\n7,0,1.,1.," + fields + "\n" + first + ",5.\n4.,9.\n").model.curves.at(7).points;
  };
  EXPECT_EQ(points("2.", "0."), (Points{{0, 0}, {0.999 * 2, 0}, {2, 5}, {6, 9}}));
  EXPECT_EQ(points("2.,0.,1", "0."), (Points{{2, 5}, {6, 9}}));
  EXPECT_EQ(points("-2.", "0."), (Points{{-2, 5}, {2, 9}}));
  EXPECT_EQ(points("2.", "-1."), (Points{{1, 5}, {6, 9}}));
}

// Half a cosine up, level, half a cosine down: the area is DIST, from TEND or from VMAX.
TEST(Curves, Smooth) {
  const auto area = [](const Curve& curve) {
    double sum = 0;
    for (std::size_t i = 1; i < curve.points.size(); ++i)
      sum += (curve.points[i][0] - curve.points[i - 1][0]) * (curve.points[i][1] + curve.points[i - 1][1]) / 2;
    return sum;
  };
  const Read read = read_text("*DEFINE_CURVE_SMOOTH\n7,0,12.,1.,5.,0.5\n*DEFINE_CURVE_SMOOTH\n8,0,12.,1.,,0.5,6.\n");
  EXPECT_EQ(read.text(), "");
  const Curve &by_end = read.model.curves.at(7), &by_height = read.model.curves.at(8);
  EXPECT_NEAR(area(by_end), 12, 1e-12);
  EXPECT_NEAR(by_end.at(3), 12 / 3.5, 1e-12);
  EXPECT_NEAR(by_end.at(1.25), 6 / 3.5, 1e-12);
  EXPECT_EQ(by_end.points.back(), (std::array<double, 2>{5, 0}));
  EXPECT_NEAR(area(by_height), 12, 1e-12);
  EXPECT_NEAR(by_height.points.back()[0], 1 + 0.5 + 2, 1e-12);
  EXPECT_EQ(read_text("*DEFINE_CURVE_SMOOTH\n7,0,12.,1.,1.5,0.5\n*DEFINE_CURVE_SMOOTH\n8,0,12.\n").errors(), 2u);
}

TEST(Curves, FaultsAreTold) {
  const Read read = read_text("*DEFINE_CURVE\n7\n0.,1.\n*DEFINE_CURVE\n7\n0.,2.\n*DEFINE_CURVE\n-3\n*DEFINE_CURVE\n");
  EXPECT_EQ(read.faults(Fault::Kind::duplicate_id), 1u) << read.text();
  EXPECT_EQ(read.errors(), 2u) << read.text();
  EXPECT_EQ(read.model.curves.at(7).points[0][1], 1);
}

TEST(Tables, WithTheCurvesThatFollowOrTheirNames) {
  const Read read = read_text(
      "*DEFINE_TABLE_TITLE\nrates\n5,2.,1.\n0.\n                "
      "10.0\n*DEFINE_CURVE\n7\n0.,1.\n*DEFINE_CURVE\n8\n0.,2.\n"
      "*DEFINE_CURVE\n9\n0.,3.\n*DEFINE_TABLE_2D\n6\n                 1.0                 8\n100.,7\n");
  EXPECT_EQ(read.text(), "");
  ASSERT_EQ(read.model.tables.size(), 2u);
  const auto& first = read.model.tables.at(5).rows;
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0].value, 2);
  EXPECT_EQ(first[1].value, 22);
  EXPECT_EQ(first[0].curve, 7);
  EXPECT_EQ(first[1].curve, 8);
  const auto& second = read.model.tables.at(6).rows;
  ASSERT_EQ(second.size(), 2u);
  EXPECT_EQ(second[0].value, 1);
  EXPECT_EQ(second[0].curve, 8);
  EXPECT_EQ(second[1].curve, 7);
}

TEST(Tables, FaultsAreTold) {
  const Read read = read_text(
      "*DEFINE_TABLE\n*DEFINE_TABLE\n-5\n1.\n*DEFINE_TABLE\n5\n1.\n2.\n*DEFINE_TABLE\n5\n3.\n*DEFINE_CURVE\n4\n0.,1."
      "\n");
  EXPECT_EQ(read.errors(), 2u) << read.text();
  EXPECT_EQ(read.faults(Fault::Kind::duplicate_id), 1u);
  EXPECT_EQ(read.model.tables.at(5).rows[1].curve, 0);  // no curve came before the next table
}

}  // namespace
}  // namespace gapcheck::model::curve_test
