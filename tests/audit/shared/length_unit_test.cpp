#include "audit/shared/length_unit.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "model/read.hpp"

namespace gapcheck::audit_test::length_unit_test {
namespace {

/// Of a deck with one part for each material: "density, Young's modulus".
audit::LengthUnit unit_of(const std::vector<std::string>& materials, const std::string& more = "") {
  std::string text = "*KEYWORD\n*SECTION_SHELL\n1,2\n1.\n";
  for (std::size_t i = 1; i <= materials.size(); ++i)
    text += fmt::format("*MAT_ELASTIC\n{0},{1},0.3\n*PART\npart\n{0},1,{0}\n", i, materials[i - 1]);
  const model::Read read = model::read_text(text + more + "*END\n");
  EXPECT_EQ(read.text(), "");
  return audit::inferred_length_unit(read.model);
}

std::string name_of(const std::string& material) {
  const std::string text = unit_of({material}).assumption;
  const std::string before = "taking the unit of length for ";
  return text.empty() ? "none" : text.substr(before.size(), text.find(',') - before.size());
}

// Constants as handbooks and decks have them.
TEST(LengthUnit, SteelInEverySystem) {
  EXPECT_EQ(name_of("7.85e-9,210000."), "mm");  // t, s: MPa
  EXPECT_EQ(name_of("7.85e-6,210."), "mm");     // kg, ms: GPa
  EXPECT_EQ(name_of("7.85e-3,210000."), "mm");  // g, ms: MPa
  EXPECT_EQ(name_of("7.85e-6,2.1e8"), "mm");    // kg, s: kPa
  EXPECT_EQ(name_of("7.85,2.1"), "cm");         // g, us: Mbar
  EXPECT_EQ(name_of("7.85,2.1e12"), "cm");      // g, s: dyn/cm2
  EXPECT_EQ(name_of("7850.,2.1e11"), "m");
  EXPECT_EQ(name_of("7.33e-4,2.9e7"), "in");  // lbf s2/in4, psi
  EXPECT_EQ(name_of("15.2,4.3e9"), "ft");     // slug/ft3, psf
}

TEST(LengthUnit, AluminiumToo) {
  EXPECT_EQ(name_of("2.7e-9,70000."), "mm");
  EXPECT_EQ(name_of("2.7e-6,70."), "mm");
  EXPECT_EQ(name_of("2700.,7.0e10"), "m");
  EXPECT_EQ(name_of("2.54e-4,1.0e7"), "in");
  EXPECT_EQ(unit_of({"2700.,7.0e10"}).assumption,
            "taking the unit of length for m, because material 1 looks like aluminium");
}

TEST(LengthUnit, Millimetres) {
  EXPECT_DOUBLE_EQ(unit_of({"7.85e-9,210000."}).millimetre, 1);
  EXPECT_DOUBLE_EQ(unit_of({"7.85,2.1"}).millimetre, 0.1);
  EXPECT_DOUBLE_EQ(unit_of({"7850.,2.1e11"}).millimetre, 0.001);
  EXPECT_DOUBLE_EQ(unit_of({"7.33e-4,2.9e7"}).millimetre, 1 / 25.4);
}

TEST(LengthUnit, NoKnownMetal) {
  EXPECT_EQ(name_of("1.e-9,210000."), "none");    // density of plastics
  EXPECT_EQ(name_of("7.85e-9,2000."), "none");    // modulus of plastics
  EXPECT_EQ(name_of("7.85e-9,210."), "none");     // of two systems
  EXPECT_EQ(name_of("4.43e-9,114000."), "none");  // titanium
  // Steel: 7600 to 8100 kg/m3, 185 to 220 GPa; aluminium: 2600 to 2850 kg/m3, 65 to 76 GPa.
  for (const char* outside : {"7.5999e-9,210000.", "8.1001e-9,210000.", "7.85e-9,184990.", "7.85e-9,220010.",
                              "2.5999e-9,70000.", "2.8501e-9,70000.", "2.7e-9,64990.", "2.7e-9,76010."})
    EXPECT_EQ(name_of(outside), "none") << outside;
  for (const char* inside : {"7.6001e-9,210000.", "8.0999e-9,210000.", "7.85e-9,185010.", "7.85e-9,219990.",
                             "2.6001e-9,70000.", "2.8499e-9,70000.", "2.7e-9,65010.", "2.7e-9,75990."})
    EXPECT_EQ(name_of(inside), "mm") << inside;
  EXPECT_FALSE(unit_of({}).known());
}

TEST(LengthUnit, OneMaterialIsEnough) {
  const audit::LengthUnit unit = unit_of({"1.e-9,2000.", "7.85e-9,210000."});
  EXPECT_EQ(unit.millimetre, 1);
  EXPECT_NE(unit.assumption.find("material 2 looks like steel"), std::string::npos) << unit.assumption;
  EXPECT_EQ(unit_of({"7.85e-9,210000.", "2.7e-6,70."}).millimetre, 1);  // both are in mm
}

TEST(LengthUnit, ContradictionsTellNothing) {
  EXPECT_FALSE(unit_of({"7.85e-9,210000.", "2700.,7.0e10"}).known());
  EXPECT_FALSE(unit_of({"7.85e-9,210000."}, "*CONTROL_UNITS\nm,sec,kg\n").known());
}

TEST(LengthUnit, MaterialsWithoutPartsDoNotCount) {
  EXPECT_FALSE(unit_of({}, "*MAT_ELASTIC\n1,7.85e-9,210000.,0.3\n").known());
}

TEST(LengthUnit, ControlUnits) {
  const auto given = [](const std::string& cards) { return unit_of({}, "*CONTROL_UNITS\n" + cards); };
  EXPECT_EQ(given("mm,ms,kg\n").assumption, "taking the unit of length for mm, as *CONTROL_UNITS says");
  EXPECT_DOUBLE_EQ(given("MM,ms,kg\n").millimetre, 1);
  EXPECT_DOUBLE_EQ(given("cm,ms,kg\n").millimetre, 0.1);
  EXPECT_DOUBLE_EQ(given("in,s,slug\n").millimetre, 1 / 25.4);
  EXPECT_DOUBLE_EQ(given(",ms,kg\n").millimetre, 0.001);  // blank: metres
  EXPECT_DOUBLE_EQ(given("mm,ms,kg\n0.01\n").millimetre, 0.1);
  EXPECT_FALSE(given("furlong,s,kg\n").known());
  EXPECT_DOUBLE_EQ(given("        mm        ms        kg\n").millimetre, 1);
  EXPECT_EQ(unit_of({"7.85e-9,210000."}, "*CONTROL_UNITS\nmm,s,t\n").assumption,
            "taking the unit of length for mm, as *CONTROL_UNITS says");
}

TEST(LengthUnit, NoConstantsFitTwoSystems) {
  // Every corner of every range, in every system: it must be found again in that one.
  for (const audit::UnitSystem& units : audit::unit_systems())
    for (const auto& [density, young] : {std::pair{7601., 186e9}, {8099., 219e9}, {2601., 66e9}, {2849., 75e9}}) {
      model::Material material;
      material.density = density / units.kilogram * units.metre * units.metre * units.metre;
      material.young = young / units.kilogram * units.metre * units.second * units.second;
      const auto metal = audit::known_metal(material);
      ASSERT_TRUE(metal) << units.name;
      EXPECT_EQ(metal->units->name, units.name);
    }
}

}  // namespace
}  // namespace gapcheck::audit_test::length_unit_test
