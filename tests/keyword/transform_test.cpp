#include "keyword/transform.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "support.hpp"

namespace gapcheck::keyword::transform_test {
namespace {

/// What the *DEFINE_TRANSFORMATION rows make of an included file.
class Transforms : public testing::Test {
 protected:
  const Transform& with(const std::string& rows, const std::string& include_cards = "") {
    directory.write("part.k", "*NODE\n       1\n");
    const std::string cards = include_cards.empty() ? "\n\n\n         1\n" : include_cards;
    const auto main = directory.write("main.k", "*KEYWORD\n*INCLUDE_TRANSFORM\npart.k\n" + cards +
                                                    "*DEFINE_TRANSFORMATION\n         1\n" + rows + "*END\n");
    auto result = read_deck(main, {}, diagnostics);
    EXPECT_TRUE(result.ok());
    deck = std::move(result).value();
    for (const Block& block : deck.blocks())
      if (block.name == "NODE") return deck.transform(block.transform);
    ADD_FAILURE();
    return deck.transform(TransformIndex(0));
  }
  static void expect_near(const Vector& a, const Vector& b) { EXPECT_LT((a - b).norm(), 1e-12) << a.transpose(); }
  TemporaryDirectory directory;
  Diagnostics diagnostics;
  Deck deck;
};

TEST_F(Transforms, Translation) {
  expect_near(with("TRANSL           1.0       2.0       3.0\n").apply({1, 1, 1}), {2, 3, 4});
  EXPECT_EQ(reports(diagnostics), "");
}

TEST_F(Transforms, FreeFormatAndTitles) { expect_near(with("$ comment\ntransl,1,2,3\n").apply({1, 1, 1}), {2, 3, 4}); }

TEST_F(Transforms, RotationAboutAnAxisThroughAPoint) {
  expect_near(with("ROTATE,0,0,1,1,0,0,90\n").apply({2, 0, 5}), {1, 1, 5});
}

TEST_F(Transforms, RotationBetweenPoints) {
  expect_near(with("POINT,1,1,0,0\nPOINT,2,1,0,7\nROTATE,1,2,90\n").apply({2, 0, 5}), {1, 1, 5});
}

TEST_F(Transforms, RotationByNothing) {
  expect_near(with("ROTATE,0,0,1,0,0,0,0\n").apply({2, 0, 5}), {2, 0, 5});
  EXPECT_EQ(reports(diagnostics), "");
}

TEST_F(Transforms, ScaleMirrorMatrixAndPointsOfATranslation) {
  expect_near(with("SCALE,2,3,\n").apply({1, 1, 1}), {2, 3, 1});
  expect_near(with("MIRROR,1,0,0,2,0,0\n").apply({3, 4, 5}), {-1, 4, 5});
  expect_near(with("POINT,5,0,0,0\nPOINT,6,0,3,0\nTRANSL2ND,5,6,2\n").apply({1, 1, 1}), {1, 3, 1});
  expect_near(with("MATRIX\n0,1,0,5,1,0,0,6\n0,0,1,7,0,0,0,1\n").apply({1, 2, 3}), {7, 7, 10});
  EXPECT_EQ(reports(diagnostics), "");
}

TEST_F(Transforms, PositionBySixPoints) {
  const std::string points = "POINT,1,1,0,0\nPOINT,2,3,0,0\nPOINT,3,1,5,0\n";
  // Onto itself; then the x axis becomes z and the y axis stays.
  expect_near(with(points + "POS6P,1,2,3,1,2,3\n").apply({7, 8, 9}), {7, 8, 9});
  const std::string targets = "POINT,4,0,0,10\nPOINT,5,0,0,11\nPOINT,6,0,1,12\n";
  expect_near(with(points + targets + "POS6P,1,2,3,4,5,6\n").apply({1, 0, 0}), {0, 0, 10});
  expect_near(with(points + targets + "POS6P,1,2,3,4,5,6\n").apply({3, 4, 0}), {0, 4, 12});
  expect_near(with(points + targets + "POS6P,1,2,3,4,5,6\n").apply({1, 0, 2}), {-2, 0, 10});
  EXPECT_EQ(reports(diagnostics), "");
  with(points + "POS6P,1,2,3,1,2,2\n");
  with(points + "POS6P,1,2,3,1,2,9\n");
  const std::string all = reports(diagnostics);
  EXPECT_EQ(count_errors(diagnostics), 2u) << all;
  EXPECT_NE(all.find("three points of POS6P lie in one line"), std::string::npos) << all;
  EXPECT_NE(all.find("POS6P refers to 9"), std::string::npos) << all;
  EXPECT_NE(all.find("what it places stays where its file says"), std::string::npos) << all;
}

TEST_F(Transforms, RowsActFromTheFirstToTheLast) {
  expect_near(with("ROTATE,0,0,1,0,0,0,90\nTRANSL,10,0,0\n").apply({1, 0, 0}), {10, 1, 0});
  expect_near(with("TRANSL,10,0,0\nROTATE,0,0,1,0,0,0,90\n").apply({1, 0, 0}), {0, 11, 0});
  expect_near(with("SCALE,2,1,1\nROTATE,0,0,1,0,0,0,90\n").apply({1, 0, 0}), {0, 2, 0});
  expect_near(with("ROTATE,0,0,1,0,0,0,90\nSCALE,2,1,1\n").apply({1, 0, 0}), {0, 1, 0});
}

TEST_F(Transforms, OffsetsAndFactors) {
  const Transform& t = with("TRANSL,1,0,0\n",
                            "       100       200       300       400       500       600       700\n       800\n"
                            "                          25.4\n         1\n");
  const std::vector<std::int64_t> expected{0, 100, 200, 300, 400, 500, 600, 700, 800};
  EXPECT_EQ(std::vector<std::int64_t>(t.offset.begin(), t.offset.end()), expected);
  EXPECT_EQ(t.length_factor, 25.4);
  EXPECT_EQ(t.mass_factor, 1);
}

TEST_F(Transforms, FaultsAreReported) {
  with("ROTATE,11,12,90\n");
  with("POS6N,1,2,3,4,5,6\n");
  with("MATRIX\n1,0,0,0,0,1,0,0\n");
  with("ROTATE,0,0,0,1,1,1,90\n");
  with(
      "TRANSL,1e30,0,0\nSCALE,1e30\nSCALE,1e30\nSCALE,1e30\nSCALE,1e30\nSCALE,1e30\nSCALE,1e30\nSCALE,1e30\nSCALE,"
      "1e30\nSCALE,1e30\nSCALE,1e30\n");
  with("", "\n\n\n        99\n");
  const std::string all = reports(diagnostics);
  EXPECT_EQ(count_errors(diagnostics), 6u) << all;
  for (const char* part : {"refers to 11", "POS6N is not supported", "behind MATRIX are missing", "has no length",
                           "no finite values", "transformation 99"})
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
}

/// Nested includes against moving a point step by step.
TEST_F(Transforms, NestedOnesCompose) {
  directory.write("leaf.k", "*NODE\n       1\n");
  directory.write("inner.k",
                  "*INCLUDE_TRANSFORM\nleaf.k\n        10        20\n\n                           3.0\n         2\n");
  const auto main = directory.write(
      "main.k",
      "*INCLUDE_TRANSFORM\ninner.k\n       100       200\n\n                           2.0\n         1\n"
      "*DEFINE_TRANSFORMATION\n         1\nROTATE,0,0,1,0,0,0,30\nTRANSL,1,2,3\n"
      "*DEFINE_TRANSFORMATION_TITLE\na title, with comma\n         2\nMIRROR,0,0,1,0,1,1\nTRANSL,-4,5,6\n");
  auto result = read_deck(main, {}, diagnostics);
  ASSERT_TRUE(result.ok());
  const Deck& nested = result.value();
  EXPECT_EQ(reports(diagnostics), "");
  const Block* leaf = nullptr;
  for (const Block& block : nested.blocks())
    if (block.name == "NODE") leaf = &block;
  ASSERT_NE(leaf, nullptr);
  const Transform& t = nested.transform(leaf->transform);
  EXPECT_EQ(t.offset[static_cast<std::size_t>(IdKind::node)], 110);
  EXPECT_EQ(t.offset[static_cast<std::size_t>(IdKind::element)], 220);
  const double c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
  for (const Vector& x : {Vector(0, 0, 0), Vector(1, 2, 3), Vector(-7, 0.5, 2)}) {
    const Vector scaled = 3 * x;
    const Vector inner(scaled.x() - 4, -scaled.y() + 5, scaled.z() + 6);
    const Vector outer = 2 * inner;
    const Vector moved(c * outer.x() - s * outer.y() + 1, s * outer.x() + c * outer.y() + 2, outer.z() + 3);
    expect_near(t.apply(t.length_factor * x), moved);
  }
}

}  // namespace
}  // namespace gapcheck::keyword::transform_test
