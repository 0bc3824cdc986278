// The program as scripts see it: exit codes, streams, formats.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "folder_test.hpp"
#include "program_names.hpp"

namespace gapcheck::command_line_test {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int code = -1;
  std::string out, err;
};

std::string content(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class CommandLine : public FolderTest {
 protected:
  /// Runs gapcheck in the project's folder, with arguments as a shell takes them.
  Outcome run(const std::string& arguments) const {
    const fs::path error_file = folder_ / "stderr";
    const std::string command =
        "cd '" GAPCHECK_ROOT "' && " GAPCHECK_PROGRAM " " + arguments + " 2>'" + error_file.string() + "'";
    Outcome outcome;
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return outcome;
    std::array<char, 4096> buffer{};
    for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
      outcome.out.append(buffer.data(), n);
    const int status = ::pclose(pipe);
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -2;
    outcome.err = content(error_file);
    return outcome;
  }

  std::string file(const std::string& name, const std::string& text) const {
    const fs::path path = folder_ / name;
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }
};

TEST_F(CommandLine, ExitCodeFollowsFailOn) {
  EXPECT_EQ(run("audit data/clean.k --fail-on note").code, 0);
  EXPECT_EQ(run("audit data/two_plates.k").code, 0) << "warnings alone";
  EXPECT_EQ(run("audit data/two_plates.k --fail-on warning").code, 1);
  EXPECT_EQ(run("audit data/deep_node_released.k").code, 1);
  EXPECT_EQ(run("audit data/deep_node_released.k --fail-on never").code, 0);
}

TEST_F(CommandLine, BadArgumentsGiveTwoAndNothingOnStandardOutput) {
  for (const char* arguments : {"",
                                "audit",
                                "frobnicate",
                                "audit data/clean.k --no-such-option",
                                "audit data/clean.k --html",
                                "audit data/clean.k --format xml",
                                "audit data/clean.k --top -1",
                                "audit data/clean.k --jobs -1",
                                "audit data/clean.k --ptol nan",
                                "audit data/clean.k --ptol=-1",
                                "audit data/clean.k --units furlong",
                                "audit data/clean.k --contact x",
                                "audit data/clean.k --contact 99999999999999999999",
                                "audit data/clean.k --select no-such-rule",
                                "audit data/clean.k data/two_plates.k --html page.html",
                                "explain no-such-rule",
                                "explain",
                                "messag x",
                                "compare a b",
                                "run x",
                                "fix x"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_TRUE(outcome.err.starts_with("gapcheck: error: ")) << arguments << ": " << outcome.err;
  }
}

TEST_F(CommandLine, InputThatCannotBeReadGivesTwo) {
  const Outcome missing = run("audit no-such-file.k");
  EXPECT_EQ(missing.code, 2);
  EXPECT_TRUE(missing.err.starts_with("gapcheck: error: no-such-file.k: ")) << missing.err;
  EXPECT_EQ(run("audit .").code, 2);
  EXPECT_EQ(run("audit '" + file("empty.k", "") + "'").code, 2);
}

TEST_F(CommandLine, ErrorsInTheInputNameFileAndLineAndTheReportIsStillWritten) {
  const std::string deck = file("broken.k", "*KEYWORD\n*INCLUDE\nmissing.k\n*END\n");
  const Outcome outcome = run("audit --format json '" + deck + "'");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("gapcheck: error: " + deck + ":"), std::string::npos) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["schema"], "gapcheck/1");
  const Outcome skipped = run("audit --missing-includes skip '" + deck + "'");
  EXPECT_EQ(skipped.code, 0) << skipped.err;
  EXPECT_NE(skipped.err.find("gapcheck: warning: "), std::string::npos);
  EXPECT_EQ(run("audit --quiet --missing-includes skip '" + deck + "'").err, "");
}

TEST_F(CommandLine, AFieldThatIsNoNumberIsMarkedInItsLine) {
  const std::string deck = file("shifted.k", "*SECTION_SHELL\n         1         2\n    1.0 2.0\n*END\n");
  const Outcome outcome = run("audit '" + deck + "'");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("move them\n        1.0 2.0\n    ^^^^^^^^^^\n"), std::string::npos) << outcome.err;
}

TEST_F(CommandLine, ParametersAreGivenByOption) {
  const std::string deck = file("given.k", "*PART\n\n&pid,1,1\n*END\n");
  EXPECT_EQ(run("audit '" + deck + "'").code, 2);
  EXPECT_NE(run("audit '" + deck + "'").err.find("or give it with --param pid=VALUE"), std::string::npos);
  EXPECT_EQ(run("audit '" + deck + "' --param PID=3").code, 0);
  EXPECT_EQ(run("audit '" + deck + "' --param pid").code, 2);
  EXPECT_NE(run("audit '" + deck + "' --param pid=3 --param other=3").err.find("--param other: the deck neither"),
            std::string::npos);
}

TEST_F(CommandLine, AContactThatDoesNotExistIsAnError) {
  EXPECT_EQ(run("audit data/two_plates.k --contact 1").code, 0);
  const Outcome outcome = run("audit data/two_plates.k --contact 1,77");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("77"), std::string::npos);
}

TEST_F(CommandLine, UnitsMakeMillimetresOfTheDeck) {
  // Its shells are 1 thick: a millimetre or a metre.
  const std::string audit = "audit data/two_plates.k --select GC303 --fail-on warning --units ";
  EXPECT_EQ(run(audit + "m-s-kg").code, 0);
  EXPECT_EQ(run(audit + "mm-s-t").code, 0);
  const std::string thin = file("thin.k", R"(*KEYWORD
*MAT_ELASTIC
1,7.85e-9,210000.,0.3
*SECTION_SHELL
1,2
0.4
*PART
part
1,1,1
*NODE
1,0,0,0
2,5,0,0
3,5,5,0
4,0,5,0
*ELEMENT_SHELL
1,1,1,2,3,4
*CONTACT_AUTOMATIC_SINGLE_SURFACE
0,0,5,0
0.
1.,1.
*END
)");
  const std::string select = "audit '" + thin + "' --select GC303 --fail-on warning";
  EXPECT_EQ(run(select).code, 0);  // its material is steel in mm, t and s: an assumption, so a note
  EXPECT_EQ(run(select + " --units mm-s-t").code, 1);
  EXPECT_EQ(run(select + " --units in-s-lbf").code, 0);
}

TEST_F(CommandLine, ListsDoNotSwallowTheDeck) {
  EXPECT_EQ(run("audit --select GC1,GC5 --ignore GC106 --contact 1 --part 1 -I . data/two_plates.k --quiet").code, 0);
}

TEST_F(CommandLine, JsonGoesToTheOutputFile) {
  const fs::path target = folder_ / "report.json";
  const Outcome outcome =
      run("audit data/two_plates.k --select GC101 --format json --output '" + target.string() + "'");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "");
  const auto json = nlohmann::json::parse(content(target));
  EXPECT_EQ(json["input"], "data/two_plates.k");
  EXPECT_EQ(json["findings"].size(), json["summary"]["warnings"]);
  EXPECT_EQ(run("audit data/two_plates.k --output '" + (folder_ / "no" / "where").string() + "'").code, 2);
}

TEST_F(CommandLine, AFullDiskIsNoticed) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
  const Outcome outcome = run("audit data/two_plates.k >/dev/full");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("cannot be written"), std::string::npos);
}

TEST_F(CommandLine, OutputDoesNotDependOnTheNumberOfThreads) {
  for (const char* deck : {"data/two_plates.k", "data/deep_node_released.k", "data/contact_chain.k"}) {
    const std::string base = std::string("audit --list ") + deck;
    const Outcome one = run(base + " --jobs 1"), two = run(base + " --jobs 2"), exact = run(base + " --exact");
    EXPECT_EQ(one.out, two.out);
    EXPECT_EQ(one.out, exact.out);
    EXPECT_EQ(one.code, two.code);
  }
}

TEST_F(CommandLine, QuietLeavesOneLine) {
  const Outcome outcome = run("audit data/two_plates.k --quiet");
  EXPECT_EQ(outcome.out.find('\n'), outcome.out.size() - 1) << outcome.out;
  EXPECT_EQ(outcome.err, "");
}

TEST_F(CommandLine, NoColoursInAPipe) { EXPECT_EQ(run("audit data/two_plates.k").out.find('\x1b'), std::string::npos); }

TEST_F(CommandLine, HelpAndVersion) {
  for (const char* arguments : {"--version", "audit --version"}) {
    EXPECT_EQ(run(arguments).code, 0);
    EXPECT_TRUE(run(arguments).out.starts_with("gapcheck ")) << arguments;
  }
  const Outcome help = run("--help");
  EXPECT_EQ(help.code, 0);
  EXPECT_NE(help.out.find("\n  run "), std::string::npos);
  EXPECT_NE(help.out.find("\n  fix "), std::string::npos);
  EXPECT_EQ(run("audit --help").code, 0);
}

TEST_F(CommandLine, RulesAndTheirPages) {
  const Outcome rules = run("rules");
  EXPECT_EQ(rules.code, 0);
  EXPECT_NE(rules.out.find("GC101"), std::string::npos);
  EXPECT_EQ(run("explain GC102").out, content(fs::path(GAPCHECK_ROOT) / "docs/rules/released-node.md"));
  EXPECT_EQ(run("explain Released-Node").out, run("explain GC102").out);
  EXPECT_EQ(run("explain RELEASED").out, run("explain GC102").out) << "one rule has it";
  const Outcome several = run("explain moved");
  EXPECT_EQ(several.code, 0);
  EXPECT_TRUE(several.out.starts_with("GC112 moved-into-another: ")) << several.out;
  EXPECT_NE(several.out.find("\nGC204 tie-moved: "), std::string::npos) << several.out;
  EXPECT_EQ(std::count(several.out.begin(), several.out.end(), '\n'), 2) << several.out;
  EXPECT_EQ(run("explain tie").out.find("GC101"), std::string::npos);
}

TEST_F(CommandLine, SaysWhatWasProbablyMeant) {
  for (const auto& [arguments, meant] :
       {std::pair("audti data/clean.k", "there is no command 'audti'; did you mean audit? "),
        std::pair("audit data/clean.k --formt json", "did you mean --format? See gapcheck audit --help"),
        std::pair("fix data/clean.k --dryrun=1", "did you mean --dry-run? "),
        std::pair("audit data/clean.k --select initial-penetraton", "did you mean initial-penetration?"),
        std::pair("messag x --select enrgy-ratio", "did you mean energy-ratio?"),
        std::pair("explain inital-penetration", "did you mean initial-penetration?")}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_NE(outcome.err.find(meant), std::string::npos) << outcome.err;
  }
  for (const char* arguments : {"frobnicate", "audit data/clean.k --zzzzzz", "explain GC999"})
    EXPECT_EQ(run(arguments).err.find("did you mean"), std::string::npos) << run(arguments).err;
}

TEST_F(CommandLine, NothingIsSelectedThatTheDeckDoesNotHave) {
  for (const std::string option : {"--part", "--contact"}) {
    const Outcome one = run("audit data/two_plates.k " + option + " 1,99");
    EXPECT_EQ(one.code, 2);
    EXPECT_EQ(one.err, "gapcheck: error: " + option + " 99: the deck has no such " + option.substr(2) + "\n");
    EXPECT_EQ(run("audit data/two_plates.k " + option + " 1").err, "");
  }
  const Outcome several = run("audit data/two_plates.k data/clean.k --part 99,2");
  EXPECT_EQ(several.code, 2);
  EXPECT_EQ(several.err, "gapcheck: error: --part 99: none of the decks has such a part\n");
}

TEST_F(CommandLine, OnlyWhatIsNewOrWorseThanTheBaselineCounts) {
  const std::string deck = file("deck.k", content(fs::path(GAPCHECK_ROOT) / "data/two_plates.k"));
  const std::string base = (folder_ / "deck.baseline").string();
  EXPECT_EQ(run("audit '" + deck + "' --fail-on warning --write-baseline '" + base + "'").code, 1);
  const std::string written = content(base);
  EXPECT_TRUE(written.starts_with("{\"schema\":\"gapcheck-baseline/1\"}\n"));
  const Outcome known = run("audit '" + deck + "' --fail-on note --quiet --baseline '" + base + "'");
  EXPECT_EQ(known.code, 0);
  EXPECT_NE(known.out.find("; against the baseline: 0 new, 0 worse, "), std::string::npos) << known.out;
  std::string deeper = content(deck);
  for (std::size_t at = 0; (at = deeper.find("             0.7\n", at)) != deeper.npos; ++at) deeper[at + 15] = '6';
  file("deck.k", deeper);
  const Outcome worse = run("audit '" + deck + "' --fail-on warning --baseline '" + base + "'");
  EXPECT_EQ(worse.code, 1);
  EXPECT_NE(worse.out.find("against the baseline: 0 new, 18 worse, "), std::string::npos) << worse.out;
  EXPECT_EQ(run("audit '" + deck + "' --select GC5 --baseline '" + base + "'").out.find("  gone\n"), std::string::npos);
  EXPECT_EQ(run("audit data/clean.k --baseline '" + base + "'").code, 0);
  EXPECT_EQ(content(base), written);
}

TEST_F(CommandLine, ABaselineThatCannotBeReadOrWrittenGivesTwo) {
  const Outcome missing = run("audit data/clean.k --baseline no-such-file");
  EXPECT_EQ(missing.code, 2);
  EXPECT_EQ(missing.out, "");
  const std::string bad = file("bad.baseline", "{\"schema\":\"gapcheck-baseline/1\"}\n{\"id\":3}\n");
  EXPECT_TRUE(run("audit data/clean.k --baseline '" + bad + "'").err.starts_with("gapcheck: error: " + bad + ":2: "));
  EXPECT_EQ(run("audit data/clean.k --write-baseline no-such-folder/b").code, 2);
  const std::string deck = file("broken.k", "*KEYWORD\n*INCLUDE\nno-such-include.k\n*END\n");
  const std::string never = (folder_ / "never").string();
  EXPECT_EQ(run("audit '" + deck + "' --write-baseline '" + never + "'").code, 2);
  EXPECT_FALSE(fs::exists(never));
}

}  // namespace
}  // namespace gapcheck::command_line_test
