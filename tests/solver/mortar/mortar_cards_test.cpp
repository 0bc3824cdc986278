// Cards of mortar and interference contacts: what is refused, and what is named in a warning.
#include <gtest/gtest.h>

#include "solver/mortar/mortar_scene.hpp"

namespace gapcheck::solver::mortar_cards_test {
namespace {

std::string told(const std::string& contact) {
  const MortarBlock lower{1, {1, 1, 1}, {0, 0, 0}, {1, 1, 1}, 0, 1}, upper{2, {1, 1, 1}, {0, 0, 1}, {1, 1, 1}, 0, 1};
  RunSettings settings;
  settings.until = 0.01;
  RunScene scene(lower.mesh() + upper.mesh() +
                     "*MAT_ELASTIC\n1,1.,1000.,0.3\n*CONTROL_TERMINATION\n1.\n*SET_NODE_LIST\n7\n10000,10001,10002\n"
                     "*DEFINE_CURVE\n1\n0.,0.\n1.,1.\n*DEFINE_CURVE\n2\n0.,0.\n1.,-1.\n" +
                     contact,
                 settings);
  std::string text = scene.message();
  for (const Diagnostic& d : scene.diagnostics().sorted()) text += "\n" + d.message;
  if (scene.prepared()) scene.go();
  return text;
}

std::string mortar(const std::string& options, const std::string& type = "AUTOMATIC_SURFACE_TO_SURFACE") {
  return "*CONTACT_" + type + "_MORTAR\n1,2,3,3\n0.\n1.,1.\n" + options;
}

TEST(MortarCards, AreCheckedBeforeTheFirstCycle) {
  const auto expect = [](const std::string& deck, const std::string& words) {
    const std::string text = told(deck);
    EXPECT_NE(text.find(words), std::string::npos) << words << " in\n" << text;
  };
  expect(mortar("\n\n1,5\n"), "IGNORE = 5");
  expect(mortar("\n\n1,-7\n"), "IGNORE = -7");
  expect(mortar("\n\n1,3,-1.\n"), "by a curve");
  expect(mortar("\n\n1,2,-1.\n"), "MPAR1 = -1 pulls");
  expect(mortar("\n\n1,4,1.,-2.\n"), "MPAR2 = -2");
  expect(mortar("\n\n1,3\n"), "MPAR1 = 0");
  expect(mortar("\n\n5\n"), "IGAP = 5");
  expect("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n1,2,3,3\n0.\n1.,2.\n", "SFSB is not used");
  expect(mortar("\n-1.\n"), "PENMAX = -1");
  expect(mortar("\n0.,0,0,0,0,0,0.5\n"), "SLDTHK");
  expect("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n7,2,4,3\n0.\n1.,1.\n", "nodes without segments");
  expect("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n1,2,3,3\n0.\n-1.,1.\n", "below 0");
}

TEST(MortarCards, AbsurdNumbersDoNoHarm) {
  for (const std::string options :
       {"\n1e30\n", "\n1e-30\n", "\n\n1,4,1e-30,1e30\n", "\n\n1,2,1e300\n", "\n\n1,3,1e300\n"})
    EXPECT_NO_FATAL_FAILURE(told(mortar(options))) << options;
}

TEST(MortarCards, InterferenceNeedsACurveThatPushes) {
  const auto text = [](const std::string& card) {
    return told("*CONTACT_SURFACE_TO_SURFACE_INTERFERENCE\n1,2,3,3\n0.\n1.,1.\n" + card);
  };
  EXPECT_NE(text("0,9\n").find("no curve 9"), std::string::npos);
  EXPECT_NE(text("0,2\n").find("pulls"), std::string::npos);
  EXPECT_NE(text("1,1\n").find("LCID1 is not used"), std::string::npos);
  EXPECT_NE(text("0,0\n").find("LCID2 is not given"), std::string::npos);
  EXPECT_EQ(text("0,1\n").find("LCID"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::solver::mortar_cards_test
