#include "model/entity/interpolation.hpp"

#include "model/read.hpp"

namespace gapcheck::model::interpolation_test {
namespace {

TEST(Interpolation, NodesAndWeights) {
  const Read read = read_text(nodes_text(5) +
                              "*CONSTRAINED_INTERPOLATION\n"
                              "         7         5       123                   0         2         1\n"
                              "         1       123       2.0\n"
                              "         2\n"
                              "         3        12       0.5       0.0       4.0\n");
  ASSERT_EQ(read.model.interpolations.size(), 1u) << read.text();
  EXPECT_EQ(read.text(), "");
  const Interpolation& one = read.model.interpolations[0];
  EXPECT_EQ(one.keyword, "CONSTRAINED_INTERPOLATION");
  EXPECT_EQ(one.id, 7);
  EXPECT_EQ(one.dependent, 5);
  EXPECT_EQ(one.freedoms, 123);
  EXPECT_EQ(one.by_set, 0);
  EXPECT_EQ(one.deletion, 2);
  EXPECT_EQ(one.place.line, 8u);
  ASSERT_EQ(one.independents.size(), 3u);
  EXPECT_EQ(one.independents[0].nodes.id, 1);
  EXPECT_FALSE(one.independents[0].nodes.set);
  EXPECT_EQ(one.independents[0].freedoms, 123);
  EXPECT_EQ(one.independents[0].weights, (std::array<double, 6>{2, 2, 2, 2, 2, 2}));
  EXPECT_EQ(one.independents[1].freedoms, 123456);
  EXPECT_EQ(one.independents[1].weights, (std::array<double, 6>{1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(one.independents[2].weights, (std::array<double, 6>{0.5, 0.5, 4, 0.5, 0.5, 0.5}));
  EXPECT_EQ(one.independents[2].place.line, 11u);
  EXPECT_EQ(read.model.file(one.independents[2].place), "a.k");
}

TEST(Interpolation, SetsAndLocalAxes) {
  const Read read = read_text(nodes_text(5) +
                              "*CONSTRAINED_INTERPOLATION\n7,5,,4,1\n11,123\n*CONSTRAINED_INTERPOLATION_LOCAL\n"
                              "8,5,,4,0\n1,123\n4\n2,123\n\n*DEFINE_COORDINATE_VECTOR\n4,1.,0.,0.,0.,1.,0.\n");
  ASSERT_EQ(read.model.interpolations.size(), 2u) << read.text();
  const Interpolation& sets = read.model.interpolations[0];
  EXPECT_EQ(sets.freedoms, 123456);
  EXPECT_EQ(sets.deletion, 1);
  EXPECT_EQ(sets.system, 0) << "CIDD belongs to _LOCAL";
  ASSERT_EQ(sets.independents.size(), 1u);
  EXPECT_TRUE(sets.independents[0].nodes.set);
  const Interpolation& local = read.model.interpolations[1];
  EXPECT_EQ(local.system, 4);
  ASSERT_EQ(local.independents.size(), 2u);
  EXPECT_EQ(local.independents[0].system, 4);
  EXPECT_EQ(local.independents[1].nodes.id, 2);
  EXPECT_EQ(local.independents[1].system, 0);
}

TEST(Interpolation, ShortAndBrokenCards) {
  EXPECT_TRUE(read_text(nodes_text(2) + "*CONSTRAINED_INTERPOLATION\n").model.interpolations.empty());
  const Read cut = read_text(nodes_text(2) + "*CONSTRAINED_INTERPOLATION_LOCAL\n3,1,x\n2,123\n");
  ASSERT_EQ(cut.model.interpolations.size(), 1u);
  EXPECT_EQ(cut.errors(), 1u) << cut.text();
  EXPECT_EQ(cut.model.interpolations[0].independents.size(), 1u);
}

}  // namespace
}  // namespace gapcheck::model::interpolation_test
