// The elastic constants of each material by the names that the manual gives to the fields of its first card.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "model/read.hpp"

namespace gapcheck::model::read_materials_test {
namespace {

/// A first card as the manual prints it. Young's modulus stands where "E" is, Poisson's ratio where "PR" is, the bulk
/// modulus where "K" is; a dash is any other field, and fields behind the last of these are left out.
struct ManualCard {
  const char *names, *fields;
};
const ManualCard cards[] = {
    {"ELASTIC 001 1", "MID RO E PR"},
    {"ELASTIC_FLUID 001_FLUID", "MID RO E PR - - K"},
    {"ELASTIC_PHASE_CHANGE", "MID RO E PR"},
    {"ELASTIC_PLASTIC_HYDRO 010 10", "MID RO - - -"},
    {"ELASTIC_SPRING_DISCRETE_BEAM 074 74", "MID RO - - -"},
    {"ELASTIC_6DOF_SPRING_DISCRETE_BEAM 093 93", "MID RO - - -"},
    {"ELASTIC_VISCOPLASTIC_THERMAL 106", "MID RO E PR"},
    {"ELASTIC_WITH_VISCOSITY 060 60", "MID RO - - -"},
    {"ORTHOTROPIC_ELASTIC 002 2", "MID RO E - - PR"},  // EA EB EC PRBA
    {"ANISOTROPIC_ELASTIC 002_ANIS", "MID RO - - -"},
    {"PLASTIC_KINEMATIC 003 3", "MID RO E PR"},
    {"ELASTIC_PLASTIC_THERMAL 004", "MID RO"},
    {"SOIL_AND_FOAM 005", "MID RO - K"},  // G KUN
    {"VISCOELASTIC 006", "MID RO K"},
    {"BLATZ-KO_RUBBER 007", "MID RO"},  // G
    {"HIGH_EXPLOSIVE_BURN 008", "MID RO - -"},
    {"NULL 009 9", "MID RO - - - - E PR"},
    {"POWER_LAW_PLASTICITY 018", "MID RO E PR"},
    {"STRAIN_RATE_DEPENDENT_PLASTICITY 019", "MID RO -"},
    {"RIGID 020 20", "MID RO E PR"},
    {"ORTHOTROPIC_THERMAL 021", "MID RO E - - PR"},
    {"COMPOSITE_DAMAGE 022 22", "MID RO E - - PR"},
    {"PIECEWISE_LINEAR_PLASTICITY 024 24", "MID RO E PR"},
    {"HONEYCOMB 026", "MID RO E PR"},
    {"RESULTANT_PLASTICITY 028", "MID RO E PR"},
    {"ISOTROPIC_ELASTIC_PLASTIC 012", "MID RO - - - K"},  // G SIGY ETAN BULK
    {"ISOTROPIC_ELASTIC_FAILURE 013", "MID RO - - - K"},
    {"JOHNSON_COOK 015", "MID RO - E PR"},  // G E PR
    {"LAMINATED_GLASS 032", "MID RO E PR"},
    {"FABRIC 034 34", "MID RO E - - PR"},
    {"FABRIC_MAP 034M", "MID RO - -"},
    {"3-PARAMETER_BARLAT 036", "MID RO E PR"},
    {"TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC 037", "MID RO E PR"},
    {"ENHANCED_COMPOSITE_DAMAGE 054 055 54 55", "MID RO E - - PR"},
    {"CLOSED_CELL_FOAM 053", "MID RO E - -"},
    {"LOW_DENSITY_FOAM 057", "MID RO E - -"},
    {"LAMINATED_COMPOSITE_FABRIC 058", "MID RO E - - PR"},
    {"COMPOSITE_FAILURE 059", "MID RO E - - PR"},
    {"KELVIN-MAXWELL_VISCOELASTIC 061", "MID RO K - -"},
    {"VISCOUS_FOAM 062", "MID RO E - - - - PR"},  // E1 N1 V2 E2 N2 PR
    {"CRUSHABLE_FOAM 063", "MID RO E PR"},
    {"LOW_DENSITY_VISCOUS_FOAM 073", "MID RO E - -"},
    {"GENERAL_VISCOELASTIC 076", "MID RO K - -"},
    {"OGDEN_RUBBER 077_O", "MID RO PR - -"},
    {"PLASTICITY_WITH_DAMAGE 081", "MID RO E PR"},
    {"FU_CHANG_FOAM 083", "MID RO E - -"},
    {"SIMPLIFIED_JOHNSON_COOK 098", "MID RO E PR"},
    {"PLASTICITY_POLYMER 089", "MID RO E PR"},
    {"SPOTWELD 100", "MID RO E PR"},
    {"DAMAGE_1 104", "MID RO E PR"},
    {"DAMAGE_2 105", "MID RO E PR"},
    {"MODIFIED_JOHNSON_COOK 107", "MID RO E PR"},
    {"GURSON 120", "MID RO E PR"},
    {"HILL_3R 122", "MID RO E PR"},
    {"PLASTICITY_COMPRESSION_TENSION 124", "MID RO E PR"},
    {"KINEMATIC_HARDENING_TRANSVERSELY_ANISOTROPIC 125", "MID RO E PR"},
    {"MODIFIED_HONEYCOMB 126", "MID RO E PR"},
    {"BARLAT_YLD2000 133", "MID RO E PR"},
    {"DESHPANDE_FLECK_FOAM 154", "MID RO E PR"},
    {"HILL_FOAM 177", "MID RO K - -"},
    {"SAMP-1 187", "MID RO K - E PR"},  // BULK GMOD EMOD NUE
    {"TABULATED_JOHNSON_COOK 224", "MID RO E PR"},
    {"UHS_STEEL 244", "MID RO E PR"},
    {"LAMINATED_FRACTURE_DAIMLER_PINHO 261", "MID RO E - - PR"},
    {"LAMINATED_FRACTURE_DAIMLER_CAMANHO 262", "MID RO E - - PR"},
    {"ORTHOTROPIC_SIMPLIFIED_DAMAGE 221", "MID RO E - - PR"},
    {"MODIFIED_PIECEWISE_LINEAR_PLASTICITY 123", "MID RO E PR"},
    {"ARUP_ADHESIVE 169", "MID RO E PR"},
    {"SIMPLIFIED_RUBBER 181", "MID RO K - -"},
};

std::vector<std::string> words(const char* text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// A card with the number 30 + i in field i, 0.03 i for Poisson's ratio.
std::string card_line(const std::vector<std::string>& fields) {
  std::string line = "1,2.5";
  for (std::size_t i = 2; i < fields.size(); ++i)
    line += fields[i] == "PR" ? fmt::format(",{}", 0.03 * static_cast<double>(i)) : fmt::format(",{}.", 30 + i);
  return line + "\n";
}

/// The value of a field of card_line(); 0 if the card does not have it.
double value_of(const std::vector<std::string>& fields, const char* name) {
  const auto field = static_cast<double>(std::find(fields.begin(), fields.end(), name) - fields.begin());
  if (field == static_cast<double>(fields.size())) return 0;
  return std::string(name) == "PR" ? 0.03 * field : 30 + field;
}

// Small strains of Mooney–Rivlin rubber: G = 2 (A + B), E = 2 G (1 + ν).
TEST(ReadMaterials, MooneyRivlin) {
  for (const char* name : {"MOONEY-RIVLIN_RUBBER", "027", "27"}) {
    const Read read = read_text(std::string("*MAT_") + name + "\n1,2.5,0.25,3.,1.\n1.,1.,1.,17\n");
    ASSERT_EQ(read.model.materials.size(), 1u) << name << read.text();
    const Material& material = read.model.materials[0];
    EXPECT_EQ(material.keyword, "MAT_MOONEY-RIVLIN_RUBBER");
    EXPECT_EQ(material.young, 20);
    EXPECT_EQ(material.poisson, 0.25);
    EXPECT_NEAR(material.bulk, 20 / 1.5, 1e-14);
    EXPECT_TRUE(material.stiffness_known);
    ASSERT_TRUE(material.mooney_rivlin);
    EXPECT_EQ(material.mooney_rivlin->a, 3);
    EXPECT_EQ(material.mooney_rivlin->b, 1);
    EXPECT_EQ(material.mooney_rivlin->test.curve, 17);
  }
}

TEST(ReadMaterials, ElasticConstantsByNameAndNumber) {
  for (const ManualCard& manual : cards) {
    const std::vector<std::string> names = words(manual.names), fields = words(manual.fields);
    const double young = value_of(fields, "E"), poisson = value_of(fields, "PR"), bulk = value_of(fields, "K");
    for (const std::string& name : names) {
      const Read read = read_text("*MAT_" + name + "\n" + card_line(fields) + "\n\n\n\n");
      ASSERT_EQ(read.model.materials.size(), 1u) << name << read.text();
      const Material& material = read.model.materials[0];
      EXPECT_EQ(material.keyword, "MAT_" + names[0]);
      EXPECT_EQ(material.density, 2.5) << name;
      EXPECT_EQ(material.young, young) << name;
      EXPECT_EQ(material.poisson, poisson) << name;
      EXPECT_DOUBLE_EQ(material.bulk, bulk != 0 ? bulk : young / 3 / (1 - 2 * poisson)) << name;
      EXPECT_EQ(material.stiffness_known, young != 0 || bulk != 0) << name;
    }
  }
}

// The longest name counts, and what follows it must be an option: a word of its own.
TEST(ReadMaterials, NamesThatBeginLikeOthers) {
  const auto keyword = [](const char* name) {
    return read_text("*MAT_" + std::string(name) + "\n1,1.,1.,0.3\n").model.materials.at(0).keyword;
  };
  EXPECT_EQ(keyword("FABRIC_MAP"), "MAT_FABRIC_MAP");
  EXPECT_EQ(keyword("ELASTIC_FLUID"), "MAT_ELASTIC_FLUID");
  EXPECT_EQ(keyword("001_FLUID"), "MAT_ELASTIC_FLUID");
  EXPECT_EQ(keyword("ELASTICS"), "MAT_ELASTICS");
  EXPECT_EQ(keyword("0240"), "MAT_0240");
  EXPECT_EQ(keyword("024_LOG_INTERPOLATION"), "MAT_PIECEWISE_LINEAR_PLASTICITY");
}

TEST(ReadMaterials, OnlySpringsAndDampersHaveConstantsInPlaceOfADensity) {
  for (const char* name : {"SPRING_ELASTOPLASTIC", "S03", "DAMPER_NONLINEAR_VISCOUS", "S05", "SPRING_GENERAL_NONLINEAR",
                           "S06", "SPRING_MAXWELL", "S07", "SPRING_INELASTIC", "S08", "SPRING_TRILINEAR_DEGRADING",
                           "S13", "SPRING_SQUAT_SHEARWALL", "S14", "SPRING_MUSCLE", "S15"}) {
    const Read read = read_text("*MAT_" + std::string(name) + "\n1,2.,3.,4.,5.,6.,7.,8.\n");
    ASSERT_EQ(read.model.materials.size(), 1u) << name;
    const Material& material = read.model.materials[0];
    EXPECT_EQ(material.density, 0) << name;
    EXPECT_EQ(material.young, 0) << name;
    EXPECT_EQ(material.bulk, 0) << name;
    EXPECT_FALSE(material.stiffness_known) << name;
    EXPECT_EQ(material.discrete.has_value(),
              !material.keyword.ends_with("GENERAL_NONLINEAR") && !material.keyword.ends_with("DEGRADING") &&
                  !material.keyword.ends_with("SHEARWALL") && !material.keyword.ends_with("MUSCLE"))
        << name;
  }
}

TEST(ReadMaterials, IdsThatAreNotPositiveAreErrors) {
  const Read read = read_text("*MAT_ELASTIC\n0,1.,1.,0.3\n*MAT_ELASTIC\n-1,1.,1.,0.3\n*MAT_ELASTIC\n1,1.,1.,0.3\n");
  EXPECT_EQ(read.errors(), 2u) << read.text();
  ASSERT_EQ(read.model.materials.size(), 1u);
  EXPECT_EQ(read.model.materials[0].id, 1);
}

}  // namespace
}  // namespace gapcheck::model::read_materials_test
