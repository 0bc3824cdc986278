// gapcheck compare as users and scripts see it.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "audit/audit.hpp"
#include "program.hpp"
#include "results/log/write_messag.hpp"

namespace gapcheck::compare_test {
namespace {

namespace fs = std::filesystem;

class Compare : public Program {
 protected:
  static std::string data(const std::string& name) { return "'" + (project / "data" / name).string() + "'"; }

  /// What the solver would write if it found what the audit finds.
  static std::string predicted(const fs::path& deck) {
    Diagnostics diagnostics;
    const auto report = audit::audit_deck(deck.string(), {}, diagnostics);
    return report ? results::write_messag(report.value()) : "";
  }
};

TEST_F(Compare, ADeckAgreesWithItself) {
  const Ended run = gapcheck("compare " + data("two_plates.k") + " " + data("two_plates.k"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("no differences, 18 nodes agree"), std::string::npos) << run.out;
}

TEST_F(Compare, EveryExampleAgreesWithItsPredictedMessag) {
  std::vector<fs::path> decks;
  for (const auto& entry : fs::directory_iterator(project / "data"))
    if (entry.path().extension() == ".k") decks.push_back(entry.path());
  ASSERT_GT(decks.size(), 20u);
  std::size_t compared = 0;
  for (const fs::path& deck : decks) {
    file("messag", predicted(deck));
    if (content(folder_ / "messag").find("40565") == std::string::npos) continue;
    const Ended run = gapcheck("compare '" + deck.string() + "' messag");
    EXPECT_EQ(run.code, 0) << deck << '\n' << run.out << run.err;
    ++compared;
  }
  EXPECT_GT(compared, 15u);
}

TEST_F(Compare, AMissingNodeAnExtraOneAndAnotherDepth) {
  const fs::path deck = project / "data/two_plates.k";
  std::string text = predicted(deck);
  const auto replace = [&](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  };
  replace("penetrating node #                     = 1006", "penetrating node #                     = 1999");
  replace("-3.0000E-01", "-3.1000E-01");  // the first block, which is now node 1999
  const std::size_t second = text.find("= 1007");
  text.replace(text.find("-3.0000E-01", second), 11, "-3.0500E-01");
  file("messag", text);
  const std::string both = "compare '" + deck.string() + "' messag";
  const Ended run = gapcheck(both);
  EXPECT_EQ(run.code, 1) << run.err;
  const auto json = nlohmann::json::parse(gapcheck(both + " --format json").out);
  EXPECT_EQ(json["contacts"][0]["agree"], 16);
  EXPECT_EQ(json["contacts"][0]["depth_differs"], 1);
  EXPECT_EQ(json["contacts"][0]["only_first"], 1);
  EXPECT_EQ(json["contacts"][0]["only_second"], 1);
  EXPECT_EQ(nlohmann::json::parse(gapcheck(both + " --format json --tol 0.01").out)["contacts"][0]["depth_differs"], 0);
  EXPECT_NE(gapcheck(both + " --top 1").out.find("3 nodes differ, largest 1"), std::string::npos);
}

TEST_F(Compare, ContactsThatTheAuditDoesNotCheckAreNotCompared) {
  file("messag", predicted(project / "data/two_plates.k"));
  const Ended run = gapcheck("compare " + data("soft2_not_checked.k") + " messag");
  EXPECT_EQ(run.code, 0) << run.out;
  EXPECT_NE(run.out.find("not compared"), std::string::npos) << run.out;
}

TEST_F(Compare, Directories) {
  fs::create_directory(folder_ / "smp");
  fs::copy(fixtures / "smp", folder_ / "smp");
  fs::create_directory(folder_ / "mpp");
  fs::copy(fixtures / "mpp", folder_ / "mpp");
  EXPECT_EQ(gapcheck("compare smp smp/messag").code, 0);
  EXPECT_EQ(gapcheck("compare mpp mpp").code, 0);
  EXPECT_EQ(gapcheck("compare smp mpp").code, 1);
  fs::create_directory(folder_ / "none");
  const Ended run = gapcheck("compare smp none");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("none: the directory has no messag"), std::string::npos) << run.err;
}

// The same deck calculated with and without the shooting node logic: the records agree, the energies do not.
TEST_F(Compare, CurvesOfTwoRuns) {
  for (const char* name : {"0", "1"})
    ASSERT_EQ(gapcheck("run " + data("workshop/penetration_snlog_" + std::string(name) + ".k") + " -o run" + name).code,
              0);
  const Ended same = gapcheck("compare run0 run0");
  EXPECT_EQ(same.code, 0) << same.out;
  EXPECT_NE(same.out.find(" compared, 0 differ"), std::string::npos) << same.out;
  const Ended run = gapcheck("compare run0 run1 --top 3 --svg plots");
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_NE(run.out.find("glstat sliding interface energy"), std::string::npos) << run.out;
  EXPECT_TRUE(fs::exists(folder_ / "plots/glstat_sliding_interface_energy.svg"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "plots"), {}), 3);
  const auto json = nlohmann::json::parse(gapcheck("compare run0 run1 --format json").out);
  EXPECT_EQ(json["equal"], false);
  EXPECT_TRUE(json["differences"].empty());
  EXPECT_GT(json["curves"]["differ"], 5);
  EXPECT_EQ(gapcheck("compare run0 run1 --no-curves").code, 0);
  EXPECT_EQ(gapcheck("compare run0 run1/messag").code, 0) << "a file stands for itself";
  EXPECT_EQ(gapcheck("compare run0 run1 --curve-tol 2").code, 0);
  EXPECT_EQ(gapcheck("compare run0 run1 --curves 'external work' --svg chosen").code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "chosen/glstat_external_work.svg")) << "named curves are plotted, equal or not";
  EXPECT_EQ(gapcheck("compare run0 run1 --curves friction,misspelt").code, 0);
  EXPECT_EQ(gapcheck("compare run0 run1 --curves misspelt").code, 2);
  EXPECT_EQ(gapcheck("compare run0 run1/messag --svg plots").code, 2);
  EXPECT_EQ(gapcheck("compare run0 run1 --curve-tol -1").code, 2);
}

TEST_F(Compare, PageFilterAndMotionOfTwoRuns) {
  for (const char* name : {"0", "1"})
    ASSERT_EQ(gapcheck("run " + data("workshop/penetration_snlog_" + std::string(name) + ".k") + " -o run" + name).code,
              0);
  EXPECT_EQ(gapcheck("compare run0 run1 --html page.html").code, 1);
  const std::string page = content(folder_ / "page.html");
  for (const char* part : {"The two differ", "glstat sliding interface energy", "<svg", "Motion: 1 of 2 parts"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  const auto json = nlohmann::json::parse(gapcheck("compare run0 run1 --format json").out);
  EXPECT_EQ(json["motion"]["differ"], 1);
  EXPECT_EQ(json["motion"]["times"].size(), json["motion"]["parts"][0]["largest"].size());
  EXPECT_LT(json["curves"]["pairs"][0]["rating"]["overall"], 0.5);
  const std::string velocity = "compare run0 run1 --curves 'node 2001 z-velocity' --format json";
  const auto largest = [&](const std::string& options) {
    return nlohmann::json::parse(gapcheck(velocity + options).out)["curves"]["pairs"][0]["largest_second"]
        .get<double>();
  };
  EXPECT_NE(largest(" --filter CFC60 --time-unit s"), largest(""));
  EXPECT_NE(largest(" --filter CFC60 --time-unit ms"), largest(" --filter CFC60 --time-unit s"));
  EXPECT_EQ(gapcheck("compare run0 run1 --filter CFC60").code, 2) << "a unit of time is missing";
  EXPECT_EQ(gapcheck("compare run0 run1 --filter CFC61 --time-unit s").code, 2);
  EXPECT_EQ(gapcheck("compare run0 run1 --time-unit s").code, 2);
  EXPECT_EQ(gapcheck("compare run0 run1 --html run0/glstat").code, 2) << "an input is not overwritten";
}

TEST_F(Compare, FilesOfOneRunAloneAreNamed) {
  ASSERT_EQ(gapcheck("run " + data("workshop/penetration_snlog_0.k") + " -o run0").code, 0);
  fs::copy(folder_ / "run0", folder_ / "half");
  fs::remove(folder_ / "half/sleout");
  const Ended run = gapcheck("compare run0 half");
  EXPECT_EQ(run.code, 0);
  EXPECT_NE(run.out.find("only in A: sleout\n"), std::string::npos) << run.out;
  file("half/glstat", content(folder_ / "run0/glstat").substr(0, 3000) + "*****");
  const Ended cut = gapcheck("compare run0 half");
  EXPECT_EQ(cut.code, 0);
  EXPECT_NE(cut.err.find("glstat:"), std::string::npos) << cut.err;
}

TEST_F(Compare, UntiedNodesOfADeckAgreeWithItsPredictedMessag) {
  const fs::path deck = project / "data/tied_then_contact.k";
  std::string text = predicted(deck);
  file("messag", text);
  const Ended run = gapcheck("compare '" + deck.string() + "' messag");
  EXPECT_EQ(run.code, 0) << run.out;
  EXPECT_NE(run.out.find("untied nodes of contact"), std::string::npos) << run.out;
}

TEST_F(Compare, ADeckIsRecognisedByItsFirstLine) {
  file("model", "$ a comment\n\n" + content(project / "data/two_plates.k"));
  EXPECT_EQ(gapcheck("compare model " + data("two_plates.k")).code, 0);
}

TEST_F(Compare, ExitCodes) {
  EXPECT_EQ(gapcheck("compare").code, 2);
  EXPECT_EQ(gapcheck("compare " + data("two_plates.k")).code, 2);
  EXPECT_EQ(gapcheck("compare " + data("two_plates.k") + " no-such-file").code, 2);
  EXPECT_EQ(gapcheck("compare " + data("two_plates.k") + " " + data("clean.k") + " --tol nan").code, 2);
  EXPECT_EQ(gapcheck("compare " + data("two_plates.k") + " " + data("clean.k") + " --contact 77").code, 2);
}

}  // namespace
}  // namespace gapcheck::compare_test
