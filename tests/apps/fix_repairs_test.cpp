// `gapcheck fix --plan`, `--apply` and `--best` as users and scripts see them.
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace gapcheck::fix_repairs_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class FixRepairs : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    fs::copy(project / "data", folder_ / "data", fs::copy_options::recursive);
  }

  /// Penetrations that an audit finds, those that stay without force left out.
  std::size_t penetrations(const std::string& deck) const {
    std::size_t count = 0;
    const Json report = Json::parse(gapcheck("audit " + deck + " --select GC101,GC102 --format json").out);
    for (const Json& finding : report["findings"])
      if (finding.value("outcome", "") != "kept" && finding.contains("node"))
        count += finding.value("count", std::size_t{1});
    return count;
  }
};

TEST_F(FixRepairs, ThePlanWritesNothing) {
  const std::string before = content(folder_ / "data/two_plates.k");
  const Ended planned = gapcheck("fix data/two_plates.k --plan");
  EXPECT_EQ(planned.code, 1) << planned.err;
  EXPECT_NE(planned.out.find("best: 1-move\n"), std::string::npos) << planned.out;
  EXPECT_EQ(content(folder_ / "data/two_plates.k"), before);
  EXPECT_EQ(gapcheck("fix data/clean.k --plan").code, 0);
  EXPECT_EQ(gapcheck("fix data/clean.k --best -o out --quiet").out,
            "0 penetrations before, 0 after; nothing changed\n");
}

TEST_F(FixRepairs, AppliedRepairsAreShownBeforeAndAfter) {
  const Ended moved = gapcheck("fix data/two_plates.k --apply 1-move --dry-run --html page.html --vtu grid.vtu");
  EXPECT_EQ(moved.code, 0) << moved.err;
  EXPECT_NE(content(folder_ / "page.html").find("\"moved_points\":"), std::string::npos);
  EXPECT_NE(content(folder_ / "page.html").find("18 penetrations before, 0 after"), std::string::npos);
  EXPECT_NE(content(folder_ / "grid.vtu").find("Name=\"move\""), std::string::npos);
  EXPECT_EQ(gapcheck("fix data/two_plates.k --apply 1-optt --dry-run --html page.html").code, 0);
  EXPECT_EQ(content(folder_ / "page.html").find("\"moved_points\":"), std::string::npos) << "no node moves";
}

TEST_F(FixRepairs, SegmentsAreMovedToo) {
  for (const char* name : {"soft2_not_checked", "mortar_not_checked"}) {
    const Ended planned = gapcheck(std::string("fix data/") + name + ".k --plan");
    EXPECT_NE(planned.out.find("best: 1-move\n"), std::string::npos) << planned.out;
  }
}

// A fix of SARIF puts texts in as they are: with the line ends of the deck.
TEST_F(FixRepairs, SarifKeepsLineEnds) {
  std::string deck;
  for (const char c : content(folder_ / "data/two_plates.k")) c == '\n' ? deck += "\r\n" : deck += c;
  file("deck.k", deck);
  const Json log = Json::parse(gapcheck("fix deck.k --plan --format sarif").out);
  std::size_t added = 0;
  for (const Json& fix : log["runs"][0]["results"][0]["fixes"]) {
    std::string fixed = deck;
    const Json& replacements = fix["artifactChanges"][0]["replacements"];
    for (auto each = replacements.rbegin(); each != replacements.rend(); ++each) {
      std::size_t begin = 0;
      for (int line = (*each)["deletedRegion"]["startLine"]; line > 1; --line) begin = fixed.find('\n', begin) + 1;
      const std::string text = (*each)["insertedContent"]["text"];
      fixed.replace(begin, fixed.find("\r\n", begin) - begin, text);
      added += text.find('\n') != std::string::npos ? 1 : 0;
    }
    const std::string words = fix["description"]["text"];
    static_cast<void>(gapcheck("fix deck.k --apply " + words.substr(0, words.find(':')) + " -o out --quiet"));
    EXPECT_EQ(fixed, content(folder_ / "out/deck.k")) << words;
  }
  EXPECT_GE(added, 4U) << "lines that replace one line";
}

// Each repair of the plan, applied, leaves what the plan says.
TEST_F(FixRepairs, EveryRepairDoesWhatThePlanSays) {
  for (const char* name : {"two_plates", "include_parameter", "thickness_sst", "solid_on_solid"}) {
    const std::string deck = std::string("data/") + name + ".k";
    const Json plan = Json::parse(gapcheck("fix " + deck + " --plan --format json").out);
    std::size_t tried = 0;
    for (const Json& pair : plan["pairs"])
      for (const Json& repair : pair["repairs"]) {
        if (repair.contains("refused")) continue;
        ++tried;
        const std::string id = repair["id"];
        fs::remove_all(folder_ / "out");
        fs::copy(folder_ / "data", folder_ / "out", fs::copy_options::recursive);
        const Ended applied = gapcheck("fix " + deck + " --apply " + id + " -o changed --format json");
        ASSERT_LT(applied.code, 2) << id << applied.err;
        fs::copy(folder_ / "changed", folder_ / "out",
                 fs::copy_options::recursive | fs::copy_options::overwrite_existing);
        const Json report = Json::parse(applied.out);
        EXPECT_EQ(report["summary"]["complete"].get<bool>(), applied.code == 0) << id;
        std::size_t after = 0;
        for (const Json& contact : report["contacts"]) after += contact["after"]["penetrations"].get<std::size_t>();
        EXPECT_GE(after, repair["left"].get<std::size_t>()) << id;
        if (plan["pairs"].size() == 1) {
          EXPECT_EQ(after, repair["left"].get<std::size_t>() + repair["elsewhere"]["penetrations"].get<std::size_t>())
              << name << " " << id;
        }
        if (after == 0) {
          EXPECT_EQ(penetrations(std::string("out/") + name + ".k"), 0u) << name << " " << id;
        }
      }
    EXPECT_GT(tried, 2u) << name;
  }
}

TEST_F(FixRepairs, TheBestRepairsAreApplied) {
  const Ended best = gapcheck("fix data/contact_chain.k --best -o out");
  EXPECT_EQ(best.code, 0) << best.err << best.out;
  EXPECT_EQ(penetrations("out/contact_chain.k"), 0u);
  EXPECT_NE(best.out.find(" before, 0 after"), std::string::npos) << best.out;
}

TEST_F(FixRepairs, ARunProvesARepair) {
  const Ended proven = gapcheck("fix data/snlog_1.k --apply 1-sst --dry-run --verify --cycles 50");
  EXPECT_EQ(proven.code, 0) << proven.err << proven.out;
  EXPECT_NE(proven.out.find("nothing was written; proven by a run\n"), std::string::npos) << proven.out;
  // With IGNORE the penetration is still there: nothing is pushed, but the contact does not start clean.
  const Ended forgiven = gapcheck("fix data/snlog_1.k --apply 1-ignore --dry-run --verify --cycles 50");
  EXPECT_EQ(forgiven.code, 1);
  EXPECT_NE(forgiven.out.find("1-ignore: 18 penetrations before, 0 after"), std::string::npos) << forgiven.out;
}

TEST_F(FixRepairs, MistakesAreNamed) {
  const auto error = [&](const std::string& options) {
    const Ended ended = gapcheck("fix data/two_plates.k " + options);
    EXPECT_EQ(ended.code, 2) << options;
    return ended.err;
  };
  EXPECT_NE(error("--apply 9-optt -o out").find("there is no repair 9-optt"), std::string::npos);
  EXPECT_NE(error("--apply 1-sst").find("give a directory"), std::string::npos);
  EXPECT_NE(error("--best").find("give a directory"), std::string::npos);
  EXPECT_NE(error("--best --plan").find("--plan"), std::string::npos);
  EXPECT_NE(error("--apply 1-sst -o data").find("is a file of the deck itself"), std::string::npos);
  EXPECT_NE(error("--plan --output data/two_plates.k").find("--output"), std::string::npos);
  EXPECT_EQ(gapcheck("fix missing.k --plan").code, 2);
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(FixRepairs, TheSameForAnyNumberOfJobs) {
  const std::string plan = "fix data/two_plates_tilted.k --plan --format json";
  EXPECT_EQ(gapcheck(plan).out, gapcheck(plan + " --jobs 1").out);
}

TEST_F(FixRepairs, ThePageShowsWhatIsPrinted) { EXPECT_EQ(examples_hold("fix.md", "plan"), 1); }

}  // namespace
}  // namespace gapcheck::fix_repairs_test
