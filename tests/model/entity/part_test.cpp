#include "model/entity/part.hpp"

#include <cmath>
#include <numbers>

#include "model/read.hpp"

namespace gapcheck::model::part_test {
namespace {

const std::string shell_text = "*ELEMENT_SHELL\n1,1,1,2,3,4\n";

TEST(Parts, HeadingsAndCardsRepeat) {
  const Read read = read_text(
      "*PART\nfirst, with a comma\n         1        10       100\n$ comment\n\n         2        11       101\n\n");
  ASSERT_EQ(read.model.parts.size(), 2u) << read.text();
  EXPECT_EQ(read.model.parts[0].title, "first, with a comma");
  EXPECT_EQ(read.model.parts[1].title, "");
  EXPECT_EQ(read.model.parts[1].id, PartId{2});
  EXPECT_EQ(read.model.parts[1].section_id, 11);
  EXPECT_EQ(read.model.parts[1].material_id, 101);
  EXPECT_EQ(read.model.part_of_id.at(2), PartIndex{1});
  EXPECT_EQ(read.text(), "");  // no elements: nothing is missing
}

TEST(Parts, ExtraCardsInAnyOrderOfOptions) {
  const std::string inertia = "0.,0.,0.,5.,1\n1.,0.,0.,1.,0.,1.\n0.,0.,0.\n1.,0.,0.,0.,1.,0.\n";
  for (const std::string options : {"INERTIA_CONTACT_PRINT", "PRINT_CONTACT_INERTIA"}) {
    const Read read = read_text("*PART_" + options + "\na\n1,1,1\n" + inertia +
                                "0.1,0.2,3.,4.,0.7,0.9,2.\n1\nb\n2,1,1\n" + inertia + ",,,,0.8\n1\n");
    ASSERT_EQ(read.model.parts.size(), 2u) << options << read.text();
    ASSERT_TRUE(read.model.parts[0].contact.has_value());
    const PartContact& contact = *read.model.parts[0].contact;
    EXPECT_EQ(contact.fs, 0.1);
    EXPECT_EQ(contact.fd, 0.2);
    EXPECT_EQ(contact.dc, 3.0);
    EXPECT_EQ(contact.vc, 4.0);
    EXPECT_EQ(contact.optt, 0.7);
    EXPECT_EQ(contact.sft, 0.9);
    EXPECT_EQ(contact.ssf, 2.0);
    EXPECT_EQ(read.model.parts[1].contact->optt, 0.8);
  }
}

TEST(Parts, CompositesAreTheirOwnSection) {
  const Read read = read_text(nodes_text(4) +
                              "*PART_COMPOSITE_CONTACT\nlaminate\n         1         2       0.8       1.0\n,,,,0.3\n"
                              "         7       0.5      45.0                   7      0.25\n"
                              "         7       0.5      45.0\n"
                              "*MAT_ELASTIC\n7,1.,2.,0.3\n" +
                              shell_text);
  ASSERT_EQ(read.model.parts.size(), 1u) << read.text();
  const Part& part = read.model.parts[0];
  EXPECT_EQ(part.composite_thickness, 1.25);
  ASSERT_EQ(part.plies.size(), 3u);
  EXPECT_EQ(part.plies[1].thickness, 0.25);
  EXPECT_EQ(part.plies[1].material, std::optional<std::uint32_t>(0));
  EXPECT_EQ(part.material_id, 7);
  ASSERT_TRUE(part.section && part.material);
  EXPECT_EQ(read.model.sections[*part.section].thickness, (std::array<double, 4>{1.25, 1.25, 1.25, 1.25}));
  EXPECT_EQ(read.model.sections[*part.section].nloc, 1.0);
  EXPECT_EQ(part.contact->optt, 0.3);
  EXPECT_EQ(read.text(), "");
}

TEST(Parts, DuplicatesAndMissingPropertiesAreFaults) {
  const Read read = read_text(nodes_text(4) + "*PART\na\n1,8,9\n*PART\nb\n1,1,1\n*PART\nc\n2,8,9\n" + shell_text);
  const std::string text = read.text();
  EXPECT_EQ(read.faults(Fault::Kind::duplicate_id), 1u) << text;
  EXPECT_NE(text.find("part 1 is defined again (first in line 8 of a.k)"), std::string::npos) << text;
  EXPECT_EQ(read.faults(Fault::Kind::unknown_reference), 2u) << text;
  EXPECT_NE(text.find("part 1 names section 8, which is not defined"), std::string::npos) << text;
  EXPECT_NE(text.find("part 1 names material 9, which is not defined"), std::string::npos) << text;
}

TEST(Parts, TruncatedCardIsAnError) {
  const Read read = read_text("*PART\nheading only\n*NODE\n1\n");
  EXPECT_EQ(read.errors(), 1u) << read.text();
  EXPECT_EQ(read.diagnostics[0].line, 2u);
}

TEST(Parts, KeywordsThatMovePartsAreNamed) {
  const Read read = read_text("*PART_MOVE_N2N\n1,1.,0.,0.\n*PART_DUPLICATE\nPART,1\n*PART_ANNEAL\n1\n");
  EXPECT_EQ(read.warnings(), 2u) << read.text();
}

TEST(Sections, ShellsRepeatWithAngles) {
  const Read read = read_text(
      "*SECTION_SHELL_TITLE\ntitle\n1,2,,10,,,1\n1.,2.\n1.,2.,3.,4.,5.,6.,7.,8.\n9.,10.\n"
      "another title\n2,16\n3.,,,,-1.\n"
      "3,101\n4.\n2,,,,,9\n0.,0.,1.\n0.,0.,1.\n1.,2.,3.,4.,5.,6.,7.,8.\n9.\n4,2\n5.\n");
  ASSERT_EQ(read.model.sections.size(), 4u) << read.text();
  EXPECT_EQ(read.model.sections[0].thickness, (std::array<double, 4>{1, 2, 1, 1}));
  EXPECT_EQ(read.model.sections[1].elform, 16);
  EXPECT_EQ(read.model.sections[1].nloc, -1.0);
  EXPECT_EQ(read.model.sections[2].id, 3);
  EXPECT_EQ(read.model.sections[3].thickness[3], 5.0);
}

TEST(Sections, ThroughTheThickness) {
  const Read read = read_text("*SECTION_SHELL\n1,2,0.833,5\n1.\n2,16\n1.\n");
  ASSERT_EQ(read.model.sections.size(), 2u) << read.text();
  EXPECT_EQ(read.model.sections[0].nip, 5);
  EXPECT_EQ(read.model.sections[0].shrf, 0.833);
  EXPECT_EQ(read.model.sections[1].nip, 2);
  EXPECT_EQ(read.model.sections[1].shrf, 1.0);
}

TEST(Sections, BeamRadius) {
  const Read read = read_text(
      "*SECTION_BEAM\n1,1,,,1\n4.,4.,2.,2.\n2,1,,,0\n4.,4.,2.,2.\n3,2\n9.\n4,9,,,1\n6.,6.\n5,6\n1.,2.\n"
      "6,3\n16.\n7,4\n8.\n8,2\nSECTION_08,1.5\n9,2\nSECTION_05,1.,1.\n10,2\nSECTION_11,2.,3.\n");
  const auto& sections = read.model.sections;
  ASSERT_EQ(sections.size(), 10u) << read.text();
  constexpr double pi = std::numbers::pi;
  EXPECT_DOUBLE_EQ(sections[0].beam_radius, 2);
  EXPECT_DOUBLE_EQ(sections[0].beam_area, pi * (4 - 1));
  EXPECT_DOUBLE_EQ(sections[1].beam_radius, std::sqrt(8 / pi));
  EXPECT_DOUBLE_EQ(sections[2].beam_radius, std::sqrt(9 / pi));
  EXPECT_DOUBLE_EQ(sections[3].beam_radius, 3);
  EXPECT_DOUBLE_EQ(sections[4].beam_radius, 0);
  EXPECT_DOUBLE_EQ(sections[5].beam_radius, std::sqrt(16 / pi));
  EXPECT_DOUBLE_EQ(sections[6].beam_radius, 4);
  EXPECT_DOUBLE_EQ(sections[7].beam_radius, 1.5);
  EXPECT_DOUBLE_EQ(sections[8].beam_radius, 0);
  EXPECT_DOUBLE_EQ(sections[9].beam_area, 6);
  EXPECT_EQ(read.warnings(), 1u) << read.text();
}

TEST(Sections, BeamConstants) {
  const Read read = read_text(
      "*SECTION_BEAM\n1,2,,,,,0.5\n9.,1.,2.,3.,,,,4.\n2,2\n9.,1.,2.,3.,4.\n3,3\n16.\n4,1,,,0\n2.,2.,4.,4.\n"
      "5,1,,,1\n4.,4.,2.,2.\n6,6\n1.,2.\n");
  const auto& sections = read.model.sections;
  ASSERT_EQ(sections.size(), 6u) << read.text();
  EXPECT_EQ(sections[0].beam->area, 9);
  EXPECT_EQ(sections[0].beam->iss, 1);
  EXPECT_EQ(sections[0].beam->itt, 2);
  EXPECT_EQ(sections[0].beam->torsion, 3);
  EXPECT_EQ(sections[0].beam->shear_area, 0);
  EXPECT_EQ(sections[0].beam->line_mass, 0.5);
  EXPECT_EQ(sections[1].beam->shear_area, 4);
  EXPECT_EQ(sections[2].beam->area, 16);
  EXPECT_EQ(sections[2].beam->iss, 0);
  EXPECT_DOUBLE_EQ(sections[3].beam->iss, 2 * 64.0 / 12);  // 2 along s, 4 along t
  EXPECT_DOUBLE_EQ(sections[3].beam->itt, 4 * 8.0 / 12);
  EXPECT_NEAR(sections[3].beam->torsion, 0.229 * 4 * 8, 0.01 * 0.229 * 4 * 8);  // tables: 0.229 a b³ for a = 2 b
  EXPECT_DOUBLE_EQ(sections[4].beam->iss, std::numbers::pi / 64 * (256 - 16));
  EXPECT_DOUBLE_EQ(sections[4].beam->torsion, std::numbers::pi / 32 * (256 - 16));
  EXPECT_FALSE(sections[5].beam.has_value());
}

TEST(Sections, Discrete) {
  const Read read = read_text("*SECTION_DISCRETE\n5,1\n0.,0.\n6,0,0.5\n\n7\n0.,3.\n");
  ASSERT_EQ(read.model.sections.size(), 3u) << read.text();
  EXPECT_TRUE(read.model.sections[0].torsional);
  EXPECT_FALSE(read.model.sections[0].limited);
  EXPECT_FALSE(read.model.sections[1].torsional);
  EXPECT_TRUE(read.model.sections[1].limited);
  EXPECT_TRUE(read.model.sections[2].limited);
}

TEST(Sections, OtherKinds) {
  const Read read = read_text(
      "*SECTION_SOLID_TITLE\nt\n1,1\nt\n2,10\n*SECTION_TSHELL\n3,1,,3,,,1\n1.,2.,3.\n4,1\n*SECTION_DISCRETE\n5\n0.,0.\n"
      "6\n0.,0.\n*SECTION_SPH\n7,1.2\n*SECTION_SEATBELT\n8\n9\n*SECTION_POINT_SOURCE\n10,1\nanything\n");
  std::vector<std::int64_t> ids;
  for (const Section& section : read.model.sections) ids.push_back(section.id);
  EXPECT_EQ(ids, (std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10})) << read.text();
  EXPECT_EQ(read.model.sections[6].kind, SectionKind::particle);
  EXPECT_EQ(read.model.sections[9].kind, SectionKind::other);
  EXPECT_EQ(read.text(), "");
}

TEST(Materials, ElasticConstantsOfCommonOnes) {
  const Read read = read_text(
      "*MAT_JOHNSON_COOK\n1,7.8e-9,77000.,200000.,0.3\n*MAT_LOW_DENSITY_FOAM\n2,1.e-10,5.\n"
      "*MAT_058\n3,1.e-9,700.,600.,,0.25\n*MAT_063\n4,1.e-10,6.,0.1\n*MAT_FU_CHANG_FOAM\n5,1.e-10,7.\n"
      "*MAT_SIMPLIFIED_RUBBER/FOAM\n6,1.e-9,2000.\n*MAT_ISOTROPIC_ELASTIC_PLASTIC\n7,1.,3.,4.,5.,6.\n"
      "*MAT_SAMP-1\n8,1.,9.,3.,12.,0.3\n*MAT_NULL\n9,1.\n*MAT_ELASTIC_PLASTIC_HYDRO\n10,1.,3.\n");
  const auto& m = read.model.materials;
  ASSERT_EQ(m.size(), 10u) << read.text();
  EXPECT_EQ(m[0].young, 200000);
  EXPECT_DOUBLE_EQ(m[0].bulk, 200000 / 1.2);
  EXPECT_EQ(m[1].young, 5);
  EXPECT_DOUBLE_EQ(m[1].bulk, 5.0 / 3);
  EXPECT_DOUBLE_EQ(m[2].bulk, 700 / 1.5);
  EXPECT_DOUBLE_EQ(m[3].bulk, 6 / 2.4);
  EXPECT_EQ(m[4].young, 7);
  EXPECT_EQ(m[5].bulk, 2000);
  EXPECT_EQ(m[6].bulk, 6);
  EXPECT_EQ(m[7].bulk, 9);
  EXPECT_EQ(m[7].young, 12);
  EXPECT_TRUE(m[8].stiffness_known);
  EXPECT_EQ(m[8].bulk, 0);
  EXPECT_FALSE(m[9].stiffness_known);
}

TEST(Materials, NamesNumbersAndOptions) {
  const Read read = read_text(
      "*MAT_024\n         1   7.8E-9  210000.       0.3\n"
      "*MAT_PIECEWISE_LINEAR_PLASTICITY_LOG_INTERPOLATION_TITLE\na title\n2,7.8e-9,210000.,0.3\n"
      "*MAT_020_TITLE\nt\n3,7.8e-9,210000.,0.3,,,,alias\n"
      "*MAT_NULL\n4,1.e-9,,,,,2.,0.4\n*MAT_100\n5,1.,2.,0.3\n*MAT_FABRIC\n6,1.,500.,600.,,0.35\n"
      "*MAT_ELASTIC_FLUID\n7,1.e-9,0.,0.,0.,0.,2200.\n*MAT_1\n8,1.,3.,0.5\n*MAT_NOBODY_KNOWS_TITLE\nt\n9,5.,1.,1.\n"
      "*MAT_3-PARAMETER_BARLAT\n10,1.,2.,0.3\n*MAT\n11\n*MAT_ADD_EROSION\n1\n*MAT_THERMAL_ISOTROPIC\n1\n");
  const auto& materials = read.model.materials;
  ASSERT_EQ(materials.size(), 11u) << read.text();
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(materials[0].keyword, "MAT_PIECEWISE_LINEAR_PLASTICITY");
  EXPECT_EQ(materials[1].keyword, "MAT_PIECEWISE_LINEAR_PLASTICITY");
  EXPECT_DOUBLE_EQ(materials[1].bulk, 210000. / (3 * 0.4));
  EXPECT_TRUE(materials[2].rigid);
  EXPECT_TRUE(materials[3].null_material);
  EXPECT_EQ(materials[3].young, 2.0);
  EXPECT_EQ(materials[3].poisson, 0.4);
  EXPECT_TRUE(materials[4].spotweld);
  EXPECT_TRUE(materials[5].fabric);
  EXPECT_EQ(materials[5].poisson, 0.35);
  EXPECT_EQ(materials[6].bulk, 2200.0);
  EXPECT_EQ(materials[7].keyword, "MAT_ELASTIC");
  EXPECT_TRUE(std::isfinite(materials[7].bulk));
  EXPECT_EQ(materials[8].keyword, "MAT_NOBODY_KNOWS");
  EXPECT_EQ(materials[8].density, 5.0);
  EXPECT_EQ(materials[8].young, 0.0);
  EXPECT_EQ(materials[9].keyword, "MAT_3-PARAMETER_BARLAT");
  EXPECT_EQ(materials[9].young, 2.0);
}

TEST(Materials, YieldData) {
  const Read read = read_text(
      "*MAT_PLASTIC_KINEMATIC\n1,1.,1000.,0.3,10.,100.,0.25\n40.,5.\n"
      "*MAT_024_TITLE\nt\n2,1.,1000.,0.3,20.,50.\n30.,4.,77,,1.\n0.,0.1,0.5\n20.,30.,40.\n"
      "*MAT_024\n3,1.,1000.,0.3,20.\n*MAT_ELASTIC\n4,1.,1000.,0.3\n");
  EXPECT_EQ(read.text(), "");
  ASSERT_EQ(read.model.materials.size(), 4u);
  const Plasticity& kinematic = *read.model.materials[0].plasticity;
  EXPECT_EQ(kinematic.sigy, 10);
  EXPECT_EQ(kinematic.etan, 100);
  EXPECT_EQ(kinematic.beta, 0.25);
  EXPECT_EQ(kinematic.rate_c, 40);
  EXPECT_EQ(kinematic.rate_p, 5);
  const Plasticity& piecewise = *read.model.materials[1].plasticity;
  EXPECT_EQ(piecewise.lcss, 77);
  EXPECT_EQ(piecewise.rate_c, 30);
  EXPECT_EQ(piecewise.points, (std::vector<std::array<double, 2>>{{0, 20}, {0.1, 30}, {0.5, 40}}));
  EXPECT_TRUE(read.model.materials[2].plasticity->points.empty());
  EXPECT_FALSE(read.model.materials[3].plasticity.has_value());
}

TEST(Materials, FailureRatesAndAnisotropy) {
  const Read read = read_text(
      "*MAT_PLASTIC_KINEMATIC\n1,1.,1000.,0.3,10.,100.,0.25\n40.,5.,0.3,1.\n"
      "*MAT_024\n2,1.,1000.,0.3,20.,50.,0.4\n30.,4.,77,78,1.\n*MAT_037\n3,1.,1000.,0.3,20.,50.,-1.5,9\n"
      "*MAT_037\n4,1.,1000.,0.3,20.\n");
  EXPECT_EQ(read.text(), "");
  ASSERT_EQ(read.model.materials.size(), 4u);
  EXPECT_EQ(read.model.materials[0].plasticity->failure_strain, 0.3);
  EXPECT_TRUE(read.model.materials[0].plasticity->viscoplastic);
  EXPECT_EQ(read.model.materials[1].plasticity->failure_strain, 0.4);
  EXPECT_EQ(read.model.materials[1].plasticity->lcsr, 78);
  EXPECT_TRUE(read.model.materials[1].plasticity->viscoplastic);
  EXPECT_EQ(read.model.materials[2].plasticity->anisotropy, -1.5);
  EXPECT_EQ(read.model.materials[2].plasticity->lcss, 9);
  EXPECT_EQ(read.model.materials[3].plasticity->anisotropy, 1);
  EXPECT_EQ(read.model.materials[3].plasticity->lcss, 0);
}

TEST(Materials, SpringsAndDampers) {
  const Read read = read_text(
      "*MAT_SPRING_ELASTIC\n1,250.\n*MAT_S02_TITLE\nd\n2,3.\n*MAT_SPRING_NONLINEAR_ELASTIC_TITLE\nn\n3,7,8\n*MAT_"
      "S05\n4,7\n");
  EXPECT_EQ(read.text(), "");
  const auto& materials = read.model.materials;
  ASSERT_EQ(materials.size(), 4u);
  using Kind = DiscreteMaterial::Kind;
  EXPECT_EQ(materials[0].discrete->kind, Kind::spring);
  EXPECT_EQ(materials[0].discrete->constant, 250);
  EXPECT_EQ(materials[0].density, 0);
  EXPECT_EQ(materials[1].keyword, "MAT_DAMPER_VISCOUS");
  EXPECT_EQ(materials[1].discrete->kind, Kind::damper);
  EXPECT_EQ(materials[1].discrete->constant, 3);
  EXPECT_EQ(materials[2].discrete->kind, Kind::nonlinear_spring);
  EXPECT_EQ(materials[2].discrete->curve, 7);
  EXPECT_EQ(materials[2].discrete->rate_curve, 8);
  EXPECT_EQ(materials[3].keyword, "MAT_DAMPER_NONLINEAR_VISCOUS");
  EXPECT_EQ(materials[3].discrete->kind, Kind::nonlinear_damper);
  EXPECT_EQ(materials[3].discrete->curve, 7);
}

TEST(Materials, SpringsWithHistory) {
  const Read read = read_text(
      "*MAT_SPRING_ELASTOPLASTIC\n1,250.,50.,7.\n*MAT_SPRING_MAXWELL_TITLE\nm\n2,9.,8.,7.,6.,5.,1.\n"
      "*MAT_SPRING_INELASTIC\n3,7,400.,-1.\n*MAT_S06\n4,7,8\n");
  EXPECT_EQ(read.text(), "");
  const auto& materials = read.model.materials;
  ASSERT_EQ(materials.size(), 4u);
  using Kind = DiscreteMaterial::Kind;
  const DiscreteMaterial &plastic = *materials[0].discrete, &maxwell = *materials[1].discrete,
                         &inelastic = *materials[2].discrete;
  EXPECT_EQ(plastic.kind, Kind::plastic_spring);
  EXPECT_EQ(plastic.constant, 250);
  EXPECT_EQ(plastic.tangent, 50);
  EXPECT_EQ(plastic.yield, 7);
  EXPECT_EQ(maxwell.kind, Kind::maxwell_spring);
  EXPECT_EQ(maxwell.constant, 9);
  EXPECT_EQ(maxwell.long_time, 8);
  EXPECT_EQ(maxwell.decay, 7);
  EXPECT_EQ(maxwell.cutoff, 6);
  EXPECT_EQ(maxwell.cutoff_force, 5);
  EXPECT_EQ(maxwell.option, 1);
  EXPECT_EQ(inelastic.kind, Kind::inelastic_spring);
  EXPECT_EQ(inelastic.curve, 7);
  EXPECT_EQ(inelastic.constant, 400);
  EXPECT_EQ(inelastic.sense, -1);
  EXPECT_FALSE(materials[3].discrete.has_value());
}

}  // namespace
}  // namespace gapcheck::model::part_test
