// `gapcheck audit` on several decks.
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace gapcheck::audit_test {
namespace {

namespace fs = std::filesystem;

class AuditProgram : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    fs::create_directories(folder_ / "models/side/lib");
    fs::create_directories(folder_ / "models/.hidden");
    const std::string deck = content(project / "data/two_plates.k");
    file("models/front.k", deck);
    file("models/side/rear.k", "*KEYWORD\n*INCLUDE\nlib/mesh.k\n*END\n");
    file("models/side/lib/mesh.k", deck);
    file("models/.hidden/old.k", deck);
    file("models/notes.txt", "nothing");
  }
  /// The last line, without the decks' own.
  static std::string last_line(const std::string& text) {
    const std::size_t end = text.find_last_not_of('\n');
    return text.substr(text.rfind('\n', end) + 1);
  }
};

TEST_F(AuditProgram, PatternsFindDecksAndNotTheirIncludes) {
  const Ended run = gapcheck("audit 'models/**/*.k' --quiet");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out,
            "models/front.k: 0 errors, 18 warnings, 2 notes in 1 contact\n"
            "models/side/rear.k: 0 errors, 18 warnings, 2 notes in 1 contact\n"
            "2 decks: 0 errors, 36 warnings, 4 notes\n");
  const Ended talking = gapcheck("audit 'models/**/*.k'");
  EXPECT_NE(talking.err.find("1 file was found that other decks include, and not audited alone; the first is "
                             "models/side/lib/mesh.k"),
            std::string::npos)
      << talking.err;
  EXPECT_EQ(gapcheck("audit 'models/*.k' --quiet").out.rfind("models/front.k: ", 0), 0u);
  EXPECT_EQ(gapcheck("audit 'models/*/rea?.k' --quiet").out.rfind("models/side/rear.k: ", 0), 0u);
  // What is named is a deck, whoever includes it.
  EXPECT_EQ(last_line(gapcheck("audit models/side/lib/mesh.k 'models/**/*.k' --quiet").out),
            "3 decks: 0 errors, 54 warnings, 6 notes\n");
}

TEST_F(AuditProgram, TheSameDeckTwiceIsOneDeck) {
  const std::string once = gapcheck("audit models/front.k").out;
  EXPECT_EQ(gapcheck("audit models/front.k ./models/front.k 'models/*.k'").out, once);
}

TEST_F(AuditProgram, AFileNamedLikeAPatternIsThatFile) {
  file("odd*name.k", content(project / "data/two_plates.k"));
  EXPECT_EQ(gapcheck("audit 'odd*name.k' --quiet").out.rfind("odd*name.k: ", 0), 0u);
}

TEST_F(AuditProgram, AFileNamedLikeAListIsThatFile) {
  for (const std::string name : {"[front]", "[a,b].k", "[a,b]"}) {
    file(name, content(project / "data/two_plates.k"));
    const Ended run = gapcheck("audit '" + name + "' models/front.k --quiet --output '[" + name + "]'");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(last_line(content(folder_ / ("[" + name + "]"))), "2 decks: 0 errors, 36 warnings, 4 notes\n") << name;
  }
}

TEST_F(AuditProgram, PatternsThatFindNothing) {
  for (const char* pattern : {"'models/*.key'", "'nowhere/**/*.k'", "'models/front.k/*.k'"}) {
    const Ended run = gapcheck(std::string("audit ") + pattern);
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find("no file is named like this"), std::string::npos) << run.err;
  }
}

TEST_F(AuditProgram, LinksDoNotMakeARound) {
  fs::create_directory_symlink(folder_ / "models", folder_ / "models/side/again");
  EXPECT_EQ(last_line(gapcheck("audit 'models/**/*.k' --quiet").out), "2 decks: 0 errors, 36 warnings, 4 notes\n");
}

TEST_F(AuditProgram, DecksThatIncludeOneAnotherAreAudited) {
  file("models/side/lib/mesh.k", "*KEYWORD\n*INCLUDE\n../rear.k\n*END\n");
  const Ended run = gapcheck("audit 'models/side/**/*.k' --quiet");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("it includes itself"), std::string::npos) << run.err;
}

/// Files in a circle are not passed over in silence because there is a deck besides.
TEST_F(AuditProgram, ACircleBesideAnotherDeckIsAudited) {
  file("models/side/lib/mesh.k", "*KEYWORD\n*INCLUDE\n../rear.k\n*INCLUDE\n../../a.k\n*END\n");
  file("models/a.k", content(project / "data/clean.k"));
  const Ended run = gapcheck("audit 'models/**/*.k' --quiet");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("it includes itself"), std::string::npos) << run.err;
  EXPECT_EQ(run.out.rfind("models/front.k: 0 errors, 18 warnings", 0), 0u) << run.out;
  EXPECT_NE(run.out.find("\nmodels/side/lib/mesh.k: "), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("models/a.k"), std::string::npos) << "the circle includes it";
}

/// The gravest exit code is that of the call; one deck that cannot be read does not keep the others back.
TEST_F(AuditProgram, ExitCodes) {
  EXPECT_EQ(gapcheck("audit models/front.k models/side/rear.k --fail-on warning").code, 1);
  EXPECT_EQ(gapcheck("audit '" + (project / "data/clean.k").string() + "' models/front.k --fail-on warning").code, 1);
  file("empty.k", "");
  const Ended run = gapcheck("audit empty.k models/front.k --fail-on warning --quiet");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(last_line(run.out), "1 deck: 0 errors, 18 warnings, 2 notes; 1 more not audited\n");
  EXPECT_NE(run.err.find("empty.k: is empty"), std::string::npos) << run.err;
  EXPECT_EQ(gapcheck("audit empty.k --format json").out, "");
}

TEST_F(AuditProgram, AContactMayBeMissingInSomeDecks) {
  file("other.k", content(project / "data/clean.k"));
  EXPECT_EQ(gapcheck("audit models/front.k other.k --contact 1").code, 0);
  const Ended run = gapcheck("audit models/front.k other.k --contact 77");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("--contact 77: none of the decks has such a contact"), std::string::npos) << run.err;
}

TEST_F(AuditProgram, FilesOfEachDeck) {
  const Ended run = gapcheck("audit 'models/**/*.k' --html 'out/{deck}.html' --key 'out/{deck}.beams' --quiet");
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* name : {"front.html", "front.beams", "side/rear.html", "side/rear.beams"})
    EXPECT_TRUE(fs::exists(folder_ / "out/models" / name)) << name;
  EXPECT_EQ(gapcheck("audit ../" + folder_.filename().string() + "/models/front.k --html '{deck}.html' --quiet").code,
            0);
  EXPECT_TRUE(fs::exists(folder_ / folder_.filename() / "models/front.html")) << "never outside of where one is";
}

TEST_F(AuditProgram, FilesThatSeveralDecksWouldWrite) {
  for (const char* option : {"--html page.html", "--key beams.k", "--write-baseline known"}) {
    const Ended run = gapcheck(std::string("audit 'models/**/*.k' ") + option);
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find("would hold the results of models/front.k and of models/side/rear.k; write {deck}"),
              std::string::npos)
        << run.err;
  }
  file("models/front.key", content(project / "data/two_plates.k"));
  EXPECT_EQ(gapcheck("audit models/front.k models/front.key --html '{deck}.html'").code, 2);
  const Ended own = gapcheck("audit models/front.k models/side/rear.k --html models/side/rear.k");
  EXPECT_EQ(own.code, 2);
  EXPECT_NE(own.err.find("is the deck itself"), std::string::npos) << own.err;
}

/// The plates of 1 are 0.7 apart.
TEST_F(AuditProgram, AsIfTheDeckHadOtherValues) {
  const auto warnings = [&](const std::string& options) {
    const Ended run = gapcheck("audit models/front.k --select GC101 --quiet " + options);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out.substr(std::string("models/front.k: ").size());
  };
  EXPECT_EQ(warnings("--as-if SST=0.71"), "0 errors, 18 warnings, 0 notes in 1 contact, as if SST=0.71\n");
  EXPECT_EQ(warnings("--as-if sst=0.69,OPTT=0"), "nothing found in 1 contact, as if SST=0.69, OPTT=0\n");
  EXPECT_EQ(warnings("--as-if thickness --units mm-ms-kg"),
            "nothing found in 1 contact, as if SST=0.5, MST=0.5, OPTT=0, IGNORE=0\n");
  EXPECT_EQ(warnings("--as-if thickness --units cm-s-g"),
            "nothing found in 1 contact, as if SST=0.05, MST=0.05, OPTT=0, IGNORE=0\n");
  const Ended json = gapcheck("audit models/front.k --as-if SST=0.71 --format json");
  EXPECT_EQ(nlohmann::json::parse(json.out)["as_if"], nlohmann::json::array({"SST=0.71"}));
  EXPECT_FALSE(nlohmann::json::parse(gapcheck("audit models/front.k --format json").out).contains("as_if"));
}

/// One page about all decks, with links to the page of each.
TEST_F(AuditProgram, HtmlIndex) {
  file("models/<b>.k", "*KEYWORD\n*NODE\n1\n*END\n");
  const Ended run = gapcheck(
      "audit models/front.k 'models/<b>.k' missing.k --html 'pages/{deck}.html' --html-index index.html --quiet");
  EXPECT_EQ(run.code, 2) << "one deck is missing";
  const std::string page = content(folder_ / "index.html");
  EXPECT_NE(page.find("<h1>3 decks: 0 errors, 18 warnings, "), std::string::npos) << page;
  EXPECT_NE(page.find("; 1 not audited</h1>"), std::string::npos) << page;
  EXPECT_LT(page.find("<td>missing.k</td><td class=\"unread\">"), page.find("models/front.k</a>")) << page;
  EXPECT_NE(page.find("<a href=\"pages/models/front.html\">models/front.k</a></td><td class=\"warning\">"),
            std::string::npos)
      << page;
  EXPECT_NE(page.find("<a href=\"pages/models/front.html#f1\">GC101 initial-penetration: contact 1: node 1006"),
            std::string::npos)
      << page;
  EXPECT_NE(page.find("<a href=\"pages/models/%3Cb%3E.html\">models/&lt;b&gt;.k</a>"), std::string::npos) << page;
  EXPECT_TRUE(fs::exists(folder_ / "pages/models/front.html"));
  // Without pages there are no links, and one deck has an index too.
  EXPECT_EQ(gapcheck("audit models/front.k --html-index one.html --quiet").code, 0);
  EXPECT_EQ(content(folder_ / "one.html").find("<a "), std::string::npos);
  // An index that cannot be written is an error before any deck is audited; the old index stays.
  for (const char* name : {"models/front.k", "pages/models/front.html", "'{deck}.html'"}) {
    const Ended refused = gapcheck(std::string("audit models/front.k --html 'pages/{deck}.html' --html-index ") + name);
    EXPECT_EQ(refused.code, 2) << name;
    EXPECT_NE(refused.err.find("--html-index"), std::string::npos) << refused.err;
  }
  EXPECT_EQ(gapcheck("audit models/front.k --quiet --html-index nowhere/index.html").code, 2);
  EXPECT_EQ(content(folder_ / "index.html"), page);
}

/// What other programs do not read is listed on request, and changes nothing else.
TEST_F(AuditProgram, Portability) {
  std::string deck = content(project / "data/two_plates.k");
  const std::string keyword = "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n";
  ASSERT_NE(deck.find(keyword), std::string::npos);
  deck.replace(deck.find(keyword), keyword.size(),
               "*CONTACT_ERODING_NODES_TO_SURFACE\n1,1,3,3\n\n\n\n*CONTACT_AUTOMATIC_GENERAL_TITLE\n"
               "         9not read\n1,,3,,,,1\n\n\n1\n" +
                   keyword);
  file("models/mixed.k", deck);
  const Ended plain = gapcheck("audit models/mixed.k"), with = gapcheck("audit models/mixed.k --portability");
  EXPECT_EQ(with.code, plain.code);
  EXPECT_EQ(with.err, plain.err);
  const std::string section =
      "portability: contact input that other programs do not read, according to their documents\n"
      "  Altair Radioss\n"
      "    *CONTACT_ERODING_NODES_TO_SURFACE: not read, 1 contact, at models/mixed.k:86\n"
      "    option TITLE: not read, 1 contact, at models/mixed.k:91\n"
      "    SAPR: not read, 1 contact, at models/mixed.k:93\n"
      "    SOFT: read, but as something else, 1 contact, at models/mixed.k:96\n\n";
  const std::size_t at = with.out.find(section);
  ASSERT_NE(at, std::string::npos) << with.out;
  EXPECT_EQ(with.out.substr(0, at) + with.out.substr(at + section.size()), plain.out);

  const auto list =
      nlohmann::json::parse(gapcheck("audit models/mixed.k --portability --format json").out)["portability"];
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0]["kind"], "keyword");
  EXPECT_EQ(list[0]["name"], "CONTACT_ERODING_NODES_TO_SURFACE");
  EXPECT_EQ(list[1]["kind"], "option");
  EXPECT_EQ(list[3]["kind"], "field");
  EXPECT_EQ(list[3]["use"], "other");
  EXPECT_EQ(list[3]["line"], 96);
  EXPECT_EQ(list[3]["file"], "models/mixed.k");
  EXPECT_FALSE(nlohmann::json::parse(gapcheck("audit models/mixed.k --format json").out).contains("portability"));
  // Deck by deck.
  const Ended both = gapcheck("audit models/front.k models/mixed.k --portability");
  EXPECT_NE(both.out.find("portability: by its documents, Altair Radioss reads all keywords, options and fields"),
            std::string::npos)
      << both.out;
  EXPECT_NE(both.out.find(section), std::string::npos) << both.out;
}

TEST_F(AuditProgram, AsIfRefusesWhatItDoesNotKnow) {
  for (const auto& [option, words] :
       {std::pair{"thickness", "Give --units"}, {"SSST=1", "one of the fields"}, {"SST=", "not a number"}}) {
    const Ended run = gapcheck(std::string("audit models/front.k --as-if ") + option);
    EXPECT_EQ(run.code, 2) << option;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  }
}

TEST_F(AuditProgram, ABaselineForEachDeck) {
  EXPECT_EQ(gapcheck("audit 'models/**/*.k' --write-baseline 'known/{deck}' --fail-on warning --quiet").code, 1);
  EXPECT_EQ(gapcheck("audit 'models/**/*.k' --baseline 'known/{deck}' --fail-on warning --quiet").code, 0);
  file("models/side/lib/mesh.k", content(project / "data/two_plates_tilted.k"));
  EXPECT_EQ(gapcheck("audit 'models/**/*.k' --baseline 'known/{deck}' --fail-on warning --quiet").code, 1);
  const Ended one = gapcheck("audit 'models/**/*.k' --baseline known");
  EXPECT_EQ(one.code, 2);
  EXPECT_NE(one.err.find("write {deck} into the name"), std::string::npos) << one.err;
  fs::remove(folder_ / "known/models/front");
  EXPECT_EQ(gapcheck("audit 'models/**/*.k' --baseline 'known/{deck}' --quiet").code, 2);
}

/// A deck without a baseline is not audited, and every format that names it says why.
TEST_F(AuditProgram, ABaselineThatOneDeckLacks) {
  ASSERT_EQ(gapcheck("audit 'models/**/*.k' --write-baseline 'known/{deck}' --quiet").code, 0);
  const std::string all = "audit 'models/**/*.k' --baseline 'known/{deck}' ";
  EXPECT_EQ(last_line(gapcheck(all + "--quiet").out),
            "2 decks: 0 errors, 36 warnings, 4 notes; against the baselines: 0 new, 0 worse, 40 unchanged, 0 gone\n");
  EXPECT_EQ(nlohmann::json::parse(gapcheck(all + "--format json").out)["summary"]["baseline"]["unchanged"], 40);
  fs::remove(folder_ / "known/models/front");
  const Ended run = gapcheck(all + "--quiet");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(last_line(run.out),
            "1 deck: 0 errors, 18 warnings, 2 notes; against the baselines: 0 new, 0 worse, 20 "
            "unchanged, 0 gone; 1 more not audited\n");
  const std::string why =
      "known/models/front: cannot be opened: No such file or directory; --write-baseline writes a first one";
  EXPECT_NE(run.err.find(why), std::string::npos) << run.err;
  const auto json = nlohmann::json::parse(gapcheck(all + "--format json").out);
  EXPECT_EQ(json["unread"], nlohmann::json::array({"models/front.k"}));
  EXPECT_EQ(json["reasons"], nlohmann::json::array({why}));
  EXPECT_EQ(json["summary"]["baseline"]["unchanged"], 20);
  const std::string junit = gapcheck(all + "--format junit").out;
  EXPECT_NE(junit.find("<error message=\"" + why + "\""), std::string::npos) << junit;
}

/// In the settings {deck} is the path from their folder, wherever one calls from.
TEST_F(AuditProgram, TheBaselineOfTheSettingsIsTheSameFromAnyFolder) {
  file("gapcheck.toml", "baseline = \"known/{deck}.base\"\nfail-on = \"warning\"\n");
  ASSERT_EQ(gapcheck("audit 'models/**/*.k' --quiet --write-baseline 'known/{deck}.base'").code, 1);
  ASSERT_TRUE(fs::exists(folder_ / "known/models/side/rear.base"));
  EXPECT_EQ(gapcheck("audit 'models/**/*.k' --quiet").code, 0);
  const std::string program = GAPCHECK_PROGRAM " audit ";
  for (const char* decks :
       {"front.k", "front.k side/rear.k", "'**/*.k'", "../models/front.k", "\"$PWD/side/rear.k\""}) {
    const Ended run = shell("cd models && " + program + decks + " --quiet");
    EXPECT_EQ(run.code, 0) << decks << ": " << run.err;
  }
}

/// Decks that share an include read it once, and find the same as alone.
TEST_F(AuditProgram, SharedIncludesAreReadOnce) {
  file("models/side/front.k", "*KEYWORD\n*INCLUDE\nlib/mesh.k\n*END\n");
  const auto both =
      nlohmann::json::parse(gapcheck("audit models/side/front.k models/side/rear.k --format json --stats").out);
  const auto alone = nlohmann::json::parse(gapcheck("audit models/side/rear.k --format json").out);
  EXPECT_EQ(both["decks"][1]["findings"], alone["findings"]);
  const auto shared = [&](std::size_t deck) {
    for (const auto& counter : both["decks"][deck]["statistics"])
      if (counter["name"] == "files read before in this call") return counter["value"].get<int>();
    return 0;
  };
  EXPECT_EQ(shared(0), 0);
  EXPECT_EQ(shared(1), 1);
}

/// What every command takes.
TEST_F(Program, OptionsOfEveryCommand) {
  use("smp");
  file("deck.k", content(project / "data/two_plates.k"));
  for (const std::string command : {"audit deck.k", "messag messag", "compare deck.k deck.k", "fix deck.k --dry-run",
                                    "run deck.k -o out --cycles 2 --ignore-unsupported", "rules", "explain GC101"}) {
    for (const char* option : {"--quiet", "--stats", "--jobs 1", "--version", "--help"}) {
      const Ended run = gapcheck(command + " " + option);
      EXPECT_TRUE(run.code == 0 || run.code == 1) << command << " " << option << ": " << run.err;
    }
    EXPECT_NE(gapcheck(command + " --stats").out + gapcheck(command + " --stats").err,
              gapcheck(command).out + gapcheck(command).err);
    EXPECT_EQ(gapcheck(command + " --version").out, gapcheck("--version").out);
  }
  EXPECT_EQ(gapcheck("explain GC101 --quiet").out.rfind("GC101 initial-penetration: ", 0), 0u);
  EXPECT_EQ(gapcheck("rules --quiet").out.rfind("GC101\n", 0), 0u);
}

TEST_F(AuditProgram, TheSameForAnyNumberOfThreads) {
  const std::string one = gapcheck("audit 'models/**/*.k' --list --jobs 1").out;
  EXPECT_NE(one.find("2 decks: "), std::string::npos) << one;
  EXPECT_EQ(one, gapcheck("audit 'models/**/*.k' --list --jobs 4").out);
}

TEST_F(AuditProgram, TextOfTenDecks) {
  for (const char* deck : {"two_plates", "clean", "contact_chain", "deep_node_released", "mortar_not_checked",
                           "solid_row", "stray_part", "t_joint", "tied_then_contact", "two_plates_crossing"}) {
    fs::copy_file(project / "data" / (std::string(deck) + ".k"), folder_ / (std::string(deck) + ".k"));
    const std::string name = deck;
    expect_golden("audit_" + name, gapcheck("audit -I '" + (project / "data").string() + "' " + name + ".k").out);
  }
}

}  // namespace
}  // namespace gapcheck::audit_test
