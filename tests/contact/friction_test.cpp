#include "contact/friction.hpp"

#include <gtest/gtest.h>

namespace gapcheck::contact {
namespace {

model::Contact named(const std::string& keyword) {
  model::Contact contact;
  contact.keyword = "CONTACT_" + keyword;
  return contact;
}

TEST(Friction, TypesThatTakeIt) {
  for (const char* keyword : {"AUTOMATIC_NODES_TO_SURFACE", "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE",
                              "AUTOMATIC_SURFACE_TO_SURFACE", "AUTOMATIC_SINGLE_SURFACE", "AUTOMATIC_GENERAL",
                              "SINGLE_SURFACE", "ERODING_SINGLE_SURFACE", "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR"}) {
    EXPECT_TRUE(takes_part_friction(named(keyword))) << keyword;
    EXPECT_TRUE(takes_friction_table(named(keyword))) << keyword;
  }
  EXPECT_TRUE(takes_part_friction(named("AIRBAG_SINGLE_SURFACE")));
  EXPECT_FALSE(takes_friction_table(named("AIRBAG_SINGLE_SURFACE")));
  for (const char* keyword : {"SURFACE_TO_SURFACE", "ERODING_SURFACE_TO_SURFACE", "FORMING_SURFACE_TO_SURFACE"})
    EXPECT_FALSE(takes_part_friction(named(keyword))) << keyword;
}

TEST(Friction, NoneInTiesAndTransducers) {
  EXPECT_TRUE(has_friction(named("SURFACE_TO_SURFACE")));
  EXPECT_FALSE(has_friction(named("TIED_SURFACE_TO_SURFACE")));
  EXPECT_FALSE(has_friction(named("FORCE_TRANSDUCER_PENALTY")));
}

}  // namespace
}  // namespace gapcheck::contact
