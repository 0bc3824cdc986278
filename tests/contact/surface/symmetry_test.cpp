#include "contact/surface/symmetry.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "contact/surface/contact_surfaces.hpp"
#include "contact/surface/erosion.hpp"
#include "model/read.hpp"

namespace gapcheck::contact::symmetry_test {
namespace {

/// Two cubes on each other along z; the corners of the lower one's bottom have the constraint code `code`, `more`
/// follows. A contact of the eroding kind with itself.
std::string tower(int code, const std::string& more, int isym = 1) {
  std::string deck = "*NODE\n";
  for (int i = 0; i < 12; ++i)
    deck +=
        fmt::format("{},{}.,{}.,{}.,{}\n", i + 1, i % 4 == 1 || i % 4 == 2 ? 1 : 0, i % 4 / 2, i / 4, i < 4 ? code : 0);
  return deck +
         "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n2,1,5,6,7,8,9,10,11,12\n*PART\np\n1,1,1\n*SECTION_SOLID\n1,1\n"
         "*MAT_ELASTIC\n1,1.,1.,0.\n" +
         fmt::format("*CONTACT_ERODING_SINGLE_SURFACE\n1,0,3\n\n\n{},1,1\n", isym) + more;
}

std::size_t faces(const std::string& deck) {
  const model::Read read = model::read_text(deck);
  EXPECT_EQ(read.errors(), 0u) << read.text();
  SurfaceStore store(read.model);
  return store.at(ContactIndex{0}).a.selection.segments.size();
}

// Ten faces are free. Code 3 holds z, the bottom's normal; 1 holds x, 7 everything.
TEST(Symmetry, FacesWithHeldNormals) {
  EXPECT_EQ(faces(tower(0, "")), 10u);
  EXPECT_EQ(faces(tower(3, "")), 9u);
  EXPECT_EQ(faces(tower(7, "")), 9u);
  EXPECT_EQ(faces(tower(1, "")), 10u);
  EXPECT_EQ(faces(tower(3, "", 0)), 10u) << "ISYM = 0 leaves nothing out";
}

TEST(Symmetry, SinglePointConstraints) {
  const std::string set = "*SET_NODE_LIST\n1\n1,2,3,4\n";
  EXPECT_EQ(faces(tower(0, set + "*BOUNDARY_SPC_SET\n1,0,0,0,1\n")), 9u);
  EXPECT_EQ(faces(tower(0, set + "*BOUNDARY_SPC_SET\n1,0,1,1,0\n")), 10u);
  EXPECT_EQ(faces(tower(0, set + "*BOUNDARY_SPC_SET\n1,5,0,0,1\n")), 10u) << "a local system";
  EXPECT_EQ(faces(tower(0, set + "*BOUNDARY_SPC_SET_BIRTH_DEATH\n1,0,0,0,1\n0.,1.\n")), 10u) << "not for ever";
  EXPECT_EQ(faces(tower(0, "*BOUNDARY_SPC_NODE\n1,0,0,0,1\n2,0,0,0,1\n3,0,0,0,1\n")), 10u) << "one corner is free";
  EXPECT_EQ(faces(tower(0, "*BOUNDARY_SPC_NODE\n1,0,0,0,1\n2,0,0,0,1\n3,0,0,0,1\n4,0,0,0,1\n")), 9u);
}

// A tilted bottom has no axis as its normal: z alone does not hold it, and all axes do.
TEST(Symmetry, TiltedFaces) {
  const model::Read read = model::read_text(tower(3, ""));
  std::vector<Vector> x = read.model.mesh.nodes.x;
  const model::SegmentNodes bottom{NodeIndex{0}, NodeIndex{1}, NodeIndex{2}, NodeIndex{3}};
  EXPECT_TRUE(SymmetryPlanes(read.model).holds(bottom, x));
  for (Vector& one : x) one.z() += 0.01 * one.x();
  EXPECT_FALSE(SymmetryPlanes(read.model).holds(bottom, x));
  EXPECT_TRUE(SymmetryPlanes(model::read_text(tower(7, "")).model).holds(bottom, x));
}

// When the lower cube fails, the face between both opens, unless its corners are held along it.
TEST(Symmetry, OpenedFaces) {
  for (const bool held : {false, true}) {
    const std::string more = held ? "*BOUNDARY_SPC_NODE\n5,0,0,0,1\n6,0,0,0,1\n7,0,0,0,1\n8,0,0,0,1\n" : "";
    const model::Read read = model::read_text(tower(3, more));
    SurfaceStore store(read.model);
    const ContactSurfaces left =
        store.erode(ContactIndex{0}, store.at(ContactIndex{0}), {{}, {true, false}, {}}, read.model.mesh.nodes.x);
    EXPECT_EQ(left.a.selection.segments.size(), held ? 5u : 6u);
  }
}

}  // namespace
}  // namespace gapcheck::contact::symmetry_test
