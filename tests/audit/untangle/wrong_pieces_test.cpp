#include "audit/untangle/wrong_pieces.hpp"

#include "audit/untangle/facing.hpp"
#include "audit/untangle/surfaces.hpp"

namespace gapcheck::audit_test::wrong_pieces_test {
namespace {

constexpr double far = 1e9;

struct Found {
  ContactScene scene;
  std::vector<audit::WrongPiece> pieces;
  explicit Found(const std::string& text, double reach = far, std::uint64_t work = 1'000'000) : scene(text) {
    const auto contours = audit::find_contours(scene.model->mesh, scene.crossings());
    EXPECT_EQ(contours.size(), 1u);
    if (contours.size() != 1) return;
    pieces = audit::find_wrong_pieces(contours[0], scene.model->mesh, *scene.surface, *scene.surface, reach, work);
  }
};

const Plate ground{.id = 1, .nx = 8, .ny = 6};

TEST(WrongPieces, TheLowerEndOfAnUprightPlate) {
  // Nodes at z = -2, 3, 8: the first row is below the ground.
  Found found(upright_deck(ground, 17.0, 6.0, -2.0, 3, 2));
  ASSERT_EQ(found.pieces.size(), 1u);
  const audit::WrongPiece& piece = found.pieces[0];
  EXPECT_EQ(found.scene.ids(piece.nodes), (std::vector<std::int64_t>{2001, 2002, 2003, 2004}));
  EXPECT_EQ(found.scene.ids(piece.rim), (std::vector<std::int64_t>{2005, 2006, 2007, 2008}));
  for (const audit::FaceSide& face : piece.faces) EXPECT_EQ(face.side, 1);  // above the ground, whose normals are up
  std::uint64_t work = 1'000'000;
  const auto facing = audit::face_piece(piece, *found.scene.surface, work);
  ASSERT_TRUE(facing);
  ASSERT_EQ(facing->size(), 8u);
  for (const audit::Facing& f : *facing) {
    EXPECT_DOUBLE_EQ(f.depth, f.wrong ? 2 : 3);
    EXPECT_EQ(f.face.side, 1);
  }
}

TEST(WrongPieces, TheUpperEndIfItIsTheSmaller) {
  // z = -12, -7, -2, 3: three rows below, one above.
  Found found(upright_deck(ground, 17.0, 6.0, -12.0, 3, 3));
  ASSERT_EQ(found.pieces.size(), 1u);
  EXPECT_EQ(found.scene.ids(found.pieces[0].nodes), (std::vector<std::int64_t>{2013, 2014, 2015, 2016}));
  for (const audit::FaceSide& face : found.pieces[0].faces) EXPECT_EQ(face.side, -1);
}

TEST(WrongPieces, MeshLinesInTheOtherPlaneAreNoTrouble) {
  // A row of nodes exactly in the ground, which is on its own mesh line, too.
  Found found(upright_deck(ground, 15.0, 5.0, -5.0, 3, 3));
  ASSERT_EQ(found.pieces.size(), 1u);
  const auto nodes = found.scene.ids(found.pieces[0].nodes);
  EXPECT_TRUE(nodes == (std::vector<std::int64_t>{2001, 2002, 2003, 2004}) || nodes.size() == 8u) << nodes.size();
}

TEST(WrongPieces, HookedPlatesAreFoundAboveEachOther) {
  // The upright plate sticks out beyond the ground: its line of crossing ends inside it, and inside the ground.
  const std::string text = upright_deck(ground, 17.0, 21.0, -2.0, 3, 2);
  Found found(text);
  ASSERT_EQ(found.pieces.size(), 1u);
  // Only what is above or below the ground (y <= 30) counts.
  EXPECT_EQ(found.scene.ids(found.pieces[0].nodes), (std::vector<std::int64_t>{2001, 2002}));
  EXPECT_TRUE(Found(text, 1.0).pieces.empty() || Found(text, 1.0).pieces[0].nodes.size() == 2u);
}

TEST(WrongPieces, NothingWhenTheWorkIsDone) {
  EXPECT_TRUE(Found(upright_deck(ground, 17.0, 6.0, -2.0, 3, 2), far, 3).pieces.empty());
}

TEST(WrongPieces, WhatIsInASolidIsWrong) {
  // A block from z = -10 to 0 in place of the ground; most of the plate is inside it.
  std::string nodes = "*NODE\n", elements = "*ELEMENT_SOLID\n";
  int id = 3001;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i)
        nodes += fmt::format("{:8}{:16}{:16}{:16}\n", id++, 10.0 * i, 10.0 * j, -10.0 + 5.0 * k);
  const auto node = [](int i, int j, int k) { return 3001 + 16 * k + 4 * j + i; };
  id = 3001;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
        elements += fmt::format("{:8}{:8}{:8}{:8}{:8}{:8}{:8}{:8}{:8}{:8}\n", id++, 3, node(i, j, k), node(i + 1, j, k),
                                node(i + 1, j + 1, k), node(i, j + 1, k), node(i, j, k + 1), node(i + 1, j, k + 1),
                                node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1));
  // Nodes of the upright plate at z = -6.5, -3, 0.5: two of its three rows are inside.
  std::string text = upright_deck(Plate{.id = 1, .z = 50, .nx = 1, .ny = 1}, 16.0, 8.0, -6.5, 2, 2, 3.5);
  text.insert(
      text.find("*CONTACT"),
      "*PART\nblock\n         3         3         1\n*SECTION_SOLID\n         3         1\n" + nodes + elements);
  Found found(text);
  ASSERT_EQ(found.pieces.size(), 1u);
  EXPECT_EQ(found.scene.ids(found.pieces[0].nodes), (std::vector<std::int64_t>{2001, 2002, 2003, 2004, 2005, 2006}));
}

}  // namespace
}  // namespace gapcheck::audit_test::wrong_pieces_test
