#include "solver/build/material/material_curve.hpp"

#include <gtest/gtest.h>

#include "model/read.hpp"

namespace gapcheck::solver::material_curve_test {
namespace {

std::vector<std::array<double, 2>> points_of(const std::string& deck) {
  const model::Read read = model::read_text(deck);
  EXPECT_EQ(read.errors(), 0u) << read.text();
  return material_points(read.model, read.model.curves.at(7));
}

// 100 points over the range: a kink at 0.002 of a curve up to 10 is cut off by the chord to the second point.
TEST(MaterialCurve, HundredPointsOfEqualDistance) {
  const auto points = points_of("*DEFINE_CURVE\n7\n0.,250.\n0.002,300.\n10.,600.\n");
  ASSERT_EQ(points.size(), 100u);
  const double spacing = 10.0 / 99, second = 300 + 300 * (spacing - 0.002) / (10 - 0.002);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_NEAR(points[i][0], spacing * static_cast<double>(i), 1e-14);
  EXPECT_EQ(points[0][1], 250);
  EXPECT_NEAR(points[1][1], second, 1e-12);
  EXPECT_EQ(points[99], (std::array<double, 2>{10, 600}));
}

TEST(MaterialCurve, NumbersOfPoints) {
  const std::string curve = "\n0.,1.\n1.,4.\n3.,5.\n", more = "*CONTROL_SOLUTION\n0,0,0,250\n";
  EXPECT_EQ(points_of("*DEFINE_CURVE\n7,0,0.,0.,0.,0.,0,150" + curve).size(), 150u);
  EXPECT_EQ(points_of(more + "*DEFINE_CURVE\n7" + curve).size(), 250u);
  EXPECT_EQ(points_of(more + "*DEFINE_CURVE\n7,0,0.,0.,0.,0.,0,150" + curve).size(), 150u);
  for (const std::string few : {"-7", "7"})
    EXPECT_EQ(points_of("*DEFINE_CURVE\n7,0,0.,0.,0.,0.,0," + few + curve).size(), 100u);
  EXPECT_EQ(points_of("*DEFINE_CURVE\n7,0,0.,0.,0.,0.,0,2000000000" + curve).size(), 100000u);
}

// A line needs no more points; what is no function of the abscissa stays for others to refuse.
TEST(MaterialCurve, WhatStaysAsItIs) {
  EXPECT_EQ(points_of("*DEFINE_CURVE\n7\n0.,1.\n2.,3.\n"), (std::vector<std::array<double, 2>>{{0, 1}, {2, 3}}));
  EXPECT_EQ(points_of("*DEFINE_CURVE\n7\n0.,1.\n2.,3.\n2.,4.\n").size(), 3u);
  EXPECT_EQ(points_of("*DEFINE_CURVE\n7\n0.,1.\n").size(), 1u);
  EXPECT_EQ(points_of("*DEFINE_CURVE\n7\n").size(), 0u);
}

}  // namespace
}  // namespace gapcheck::solver::material_curve_test
