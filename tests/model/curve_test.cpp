#include "model/curve.hpp"

#include "read.hpp"

namespace gapcheck::model {
namespace {

TEST(Curves, OffsetsAndScales) {
  const Read read = read_text(
      "*DEFINE_CURVE_TITLE\na title\n         7         0       2.0       3.0       1.0      -1.0\n"
      "                 0.0                 5.0\n                 4.0                 9.0\n"
      "*DEFINE_CURVE\n8\n0.,1.\n1.,2.\n\n*DEFINE_CURVE_FUNCTION\n9\nsin(time)\n");
  EXPECT_EQ(read.text(), "");
  ASSERT_EQ(read.model.curves.size(), 2u);
  EXPECT_EQ(read.model.curves.at(7).points, (std::vector<std::array<double, 2>>{{2, 12}, {10, 24}}));
  EXPECT_EQ(read.model.curves.at(8).points, (std::vector<std::array<double, 2>>{{0, 1}, {1, 2}}));
  EXPECT_EQ(read.model.curves.at(7).place.line, 3u);
}

TEST(Curves, FaultsAreTold) {
  const Read read = read_text("*DEFINE_CURVE\n7\n0.,1.\n*DEFINE_CURVE\n7\n0.,2.\n*DEFINE_CURVE\n-3\n*DEFINE_CURVE\n");
  EXPECT_EQ(read.faults(Fault::Kind::duplicate_id), 1u) << read.text();
  EXPECT_EQ(read.errors(), 2u) << read.text();
  EXPECT_EQ(read.model.curves.at(7).points[0][1], 1);
}

}  // namespace
}  // namespace gapcheck::model
