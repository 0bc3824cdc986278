#include <fstream>
#include <string>

#include "model/read.hpp"

namespace gapcheck::model::read_controls_test {
namespace {

double length_unit(const std::string& cards) {
  return read_text("*CONTROL_UNITS\n" + cards).model.controls.length_unit;
}

/// The controls of an include whose unit of time is 5 of the model's, of length 7.
Controls included(const std::string& blocks) {
  const std::string path = testing::TempDir() + "/read_controls_include.k";
  std::ofstream(path) << blocks;
  return read_text("*INCLUDE_TRANSFORM\n" + path + "\n\n,,\n3.,5.,7.\n\n").model.controls;
}

TEST(ReadControls, UnitsOfLengthInMetres) {
  const struct {
    const char* name;
    double metres;
  } cases[] = {{"m", 1}, {"mm", 0.001}, {"cm", 0.01}, {"in", 0.0254}, {"ft", 0.3048}, {"MM", 0.001}, {"", 1}};
  for (const auto& test : cases) EXPECT_EQ(length_unit(std::string(test.name) + ",s,kg\n"), test.metres) << test.name;
  for (const char* unknown : {"yd", "mmm", "meter", "c"}) EXPECT_EQ(length_unit(unknown), 0) << unknown;
  EXPECT_EQ(length_unit("yd,s,kg\n0.9144\n"), 0.9144);
  EXPECT_EQ(length_unit("mm,s,kg\n0.9144\n"), 0.9144) << "the number goes before the name";
  EXPECT_EQ(read_text("*NODE\n1\n").model.controls.length_unit, 0);
}

TEST(ReadControls, TimesAndLengthsOfIncludes) {
  const Controls controls = included(
      "*CONTROL_TERMINATION\n0.1,500,0.01,5.\n*CONTROL_TIMESTEP\n1e-6,0.5,0,0.,-2e-6,7\n"
      "*CONTROL_CONTACT\n\n\n0.3,0.2,0.0,0.5,0.6,0.7\n*CONTROL_UNITS\nmm,s,kg\n");
  EXPECT_DOUBLE_EQ(controls.endtim, 0.5);
  EXPECT_EQ(controls.endcyc, 500);
  EXPECT_EQ(controls.dtmin, 0.01);  // a share of the first step
  EXPECT_DOUBLE_EQ(controls.dtinit, 5e-6);
  EXPECT_DOUBLE_EQ(controls.dt2ms, -1e-5);
  EXPECT_EQ(controls.tssfac, 0.5);
  EXPECT_DOUBLE_EQ(controls.th, 4.2);
  EXPECT_EQ(controls.th_sf, 0.7);
  // Seven units of the model are a millimetre.
  EXPECT_DOUBLE_EQ(controls.length_unit, 0.001 / 7);
}

// The thickness at spot welds stays, and that is said where it matters only.
TEST(ReadControls, ThinningAtSpotWeldsIsNamed) {
  const auto warned = [](const std::string& card4, const std::string& weld = "*MAT_SPOTWELD\n1,7.8e-9,2e5,0.3\n") {
    const auto read = read_text("*CONTROL_CONTACT\n\n\n\n" + card4 + "\n" + weld);
    for (const Diagnostic& each : read.diagnostics)
      if (each.severity == Severity::warning && each.message.find("SPOTHIN") != std::string::npos) return each.line;
    return std::uint32_t{0};
  };
  EXPECT_EQ(warned("0,0,0,0,0,0,0.5"), 5u);
  EXPECT_EQ(warned("0,0,0,0,0,0,0.5", "*MAT_ELASTIC\n1,7.8e-9,2e5,0.3\n"), 0u) << "nothing is welded";
  EXPECT_EQ(warned("0,0,0,0,0,0,0."), 0u);
  EXPECT_EQ(warned("0,0,0,0,0,0,1.5"), 0u) << "outside of its range it does nothing";
}

TEST(ReadControls, DefaultsOfBlankCards) {
  const Controls controls =
      read_text("*CONTROL_CONTACT\n\n*CONTROL_BULK_VISCOSITY\n\n*CONTROL_TIMESTEP\n\n").model.controls;
  EXPECT_EQ(controls.slsfac, 0.1);
  EXPECT_EQ(controls.penopt, 1);
  EXPECT_EQ(controls.orien, 1);
  EXPECT_EQ(controls.xpene, 4);
  EXPECT_EQ(controls.bulk_q1, 1.5);
  EXPECT_EQ(controls.bulk_q2, 0.06);
  EXPECT_EQ(controls.tssfac, 0.9);
}

}  // namespace
}  // namespace gapcheck::model::read_controls_test
