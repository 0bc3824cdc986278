#include <fstream>
#include <string>

#include "model/read.hpp"

namespace gapcheck::model::read_beams_test {
namespace {

/// The model of an include with units of mass 3, time 5 and length 7; sets are shifted by 100, curves by 200.
Read included(const std::string& blocks) {
  const std::string path = testing::TempDir() + "/read_beams_include.k";
  std::ofstream(path) << blocks;
  return read_text("*INCLUDE_TRANSFORM\n" + path + "\n,,,,100,200\n,\n3.,5.,7.\n\n");
}

constexpr double stress = 3.0 / 7 / 25, force = 3.0 * 7 / 25;

TEST(ReadBeams, ProfilesOfIntegratedBeams) {
  const Read read = included(
      "*SECTION_BEAM\n1,1,0.9,3,0,,2.\n1.,2.,3.,4.,1.\n2,9,,,1\n5.,,1.\n3,9,,5,2\n5.,6.,1.,2.,1,,1.\n4,2\n1.,2.,3.\n");
  EXPECT_EQ(read.text(), "");
  const std::vector<Section>& sections = read.model.sections;
  ASSERT_EQ(sections.size(), 4u);
  const BeamProfile& rectangle = *sections[0].profile;
  EXPECT_EQ(rectangle.s, (std::array<double, 2>{7, 14}));
  EXPECT_EQ(rectangle.t, (std::array<double, 2>{21, 28}));
  EXPECT_EQ(rectangle.rule, 3);
  EXPECT_EQ(rectangle.shear_factor, 0.9);
  EXPECT_DOUBLE_EQ(rectangle.line_mass, 2.0 * 3 / 7);
  EXPECT_TRUE(rectangle.shifted);
  EXPECT_FALSE(rectangle.tube || rectangle.arbitrary || rectangle.torsion_free);
  const BeamProfile& tube = *sections[1].profile;
  EXPECT_TRUE(tube.tube);
  EXPECT_EQ(tube.s, (std::array<double, 2>{35, 35})) << "blank: as at the first end";
  EXPECT_EQ(tube.t, (std::array<double, 2>{7, 7}));
  EXPECT_EQ(tube.rule, 2);
  EXPECT_EQ(tube.shear_factor, 1);
  EXPECT_TRUE(sections[2].profile->arbitrary);
  EXPECT_TRUE(sections[2].profile->torsion_free);
  EXPECT_FALSE(sections[2].profile->shifted);
  EXPECT_FALSE(sections[3].integrated());
}

TEST(ReadBeams, Spotwelds) {
  const Read read = included(
      "*MAT_SPOTWELD_TITLE\nweld\n1,1.,2000.,0.3,10.,20.,0.5,4.\n0.1,1.,2.,3.,4.,5.,6.,7.\n"
      "*MAT_100\n2,1.,2000.,0.3,-8.\n\n*MAT_SPOTWELD_DAMAGE-FAILURE\n3,1.,2000.,0.3,10.\n\n\n");
  EXPECT_EQ(read.text(), "");
  ASSERT_EQ(read.model.materials.size(), 3u);
  const SpotWeld& weld = *read.model.materials[0].weld;
  EXPECT_EQ(weld.variant, "");
  EXPECT_DOUBLE_EQ(weld.sigy, 10 * stress);
  EXPECT_DOUBLE_EQ(weld.hardening, 20 * stress);
  EXPECT_DOUBLE_EQ(weld.step, 0.5 * 5);
  EXPECT_DOUBLE_EQ(weld.failure_time, 4 * 5);
  EXPECT_EQ(weld.failure_strain, 0.1);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(weld.strength[i], static_cast<double>(i + 1) * force * (i < 3 ? 1 : 7), 1e-12) << i;
  EXPECT_EQ(weld.filter, 7);
  EXPECT_EQ(read.model.materials[1].weld->curve, 208);
  EXPECT_EQ(read.model.materials[1].weld->sigy, 0);
  EXPECT_EQ(read.model.materials[2].weld->variant, "SPOTWELD_DAMAGE-FAILURE");
  EXPECT_TRUE(read.model.materials[2].spotweld);
}

TEST(ReadBeams, Preloads) {
  const Read read = included("*INITIAL_AXIAL_FORCE_BEAM\n4,9,2.,1\n\n5,9\n");
  EXPECT_EQ(read.text(), "");
  ASSERT_EQ(read.model.beam_preloads.size(), 2u);
  const BeamPreload& first = read.model.beam_preloads[0];
  EXPECT_EQ(first.set, 104);
  EXPECT_EQ(first.curve, 209);
  EXPECT_DOUBLE_EQ(first.scale, 2 * force);
  EXPECT_EQ(first.kbend, 1);
  EXPECT_EQ(first.place.line, 2u);
  EXPECT_DOUBLE_EQ(read.model.beam_preloads[1].scale, force);
}

}  // namespace
}  // namespace gapcheck::model::read_beams_test
