#include "solver/build/build_spring_law.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "model/read.hpp"

namespace gapcheck::solver::build_spring_law_test {
namespace {

const std::string curves =
    "*DEFINE_CURVE\n7\n0.,0.\n1.,4.\n2.,5.\n*DEFINE_CURVE\n8\n-1.,-4.\n0.,0.\n1.,2.\n*DEFINE_CURVE\n9\n0.,1.\n1.,2.\n"
    "*DEFINE_CURVE\n10\n0.,0.\n1.,-2.\n*DEFINE_CURVE\n11\n0.,0.\n";

SolverResult<SpringLaw> law_of(const std::string& card, bool torsional = false, double length = 1) {
  model::Read read = model::read_text(card + curves);
  model::Material material = read.model.materials.at(0);
  if (material.discrete) material.discrete->length_factor = length;
  Diagnostics diagnostics;
  return build_spring_law(read.model, material, torsional, diagnostics);
}

TEST(BuildSpringLaw, Constants) {
  const SpringLaw plastic = law_of("*MAT_SPRING_ELASTOPLASTIC\n1,100.,20.,5.\n").value();
  EXPECT_EQ(plastic.kind, SpringLaw::Kind::elastoplastic);
  EXPECT_EQ(plastic.stiffness, 100);
  EXPECT_NEAR(plastic.hardening, 25, 1e-13);
  EXPECT_EQ(plastic.yield, 5);
  const SpringLaw maxwell = law_of("*MAT_S07_TITLE\nm\n1,100.,20.,3.,0.5,-2.\n").value();
  EXPECT_EQ(maxwell.kind, SpringLaw::Kind::maxwell);
  EXPECT_EQ(maxwell.stiffness, 20);
  EXPECT_EQ(maxwell.transient, 80);
  EXPECT_EQ(maxwell.decay, 3);
  EXPECT_EQ(maxwell.cutoff, 0.5);
  EXPECT_EQ(maxwell.cutoff_force, -2);
  EXPECT_TRUE(std::isinf(law_of("*MAT_S07\n1,100.,20.,3.\n").value().cutoff));
  EXPECT_TRUE(std::isinf(law_of("*MAT_S07\n1,100.,20.,3.,1e20\n").value().cutoff));
  const SpringLaw damper = law_of("*MAT_S05\n1,8\n").value();
  EXPECT_EQ(damper.rates.at(-2), -8);
  EXPECT_EQ(damper.rates.at(2), 4);
}

// The greater of KU and the steepest slope unloads; compression is what a blank CTF means.
TEST(BuildSpringLaw, Inelastic) {
  const SpringLaw law = law_of("*MAT_SPRING_INELASTIC\n1,7,1.\n").value();
  EXPECT_EQ(law.stiffness, 4);
  EXPECT_EQ(law.sense, -1);
  EXPECT_EQ(law.loading.at(2), 5);
  EXPECT_EQ(law_of("*MAT_S08\n1,7,9.,1.\n").value().stiffness, 9);
  EXPECT_EQ(law_of("*MAT_S08\n1,7,9.,1.\n").value().sense, -1);
  EXPECT_EQ(law_of("*MAT_S08\n1,7,9.,-1.\n").value().sense, 1);
}

// Units of an include: a moment per angle has the square of the length's factor, a moment the factor itself more
// than a force, whose own one is in the card's value already.
TEST(BuildSpringLaw, TorsionInOtherUnits) {
  const SpringLaw law = law_of("*MAT_S03\n1,100.,20.,5.\n", true, 10).value();
  EXPECT_EQ(law.stiffness, 100 * 100);
  EXPECT_NEAR(law.hardening, 25 * 100, 1e-10);
  EXPECT_EQ(law.yield, 5 * 10);
  EXPECT_EQ(law_of("*MAT_S03\n1,100.,20.,5.\n", false, 10).value().yield, 5);
  EXPECT_EQ(law_of("*MAT_S07\n1,100.,20.,3.,1.,-2.\n", true, 10).value().cutoff_force, -20);
  EXPECT_EQ(law_of("*MAT_S08\n1,7,9.,1.\n", true, 10).value().stiffness, 900);
}

struct BadSpring {
  const char* card;
  const char* says;
};

class BadSpringCard : public testing::TestWithParam<BadSpring> {};

TEST_P(BadSpringCard, IsNamed) {
  const auto law = law_of(GetParam().card);
  ASSERT_FALSE(law.ok()) << GetParam().card;
  EXPECT_EQ(law.error().kind, Failure::Kind::bad_material);
  EXPECT_NE(law.error().message.find(GetParam().says), std::string::npos) << law.error().message;
  EXPECT_EQ(law.error().place.line, 2u);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadSpringCard,
    testing::Values(
        BadSpring{"*MAT_S03\n1\n", "K is 0"}, BadSpring{"*MAT_S03\n1,-1.,0.,5.\n", "K is -1"},
        BadSpring{"*MAT_S03\n1,100.,100.,5.\n", "KT is 100"}, BadSpring{"*MAT_S03\n1,100.,-1.,5.\n", "KT is -1"},
        BadSpring{"*MAT_S03\n1,100.,20.\n", "FY is 0"}, BadSpring{"*MAT_S03\n1,100.,20.,-5.\n", "FY is -5"},
        BadSpring{"*MAT_S05\n1\n", "curve 0 is not there"}, BadSpring{"*MAT_S05\n1,99\n", "curve 99 is not there"},
        BadSpring{"*MAT_S05\n1,11\n", "no two points"}, BadSpring{"*MAT_S05\n1,7\n", "LCDR"},
        BadSpring{"*MAT_S05\n1,9\n", "LCDR"}, BadSpring{"*MAT_S06\n1,7,7,1.,5.,-5.\n", "none of the springs"},
        BadSpring{"*MAT_S07\n1,10.,20.,3.\n", "K0 is 10"}, BadSpring{"*MAT_S07\n1,100.,-20.,3.\n", "KI is -20"},
        BadSpring{"*MAT_S07\n1,100.,20.,-3.\n", "BETA is -3"}, BadSpring{"*MAT_S07\n1,100.,20.,3.,-1.\n", "TC is -1"},
        BadSpring{"*MAT_S08\n1,99\n", "curve 99 is not there"}, BadSpring{"*MAT_S08\n1,8\n", "LCFD"},
        BadSpring{"*MAT_S08\n1,9\n", "LCFD"}, BadSpring{"*MAT_S08\n1,10\n", "LCFD"},
        BadSpring{"*MAT_S08\n1,7,-1.\n", "KU is -1"}, BadSpring{"*MAT_S08\n1,7,1.,2.\n", "CTF is 2"}));

TEST(BuildSpringLaw, WhatIsNotCalculated) {
  const auto why = [](const std::string& card) {
    return spring_not_calculated(model::read_text(card).model.materials.at(0));
  };
  for (const char* card : {"*MAT_S01\n1,5.\n", "*MAT_S02\n1,5.\n", "*MAT_S03\n1,5.,0.,1.\n", "*MAT_S04\n1,7\n",
                           "*MAT_S05\n1,7\n", "*MAT_S07\n1,5.\n", "*MAT_S08\n1,7\n", "*MAT_ELASTIC\n1,1.,1.\n"})
    EXPECT_EQ(why(card), "") << card;
  EXPECT_NE(why("*MAT_S04\n1,7,8\n").find("LCR = 8"), std::string::npos);
  EXPECT_NE(why("*MAT_S06\n1,7,8\n").find("pictures"), std::string::npos);
  EXPECT_NE(why("*MAT_S07\n1,5.,1.,1.,0.,0.,1.\n").find("COPT = 1"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::solver::build_spring_law_test
