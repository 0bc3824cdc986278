#include "audit/ids_in_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "audit/audit.hpp"
#include "folder_test.hpp"

namespace gapcheck::audit_test::ids_in_files_test {
namespace {

class IdsInFiles : public FolderTest {
 protected:
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  /// All messages, as "ID message".
  std::string messages() {
    Diagnostics diagnostics;
    const auto report = audit::audit_deck((folder_ / "main.k").string(), {}, diagnostics);
    EXPECT_TRUE(report.ok());
    std::string all;
    for (const Finding& finding : report.value().findings) all += finding.id + " " + finding.message + "\n";
    return all;
  }
};

const std::string plate = "*NODE\n1\n2,1.\n3,1.,1.\n4,0.,1.\n*ELEMENT_SHELL\n1,1,1,2,3,4\n";
const std::string part = "*PART\n\n1,1,1\n*SECTION_SHELL\n1,2\n1.\n*MAT_ELASTIC\n1,1.,1.,.3\n";

TEST_F(IdsInFiles, UnknownNodesAreCountedPerSet) {
  write("b.k", plate + "*SET_NODE\n5\n1,2,77,78\n*SET_NODE\n6\n79\n");
  write("main.k", "*NODE\n11\n*ELEMENT_MASS\n21,11\n" + part + "*INCLUDE_AUTO_OFFSET\nb.k\n");
  const std::string all = messages();
  EXPECT_NE(all.find("GC502 node set 5 names 4 members that are not defined (1, 2, 77, 78)"), std::string::npos) << all;
  EXPECT_NE(all.find("GC502 node set 6 names a member that is not defined (79)"), std::string::npos) << all;
  EXPECT_EQ(all.find("GC501"), std::string::npos) << all;
}

TEST_F(IdsInFiles, FaultsNameBothIds) {
  write("b.k", plate + "*NODE\n4,0.,2.\n*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,1,2,3,9\n*ELEMENT_SHELL\n3,8,1,2,3,4\n");
  write("main.k", "*NODE\n11\n*ELEMENT_MASS\n21,11\n" + part + "*INCLUDE_AUTO_OFFSET\nb.k\n");
  const std::string all = messages();
  for (const char* text : {"node 15 (4 in the file) is defined again", "shell 22 (1 in the file) is defined again",
                           "shell 23 (2 in the file) names node 20 (9 in the file), which is not defined",
                           "(first: shell 24 (3 in the file))"})
    EXPECT_NE(all.find(text), std::string::npos) << text << " in\n" << all;
}

TEST_F(IdsInFiles, FindingsOnTheMeshNameBothIds) {
  write("b.k", plate + "*NODE\n5\n6,.5\n*ELEMENT_SHELL\n2,1,1,6,2,2\n");
  write("main.k", part + "*NODE\n14,9.,9.,9.\n*ELEMENT_MASS\n21,14\n*INCLUDE_AUTO_OFFSET\nb.k\n" +
                      "*SET_NODE\n1\n19\n*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n1,1,4,3\n\n\n");
  const std::string all = messages();
  const std::string file = (folder_ / "b.k").string();
  EXPECT_NE(all.find("take it out of the node set (node 19 is 5 in " + file + ")"), std::string::npos) << all;
  EXPECT_NE(all.find("element 23 is 2 in " + file), std::string::npos) << all;
}

}  // namespace
}  // namespace gapcheck::audit_test::ids_in_files_test
