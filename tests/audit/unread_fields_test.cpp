#include "audit/unread_fields.hpp"

#include <gtest/gtest.h>

#include <string>

#include "audit/run.hpp"

namespace gapcheck::audit_test::unread_fields_test {
namespace {

/// Two plates at a distance of 2, with the given section and surface.
AuditRun plates(const std::string& thickness, const std::string& surface, const std::string& member = "1",
                const audit::AuditOptions& options = {}) {
  return run_text(
      "*NODE\n1\n2,9.\n3,9.,9.\n4,0.,9.\n11,0.,0.,2.\n12,9.,0.,2.\n13,9.,9.,2.\n14,0.,9.,2.\n"
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,11,12,13,14\n*PART\na\n1,1,1\nb\n2,2,1\n"
      "*SECTION_SHELL\n1,2\n" +
          thickness + "\n*SECTION_SHELL\n2,2\n1.\n*MAT_ELASTIC\n1,7.8e-9,210000.,.3\n*SET_PART\n5\n" + member +
          "\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + surface + ",2,2,3\n\n\n*END\n",
      options);
}

std::string ids(const AuditRun& run) {
  std::string all;
  for (const Finding& finding : run.report.findings) all += finding.id + " ";
  return all;
}

TEST(UnreadFields, HaveNoFindingsOfTheirOwn) {
  EXPECT_TRUE(clean(plates("1.", "5"))) << "the deck itself is fine";
  EXPECT_NE(ids(plates("0.", "5")).find("GC303"), std::string::npos);
  const AuditRun run = plates("&t", "5");
  EXPECT_EQ(ids(run).find("GC3"), std::string::npos) << ids(run);
  EXPECT_EQ(run.errors(), 1U) << describe(run.diagnostics);
  const std::string said = describe(run.diagnostics);
  EXPECT_NE(said.find("\"t\" is not defined"), std::string::npos) << said;
  EXPECT_NE(said.find("findings about things with fields that could not be read are left out"), std::string::npos)
      << said;
}

// The masses that a contact's time step takes come from the parts around, too.
TEST(UnreadFields, TimeSteps) {
  EXPECT_NE(ids(plates("1e-6", "5")).find("GC420"), std::string::npos) << ids(plates("1e-6", "5"));
  EXPECT_EQ(ids(plates("&t", "5")).find("GC420"), std::string::npos);
}

TEST(UnreadFields, EmptySurfaces) {
  EXPECT_NE(ids(plates("1.", "0")).find("GC503"), std::string::npos);
  EXPECT_EQ(ids(plates("1.", "&set")).find("GC5"), std::string::npos);
  EXPECT_NE(ids(plates("1.", "5", "7")).find("GC503"), std::string::npos);
  EXPECT_EQ(ids(plates("1.", "5", "&part")).find("GC503"), std::string::npos);
  // The same for a branch.
  const auto branch = [](const std::string& component) {
    return ids(plates("1.\n*SET_PART_TREE\n6\n\n" + component,
                      "5,2,2,3\n\n\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n6,2,7,3\n\n\n*CONTACT_SPOTWELD\n1"));
  };
  EXPECT_NE(branch("-7").find("GC503"), std::string::npos) << branch("-7");
  EXPECT_EQ(branch("&none").find("GC503"), std::string::npos) << branch("&none");
}

TEST(UnreadFields, GivenParametersAreRead) {
  audit::AuditOptions options;
  options.read.parameters = {"t=1.5", "set=5", "part=1"};
  const AuditRun run = plates("<<t:10>>", "&set", "&part", options);
  EXPECT_TRUE(clean(run)) << describe(run.diagnostics);
  EXPECT_EQ(ids(run), ids(plates("1.5", "5", "1")));
}

}  // namespace
}  // namespace gapcheck::audit_test::unread_fields_test
