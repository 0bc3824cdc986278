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
    EXPECT_TRUE(name.known && name.id && name.mpp) << written;
    EXPECT_FALSE(name.thermal || name.thermal_friction || name.ortho_friction) << written;
    EXPECT_EQ(name.extra, ExtraCards::none);
  }
}

TEST(ContactName, ThermalAndFriction) {
  const ContactName both = parse_contact_name("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_THERMAL_FRICTION_ID");
  EXPECT_TRUE(both.thermal && both.thermal_friction && both.id && both.known);
  EXPECT_EQ(both.bare, "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE");
  const ContactName thermal = parse_contact_name("CONTACT_TIED_SURFACE_TO_SURFACE_THERMAL_ID");
  EXPECT_TRUE(thermal.thermal && thermal.known);
  EXPECT_FALSE(thermal.thermal_friction);
  const ContactName ortho = parse_contact_name("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_ORTHO_FRICTION");
  EXPECT_TRUE(ortho.ortho_friction && ortho.known);
  EXPECT_EQ(ortho.bare, "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR");
}

TEST(ContactName, MortarInAnyPlace) {
  EXPECT_EQ(parse_contact_name("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_TIED").bare,
            "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIED_MORTAR");
  EXPECT_EQ(parse_contact_name("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_MORTAR").extra, ExtraCards::one);
  EXPECT_TRUE(parse_contact_name("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_USER_MORTAR").known);
  EXPECT_TRUE(parse_contact_name("CONTACT_AUTOMATIC_SINGLE_SURFACE_MORTAR_ID").known);
}

TEST(ContactName, SmoothIsAnOption) {
  EXPECT_EQ(parse_contact_name("CONTACT_FORMING_SURFACE_TO_SURFACE_SMOOTH").bare, "CONTACT_FORMING_SURFACE_TO_SURFACE");
}

TEST(ContactName, OwnLayoutsAndUnknownNames) {
  for (const char* written :
       {"CONTACT_2D_AUTOMATIC_SINGLE_SURFACE_THERMAL", "CONTACT_ENTITY", "CONTACT_GEBOD_LEFT_HAND", "CONTACT_1D",
        "CONTACT_GUIDED_CABLE_SET", "CONTACT_RIGID_SURFACE", "CONTACT_SPG", "CONTACT_COUPLING"}) {
    EXPECT_EQ(parse_contact_name(written).extra, ExtraCards::own) << written;
    EXPECT_TRUE(parse_contact_name(written).known) << written;
    EXPECT_FALSE(parse_contact_name(written).modifier) << written;
  }
  EXPECT_TRUE(parse_contact_name("CONTACT_INTERIOR").modifier);
  for (const char* written : {"CONTACT_NO_SUCH_THING_ID", "CONTACT", "CONTACT_", "CONTACT__ID", "CONTACT_ID"})
    EXPECT_FALSE(parse_contact_name(written).known) << written;
  EXPECT_TRUE(parse_contact_name("CONTACT_NO_SUCH_THING_ID").id);
}

TEST(ContactName, CardsOfTheType) {
  EXPECT_EQ(parse_contact_name("CONTACT_ERODING_SINGLE_SURFACE").extra, ExtraCards::one);
  EXPECT_EQ(parse_contact_name("CONTACT_DRAWBEAD_ID").extra, ExtraCards::drawbead);
  EXPECT_EQ(parse_contact_name("CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK_DAMPING").extra,
            ExtraCards::tiebreak_damping);
  EXPECT_TRUE(parse_contact_name("CONTACT_FORCE_TRANSDUCER_PENALTY_ID").transducer);
}

}  // namespace
}  // namespace gapcheck::model::contact_name_test
