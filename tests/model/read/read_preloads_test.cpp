#include <fmt/format.h>

#include "model/read.hpp"

namespace gapcheck::model::read_preloads_test {
namespace {

constexpr std::array<double, 6> rising{2, 3, 4, 5, 6, 7};

/// Fields of one width.
std::string row(std::size_t width, const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{:>{}}", value, width);
  return text + "\n";
}

std::string header(const std::vector<int>& fields) {
  std::string text;
  for (const int field : fields) text += fmt::format("{:>10}", field);
  return text + "\n";
}

/// All places of one layer before the next layer; history behind each point.
TEST(ReadPreloads, ShellStresses) {
  for (const bool large : {false, true}) {
    std::string text = "*INITIAL_STRESS_SHELL\n" + header({7, 2, 2, 9, 0, large ? 1 : 0});
    for (const double t : {-0.5, -0.5, 0.5, 0.25}) {
      const std::size_t width = large ? 16 : 10;
      if (large)
        text += row(width, {t, 2, 3, 4, 5}) + row(width, {6, 7, 0.125});
      else
        text += row(width, {t, 2, 3, 4, 5, 6, 7, 0.125});
      text += large ? row(width, {0, 0, 0, 0, 0}) + row(width, {0, 0, 0, t == 0.25 ? 1. : 0.})
                    : row(width, {0, 0, 0, 0, 0, 0, 0, 0}) + row(width, {t == 0.25 ? 1. : 0.});
    }
    const Read read = read_text(text + "\n" + header({8, 1, 1, 0, 0, large ? 1 : 0}) + "\n" + (large ? "\n" : ""));
    EXPECT_EQ(read.text(), "");
    ASSERT_EQ(read.model.initial_stresses.size(), 2U);
    const InitialStress& first = read.model.initial_stresses[0];
    EXPECT_EQ(first.kind, InitialStress::Kind::shell);
    EXPECT_EQ(first.id, 7);
    EXPECT_EQ(first.place.line, 2U);
    EXPECT_TRUE(first.complete());
    EXPECT_TRUE(first.history_used);
    ASSERT_EQ(first.points.size(), 4U);
    EXPECT_EQ(first.points[3].place, 0.25);
    EXPECT_EQ(first.points[1].stress, rising);
    EXPECT_EQ(first.points[2].plastic_strain, 0.125);
    const InitialStress& second = read.model.initial_stresses[1];
    EXPECT_TRUE(second.complete());
    EXPECT_FALSE(second.history_used);
    EXPECT_EQ(second.points[0].stress, (std::array<double, 6>{}));
  }
}

/// The second card of the large format has room for three history variables.
TEST(ReadPreloads, SolidStresses) {
  for (const int history : {0, 2, 3, 4, 8, 9}) {
    std::string text = "*INITIAL_STRESS_SOLID_SET\n" + header({7, 2, history, 1});
    for (int point = 0; point < 2; ++point) {
      text += row(16, {2, 3, 4, 5, 6}) + row(16, {7, 0.125, 0, 0, 0});
      for (int rest = history - 3; rest > 0; rest -= 5) text += row(16, {0, 0, 0, 0, 0});
    }
    const Read read = read_text(text + header({9, 1, 0, 1}) + row(16, {1}) + row(16, {0, 0, 5}));
    EXPECT_EQ(read.text(), "");
    ASSERT_EQ(read.model.initial_stresses.size(), 2U) << history;
    const InitialStress& first = read.model.initial_stresses[0];
    EXPECT_EQ(first.kind, InitialStress::Kind::solid_set);
    ASSERT_EQ(first.points.size(), 2U);
    EXPECT_EQ(first.points[1].stress, rising);
    EXPECT_EQ(first.points[1].plastic_strain, 0.125);
    EXPECT_FALSE(first.history_used);
    EXPECT_EQ(read.model.initial_stresses[1].id, 9) << history;
    EXPECT_FALSE(read.model.initial_stresses[1].history_used);  // NHISV is 0
  }
  const Read small = read_text("*INITIAL_STRESS_SOLID\n" + header({7, 1}) + row(10, {2, 3, 4, 5, 6, 7, 0.125}));
  ASSERT_EQ(small.model.initial_stresses.size(), 1U);
  EXPECT_EQ(small.model.initial_stresses[0].points[0].stress, rising);
  EXPECT_EQ(small.model.initial_stresses[0].points[0].plastic_strain, 0.125);
}

/// Counts that cannot be read end the block, and cost nothing.
TEST(ReadPreloads, HostileCounts) {
  for (const char* counts : {"7,0,2", "7,1,-3", "7,2000000000,2000000000", "7,1,1,-4", "7,1,1,2000000000", "7,1,1,0,6",
                             "7,1,1,0,0,3", "7,1,1,0,0,0,2,2"}) {
    const Read read = read_text(std::string("*INITIAL_STRESS_SHELL\n") + counts + "\n0.,1.\n8,1,1\n0.,1.\n");
    ASSERT_EQ(read.model.initial_stresses.size(), 1U) << counts;
    EXPECT_FALSE(read.model.initial_stresses[0].readable()) << counts;
    EXPECT_FALSE(read.model.initial_stresses[0].complete()) << counts;
  }
  const Read cut = read_text("*INITIAL_STRESS_SHELL\n7,2,3\n0.,1.\n0.,2.\n");
  ASSERT_EQ(cut.model.initial_stresses.size(), 1U);
  EXPECT_FALSE(cut.model.initial_stresses[0].complete());
  EXPECT_EQ(cut.model.initial_stresses[0].points.size(), 2U);
}

TEST(ReadPreloads, Sections) {
  const Read read = read_text(
      "*DATABASE_CROSS_SECTION_PLANE_ID\n7,bolt\n3,1.,2.,3.,2.,4.,6.,5.\n7.,8.,9.,10.,11.\n"
      "*DATABASE_CROSS_SECTION_SET\n21,22,23,24\n*INITIAL_STRESS_SECTION\n1,7,9,4,6,1,2\n");
  EXPECT_EQ(read.text(), "");
  ASSERT_EQ(read.model.cross_sections.size(), 2U);
  const CrossSection& plane = read.model.cross_sections[0];
  EXPECT_TRUE(plane.plane);
  EXPECT_EQ(plane.id, 7);
  EXPECT_EQ(plane.parts, 3);
  EXPECT_EQ(plane.tail, Vector(1, 2, 3));
  EXPECT_EQ(plane.normal, Vector(1, 2, 3));
  EXPECT_EQ(plane.radius, 5);
  EXPECT_EQ(plane.edge, Vector(6, 6, 6));
  EXPECT_EQ(plane.along, 10);
  EXPECT_EQ(plane.across, 11);
  EXPECT_EQ(plane.place.line, 3U);
  EXPECT_FALSE(read.model.cross_sections[1].plane);
  EXPECT_EQ(read.model.cross_sections[1].id, 2);
  EXPECT_EQ(read.model.cross_sections[1].nodes, 21);
  EXPECT_EQ(read.model.cross_sections[1].solids, 22);
  ASSERT_EQ(read.model.section_preloads.size(), 1U);
  const SectionPreload& preload = read.model.section_preloads[0];
  EXPECT_EQ(preload.id, 1);
  EXPECT_EQ(preload.section, 7);
  EXPECT_EQ(preload.curve, 9);
  EXPECT_EQ(preload.parts, 4);
  EXPECT_EQ(preload.vector, 6);
  EXPECT_EQ(preload.shear, 1);
  EXPECT_EQ(preload.ghost, 2);
  EXPECT_EQ(preload.scale, 1);
  EXPECT_EQ(preload.place.line, 8U);
}

}  // namespace
}  // namespace gapcheck::model::read_preloads_test
