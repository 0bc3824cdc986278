// Decks whose names, titles and line ends are not what a reader expects; keywords that are misspelt.
#include "apps/program.hpp"

namespace gapcheck::hostile_text_test {
namespace {

class HostileText : public Program {
 protected:
  static std::string example() { return content(project / "data/two_plates.k"); }
  static std::string with(std::string text, std::string_view what, std::string_view by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
      text.replace(at, what.size(), by);
    return text;
  }
  [[nodiscard]] Ended in_terminal(const std::string& environment, const std::string& arguments) const {
    return shell(environment + " script -qec \"" GAPCHECK_PROGRAM " " + arguments + "\" /dev/null < /dev/null");
  }
};

/// No line begins with a command of GitHub; blanks in front of it do not count.
void expect_no_command(const std::string& text) {
  for (std::size_t at = 0; at < text.size(); at = std::min(text.find('\n', at), text.size() - 1) + 1) {
    const std::size_t first = std::min(text.find_first_not_of(" \t", at), text.size());
    EXPECT_NE(text.compare(first, 2, "::"), 0) << text.substr(at, 100);
  }
}

TEST_F(HostileText, AMisspeltKeywordIsAnErrorThatNamesTheNearest) {
  for (const auto& [right, wrong] :
       {std::pair{"*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID", "*CONTCT_AUTOMATIC_SINGLE_SURFACE_ID"},
        std::pair{"*ELEMENT_SHELL", "*ELEMNT_SHELL"}, std::pair{"*PART", "*PAT"}}) {
    const std::string text = with(example(), right, wrong);
    ASSERT_NE(text, example());
    const Ended audit = gapcheck("audit " + file("deck.k", text));
    EXPECT_EQ(audit.code, 1) << wrong;
    EXPECT_NE(audit.out.find(std::string(wrong) + " is not a known keyword"), std::string::npos) << audit.out;
    EXPECT_NE(audit.out.find("did you mean " + std::string(right) + "?"), std::string::npos) << audit.out;
    const Ended run = gapcheck("run deck.k -o out");
    EXPECT_EQ(run.code, 2) << wrong;
    EXPECT_NE(run.err.find("did you mean " + std::string(right) + "?"), std::string::npos) << run.err;
    const Ended fix = gapcheck("fix deck.k --dry-run");
    EXPECT_EQ(fix.code, 2) << wrong;
    EXPECT_NE(fix.err.find("did you mean " + std::string(right) + "?"), std::string::npos) << fix.err;
  }
}

TEST_F(HostileText, WhatMayBeSkippedIsNotSkippedMisspelt) {
  const std::string text = with(example(), "*END\n", "*SET_PRT_LIST\n1\n1\n*INCLUD\nmesh.k\n*CONTROL_CONTCT\n\n*END\n");
  const Ended run = gapcheck("run " + file("deck.k", text) + " -o out");
  EXPECT_EQ(run.code, 2);
  for (const char* meant : {"*SET_PART_LIST?", "*INCLUDE?", "*CONTROL_CONTACT?"})
    EXPECT_NE(run.err.find(meant), std::string::npos) << run.err;
}

TEST_F(HostileText, LineEnds) {
  const Ended usual = gapcheck("audit " + file("deck.k", example()));
  EXPECT_EQ(gapcheck("audit " + file("deck.k", with(example(), "\n", "\r\r\n"))).out, usual.out);
  for (const char* end : {"\r", "\u0085", "\u2028", "\u2029"}) {
    const Ended audit = gapcheck("audit " + file("deck.k", with(example(), "\n", end)));
    EXPECT_EQ(audit.code, 2);
    EXPECT_EQ(audit.out, "");
    EXPECT_NE(audit.err.find("Convert the line ends"), std::string::npos) << audit.err;
  }
}

TEST_F(HostileText, FilesThatAreNoDeckAndDecksThatAreNoLog) {
  const Ended audit = gapcheck("audit " + file("notes.txt", "hello\nworld\n"));
  EXPECT_EQ(audit.code, 2);
  EXPECT_EQ(audit.out, "");
  EXPECT_NE(audit.err.find("notes.txt: holds no keyword"), std::string::npos) << audit.err;
  const std::string deck = file("model", example());
  for (const Ended& log : {gapcheck("messag " + deck), check_c(deck)}) {
    EXPECT_EQ(log.code, 2);
    EXPECT_EQ(log.out, "");
    EXPECT_NE(log.err.find("model: is a keyword deck, not a solver's log; use gapcheck audit"), std::string::npos)
        << log.err;
  }
}

TEST_F(HostileText, ADeckWithoutLineEnds) {
  const Ended audit = gapcheck("audit " + file("deck.k", with(example(), "\n", " ")));
  EXPECT_EQ(audit.code, 2);
  EXPECT_EQ(audit.out, "");
  EXPECT_NE(audit.err.find("deck.k:1: holds all its keywords in one line"), std::string::npos) << audit.err;
  // A file of one keyword is nothing special.
  EXPECT_EQ(gapcheck("audit " + file("deck.k", "*KEYWORD 5 * 7, *a\n")).code, 0);
}

TEST_F(HostileText, ADeckThatWasCutBesideALog) {
  use("smp");
  const std::string deck = file("deck.k", with(example(), "*END\n", ""));
  const std::string note = "note: deck.k: ends without *END; if it was cut, what followed is missing\n";
  for (const Ended& run : {gapcheck("messag messag --deck " + deck), check_c("--deck " + deck + " -pid messag")})
    EXPECT_NE(run.err.find(note), std::string::npos) << run.err;
}

TEST_F(HostileText, ADeckThatWasCut) {
  const Ended whole = gapcheck("audit " + file("deck.k", example()));
  EXPECT_EQ(whole.err, "");
  const Ended cut = gapcheck("audit " + file("deck.k", with(example(), "*END\n", "")));
  EXPECT_EQ(cut.err, "gapcheck: note: deck.k: ends without *END; if it was cut, what followed is missing\n");
  EXPECT_EQ(cut.out, whole.out);
  EXPECT_EQ(cut.code, whole.code);
}

TEST_F(HostileText, ControlCharactersOfTitlesAndMessages) {
  std::string text = with(example(), "*END\n",
                          "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n9,\xC2\x9B"
                          "31m\x1b[2J\x9b"
                          "0m\n"
                          "1,0,3\n\n\n*\xC2\x9B"
                          "31m\n*INCLUDE\na\xC2\x9B"
                          "b\n*END\n");
  const Ended audit = gapcheck("audit " + file("deck.k", text));
  EXPECT_NE(audit.out.find("?31m?[2J?0m"), std::string::npos) << audit.out;
  EXPECT_NE(audit.err.find("a?b"), std::string::npos) << audit.err;
  for (const std::string& said : {audit.out, audit.err})
    for (const char* control : {"\x1b", "\xC2\x9B", "\x9b"}) EXPECT_EQ(said.find(control), std::string::npos) << said;
}

TEST_F(HostileText, NamesThatAreCommandsOrFormulas) {
  for (const std::string name : {"::error file=x::y.k", "=cmd.k", "@sum.k"}) {
    file(name, example());
    for (const char* format : {"text", "junit", "csv"}) {
      const Ended audit = gapcheck("audit './" + name + "' './" + name + "' --format " + format + " --stats");
      EXPECT_EQ(audit.code, 0) << audit.err;
      expect_no_command(audit.out);
      expect_no_command(audit.err);
    }
    const Ended text = gapcheck("audit '" + name + "'");
    EXPECT_EQ(text.code, 0) << text.err;
    EXPECT_EQ(text.out.rfind("./" + name + "\n", 0), 0U) << text.out;
    expect_no_command(text.out);
    const Ended table = gapcheck("audit '" + name + "' --format csv");
    EXPECT_EQ(table.out.find("," + name + ","), std::string::npos) << table.out;
    EXPECT_NE(table.out.find(",./" + name + ","), std::string::npos) << table.out;
    const Ended github = gapcheck("audit '" + name + "' --format github");
    for (std::size_t at = 0; at < github.out.size(); at = github.out.find('\n', at) + 1)
      EXPECT_TRUE(github.out.compare(at, 15, "::warning file=") == 0 ||
                  github.out.compare(at, 14, "::notice file=") == 0)
          << github.out.substr(at, 100);
    EXPECT_EQ(github.out.find("::y.k"), std::string::npos) << "colons of properties are escaped";
  }
}

TEST_F(HostileText, ColoursOnlyForTerminalsThatKnowThem) {
  const std::string arguments = "audit " + file("deck.k", example());
  const std::string colour = "\x1b[";
  EXPECT_NE(in_terminal("TERM=xterm NO_COLOR=", arguments).out.find(colour), std::string::npos);
  EXPECT_EQ(in_terminal("TERM=dumb NO_COLOR=", arguments).out.find(colour), std::string::npos);
  EXPECT_EQ(in_terminal("TERM=xterm NO_COLOR=1", arguments).out.find(colour), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::hostile_text_test
