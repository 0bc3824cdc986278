#include "contact/definition/contact_type.hpp"

#include <gtest/gtest.h>

namespace gapcheck::contact::contact_type_test {
namespace {

model::Contact named(std::string keyword) {
  model::Contact c;
  set_name("CONTACT_" + keyword, c);
  return c;
}

std::string code(const std::string& keyword) { return classify(named(keyword)).printed(); }

TEST(ContactType, CodesOfTheWorkshopTable) {
  EXPECT_EQ(code("AUTOMATIC_SINGLE_SURFACE"), "13");
  EXPECT_EQ(code("AIRBAG_SINGLE_SURFACE"), "a13");
  EXPECT_EQ(code("SURFACE_TO_SURFACE"), "3");
  EXPECT_EQ(code("AUTOMATIC_SURFACE_TO_SURFACE"), "a3");
  EXPECT_EQ(code("FORMING_ONE_WAY_SURFACE_TO_SURFACE"), "m10");
  EXPECT_EQ(code("ERODING_NODES_TO_SURFACE"), "16");
  EXPECT_EQ(code("CONSTRAINT_SURFACE_TO_SURFACE"), "17");
  EXPECT_EQ(code("TIED_SURFACE_TO_SURFACE_OFFSET"), "o2");
  EXPECT_EQ(code("TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET"), "c6");
  EXPECT_EQ(code("TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET"), "b7");
  EXPECT_EQ(code("SPOTWELD_WITH_TORSION"), "7");
  EXPECT_EQ(code("AUTOMATIC_GENERAL_INTERIOR"), "i26");
  EXPECT_EQ(code("FORCE_TRANSDUCER_PENALTY"), "25");
  EXPECT_EQ(code("SURFACE_TO_SURFACE_INTERFERENCE"), "3");
  EXPECT_EQ(code("AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_SMOOTH"), "a10");
}

TEST(ContactType, EveryUncheckedTypeSaysWhy) {
  for (const char* keyword :
       {"TIED_SURFACE_TO_SURFACE", "AUTOMATIC_SINGLE_SURFACE_MORTAR", "AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK",
        "TIEBREAK_NODES_TO_SURFACE", "FORCE_TRANSDUCER_PENALTY", "DRAWBEAD", "RIGID_NODES_TO_RIGID_BODY", "SINGLE_EDGE",
        "SOMETHING_ELSE"})
    EXPECT_FALSE(classify(named(keyword)).checked()) << keyword;
  for (const char* keyword : {"AUTOMATIC_SINGLE_SURFACE", "SINGLE_SURFACE", "NODES_TO_SURFACE", "AUTOMATIC_GENERAL"})
    EXPECT_TRUE(classify(named(keyword)).checked()) << keyword;
}

TEST(ContactType, Soft2CountsOnlyWhereTheTypeHasIt) {
  model::Contact single = named("AUTOMATIC_SINGLE_SURFACE");
  single.soft = 2;
  EXPECT_FALSE(classify(single).checked());
  // The solver switches these to SOFT = 1 and lists their penetrations.
  for (const char* keyword : {"AUTOMATIC_NODES_TO_SURFACE", "AUTOMATIC_GENERAL", "FORMING_SURFACE_TO_SURFACE"}) {
    model::Contact other = named(keyword);
    other.soft = 2;
    EXPECT_TRUE(classify(other).checked()) << keyword;
  }
}

TEST(ContactType, WhatMeetsWhat) {
  const auto pairing = [](const char* keyword, std::int64_t soft = 0) {
    model::Contact contact = named(keyword);
    contact.soft = soft;
    return classify(contact).pairing;
  };
  EXPECT_EQ(pairing("AUTOMATIC_SINGLE_SURFACE"), Pairing::nodes);
  EXPECT_EQ(pairing("AUTOMATIC_SINGLE_SURFACE", 2), Pairing::segments);
  EXPECT_EQ(pairing("AUTOMATIC_GENERAL", 2), Pairing::nodes);
  EXPECT_EQ(pairing("AUTOMATIC_SINGLE_SURFACE_MORTAR", 2), Pairing::mortar);
  EXPECT_EQ(pairing("FORMING_SURFACE_TO_SURFACE_MORTAR"), Pairing::mortar);
  for (const char* keyword :
       {"AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_TIED", "AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_MORTAR",
        "TIED_SURFACE_TO_SURFACE", "FORCE_TRANSDUCER_PENALTY", "RIGID_NODES_TO_RIGID_BODY"})
    EXPECT_EQ(pairing(keyword), Pairing::none) << keyword;
}

TEST(ContactType, IgnoreComesFromMppThenCardCThenControl) {
  model::Contact c = named("AUTOMATIC_SINGLE_SURFACE");
  model::Controls controls;
  controls.ignore = 2;
  const ContactType type = classify(c);
  EXPECT_EQ(settings(c, type, controls).ignore, 2);
  c.ignore = 0;  // zero asks the next place
  EXPECT_EQ(settings(c, type, controls).ignore, 2);
  c.mpp_ignore = 1;
  EXPECT_EQ(settings(c, type, controls).ignore, 1);
}

TEST(ContactType, WithoutItsFirstCardThereIsNothingToSearch) {
  model::Contact c = named("AUTOMATIC_SINGLE_SURFACE");
  c.cards.any = false;
  EXPECT_FALSE(classify(c).checked());
  EXPECT_EQ(classify(c).treatment, Treatment::none);
}

TEST(ContactType, TypesWithSoft2) {
  EXPECT_TRUE(has_soft_2(classify(named("AUTOMATIC_SURFACE_TO_SURFACE"))));
  EXPECT_TRUE(has_soft_2(classify(named("ERODING_SINGLE_SURFACE"))));
  EXPECT_FALSE(has_soft_2(classify(named("AUTOMATIC_NODES_TO_SURFACE"))));
  EXPECT_FALSE(has_soft_2(classify(named("AUTOMATIC_GENERAL"))));
}

TEST(ContactType, OldTypesIgnoreThicknessUnlessAskedTo) {
  model::Contact c = named("SURFACE_TO_SURFACE");
  model::Controls controls;
  const ContactType type = classify(c);
  EXPECT_EQ(settings(c, type, controls).shlthk, 0);
  controls.shlthk = 1;
  EXPECT_EQ(settings(c, type, controls).shlthk, 1);
  c.thkopt = 2;
  EXPECT_EQ(settings(c, type, controls).shlthk, 0);
  // SHLTHK of the contact counts with THKOPT = 1 and with nothing else.
  controls.shlthk = 0;
  c.shlthk = 2;
  EXPECT_EQ(settings(c, type, controls).shlthk, 0);
  c.thkopt = 0;
  EXPECT_EQ(settings(c, type, controls).shlthk, 0);
  c.thkopt = 1;
  EXPECT_EQ(settings(c, type, controls).shlthk, 2);
  EXPECT_EQ(settings(named("AUTOMATIC_SURFACE_TO_SURFACE"), classify(named("AUTOMATIC_SURFACE_TO_SURFACE")), {}).shlthk,
            2);
}

TEST(ContactType, FormingTypesTakeShlthkFromTheSamePlaces) {
  // Rigid tools count with SHLTHK = 2 alone, and THKOPT says which SHLTHK that is.
  for (const char* keyword : {"FORMING_ONE_WAY_SURFACE_TO_SURFACE", "FORMING_SURFACE_TO_SURFACE_MORTAR"}) {
    model::Contact c = named(keyword);
    model::Controls controls;
    const auto counted = [&] { return settings(c, classify(c), controls).shlthk; };
    EXPECT_EQ(counted(), 1);
    c.shlthk = 2;
    EXPECT_EQ(counted(), 1) << keyword << ": beside THKOPT = 0 that of *CONTROL_CONTACT counts";
    c.thkopt = 1;
    EXPECT_EQ(counted(), 2);
    c.thkopt = 2;
    controls.shlthk = 2;
    EXPECT_EQ(counted(), 1);
    c.thkopt = 0;
    EXPECT_EQ(counted(), 2);
  }
}

TEST(ContactType, OnlyAutomaticTypesKnowIgnore) {
  model::Controls controls;
  controls.ignore = 1;
  const auto ignore = [&](const char* keyword) {
    const model::Contact contact = named(keyword);
    return settings(contact, classify(contact), controls).ignore;
  };
  for (const char* keyword : {"AUTOMATIC_SINGLE_SURFACE", "AUTOMATIC_NODES_TO_SURFACE", "AUTOMATIC_GENERAL",
                              "ERODING_SINGLE_SURFACE", "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR"})
    EXPECT_EQ(ignore(keyword), 1) << keyword;
  for (const char* keyword : {"SURFACE_TO_SURFACE", "NODES_TO_SURFACE", "ONE_WAY_SURFACE_TO_SURFACE", "SINGLE_SURFACE",
                              "FORMING_ONE_WAY_SURFACE_TO_SURFACE", "CONSTRAINT_SURFACE_TO_SURFACE"})
    EXPECT_EQ(ignore(keyword), 0) << keyword;
}

TEST(ContactType, SquareEdges) {
  model::Controls controls;
  model::Contact c = named("AUTOMATIC_SINGLE_SURFACE");
  const auto square = [&] { return settings(c, classify(c), controls).square_edges; };
  controls.shledg = 1;
  EXPECT_FALSE(square());
  c.soft = 2;
  EXPECT_TRUE(square());
  c.shledg = 2;
  EXPECT_FALSE(square()) << "the contact's own word goes before the control card's";
  controls.shledg = 0;
  c.shledg = 1;
  EXPECT_TRUE(square());
}

}  // namespace
}  // namespace gapcheck::contact::contact_type_test
