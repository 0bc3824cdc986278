// --vtu and --sets: as files, and in the eyes of other readers.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "program.hpp"

namespace gapcheck::exports_test {
namespace {

class Exports : public Program {
 protected:
  /// One of the checks beside this file, with Debian's own Python: that has Debian's packages.
  [[nodiscard]] Ended check(const std::string& script, const std::string& options, const std::string& more = "") const {
    return shell("'" GAPCHECK_SYSTEM_PYTHON "' -B '" + (project / "tests/apps" / script).string() + "' " + options +
                 " " GAPCHECK_PROGRAM " '" + project.string() + "' " + more);
  }
  [[nodiscard]] std::string deck(const std::string& name) const {
    return "'" + (project / "data" / name).string() + "'";
  }
};

TEST_F(Exports, AreWrittenBesideTheResults) {
  const Ended plain = gapcheck("audit --format csv " + deck("two_plates.k"));
  const Ended with_files = gapcheck("audit --format csv --vtu a.vtu --sets a.k --set-id 700 " + deck("two_plates.k"));
  EXPECT_EQ(with_files.out, plain.out);
  EXPECT_EQ(with_files.code, plain.code);
  EXPECT_NE(content(folder_ / "a.vtu").find("NumberOfPoints=\"32\" NumberOfCells=\"18\""), std::string::npos);
  EXPECT_NE(content(folder_ / "a.k").find("\n       700\n"), std::string::npos);
}

TEST_F(Exports, AreTheSameForAnyNumberOfThreads) {
  for (const char* name : {"two_plates_crossing.k", "two_plates_tilted.k", "contact_chain.k", "tied_then_contact.k"}) {
    for (const char* jobs : {"1", "4"})
      EXPECT_EQ(gapcheck(std::string("audit --quiet --jobs ") + jobs + " --vtu " + jobs + ".vtu --sets " + jobs +
                         ".k " + deck(name))
                    .err,
                "");
    EXPECT_EQ(content(folder_ / "1.vtu"), content(folder_ / "4.vtu")) << name;
    EXPECT_EQ(content(folder_ / "1.k"), content(folder_ / "4.k")) << name;
    EXPECT_NE(content(folder_ / "1.k"), "");
  }
}

TEST_F(Exports, FilesThatCannotBeWrittenAreErrors) {
  for (const std::string words : {"--vtu no/such/folder.vtu", "--sets no/such/folder.k"}) {
    const Ended run = gapcheck("audit " + words + " " + deck("clean.k"));
    EXPECT_EQ(run.code, 2) << words;
    EXPECT_NE(run.err.find("no/such/folder"), std::string::npos) << run.err;
  }
  file("own.k", content(project / "data/clean.k"));
  const Ended own = gapcheck("audit own.k --sets own.k");
  EXPECT_EQ(own.code, 2);
  EXPECT_NE(own.err.find("is the deck itself"), std::string::npos) << own.err;
}

TEST_F(Exports, SetsOfALog) {
  use("smp");
  EXPECT_EQ(gapcheck("messag messag --quiet --sets sets.k").err, "");
  EXPECT_NE(content(folder_ / "sets.k").find("*SET_NODE_LIST_TITLE\nGC10"), std::string::npos);
  EXPECT_EQ(gapcheck("messag messag --quiet --sets free.k --deck " + deck("two_plates.k")).err, "");
  EXPECT_NE(content(folder_ / "free.k"), "");
}

TEST_F(Exports, GridsInTheirOwnReader) {
  const Ended run = check("check_vtu.py", "");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
}

TEST_F(Exports, GridsInVtk) {
  const Ended run = check("check_vtu.py", "--vtk");
  if (run.code == 77) GTEST_SKIP() << run.out;
  EXPECT_EQ(run.code, 0) << run.out << run.err;
}

TEST_F(Exports, SetsByCardLayouts) {
  const std::filesystem::path cards = project / ".." / "shared" / "reference" / "cards.json";
  if (!std::filesystem::exists(cards)) GTEST_SKIP() << "no card layouts in " << cards << "; put them there to run this";
  const Ended run = check("check_sets.py", "", "'" + cards.string() + "'");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
}

}  // namespace
}  // namespace gapcheck::exports_test
