#include "audit/untangle/face_region.hpp"

#include <cmath>

#include "audit/untangle/surfaces.hpp"

namespace gapcheck::audit_test::face_region_test {
namespace {

contact::Bounds everywhere() {
  contact::Bounds box;
  box.add(Vector::Constant(-1e9));
  box.add(Vector::Constant(1e9));
  return box;
}

/// A strip of four shells, of which every other one has its normal down.
std::string strip() {
  std::string text = "*KEYWORD\n" + elastic_steel +
                     "*PART\nstrip\n         1         1         1\n*SECTION_SHELL\n         1         2\n"
                     "        1.        1.        1.        1.\n*NODE\n";
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; j < 2; ++j) text += fmt::format("{:8}{:16}{:16}{:16}\n", 1 + 2 * i + j, 5.0 * i, 5.0 * j, 0.0);
  text += "*ELEMENT_SHELL\n";
  for (int i = 0; i < 4; ++i) {
    const int a = 1 + 2 * i, b = a + 2, c = a + 3, d = a + 1;
    text += i % 2 == 0 ? fmt::format("{:8}{:8}{:8}{:8}{:8}{:8}\n", i + 1, 1, a, b, c, d)
                       : fmt::format("{:8}{:8}{:8}{:8}{:8}{:8}\n", i + 1, 1, a, d, c, b);
  }
  return text + single_surface + "*END\n";
}

TEST(FaceRegion, CarriesTheSideOverTurnedNormals) {
  const ContactScene scene(strip());
  audit::FaceRegion region(*scene.surface);
  std::uint64_t work = 1000;
  const std::vector<audit::FaceSide> from{{SegmentIndex{0}, 1.0}};
  ASSERT_TRUE(region.grow(from, everywhere(), work));
  ASSERT_EQ(region.faces().size(), 4u);
  for (const audit::FaceSide& face : region.faces()) {
    const auto& n = scene.surface->segments().nodes[face.segment.value];
    const auto& x = scene.model->mesh.nodes.x;
    const double up = (x[n[2].value] - x[n[0].value]).cross(x[n[3].value] - x[n[1].value]).z();
    EXPECT_GT(face.side * up, 0) << face.segment.value;
  }
}

TEST(FaceRegion, StaysInItsBoxAndItsWork) {
  const ContactScene scene(plates_deck(Plate{.id = 1, .nx = 10, .ny = 1}));
  const std::vector<audit::FaceSide> from{{SegmentIndex{0}, 1.0}};
  contact::Bounds box;
  box.add(Vector(0, 0, 0));
  box.add(Vector(17, 1, 0));
  std::uint64_t work = 1000;
  audit::FaceRegion region(*scene.surface);
  ASSERT_TRUE(region.grow(from, box, work));
  EXPECT_EQ(region.faces().size(), 4u);
  audit::FaceRegion none(*scene.surface);
  work = 3;
  EXPECT_FALSE(none.grow(from, everywhere(), work));
}

TEST(FaceRegion, NearestFace) {
  const Plate ground{.id = 1, .nx = 3, .ny = 3}, above{.id = 2, .z = 2, .x = 6, .y = 6, .nx = 3, .ny = 1};
  const ContactScene scene(plates_deck(ground, above));
  audit::FaceRegion region(*scene.surface);
  std::uint64_t work = 1000;
  const std::vector<audit::FaceSide> from{{SegmentIndex{0}, -1.0}};
  ASSERT_TRUE(region.grow(from, everywhere(), work));
  EXPECT_EQ(region.faces().size(), 9u);  // not the plate above, which shares no edge
  const auto inside = region.nearest(scene.node(above.node(0, 0)));
  EXPECT_DOUBLE_EQ(inside.distance, 2);
  EXPECT_TRUE(inside.in_band && inside.above);
  EXPECT_EQ(inside.face.side, -1);
  EXPECT_EQ(inside.face.segment, SegmentIndex{4});
  const auto beside = region.nearest(scene.node(above.node(2, 0)));  // x = 16: 1 beyond the edge
  EXPECT_DOUBLE_EQ(beside.distance, std::sqrt(5.0));
  EXPECT_TRUE(beside.in_band);
  EXPECT_FALSE(beside.above);
  const auto far = region.nearest(scene.node(above.node(3, 0)));  // 6 beyond it
  EXPECT_FALSE(far.in_band || far.above);
}

}  // namespace
}  // namespace gapcheck::audit_test::face_region_test
