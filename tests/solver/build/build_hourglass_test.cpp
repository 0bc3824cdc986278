#include "solver/build/build_hourglass.hpp"

#include <gtest/gtest.h>

#include <array>

#include "model/read.hpp"

namespace gapcheck::solver::build_hourglass_test {
namespace {

ElementControl control_of(const std::string& cards, std::size_t* warnings = nullptr,
                          ElementFamily family = ElementFamily::shells) {
  const model::Read read = model::read_text("*PART\np\n1,1,1,0,4\n" + cards);
  Diagnostics diagnostics;
  const ElementControl control =
      element_control(read.model, read.model.parts.at(0), family, {HourglassKind::viscous, 0.2}, diagnostics);
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
  EXPECT_EQ(control_of("*HOURGLASS\n4,8,0.1\n", &warnings).hourglass.kind, HourglassKind::stiffness);
  EXPECT_EQ(warnings, 1u);
  EXPECT_EQ(control_of("*HOURGLASS\n4,9,0.1\n", &warnings, ElementFamily::solids).hourglass.kind,
            HourglassKind::assumed_strain);
  EXPECT_EQ(warnings, 1u);
  EXPECT_EQ(control_of("*HOURGLASS\n5,6,0.1\n", &warnings).hourglass.kind, HourglassKind::viscous);
  EXPECT_EQ(warnings, 1u) << "undefined";
  // Of shells 4 to 6 are the same.
  EXPECT_EQ(control_of("*HOURGLASS\n4,6,0.1\n", &warnings).hourglass.kind, HourglassKind::stiffness);
  EXPECT_EQ(warnings, 0u);
  EXPECT_EQ(control_of("*HOURGLASS\n4,5,0.1\n", &warnings).hourglass.kind, HourglassKind::stiffness);
  EXPECT_EQ(warnings, 0u);
}

TEST(BuildHourglass, TypesOfSolids) {
  const auto solid = [](int type) {
    std::size_t warnings = 0;
    const Hourglass control = control_of("*CONTROL_HOURGLASS\n" + std::to_string(type) + ",1.\n*HOURGLASS\n4\n",
                                         &warnings, ElementFamily::solids)
                                  .hourglass;
    EXPECT_EQ(warnings, 0u) << type;
    EXPECT_EQ(control.coefficient, 1) << type;
    return control;
  };
  EXPECT_TRUE(solid(1).plain_shapes);
  EXPECT_FALSE(solid(2).plain_shapes);
  for (const int type : {1, 2, 3}) EXPECT_EQ(solid(type).kind, HourglassKind::viscous);
  for (const int type : {4, 5}) EXPECT_EQ(solid(type).kind, HourglassKind::stiffness);
  for (const int type : {6, 7}) EXPECT_EQ(solid(type).kind, HourglassKind::assumed_strain);
  for (const int type : {1, 2, 4}) EXPECT_FALSE(solid(type).exact_volume);
  for (const int type : {3, 5, 6, 7}) EXPECT_TRUE(solid(type).exact_volume);
}

// QB is QM and QW is QB where they are not given.
TEST(BuildHourglass, CoefficientsOfShells) {
  const auto of = [](const std::string& card) {
    const Hourglass control = control_of(card).hourglass;
    return std::array<double, 3>{control.coefficient, control.bending, control.warping};
  };
  EXPECT_EQ(of("*HOURGLASS\n4,4,0.05\n"), (std::array<double, 3>{0.05, 0.05, 0.05}));
  EXPECT_EQ(of("*HOURGLASS\n4,4,0.05,0,0,0,0.03\n"), (std::array<double, 3>{0.05, 0.03, 0.03}));
  EXPECT_EQ(of("*HOURGLASS\n4,4,0.05,0,0,0,0.03,0.01\n"), (std::array<double, 3>{0.05, 0.03, 0.01}));
}

}  // namespace
}  // namespace gapcheck::solver::build_hourglass_test
