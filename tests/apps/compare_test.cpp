// gapcheck compare as users and scripts see it.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "audit/audit.hpp"
#include "program.hpp"
#include "results/write_messag.hpp"

namespace gapcheck {
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
}  // namespace gapcheck
