#include "model/contact/contact_name.hpp"

#include <gtest/gtest.h>

namespace gapcheck::model::contact_name_test {
namespace {

TEST(ContactName, OptionsInAnyOrder) {
  for (const char* written :
       {"CONTACT_AUTOMATIC_SINGLE_SURFACE_ID_MPP", "CONTACT_AUTOMATIC_SINGLE_SURFACE_MPP_ID",
        "CONTACT_AUTOMATIC_SINGLE_SURFACE_MPP_TITLE", "CONTACT_MPP_ID_AUTOMATIC_SINGLE_SURFACE"}) {
    const ContactName name = parse_contact_name(written);
    EXPECT_EQ(name.bare, "CONTACT_AUTOMATIC_SINGLE_SURFACE") << written;
    EXPECT_TRUE(name.known() && name.options.id && name.options.mpp) << written;
    EXPECT_FALSE(name.options.thermal || name.options.thermal_friction || name.options.ortho_friction) << written;
    EXPECT_EQ(name.kind->cards, TypeCards::none);
  }
}

TEST(ContactName, ThermalAndFriction) {
  const ContactName both = parse_contact_name("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_THERMAL_FRICTION_ID");
  EXPECT_TRUE(both.options.thermal && both.options.thermal_friction && both.options.id && both.known());
  EXPECT_EQ(both.bare, "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE");
  const ContactName thermal = parse_contact_name("CONTACT_TIED_SURFACE_TO_SURFACE_THERMAL_ID");
  EXPECT_TRUE(thermal.options.thermal && thermal.known());
  EXPECT_FALSE(thermal.options.thermal_friction);
  const ContactName ortho = parse_contact_name("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_ORTHO_FRICTION");
  EXPECT_TRUE(ortho.options.ortho_friction && ortho.known());
  EXPECT_EQ(ortho.bare, "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR");
}

TEST(ContactName, MortarInAnyPlace) {
  EXPECT_EQ(parse_contact_name("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_TIED").bare,
            "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIED_MORTAR");
  EXPECT_EQ(parse_contact_name("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_MORTAR").kind->cards,
            TypeCards::tiebreak);
  EXPECT_TRUE(parse_contact_name("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_USER_MORTAR").known());
  EXPECT_TRUE(parse_contact_name("CONTACT_AUTOMATIC_SINGLE_SURFACE_MORTAR_ID").known());
}

TEST(ContactName, SmoothIsAnOption) {
  EXPECT_EQ(parse_contact_name("CONTACT_FORMING_SURFACE_TO_SURFACE_SMOOTH").bare, "CONTACT_FORMING_SURFACE_TO_SURFACE");
}

TEST(ContactName, OwnLayoutsAndUnknownNames) {
  for (const char* written :
       {"CONTACT_2D_AUTOMATIC_SINGLE_SURFACE_THERMAL", "CONTACT_ENTITY", "CONTACT_GEBOD_LEFT_HAND", "CONTACT_1D",
        "CONTACT_GUIDED_CABLE_SET", "CONTACT_RIGID_SURFACE", "CONTACT_SPG", "CONTACT_COUPLING"}) {
    EXPECT_TRUE(parse_contact_name(written).own_layout) << written;
    EXPECT_TRUE(parse_contact_name(written).known()) << written;
    EXPECT_FALSE(parse_contact_name(written).modifier) << written;
  }
  EXPECT_TRUE(parse_contact_name("CONTACT_INTERIOR").modifier);
  for (const char* written : {"CONTACT_NO_SUCH_THING_ID", "CONTACT", "CONTACT_", "CONTACT__ID", "CONTACT_ID"})
    EXPECT_FALSE(parse_contact_name(written).known()) << written;
  EXPECT_TRUE(parse_contact_name("CONTACT_NO_SUCH_THING_ID").options.id);
}

// A word that the table does not know never leaves the plain type.
TEST(ContactName, WordsThatNoKindHas) {
  for (const char* written :
       {"CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_INTERFERENCE", "CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED_WELD",
        "CONTACT_NODES_TO_SURFACE_COMPOSITE", "CONTACT_TIED_SURFACE_TO_SURFACE_MORTAR",
        "CONTACT_ERODING_SINGLE_SURFACE_MORTAR", "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_BLUE",
        "CONTACT_SURFACE_TO_SURFACE_AUTOMATIC", "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_FRICTION"})
    EXPECT_FALSE(parse_contact_name(written).known()) << written;
  const ContactKind* fit = parse_contact_name("CONTACT_SURFACE_TO_SURFACE_INTERFERENCE").kind;
  ASSERT_NE(fit, nullptr);
  EXPECT_TRUE(fit->can(Ability::interference));
  EXPECT_EQ(fit->method, RunMethod::penalty);
}

TEST(ContactName, CardsOfTheType) {
  EXPECT_EQ(parse_contact_name("CONTACT_ERODING_SINGLE_SURFACE").kind->cards, TypeCards::eroding);
  EXPECT_EQ(parse_contact_name("CONTACT_DRAWBEAD_ID").kind->cards, TypeCards::draw_bead);
  EXPECT_EQ(parse_contact_name("CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK_DAMPING").kind->cards,
            TypeCards::tiebreak_damping);
  EXPECT_EQ(parse_contact_name("CONTACT_FORCE_TRANSDUCER_PENALTY_ID").kind->code, ContactCode::transducer);
}

}  // namespace
}  // namespace gapcheck::model::contact_name_test
