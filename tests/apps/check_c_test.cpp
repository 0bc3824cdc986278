// check-c as users and scripts see it: every option with its expected text, exit codes, files.
#include <utility>
#include <vector>

#include "program.hpp"
#include "results/d3plot_sample.hpp"

namespace gapcheck::check_c_test {
namespace {

class CheckC : public Program {
 protected:
  /// The deck of the fixtures, relative to no folder.
  static inline const std::string deck = "--deck '" + (project / "data/two_plates.k").string() + "' ";
};

TEST_F(CheckC, EveryOptionHasItsText) {
  use("smp");
  const std::vector<std::pair<std::string, std::string>> cases{
      {"default", ""},
      {"list", "-list"},
      {"top", "-top 2"},
      {"top_0", "-top 0"},
      {"ptol", "-ptol 0.2"},
      {"sid", "-sid 2,4"},
      {"bucket", "-bucket -sid 1"},
      {"bucket_rsort", "-bucket -rsort -sid 1"},
      {"pid", deck + "-pid"},
      {"psum", deck + "-psum"},
      {"rsort", "-rsort"},
      {"rtol", "-rtol 0.7"},
      {"title", "-title"},
      {"typ", "-typ"},
      {"type", "-type"},
      {"timestep", "-timestep"},
      {"all", "-all"},
      {"all_timestep_typ", "-all -timestep -typ -title"},
  };
  for (const auto& [name, options] : cases) {
    const Ended run = check_c(options + " messag");
    EXPECT_EQ(run.code, 1) << name;
    EXPECT_EQ(run.err, "") << name;
    expect_golden("check_c_" + name, run.out);
  }
  for (const char* other : {"-typkey", "-typ -typ", "-typ -title -typ -typ"}) {
    const std::string title = std::string(other).find("-title") == std::string::npos ? "" : "-title ";
    EXPECT_EQ(check_c(std::string(other) + " messag").out, check_c(title + "-type messag").out) << other;
  }
  EXPECT_NE(check_c("-typ -type messag").out, check_c("-type messag").out) << "code and keyword";
}

TEST_F(CheckC, EverySelectionHasItsText) {
  use("soft2");
  for (const char* word :
       {"tied",  "sep", "offset", "far", "short", "notfound", "rigslav", "rigmast", "conflict", "untied",
        "typ13", "pen", "mid",    "del", "below", "soft2",    "inter",   "war",     "first",    "last"}) {
    const Ended run = check_c(std::string("-list -sel ") + word + " messag");
    const bool none = std::string(word) == "far" || std::string(word) == "notfound" || std::string(word) == "pen";
    EXPECT_EQ(run.code, none ? 0 : 1) << word;
    expect_golden(std::string("check_c_sel_") + word, run.out);
  }
}

TEST_F(CheckC, SeveralFilesOfAnMppRun) {
  use("mpp");
  const Ended run = check_c("mes0000 mes0001");
  EXPECT_EQ(run.code, 1);
  expect_golden("check_c_mpp", run.out);
}

TEST_F(CheckC, ExitCodes) {
  use("clean");
  EXPECT_EQ(check_c("messag").code, 0);
  EXPECT_EQ(check_c("-all messag").code, 0);
  EXPECT_EQ(check_c("no-such-file").code, 2);
  EXPECT_EQ(check_c("-hsp no-such-file messag").code, 2);
  EXPECT_EQ(check_c("--messages no-such-file messag").code, 2);
  EXPECT_EQ(check_c("-pid messag").code, 2) << "parts were asked for and cannot be had";
  EXPECT_EQ(check_c("-g no-such-file messag").code, 2);
  EXPECT_EQ(check_c("--deck no-such-file messag").code, 2);
  EXPECT_EQ(check_c("'" + file("empty", "") + "'").code, 2);
  EXPECT_EQ(check_c(".").code, 2);
  if (std::filesystem::exists("/dev/full")) {
    EXPECT_EQ(check_c("messag >/dev/full").code, 2);
  }
}

TEST_F(CheckC, UsageWithoutArguments) {
  const Ended usage = check_c("");
  EXPECT_EQ(usage.code, 2);
  EXPECT_TRUE(usage.out.starts_with("usage: check-c [options] messag-file[s]\noptions:\n")) << usage.out;
  expect_golden("check_c_usage", usage.out);
  for (const char* help : {"-help", "-h", "--help"}) {
    EXPECT_EQ(check_c(help).code, 0);
    EXPECT_EQ(check_c(help).out, usage.out);
  }
  for (const char* option : {"-list",     "-top ##",     "-ptol ##", "-sid #,#",    "-bucket",    "-pid",  "-psum",
                             "-rsort",    "-rtol ##",    "-title",   "-hsp <file>", "-typ ",      "-type", "-timestep",
                             "-all",      "-g <d3plot>", "-ani",     "-a4sel",      "-sel <typ>", "-key",  "-medina",
                             "-mnode ##", "-version",    "--deck",   "--messages"})
    EXPECT_NE(usage.out.find(std::string("\n  ") + option), std::string::npos) << option;
}

TEST_F(CheckC, Version) {
  for (const char* option : {"-version", "--version"}) {
    EXPECT_EQ(check_c(option).code, 0);
    EXPECT_TRUE(check_c(option).out.starts_with("check-c ")) << option;
  }
}

TEST_F(CheckC, BadArgumentsSayWhatIsWrong) {
  use("smp");
  for (const char* arguments : {"-lst messag",         "-list",
                                "messag -top",         "-top -list messag",
                                "-top x messag",       "-top -1 messag",
                                "-top 1.5 messag",     "-ptol nan messag",
                                "-ptol -1 messag",     "-rtol x messag",
                                "-sid x messag",       "-sid , messag",
                                "-sid 1,x messag",     "-sid 99999999999999999999 messag",
                                "-sel nothing messag", "-sel '' messag",
                                "-mnode 0 messag",     "-ani -a4sel messag",
                                "-hsp '' messag",      "--frobnicate messag",
                                "--jobs -1 messag"}) {
    const Ended run = check_c(arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_TRUE(run.err.starts_with("check-c: error: ")) << arguments << ": " << run.err;
  }
}

TEST_F(CheckC, AnUnknownInterfaceIsMentioned) {
  use("smp");
  const Ended run = check_c("-sid 1,77 messag");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find("warning: -sid 77"), std::string::npos) << run.err;
  EXPECT_EQ(check_c("--quiet -sid 1,77 messag").err, "");
}

TEST_F(CheckC, TitlesOfAnotherD3hsp) {
  use("smp");
  std::filesystem::rename(folder_ / "d3hsp", folder_ / "other");
  EXPECT_EQ(check_c("-title messag").out.find("all parts"), std::string::npos);
  EXPECT_NE(check_c("-title -hsp other messag").out.find("interface 1 \"all parts\""), std::string::npos);
}

TEST_F(CheckC, ADamagedFileGivesWhatCanBeReadAndTwo) {
  use("smp");
  const std::string text = content(folder_ / "messag");
  file("cut", text.substr(0, text.find("     penetrated segment nodes", text.find("= 2002"))));
  const Ended run = check_c("cut");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.out.find("1006"), std::string::npos);
  EXPECT_TRUE(run.err.starts_with("check-c: error: cut:")) << run.err;
}

TEST_F(CheckC, UserAdditionsToTheMessageKinds) {
  use("smp");
  file("kinds.txt", "kind soft2-intersection\ncodes 49999\n");
  const Ended run = check_c("-sel inter -list --messages kinds.txt messag");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.out.find("49999"), std::string::npos) << run.out;
  EXPECT_EQ(check_c("-sel inter -list messag").code, 0);
}

TEST_F(CheckC, FilesForPostProcessors) {
  use("smp");
  const Ended key = check_c("-key -medina -a4sel -mnode 500 messag");
  EXPECT_EQ(key.code, 1) << key.err;
  EXPECT_TRUE(key.out.ends_with("check-c.key written\ncheck-c.ses written\ncheck-c.prt written\n")) << key.out;
  EXPECT_NE(content(folder_ / "check-c.key").find("*ELEMENT_BEAM"), std::string::npos);
  EXPECT_NE(content(folder_ / "check-c.ses").find("sel nod"), std::string::npos);
  EXPECT_NE(content(folder_ / "check-c.prt").find("500"), std::string::npos);
  EXPECT_EQ(check_c("-ani messag").code, 1);
  EXPECT_NE(content(folder_ / "check-c.ses").find("ide nod"), std::string::npos);
  EXPECT_EQ(content(folder_ / "check-c.ses").find("sel nod"), std::string::npos);
}

TEST_F(CheckC, FilesHoldWhatWasPicked) {
  use("smp");
  const auto nodes = [&](const std::string& options) {
    EXPECT_EQ(check_c("-ani " + options + " messag").code, 1);
    return content(folder_ / "check-c.ses");
  };
  EXPECT_NE(nodes("-sid 1").find("2001"), std::string::npos) << "all nodes, not only those that are shown";
  EXPECT_EQ(nodes("-sid 1 -top 5").find("2001"), std::string::npos);
  EXPECT_EQ(nodes("-sid 1 -ptol 0.1").find("2001"), std::string::npos);
  EXPECT_EQ(nodes("-sel tied").find("1006"), std::string::npos);
}

TEST_F(CheckC, FilesThatCannotBeWritten) {
  use("smp");
  std::filesystem::create_directory(folder_ / "check-c.key");
  const Ended run = check_c("-key messag");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("check-c.key: cannot be written"), std::string::npos) << run.err;
}

TEST_F(CheckC, PartsOfAD3plot) {
  results::SampleD3plot plot;
  const std::string node = std::to_string(plot.node_id(0));
  std::string text = content(fixtures / "smp/messag");
  for (std::size_t at = 0; (at = text.find("= 1006", at)) != std::string::npos; ++at) text.replace(at, 6, "= " + node);
  file("messag", text);
  EXPECT_EQ(check_c("-pid messag").code, 2);
  file("d3plot", plot.bytes());
  const Ended beside = check_c("-pid -sid 1 messag");
  EXPECT_EQ(beside.code, 1) << beside.err;
  std::filesystem::rename(folder_ / "d3plot", folder_ / "plot");
  EXPECT_EQ(check_c("-pid -sid 1 -g plot messag").out, beside.out);
  expect_golden("check_c_g", beside.out);
}

TEST_F(CheckC, ARealRun) {
  const auto folder = project / "../shared/decks/tied_plate_with_run";
  if (!std::filesystem::exists(folder / "messag")) GTEST_SKIP() << folder << " is not here";
  const Ended run = check_c("-all -title -typ -timestep -list '" + (folder / "messag").string() + "'");
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* part :
       {"interface 80085 \"Left_on_left_action\"  type 2", "interface 8008 \"Right_on_right_action\"", "type a3",
        "time step 1.669E-07, controlled by node 1 of part 1", "Warning 60303 (IMP)",
        "the time step should not exceed 1.669E-07"})
    EXPECT_NE(run.out.find(part), std::string::npos) << part << '\n' << run.out;
}

}  // namespace
}  // namespace gapcheck::check_c_test
