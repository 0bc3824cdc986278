#include "model/assumption.hpp"

#include "model/read.hpp"

namespace gapcheck::model::assumption_test {
namespace {

Assumption assumed(const std::string& text) {
  auto result = read_assumption(text);
  EXPECT_TRUE(result.ok()) << text << ": " << (result.ok() ? "" : result.error().message);
  return result ? result.value() : Assumption{};
}

TEST(Assumption, ReadsFieldAndValue) {
  const Assumption plain = assumed("SST=0.5"), loose = assumed(" optt = 0 "), fortran = assumed("mst=5.-1");
  EXPECT_EQ(plain.field, "SST");
  EXPECT_EQ(plain.value, 0.5);
  EXPECT_EQ(loose.field, "OPTT");
  EXPECT_EQ(loose.value, 0);
  EXPECT_EQ(fortran.value, 0.5);
  EXPECT_EQ(assumed("SST=-1").value, -1);
}

TEST(Assumption, RefusesWhatTheFieldCannotHave) {
  for (const char* text : {"", "SST", "=1", "SSST=1", "SST=", "SST=x", "SST=nan", "SST=1e999", "OPTT=-1", "IGNORE=0.5",
                           "SOFT=1e300", "SST=1=2"})
    EXPECT_FALSE(read_assumption(text).ok()) << text;
  EXPECT_NE(read_assumption("XYZ=1").error().message.find("SST, MST"), std::string::npos);
}

const char* const deck =
    "*KEYWORD\n*PART_CONTACT\none\n1,1,1\n0.2,0,0,0,3.,2.\n*PART\ntwo\n2,1,1\n"
    "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MPP_ID\n7\n1\n1,2,3,3\n0.\n1.,1.,2.,3.\n"
    "*CONTACT_TIED_SURFACE_TO_SURFACE_ID\n8\n1,2,3,3\n0.\n1.,1.,-2.,-3.\n"
    "*CONTROL_CONTACT\n\n\n\n1\n*END\n";

TEST(Assumption, ChangesEveryPlaceThatCounts) {
  Model model = read_text(deck).model;
  ASSERT_EQ(model.contacts.size(), 2U);
  assume(std::vector{assumed("SST=0.5"), assumed("MST=0.25"), assumed("OPTT=0"), assumed("IGNORE=2"), assumed("SFM=3")},
         model);
  EXPECT_EQ(model.contacts[0].sst, 0.5);
  EXPECT_EQ(model.contacts[0].mst, 0.25);
  EXPECT_EQ(model.contacts[0].sfm, 3);
  EXPECT_EQ(model.contacts[1].sst, -2) << "a tie distance is not a contact thickness";
  EXPECT_EQ(model.contacts[1].mst, -3);
  EXPECT_EQ(model.contacts[1].sfm, 3);
  EXPECT_EQ(model.controls.ignore, 2);
  EXPECT_EQ(model.contacts[0].ignore, 2);
  EXPECT_FALSE(model.contacts[0].mpp_ignore);
  ASSERT_TRUE(model.parts[0].contact);
  EXPECT_EQ(model.parts[0].contact->optt, 0);
  EXPECT_EQ(model.parts[0].contact->sft, 2);
  EXPECT_FALSE(model.parts[1].contact);
}

TEST(Assumption, TheLastOneCountsAndAnOpttReachesAllParts) {
  Model model = read_text(deck).model;
  assume(std::vector{assumed("SST=0.5"), assumed("SST=0.75"), assumed("OPTT=1.5")}, model);
  EXPECT_EQ(model.contacts[0].sst, 0.75);
  for (const Part& part : model.parts) {
    ASSERT_TRUE(part.contact);
    EXPECT_EQ(part.contact->optt, 1.5);
  }
}

}  // namespace
}  // namespace gapcheck::model::assumption_test
