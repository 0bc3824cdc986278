#include "model/contact/nearest_contact_name.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "model/contact/contact_name.hpp"

namespace gapcheck::model::nearest_contact_name_test {
namespace {

TEST(NearestContactName, LettersWordsAndOrder) {
  const struct {
    const char *written, *nearest;
  } cases[] = {
      {"AUTOMATIC_SINGEL_SURFACE", "AUTOMATIC_SINGLE_SURFACE"},
      {"AUTOMATIC_SINGLE", "AUTOMATIC_SINGLE_SURFACE"},
      {"AUTOMATICSINGLE_SURFACE_ID", "AUTOMATIC_SINGLE_SURFACE"},
      {"SURFACE_TO_SURFACE_AUTOMATIC", "AUTOMATIC_SURFACE_TO_SURFACE"},
      {"AUTOMATIC_SURFACE_TO_SURFACES_MORTAR", "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR"},
      {"TIED_NODE_TO_SURFACE_OFFSET_ID", "TIED_NODES_TO_SURFACE_OFFSET"},
      {"FORCE_TRANSDUCER_PENALTI", "FORCE_TRANSDUCER_PENALTY"},
      {"GENERALL", "AUTOMATIC_GENERAL"},
  };
  for (const auto& test : cases)
    EXPECT_EQ(nearest_contact_name("CONTACT_" + std::string(test.written)), "CONTACT_" + std::string(test.nearest));
}

TEST(NearestContactName, NothingNear) {
  for (const std::string& name :
       {std::string("NO_SUCH_THING"), std::string("FOO"), std::string(), std::string("_"), std::string(10000, 'A')})
    EXPECT_EQ(nearest_contact_name("CONTACT_" + name), "") << name.substr(0, 20);
  EXPECT_EQ(nearest_contact_name("CONTACT"), "");
}

TEST(NearestContactName, KnownNamesAreKnown) {
  const std::set<std::string> known(known_contact_names().begin(), known_contact_names().end());
  for (const ContactKind& kind : contact_kinds()) EXPECT_TRUE(known.contains(std::string(kind.name))) << kind.name;
  for (const std::string_view name : known_contact_names())
    EXPECT_TRUE(parse_contact_name("CONTACT_" + std::string(name)).known()) << name;
}

}  // namespace
}  // namespace gapcheck::model::nearest_contact_name_test
