#include "solver/build/build_hourglass.hpp"

#include <gtest/gtest.h>

#include "model/read.hpp"

namespace gapcheck::solver::build_hourglass_test {
namespace {

ElementControl control_of(const std::string& cards, std::size_t* warnings = nullptr) {
  const model::Read read = model::read_text("*PART\np\n1,1,1,0,4\n" + cards);
  Diagnostics diagnostics;
  const ElementControl control =
      element_control(read.model, read.model.parts.at(0), {HourglassKind::viscous, 0.2}, diagnostics);
  if (warnings != nullptr) *warnings = diagnostics.sorted().size();
  return control;
}

TEST(BuildHourglass, PartBeforeControlBeforeDefault) {
  std::size_t warnings = 0;
  EXPECT_EQ(control_of("*HOURGLASS\n4\n", &warnings).hourglass.coefficient, 0.2);
  EXPECT_EQ(warnings, 0u);
  const ElementControl general =
      control_of("*HOURGLASS\n4\n*CONTROL_HOURGLASS\n4,0.07\n*CONTROL_BULK_VISCOSITY\n2.,0.1\n");
  EXPECT_EQ(general.hourglass.kind, HourglassKind::stiffness);
  EXPECT_EQ(general.hourglass.coefficient, 0.07);
  EXPECT_EQ(general.quadratic_viscosity, 2);
  EXPECT_EQ(general.linear_viscosity, 0.1);
  const ElementControl own =
      control_of("*HOURGLASS\n4,3,0.05,0,1.2,0.03\n*CONTROL_HOURGLASS\n4,0.07\n*CONTROL_BULK_VISCOSITY\n2.,0.1\n");
  EXPECT_EQ(own.hourglass.kind, HourglassKind::viscous);
  EXPECT_EQ(own.hourglass.coefficient, 0.05);
  EXPECT_EQ(own.quadratic_viscosity, 1.2);
  EXPECT_EQ(own.linear_viscosity, 0.03);
}

TEST(BuildHourglass, OtherTypesAreTheNearestWithAWarning) {
  std::size_t warnings = 0;
  EXPECT_EQ(control_of("*HOURGLASS\n4,6,0.1\n", &warnings).hourglass.kind, HourglassKind::stiffness);
  EXPECT_EQ(warnings, 1u);
  EXPECT_EQ(control_of("*HOURGLASS\n5,6,0.1\n", &warnings).hourglass.kind, HourglassKind::viscous);
  EXPECT_EQ(warnings, 1u);
  EXPECT_EQ(control_of("*HOURGLASS\n4,5,0.1\n", &warnings).hourglass.kind, HourglassKind::stiffness);
  EXPECT_EQ(warnings, 0u);
}

}  // namespace
}  // namespace gapcheck::solver::build_hourglass_test
