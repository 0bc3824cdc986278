#include "keyword/known_keywords.hpp"

#include <gtest/gtest.h>

#include "keyword/layout.hpp"

namespace gapcheck::keyword::known_keywords_test {
namespace {

TEST(KnownKeywords, AllWithALayoutAlsoWithIdAndTitle) {
  for (const std::string_view name : layout_names("")) {
    EXPECT_EQ(standing_of(name), Standing::known) << name;
    EXPECT_EQ(standing_of(std::string(name) + "_TITLE"), Standing::known) << name;
    EXPECT_EQ(standing_of(std::string(name) + "_ID"), Standing::known) << name;
  }
}

TEST(KnownKeywords, FamiliesNumbersAndOptions) {
  for (const char* name :
       {"AIRBAG_SIMPLE_AIRBAG_MODEL", "COMMENT", "ICFD_WHATEVER", "MAT_024", "MAT_B01", "MAT_054/055",
        "MAT_3-PARAMETER_BARLAT", "MAT_ADD_THERMAL_EXPANSION", "CONTROL_IMPLICIT_SOLUTION", "DEFINE_CURVE_WHATEVER",
        "ELEMENT_SHELL_OFFSET_THICKNESS", "SECTION_SEATBELT", "FREQUENCY_DOMAIN_FRF", "DEFORMABLE_TO_RIGID_AUTOMATIC",
        "CONSTRAINED_NODAL_RIGIDBODY", "CONTROL_TIME_STEP"})
    EXPECT_EQ(standing_of(name), Standing::known) << name;
}

TEST(KnownKeywords, OthersAreNot) {
  for (const char* name : {"", "X", "ELEMENT", "ELEMNT_SHELL", "CONTCT_AUTOMATIC_SINGLE_SURFACE", "INCLUD", "NODES",
                           "SET", "SET_PRT_LIST", "CONTROL_CONTCT", "NODE\r", "*", "MATERIAL_024"})
    EXPECT_EQ(standing_of(name), Standing::unknown) << name;
  EXPECT_EQ(standing_of("ELEMENT_SHELL_THICKNES"), Standing::other_form);
  EXPECT_EQ(known_beginning("ELEMENT_SHELL_THICKNES_OFFSET"), "ELEMENT_SHELL");
  EXPECT_EQ(known_beginning("ELEMENT_SHELL_THICKNESS"), "");
  EXPECT_EQ(known_beginning("ELEMNT_SHELL"), "");
}

TEST(NearestKeyword, LettersUnderscoresAndTheOrderOfWords) {
  EXPECT_EQ(nearest_keyword("ELEMNT_SHELL_THICKNESS_BETA_TITLE"), "ELEMENT_SHELL_THICKNESS_BETA_TITLE");
  EXPECT_EQ(nearest_keyword("ELEMENT_SHELL_THICKNES"), "ELEMENT_SHELL_THICKNESS");
  EXPECT_EQ(nearest_keyword("SET_PART_LIST_GENERATE_INCREMNET_TITLE"), "SET_PART_LIST_GENERATE_INCREMENT_TITLE");
  EXPECT_EQ(nearest_keyword("CONSTRAINED_NODAL_RIGD_BODY"), "CONSTRAINED_NODAL_RIGID_BODY");
  EXPECT_EQ(nearest_keyword("SETNODE_LIST"), "SET_NODE_LIST");
  EXPECT_EQ(nearest_keyword("SHELL_SECTION"), "SECTION_SHELL");
  EXPECT_EQ(nearest_keyword("KEYWRD"), "KEYWORD");
  EXPECT_EQ(nearest_keyword("FREQUNCY_DOMAIN_SSD"), "FREQUENCY_DOMAIN_SSD");
}

TEST(NearestKeyword, NothingIfNoneIsNear) {
  EXPECT_EQ(nearest_keyword("WHATEVER_THIS_IS"), "");
  EXPECT_EQ(nearest_keyword(""), "");
  EXPECT_EQ(nearest_keyword("DATABASE_BINARY1"), "") << "digits alone make another name";
  EXPECT_EQ(nearest_keyword("SET_PRT_LIST" + std::string(100, 'X')), "");
  EXPECT_EQ(nearest_keyword("BOUNDARY_SPQ"), "") << "short words with another letter are other words";
}

TEST(NearestKeyword, EquallyNearOnesByTheirCommonBeginning) {
  // One letter from PART and from MAT.
  EXPECT_EQ(nearest_keyword("PAT"), "PART");
}

}  // namespace
}  // namespace gapcheck::keyword::known_keywords_test
