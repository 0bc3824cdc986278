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
                                                    "*DEFINE_TRANSFORMATION\n         1\n" + rows + nodes + "*END\n");
    auto result = read_deck(main, {}, into == nullptr ? diagnostics : *into);
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
  std::string nodes;            ///< of the main file
  Diagnostics* into = nullptr;  ///< in place of `diagnostics`
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
  EXPECT_NE(all.find("POS6P refers to point 9"), std::string::npos) << all;
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
  with("SHEAR,1,2,3,4,5,6\n");
  with("MATRIX\n1,0,0,0,0,1,0,0\n");
  with("ROTATE,0,0,0,1,1,1,90\n");
  with(
      "TRANSL,1e30,0,0\nSCALE,1e30\nSCALE,1e30\nSCALE,1e30\nSCALE,1e30\nSCALE,1e30\nSCALE,1e30\nSCALE,1e30\nSCALE,"
      "1e30\nSCALE,1e30\nSCALE,1e30\n");
  with("", "\n\n\n        99\n");
  const std::string all = reports(diagnostics);
  EXPECT_EQ(count_errors(diagnostics), 6u) << all;
  for (const char* part : {"refers to point 11", "ROTATE3NA takes nodes", "behind MATRIX are missing", "has no length",
                           "no finite values", "transformation 99", "the option SHEAR is not supported"})
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
}

/// Points go along with the rows before the reference, wherever their own rows are; nodes stay.
TEST_F(Transforms, PointsMoveWithTheRowsBeforeTheReference) {
  // An axis along z through (1, 0, 0) that TRANSL takes to (11, 0, 0).
  const Vector turned(11, 1, 5);
  for (const char* rows :
       {"POINT,1,1,0,0\nPOINT,2,1,0,7\nTRANSL,10,0,0\nROTATE,1,2,90\n",
        "TRANSL,10,0,0\nPOINT,1,1,0,0\nPOINT,2,1,0,7\nROTATE,1,2,90\n", "TRANSL,10,0,0\nROTATE,0,0,1,11,0,0,90\n"})
    expect_near(with(rows).apply({2, 0, 5}), turned);
  // The first turn takes the axis of the second one from z to -y.
  expect_near(with("POINT,1,0,0,0\nPOINT,2,0,0,1\nROTATE,1,0,0,0,0,0,90\nROTATE,1,2,90\n").apply({1, 0, 0}), {0, 0, 1});
  EXPECT_EQ(reports(diagnostics), "");
  // POS6P does nothing to what lies on its targets already, where rows before it have moved both alike.
  const std::string points = "POINT,1,1,0,0\nPOINT,2,3,0,0\nPOINT,3,1,5,0\n";
  expect_near(with(points + "TRANSL,0,0,4\nPOS6P,1,2,3,1,2,3\n").apply({7, 8, 9}), {7, 8, 13});
  EXPECT_NE(reports(diagnostics).find("POS6P has rows before it, which move its six points too"), std::string::npos);
}

TEST_F(Transforms, RowsThatReferToNodes) {
  nodes = "*NODE\n11,1.,0.,0.\n12,1.,0.,7.\n13,3.,0.,2.\n14,0.,3.,0.\n15,0.,0.,0.\n";
  expect_near(with("ROTATE3NA,11,12,11,90\n").apply({2, 0, 5}), {1, 1, 5});
  // The axis along the first two nodes goes through the third.
  expect_near(with("ROTATE3NA,11,12,13,90\n").apply({4, 0, 5}), {3, 1, 5});
  expect_near(with("TRANSL2ND,15,14,2\n").apply({1, 1, 1}), {1, 3, 1});
  expect_near(with("TRANSL2ND,15,14,-2\n").apply({1, 1, 1}), {1, -1, 1});
  // Rows before the reference do not move nodes.
  expect_near(with("TRANSL,10,0,0\nROTATE3NA,11,12,11,90\n").apply({1, 0, 0}), {1, 10, 0});
  EXPECT_EQ(reports(diagnostics), "");
  expect_near(with("TRANSL2ND,15,14\n").apply({1, 1, 1}), {1, 4, 1});
  EXPECT_NE(reports(diagnostics).find("TRANSL2ND without a distance"), std::string::npos);
}

/// The same as by six points; a quarter turn takes a known point to a known place.
TEST_F(Transforms, PositionBySixNodes) {
  nodes = "*NODE\n1001,1.,0.,0.\n1002,3.,0.,0.\n1003,1.,5.,0.\n1004,0.,0.,10.\n1005,0.,0.,11.\n1006,0.,1.,12.\n";
  expect_near(with("POS6N,1001,1002,1003,1001,1002,1003\n").apply({7, 8, 9}), {7, 8, 9});
  expect_near(with("POS6N,1001,1002,1003,1004,1005,1006\n").apply({1, 0, 0}), {0, 0, 10});
  expect_near(with("POS6N,1001,1002,1003,1004,1005,1006\n").apply({3, 4, 0}), {0, 4, 12});
  expect_near(with("POS6N,1001,1002,1003,1004,1005,1006\n").apply({1, 0, 2}), {-2, 0, 10});
  EXPECT_EQ(reports(diagnostics), "");
}

TEST_F(Transforms, NodesOfOtherIncludes) {
  // The included file of the nodes is scaled, turned and numbered from 500 on before the other one refers to them.
  directory.write("frame.k", "*NODE\n1,1.,0.,0.\n2,1.,0.,2.\n");
  directory.write("part.k", "*NODE\n       9\n");
  const auto main = directory.write(
      "main.k",
      "*INCLUDE_TRANSFORM\nframe.k\n       500\n\n                           2.0\n         2\n"
      "*INCLUDE_TRANSFORM\npart.k\n\n\n\n         1\n"
      "*DEFINE_TRANSFORM_TITLE\nits other name\n         1\nTRANSL2ND,501,502,3\nROTATE3NA,501,502,501,90\n"
      "*DEFINE_TRANSFORMATION\n         2\nROTATE,0,1,0,0,0,0,90\n");
  auto result = read_deck(main, {}, diagnostics);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(reports(diagnostics), "");
  // The nodes lie at (0, 0, -2) and (4, 0, -2): 3 along x, and a quarter turn about this line.
  for (const Block& block : result.value().blocks())
    if (block.name == "NODE" && result.value().file(block.file).path.ends_with("part.k"))
      expect_near(result.value().transform(block.transform).apply({1, 1, -2}), {4, 0, -1});
}

/// In a file that is itself placed, nodes are where they lie in this file's own coordinates.
TEST_F(Transforms, NodesOfNestedIncludes) {
  directory.write("leaf.k", "*NODE\n       9\n");
  directory.write("inner.k",
                  "*NODE\n1,1.,0.,0.\n2,1.,0.,4.\n*INCLUDE_TRANSFORM\nleaf.k\n\n\n\n        12\n"
                  "*DEFINE_TRANSFORMATION\n        12\nROTATE3NA,1,2,1,90\n");
  const auto read = [&](const std::string& inner_nodes) {
    const auto main = directory.write(
        "main.k",
        "*NODE\n91,2.,3.,0.\n92,2.,3.,8.\n*INCLUDE_TRANSFORM\ninner.k\n       100\n\n"
        "                           2.0\n         1\n*DEFINE_TRANSFORMATION\n         1\nTRANSL,0,3,0\n" +
            inner_nodes);
    return read_deck(main, {}, diagnostics);
  };
  const auto leaf_at = [&](const Deck& of, const Vector& x) {
    for (const Block& block : of.blocks())
      if (block.name == "NODE" && of.file(block.file).path.ends_with("leaf.k")) {
        const Transform& t = of.transform(block.transform);
        return t.apply(t.length_factor * x);
      }
    return Vector(0, 0, 0);
  };
  // (2, 0, 5) turns to (1, 1, 5) in the inner file; the main file doubles that and moves it by 3.
  const auto own = read("");
  ASSERT_TRUE(own.ok());
  EXPECT_EQ(reports(diagnostics), "");
  expect_near(leaf_at(own.value(), {2, 0, 5}), {2, 5, 10});
  // The main file's nodes 91 and 92 lie on the same axis, in the coordinates of the inner file.
  directory.write("inner.k",
                  "*INCLUDE_TRANSFORM\nleaf.k\n\n\n\n        12\n"
                  "*DEFINE_TRANSFORMATION\n        12\nROTATE3NA,-9,-8,-9,90\n");
  const auto outer = read("");
  ASSERT_TRUE(outer.ok());
  EXPECT_EQ(reports(diagnostics), "");
  expect_near(leaf_at(outer.value(), {2, 0, 5}), {2, 5, 10});
}

TEST_F(Transforms, HostileRows) {
  nodes = "*NODE\n11,0.,0.,0.\n12,.1,.2,.3\n13,.3,.6,.9\n14,0.,1.,0.\n15,0.,0.,1.\n16,abc,0.,0.\n";
  const std::vector<std::pair<std::string, std::string>> rows{
      {"POS6N,11,12,13,11,14,15", "three nodes of POS6N lie in one line"},
      {"POS6N,11,14,15,11,12,13", "three nodes of POS6N lie in one line"},
      {"POS6N,11,14,15,11,14", "POS6N needs the ids of 6 nodes"},
      {"POS6N,11,14,15,11,14,99", "POS6N: node 99 is not defined"},
      {"POS6N,11,14,15,11,14,15\nPOS6N,11,14,15,11,14,15", "it has a second row POS6N"},
      {"POS6N,1,14,15,11,14,15", "which is placed by this transformation or included after it"},
      {"ROTATE3NA,11,11,12,90", "the axis of ROTATE3NA has no length"},
      {"ROTATE3NA,11,12,99,90", "ROTATE3NA: node 99 is not defined"},
      {"ROTATE3NA,11,16,11,90", "the axis of ROTATE3NA has no length"},
      {"TRANSL2ND,11,11,1", "the two nodes of TRANSL2ND lie at one place"},
      {"TRANSL2ND,1e30,11,1", "TRANSL2ND needs the ids of 2 nodes"},
      {"TRANSL2ND,-11,11.5,1", "TRANSL2ND needs the ids of 2 nodes"},
      {"TRANSL2ND,9e14,11,1", "TRANSL2ND: node 900000000000000 is not defined"},
      {"TRANSL2ND,nan,11,1", "TRANSL2ND needs the ids of 2 nodes"},
      {"POINT,1e29,0,0,0\nROTATE,2,3,90", "ROTATE refers to point 2"},
      {"POINT,1,0,0,0\nPOINT,2,.1,.2,.3\nPOINT,3,.3,.6,.9\nPOS6P,1,2,3,1,2,3",
       "three points of POS6P lie in one line"}};
  for (const auto& [row, words] : rows) {
    Diagnostics own;
    into = &own;
    expect_near(with(row + "\n").apply({1, 2, 3}), {1, 2, 3});
    const std::string said = reports(own);
    EXPECT_GE(count_errors(own), 1u) << row;
    EXPECT_NE(said.find(words), std::string::npos) << row << "\n" << said;
  }
  // Two points in place of two nodes are clear enough.
  into = nullptr;
  expect_near(with("POINT,5,0,0,0\nPOINT,6,0,3,0\nTRANSL2ND,5,6,2\n").apply({1, 1, 1}), {1, 3, 1});
  EXPECT_NE(reports(diagnostics).find("TRANSL2ND takes nodes"), std::string::npos);
  EXPECT_EQ(count_errors(diagnostics), 0u);
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
