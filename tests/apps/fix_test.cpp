// `gapcheck fix` as users and scripts see it.
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace gapcheck::fix_test {
namespace {

namespace fs = std::filesystem;

class FixProgram : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    fs::copy(project / "data", folder_ / "data", fs::copy_options::recursive);
  }
};

TEST_F(FixProgram, WritesADeckThatTheAuditLikes) {
  const std::string before = content(folder_ / "data/two_plates.k");
  const Ended fixed = gapcheck("fix data/two_plates.k -o out");
  EXPECT_EQ(fixed.code, 0) << fixed.err;
  EXPECT_NE(fixed.out.find("18 nodes penetrating before, 0 after; 32 nodes moved in 1 file\n"), std::string::npos)
      << fixed.out;
  EXPECT_EQ(content(folder_ / "data/two_plates.k"), before);
  EXPECT_EQ(gapcheck("audit data/two_plates.k --select GC101 --fail-on warning --quiet").code, 1);
  EXPECT_EQ(gapcheck("audit out/two_plates.k --select GC101 --fail-on warning --quiet").code, 0);
}

TEST_F(FixProgram, ShowsTheDeckBeforeAndAfter) {
  const std::string before = content(folder_ / "data/two_plates.k");
  const Ended fixed = gapcheck("fix data/two_plates.k --dry-run --html page.html --vtu grid.vtu");
  EXPECT_EQ(fixed.code, 0) << fixed.err;
  EXPECT_NE(content(folder_ / "page.html").find("\"moved_points\":"), std::string::npos);
  EXPECT_NE(content(folder_ / "grid.vtu").find("Name=\"move\""), std::string::npos);
  for (const char* option : {"--html", "--vtu"}) {
    const Ended over = gapcheck(std::string("fix data/two_plates.k --dry-run ") + option + " data/two_plates.k");
    EXPECT_EQ(over.code, 2) << option;
    EXPECT_EQ(content(folder_ / "data/two_plates.k"), before) << option;
    EXPECT_EQ(gapcheck(std::string("fix data/two_plates.k --plan ") + option + " p").code, 2) << option;
    EXPECT_EQ(gapcheck(std::string("start data/two_plates.k ") + option + " data/two_plates.k").code, 2) << option;
    EXPECT_EQ(content(folder_ / "data/two_plates.k"), before) << option;
  }
  EXPECT_EQ(gapcheck("start data/ignore_0.k --vtu start.vtu --html none/page.html").code, 2)
      << "there is no such folder";
  EXPECT_EQ(gapcheck("start data/ignore_0.k --vtu start.vtu").code, 1);
  EXPECT_NE(content(folder_ / "start.vtu").find("Name=\"move\""), std::string::npos);
}

TEST_F(FixProgram, WritesOnlyTheIncludeThatChanges) {
  const Ended fixed = gapcheck("fix data/include_parameter.k -o out");
  EXPECT_EQ(fixed.code, 0) << fixed.err;
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out")) files += entry.is_regular_file() ? 1 : 0;
  EXPECT_EQ(files, 1u);
  EXPECT_FALSE(fs::exists(folder_ / "out/include_parameter.k"));
  fs::copy(folder_ / "out", folder_ / "data", fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  EXPECT_EQ(gapcheck("audit data/include_parameter.k --select GC101 --fail-on warning --quiet").code, 0);
}

TEST_F(FixProgram, NeverWritesOverTheDeck) {
  const std::string before = content(folder_ / "data/two_plates.k");
  fs::create_directory_symlink(folder_ / "data", folder_ / "link");
  for (const char* place : {"data", "data/../data", "link"}) {
    const Ended fixed = gapcheck(std::string("fix data/two_plates.k -o ") + place);
    EXPECT_EQ(fixed.code, 2);
    EXPECT_NE(fixed.err.find("is a file of the deck itself"), std::string::npos) << fixed.err;
  }
  EXPECT_EQ(content(folder_ / "data/two_plates.k"), before);
}

TEST_F(FixProgram, NotEvenUnderAnotherName) {
  const std::string before = content(folder_ / "data/two_plates.k");
  fs::create_directory(folder_ / "copy");
  fs::create_hard_link(folder_ / "data/two_plates.k", folder_ / "copy/two_plates.k");
  EXPECT_EQ(gapcheck("fix data/two_plates.k -o copy").code, 2);
  EXPECT_EQ(content(folder_ / "data/two_plates.k"), before);
}

TEST_F(FixProgram, RefusesGeometryThatIsNotRead) {
  std::string deck = content(folder_ / "data/two_plates.k");
  deck.insert(deck.find("*END"), "*PART_MOVE\n         2       0.0       0.0       5.0\n");
  std::ofstream(folder_ / "moved.k") << deck;
  const Ended fixed = gapcheck("fix moved.k -o out");
  EXPECT_EQ(fixed.code, 2);
  EXPECT_NE(fixed.err.find("*PART_MOVE moves nodes after their lines are read"), std::string::npos) << fixed.err;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(FixProgram, ChoicesMustBeInTheDeck) {
  for (const char* choice : {"--lock 777", "--lock node:9000000", "--priority 888=5"}) {
    const Ended fixed = gapcheck(std::string("fix data/two_plates.k --dry-run ") + choice);
    EXPECT_EQ(fixed.code, 2) << choice;
    EXPECT_NE(fixed.err.find("the deck has no such"), std::string::npos) << fixed.err;
  }
}

TEST_F(FixProgram, DryRunSaysTheSameAndWritesNothing) {
  EXPECT_EQ(gapcheck("fix data/two_plates.k").code, 2);
  const Ended dry = gapcheck("fix data/two_plates.k --dry-run --format json");
  EXPECT_EQ(dry.code, 0);
  const Ended wet = gapcheck("fix data/two_plates.k -o out --format json");
  auto a = nlohmann::json::parse(dry.out), b = nlohmann::json::parse(wet.out);
  EXPECT_EQ(a["schema"], "gapcheck-fix/1");
  EXPECT_EQ(a["moved"].size(), 32u);
  EXPECT_TRUE(a["dry_run"]);
  EXPECT_EQ(b["files"][0]["written"], "out/two_plates.k");
  for (auto* json : {&a, &b}) {
    json->erase("dry_run");
    json->erase("files");
  }
  EXPECT_EQ(a, b);
  EXPECT_EQ(gapcheck("fix data/two_plates.k --dry-run --format json --jobs 1").out, dry.out);
}

TEST_F(FixProgram, SaysWhatRemains) {
  const Ended locked = gapcheck("fix data/two_plates.k -o out --lock 1,2");
  EXPECT_EQ(locked.code, 1);
  EXPECT_NE(locked.out.find("18 nodes not freed by any movement"), std::string::npos) << locked.out;
  EXPECT_NE(locked.out.find("locked"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "out/two_plates.k"));
  EXPECT_EQ(gapcheck("fix data/two_plates.k --dry-run --lock 1 --lock node:2001-2016").code, 1);
  EXPECT_EQ(gapcheck("fix data/two_plates.k --dry-run --lock 1 --priority 2=10").code, 0);
}

TEST_F(FixProgram, ThePageShowsWhatAVerifiedCorrectionPrints) { EXPECT_EQ(examples_hold("fix.md", "verify"), 1); }

TEST_F(FixProgram, ARunProvesTheCorrection) {
  const Ended proven = gapcheck("fix data/contact_chain.k --dry-run --verify --cycles 50 --format json");
  EXPECT_EQ(proven.code, 0) << proven.err;
  const auto proof = nlohmann::json::parse(proven.out)["proof"];
  EXPECT_TRUE(proof["holds"]);
  EXPECT_EQ(proof["before"]["moved_at_start"], 9);
  EXPECT_EQ(proof["before"]["forced_at_start"], 9);
  EXPECT_NEAR(proof["before"]["start_energy"], 2795.43, 0.01);
  EXPECT_EQ(proof["after"]["moved_at_start"], 0);
  EXPECT_EQ(proof["after"]["start_energy"], 0);
  EXPECT_EQ(proof["after"]["cycles"], 50);
  // What cannot be moved still pushes, and the run shows it.
  const Ended locked = gapcheck("fix data/snlog_1.k --dry-run --verify --cycles 5 --lock 1,2 --format json");
  EXPECT_EQ(locked.code, 1);
  EXPECT_FALSE(nlohmann::json::parse(locked.out)["proof"]["holds"]);
}

TEST_F(FixProgram, ADeckThatIsNotCalculatedIsNotProven) {
  std::string deck = content(folder_ / "data/two_plates.k");
  deck.insert(deck.find("*END"), "*AIRBAG_ADIABATIC_GAS_MODEL\n1,0\n1.,1.\n");
  std::ofstream(folder_ / "airbag.k") << deck;
  const Ended refused = gapcheck("fix airbag.k --dry-run --verify");
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.out.find("the corrected deck cannot be run: airbag.k:"), std::string::npos) << refused.out;
  EXPECT_EQ(gapcheck("fix airbag.k --dry-run --verify --cycles 5 --ignore-unsupported").code, 0);
  EXPECT_EQ(gapcheck("fix data/two_plates.k --dry-run --cycles 5").code, 2) << "only with --verify";
}

TEST_F(FixProgram, RefusesWhatItDoesNotUnderstand) {
  for (const char* bad : {"--lock x", "--lock 5-3", "--lock node:", "--lock -1", "--priority 1", "--priority 1=0",
                          "--priority 1=nan", "--format xml"})
    EXPECT_EQ(gapcheck(std::string("fix data/two_plates.k --dry-run ") + bad).code, 2) << bad;
  EXPECT_EQ(gapcheck("fix data/missing.k --dry-run").code, 2);
  EXPECT_EQ(gapcheck("fix data --dry-run").code, 2);
}

}  // namespace
}  // namespace gapcheck::fix_test
