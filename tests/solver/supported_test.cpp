#include "solver/supported.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "model/read.hpp"

namespace gapcheck::solver::supported_test {
namespace {

std::vector<Unsupported> unsupported_in(const std::string& text) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(text, "a.k", {}, diagnostics);
  EXPECT_TRUE(deck);
  const auto model = model::read_model(deck.value(), diagnostics);
  return unsupported(deck.value(), model.value());
}

/// "line keyword: why", one per line.
std::string text_of(const std::vector<Unsupported>& list) {
  std::string text;
  for (const Unsupported& one : list) text += std::to_string(one.line) + " " + one.keyword + ": " + one.why + "\n";
  return text;
}

const std::string mesh =
    "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n*ELEMENT_SHELL\n1,1,1,2,3,4\n*PART\np\n1,1,1\n"
    "*SECTION_SHELL\n1,2\n0.1\n";

TEST(Supported, WhatIsCalculatedOrHarmlessIsNotNamed) {
  EXPECT_EQ(
      text_of(unsupported_in(
          "*KEYWORD\n*TITLE\na deck\n" + mesh +
          "*MAT_PIECEWISE_LINEAR_PLASTICITY_TITLE\nsteel\n1,1.,1000.,0.3,10.,100.\n"
          "*BOUNDARY_SPC_SET_ID\n1,held\n1,0,1\n*SET_NODE_LIST_TITLE\nnodes\n1\n1\n*LOAD_SEGMENT_SET_ID\n1,x\n1,1\n"
          "*DATABASE_BINARY_D3PLOT\n1.\n*CONTROL_TERMINATION\n1.\n*CONTROL_ENERGY\n2\n*DEFINE_CURVE_TITLE\nc\n1\n0.,1."
          "\n"
          "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n1,c\n0\n\n\n*CONTACT_FORCE_TRANSDUCER_PENALTY\n1,0,3\n\n\n"
          "*RIGIDWALL_PLANAR_ID\n1,w\n0\n0.,0.,0.,0.,0.,1.\n*CONTROL_TIMESTEP\n0.,0.9\n*END\n")),
      "");
}

TEST(Supported, AssembliesOfWeldBricks) {
  for (const char* form : {"", "_4", "_16", "_N"})
    EXPECT_EQ(
        text_of(unsupported_in(fmt::format("*KEYWORD\n*DEFINE_HEX_SPOTWELD_ASSEMBLY{}\n1\n1,2,3,4\n", form))),
        fmt::format("2 DEFINE_HEX_SPOTWELD_ASSEMBLY{}: the bricks of a weld fail one by one, not by the resultants "
                    "of all\n",
                    form));
}

TEST(Supported, SpringsThatAreNotCalculated) {
  const std::string springs =
      "*NODE\n1,0.,0.,0.\n*ELEMENT_DISCRETE\n1,1,1,0\n*PART\np\n1,1,1\n*SECTION_DISCRETE\n1\n\n";
  EXPECT_EQ(text_of(unsupported_in("*KEYWORD\n" + springs + "*MAT_S03\n1,5.,0.,1.\n")), "");
  EXPECT_EQ(text_of(unsupported_in("*KEYWORD\n" + springs + "*MAT_S04\n1,7,8\n")),
            "13 MAT_SPRING_NONLINEAR_ELASTIC: material 1: the curve over the rate (LCR = 8) is not calculated; set LCR "
            "to 0\n");
  EXPECT_EQ(text_of(unsupported_in("*KEYWORD\n" + springs + "*MAT_S06\n1,7,8\n")),
            "13 MAT_SPRING_GENERAL_NONLINEAR: material 1: how its curves move with the yield forces is published as "
            "pictures only; *MAT_SPRING_ELASTOPLASTIC and *MAT_SPRING_INELASTIC are calculated\n");
}

// Sensors do nothing until *SENSOR_CONTROL asks them.
TEST(Supported, SensorsAlone) {
  const std::string sensors = "*KEYWORD\n*SENSOR_DEFINE_FORCE\n1,RWALL,1\n*SENSOR_SWITCH\n1,SENSOR,1,GT,1.\n";
  EXPECT_EQ(text_of(unsupported_in(sensors)), "");
  EXPECT_EQ(text_of(unsupported_in(sensors + "*SENSOR_CONTROL\n1,CONTACT,1\n")),
            "6 SENSOR_CONTROL: sensors switch nothing on or off\n");
}

TEST(Supported, KeywordsWithTheirPlaces) {
  const auto list = unsupported_in("*KEYWORD\n*CONSTRAINED_LINEAR\n1,2\n*INITIAL_STRESS_BEAM\n1\n*AIRBAG_ID\n1\n");
  ASSERT_EQ(list.size(), 3u) << text_of(list);
  EXPECT_EQ(list[0].keyword, "CONSTRAINED_LINEAR");
  EXPECT_EQ(list[0].file, "a.k");
  EXPECT_EQ(list[0].line, 2u);
  EXPECT_NE(list[0].why.find("does not know"), std::string::npos);
  EXPECT_EQ(list[1].why, "of start stresses those of shells and solids are calculated");
  EXPECT_EQ(list[2].line, 6u);
}

/// A run begins where the nodes of the model are; moves that these have not made are named.
TEST(Supported, Moves) {
  const std::string material = "*MAT_ELASTIC\n1,1.,1000.,.3\n*SET_NODE\n1\n1\n*SET_PART\n2\n1\n";
  const std::string transformation = "*DEFINE_TRANSFORMATION\n5\nTRANSL,1.\n*DEFINE_TRANSFORM\n6\nTRANSL2ND,1,2,1.\n";
  EXPECT_EQ(text_of(unsupported_in(mesh + material + transformation +
                                   "*PART_MOVE\n1,1.\n2,1.,,,,1\n*NODE_TRANSFORM\n5,1\n6,1,1\n*END\n")),
            "");
  EXPECT_EQ(
      text_of(unsupported_in(mesh + material + "*PART_MOVE\n1,1.,,,7\n9,1.\n9,1.,,,,1\n")),
      "23 PART_MOVE: its move is given in the coordinate system 7: no *DEFINE_COORDINATE_SYSTEM, _NODES or _VECTOR "
      "defines it\n24 PART_MOVE: part 9 is not defined\n25 PART_MOVE: part set 9 is not defined\n");
  EXPECT_EQ(text_of(unsupported_in(mesh + material + "*NODE_TRANSFORM\n5,1\n5,1\n5,3,1\n")),
            "23 NODE_TRANSFORM: transformation 5 is not defined\n25 NODE_TRANSFORM: node set 3 is not defined\n");
  EXPECT_EQ(text_of(unsupported_in(mesh + material + transformation + "*NODE_TRANSFORM\n5,1,1\n*DEFINE_BOX\n1\n")),
            "29 NODE_TRANSFORM: with IMMED = 1 it moves nodes before sets by *DEFINE_BOX are chosen\n");
  const std::string others = text_of(unsupported_in(mesh + material + "*PART_MOVE_N2N\n1,1,2\n"));
  EXPECT_NE(others.find("PART_MOVE_N2N: the solver does not know this keyword"), std::string::npos) << others;
}

TEST(Supported, MovedInertia) {
  const auto named = [](const std::string& node, const std::string& distance) {
    return text_of(
        unsupported_in("*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n*ELEMENT_SHELL\n1,1,1,2,3,4\n"
                       "*PART_INERTIA\np\n1,1,1\n.5,.5,0.,1.,0," +
                       node + "\n1.,0.,0.,1.,0.,1.\n\n*SECTION_SHELL\n1,2\n0.1\n*MAT_RIGID\n1,1.,1000.,.3\n" +
                       "*PART_MOVE\n1," + distance + "\n"));
  };
  EXPECT_EQ(named("0", "1."),
            "10 PART_MOVE: it moves part 1, and whether the centre in its *PART_INERTIA goes along is not known\n");
  EXPECT_EQ(named("0", "0."), "");
  EXPECT_EQ(named("1", "1."), "") << "the centre is a node, which moves";
}

TEST(Supported, MaterialsOfPartsWithElements) {
  EXPECT_EQ(
      text_of(unsupported_in(mesh + "*MAT_COMPOSITE_DAMAGE\n1,1.,1000.\n*MAT_ENHANCED_COMPOSITE_DAMAGE\n2,1.,1000.\n")),
      "15 MAT_COMPOSITE_DAMAGE: material 1 is of no kind that is calculated\n");
  const std::string failing =
      text_of(unsupported_in(mesh + "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,1.,1000.,0.3,10.,100.,-0.2\n40.,5.,0,7,3.\n"));
  EXPECT_NE(failing.find("FAIL < 0"), std::string::npos) << failing;
  EXPECT_NE(failing.find("LCSR"), std::string::npos) << failing;
  EXPECT_NE(failing.find("VP = 3"), std::string::npos) << failing;
}

TEST(Supported, ContactsWallsAndSettings) {
  const std::string text = text_of(unsupported_in(
      "*CONTACT_SURFACE_TO_SURFACE\n1,2,3,3\n\n\n*CONTACT_RIGID_BODY_TWO_WAY_TO_RIGID_BODY\n1,2,3,3\n\n\n1\n"
      "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_TIED\n1,2,3,3\n\n\n*CONTACT_DRAWBEAD\n1,2,3,3\n\n\n1,1,1.\n"
      "*RIGIDWALL_GEOMETRIC_SPHERE\n0\n0.,0.,0.,0.,0.,1.\n1.\n*RIGIDWALL_PLANAR_MOVING\n0\n0.,0.,0.,0.,0.,1.\n1.\n"
      "*RIGIDWALL_PLANAR\n0\n0.,0.,0.,0.,0.,1.,-4.\n"
      "*CONTACT_SLIDING_ONLY\n1,2,3,3\n\n\n*CONTACT_SLIDING_ONLY_PENALTY\n1,2,3,3\n\n\n"
      "*CONTROL_TIMESTEP\n0.,0.9,0,1e-7,-1e-6,4\n*CONTROL_DYNAMIC_RELAXATION\n,,,,,,,5\n"));
  for (const std::string expected :
       {"CONTACT_RIGID_BODY_TWO_WAY_TO_RIGID_BODY: contact 2", "MORTAR_TIED: contact 3: the ties",
        "DRAWBEAD: contact 4", "RIGIDWALL_PLANAR: wall 3: FRIC", "TSLIMT", "IDRFLG = 5",
        "CONTACT_SLIDING_ONLY: contact 5: how SLIDING_ONLY holds", "calculated, CONSTRAINT_SURFACE_TO_SURFACE,",
        "contact 6: how SLIDING_ONLY_PENALTY holds", "calculated, SURFACE_TO_SURFACE,"})
    EXPECT_NE(text.find(expected), std::string::npos) << expected << " in\n" << text;
  for (const std::string calculated : {"CONTACT_SURFACE_TO_SURFACE:", "SPHERE", "MOVING", "DT2MS", "LCTM"})
    EXPECT_EQ(text.find(calculated), std::string::npos) << text;
}

}  // namespace
}  // namespace gapcheck::solver::supported_test
