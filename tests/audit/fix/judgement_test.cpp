#include "audit/fix/judgement.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "contact/scene.hpp"

namespace gapcheck::audit::judgement_test {
namespace {

Judgement judged(std::uint64_t penetrating, double depth) {
  Judgement result;
  result.penetrating = penetrating;
  result.depth = depth;
  return result;
}

TEST(Judgement, FewerNodesAreBetterThanLessDepth) {
  BestMove best{{}, {}, judged(3, 1.0)};
  EXPECT_FALSE(best.take({Vector::UnitX()}, {}, judged(4, 0.1), 0));
  EXPECT_FALSE(best.take({Vector::UnitX()}, {}, judged(3, 1.1), 0));
  EXPECT_TRUE(best.target.empty());
  EXPECT_TRUE(best.take({Vector::UnitX()}, {Vector::UnitY()}, judged(2, 5.0), 7));
  EXPECT_EQ(best.target.at(0), Vector::UnitX());
  EXPECT_EQ(best.written.at(0), Vector::UnitY());
  EXPECT_TRUE(best.take({}, {}, judged(2, 4.0), 9));
}

TEST(Judgement, EquallyGoodIsTakenIfLessMovesButIsNoProgress) {
  BestMove best{{}, {}, judged(2, 1.0)};
  best.movement = 5;
  EXPECT_FALSE(best.take({Vector::UnitZ()}, {}, judged(2, 1.0), 6));
  EXPECT_TRUE(best.target.empty());
  EXPECT_FALSE(best.take({Vector::UnitZ()}, {}, judged(2, 1.0), 4));
  EXPECT_EQ(best.target.size(), 1U);
  EXPECT_EQ(best.movement, 4);
}

TEST(Judgement, FewerCrossingsAreBetterThanFewerNodes) {
  BestMove best{{}, {}, judged(2, 1.0)};
  best.judgement.crossings = 3;
  Judgement more = judged(0, 0);
  more.crossings = 4;
  EXPECT_FALSE(best.take({}, {}, std::move(more), 0));
  Judgement fewer = judged(9, 9.0);
  fewer.crossings = 2;
  EXPECT_TRUE(best.take({Vector::UnitZ()}, {}, std::move(fewer), 100));
  EXPECT_EQ(best.judgement.penetrating, 9U);
}

TEST(Judgement, CountsWhatACorrectionHasToFree) {
  contact::Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, 2, 2);
  scene.plate(scene.part(2, 1), {3, 4, 0.7}, {10, 0, 0}, {0, 10, 0}, 2, 2);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  ContactJudge judge(scene.model);
  std::vector<Vector> x = scene.model.mesh.nodes.x;
  const Judgement now = judge.at(x);
  EXPECT_EQ(now.penetrating, 8U);
  EXPECT_NEAR(now.depth, 8 * 0.3, 1e-12);
  EXPECT_GE(now.work, x.size());
  // Nodes stay where they are put.
  EXPECT_EQ(now.state.x, x);
  for (std::size_t i = 9; i < x.size(); ++i) x[i].z() = 1;
  EXPECT_EQ(judge.at(x).penetrating, 0U);
  EXPECT_EQ(scene.model.mesh.nodes.x, x);
}

}  // namespace
}  // namespace gapcheck::audit::judgement_test
