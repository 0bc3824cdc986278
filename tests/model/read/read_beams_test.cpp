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
  EXPECT_EQ(rectangle.location, (std::array<double, 2>{1, 0}));
  EXPECT_FALSE(rectangle.tube || rectangle.arbitrary || rectangle.torsion_free);
  const BeamProfile& tube = *sections[1].profile;
  EXPECT_TRUE(tube.tube);
  EXPECT_EQ(tube.s, (std::array<double, 2>{35, 35})) << "blank: as at the first end";
  EXPECT_EQ(tube.t, (std::array<double, 2>{7, 7}));
  EXPECT_EQ(tube.rule, 2);
  EXPECT_EQ(tube.shear_factor, 1);
  EXPECT_TRUE(sections[2].profile->arbitrary);
  EXPECT_TRUE(sections[2].profile->torsion_free);
  EXPECT_EQ(sections[2].profile->location, (std::array<double, 2>{0, 0}));
  EXPECT_FALSE(sections[3].integrated());
}

TEST(ReadBeams, DiscreteBeamsAndCables) {
  const Read read = included(
      "*SECTION_BEAM\n1,6,,,,-2.\n2.,3.,0,4.,5.,0.,1.,0.\n"
      "*MAT_LINEAR_ELASTIC_DISCRETE_BEAM_TITLE\nbushing\n1,1.,2.,3.,4.,5.,6.,7.\n1.,2.,3.,4.,5.,6.\n6.,5.,4.,3.,2.,1.\n"
      "*MAT_067\n2,1.,11,12,13,14,15,16\n21,22,23,24,25,26\n1.,0.,0.,0.,0.,1.\n2.,0.,0.,0.,0.,2.\n3.,0.,0.,0.,0.,3.\n"
      "*MAT_68\n3,1.,2.\n\n31\n4.\n5.\n6.\n"
      "*MAT_CABLE_DISCRETE_BEAM\n4,1.,1000.,41,8.,9.,10.,2\n1,2.,0.5,0.1,12.\n*MAT_071\n5,1.,-1000.\n");
  EXPECT_EQ(read.text(), "");
  const DiscreteBeamSection& section = *read.model.sections[0].spring;
  EXPECT_DOUBLE_EQ(section.volume, 2.0 * 343);
  EXPECT_DOUBLE_EQ(section.inertia, 3.0 * 3 * 49);
  EXPECT_DOUBLE_EQ(section.cable_area, 4.0 * 49);
  EXPECT_DOUBLE_EQ(section.cable_offset, 5.0 * 7);
  EXPECT_EQ(section.scoor, -2);
  EXPECT_EQ(section.fixed, (std::array<bool, 3>{false, true, false}));
  ASSERT_EQ(read.model.materials.size(), 5u);
  const DiscreteBeamMaterial& linear = *read.model.materials[0].discrete_beam;
  EXPECT_NEAR(linear.stiffness[1], 3 * force / 7, 1e-12);
  EXPECT_NEAR(linear.stiffness[5], 7 * force * 7, 1e-12);
  EXPECT_NEAR(linear.damping[0], 1 * force / 7 * 5, 1e-12);
  EXPECT_NEAR(linear.damping[3], 4 * force * 7 * 5, 1e-12);
  EXPECT_NEAR(linear.preload[2], 4 * force, 1e-12);
  EXPECT_NEAR(linear.preload[5], 1 * force * 7, 1e-12);
  const DiscreteBeamMaterial& nonlinear = *read.model.materials[1].discrete_beam;
  EXPECT_EQ(nonlinear.kind, DiscreteBeamMaterial::Kind::nonlinear);
  EXPECT_EQ(nonlinear.curve, (std::array<std::int64_t, 6>{211, 212, 213, 214, 215, 216}));
  EXPECT_EQ(nonlinear.damping_curve, (std::array<std::int64_t, 6>{221, 222, 223, 224, 225, 226}));
  EXPECT_NEAR(nonlinear.failure_force[5], 2 * force * 7, 1e-12);
  EXPECT_NEAR(nonlinear.failure_motion[0], 3 * 7, 1e-12);
  EXPECT_EQ(nonlinear.failure_motion[5], 3);
  const DiscreteBeamMaterial& plastic = *read.model.materials[2].discrete_beam;
  EXPECT_EQ(plastic.kind, DiscreteBeamMaterial::Kind::plastic);
  EXPECT_EQ(plastic.curve[0], 231);
  EXPECT_NEAR(plastic.failure_force[0], 4 * force, 1e-12);
  EXPECT_NEAR(plastic.preload[0], 6 * force, 1e-12);
  const DiscreteBeamMaterial::Cable& cable = read.model.materials[3].discrete_beam->cable;
  EXPECT_NEAR(cable.young, 1000 * stress, 1e-12);
  EXPECT_EQ(cable.curve, 241);
  EXPECT_NEAR(cable.force, 8 * force, 1e-12);
  EXPECT_EQ(cable.end, 45);
  EXPECT_EQ(cable.ramp, 50);
  EXPECT_EQ(cable.start, 10);
  EXPECT_EQ(cable.failure_strain, 0.1);
  EXPECT_NEAR(cable.failure_force, 12 * force, 1e-12);
  EXPECT_NEAR(read.model.materials[4].discrete_beam->cable.young, -1000 * force / 7, 1e-12);
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
