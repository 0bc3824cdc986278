// gapcheck.toml as users see it: where it is looked for, what it does, what the command line takes from it.
#include "settings/settings.hpp"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Option.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"
#include "audit/registry.hpp"
#include "commands.hpp"
#include "options.hpp"

namespace gapcheck::settings_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class SettingsProgram : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    fs::create_directory(folder_ / ".git");  // nothing above this folder has a say
    for (const char* name : {"contact_chain.k", "two_plates.k", "two_plates_tilted.k"}) use_deck(name);
  }
  void use_deck(const std::string& name) const { fs::copy_file(project / "data" / name, folder_ / name); }
  void settings(const std::string& text) const { file("gapcheck.toml", text); }
  [[nodiscard]] Json json(const std::string& arguments) const {
    return Json::parse(gapcheck("audit " + arguments + " --format json").out, nullptr, false);
  }
  /// Number of findings with this id.
  static std::size_t count(const Json& report, const std::string& id) {
    std::size_t n = 0;
    for (const Json& finding : report["findings"]) n += finding["id"] == id ? 1 : 0;
    return n;
  }
};

struct Effect {
  std::string setting, option, arguments;
};

/// A key does what its option does, and that is not nothing.
TEST_F(SettingsProgram, KeysOfTheTopLevelAreOptions) {
  file("thin.k",
       "*KEYWORD\n*MAT_ELASTIC\n1,7.85e-9,210000.,0.3\n*SECTION_SHELL\n1,2\n0.4\n*PART\npart\n1,1,1\n"
       "*NODE\n1,0,0,0\n2,5,0,0\n3,5,5,0\n4,0,5,0\n*ELEMENT_SHELL\n1,1,1,2,3,4\n"
       "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5,0\n0.\n1.,1.\n*END\n");
  fs::create_directory(folder_ / "lib");
  file("lib/mesh.k", content(project / "data/two_plates.k"));
  file("outer.k", "*KEYWORD\n*INCLUDE\nmesh.k\n*END\n");
  file("lacks.k", "*KEYWORD\n*INCLUDE\nnowhere.k\n*END\n");
  ASSERT_EQ(gapcheck("audit contact_chain.k --write-baseline known --quiet").code, 0);
  const std::vector<Effect> effects{
      {"units = \"mm-s-t\"", "--units mm-s-t", "thin.k --fail-on warning"},
      {"include-directories = \"lib\"", "-I lib", "outer.k"},
      {"missing-includes = \"skip\"", "--missing-includes skip", "lacks.k"},
      {"select = [\"GC101\"]", "--select GC101", "contact_chain.k"},
      {"ignore = [\"GC308\", \"GC4\"]", "--ignore GC308,GC4", "contact_chain.k"},
      {"contact = 10", "--contact 10", "contact_chain.k"},
      {"part = [3]", "--part 3", "contact_chain.k"},
      {"ptol = 0.15", "--ptol 0.15", "contact_chain.k"},
      {"rtol = 0.85", "--rtol 0.85", "contact_chain.k"},
      {"ratio = 0.15", "--ratio 0.15", "contact_chain.k"},
      {"format = \"csv\"", "--format csv", "contact_chain.k"},
      {"top = 1", "--top 1", "contact_chain.k"},
      {"fail-on = \"note\"", "--fail-on note", "contact_chain.k"},
      {"baseline = \"known\"", "--baseline known", "contact_chain.k --fail-on warning"},
  };
  for (const auto& [setting, option, arguments] : effects) {
    fs::remove(folder_ / "gapcheck.toml");
    const Ended bare = gapcheck("audit " + arguments), wanted = gapcheck("audit " + arguments + " " + option);
    settings(setting + "\n");
    const Ended set = gapcheck("audit " + arguments);
    EXPECT_EQ(set.code, wanted.code) << setting << set.err;
    EXPECT_EQ(set.out, wanted.out) << setting;
    EXPECT_EQ(set.err, wanted.err) << setting;
    EXPECT_TRUE(bare.out != set.out || bare.code != set.code) << setting << " without effect";
  }
  // --jobs alone changes nothing that can be seen.
  EXPECT_EQ(effects.size() + 1,
            static_cast<std::size_t>(std::count_if(app::setting_keys().begin(), app::setting_keys().end(),
                                                   [](const app::SettingKey& key) { return key.table.empty(); })));
}

TEST_F(SettingsProgram, OptionsAreGivenToTheCommand) {
  const std::string deck = (folder_ / "two_plates.k").string();
  settings("jobs = 3\nmissing-includes = \"skip\"\ninclude-directories = [\"a\", \"b\"]\n");
  CLI::App command;
  std::size_t jobs = 0;
  keyword::ReadOptions read;
  std::string missing = "error";
  app::add_jobs(command, jobs);
  app::add_includes(command, read, missing);
  app::Failures failures([](const Diagnostic& error) { ADD_FAILURE() << error.message; });
  static_cast<void>(app::use_settings({}, deck, false, command, failures));
  ASSERT_FALSE(failures.any());
  EXPECT_EQ(jobs, 3u);
  EXPECT_EQ(missing, "skip");
  EXPECT_EQ(read.include_directories, (std::vector{(folder_ / "a").string(), (folder_ / "b").string()}));
}

TEST_F(SettingsProgram, TheCommandLineWins) {
  settings("select = [\"GC308\", \"GC421\"]\nformat = \"csv\"\nfail-on = \"note\"\nptol = 0.15\n");
  const Json report = json("contact_chain.k --select GC101 --ptol 0.1");
  EXPECT_EQ(count(report, "GC101"), 18u) << "lists replace, they do not add";
  EXPECT_EQ(count(report, "GC308"), 0u);
  EXPECT_EQ(gapcheck("audit contact_chain.k").code, 1);
  EXPECT_EQ(gapcheck("audit contact_chain.k --fail-on never").code, 0);
}

TEST_F(SettingsProgram, ItIsLookedForUpwardsToTheRepository) {
  fs::create_directories(folder_ / "models/front/.git");
  fs::create_directories(folder_ / "models/rear/deep");
  for (const char* place : {"models/front/a.k", "models/rear/a.k", "models/rear/deep/a.k"})
    fs::copy_file(folder_ / "two_plates.k", folder_ / place);
  settings("fail-on = \"note\"\n");
  EXPECT_EQ(gapcheck("audit two_plates.k --quiet").code, 1);
  EXPECT_EQ(gapcheck("audit models/rear/deep/a.k --quiet").code, 1);
  EXPECT_EQ(gapcheck("audit ./models/../models/rear/a.k --quiet").code, 1);
  EXPECT_EQ(gapcheck("audit models/front/a.k --quiet").code, 0) << "a repository of its own";
  EXPECT_EQ(shell("cd models/rear/deep && " GAPCHECK_PROGRAM " audit a.k --quiet").code, 1);
  // The nearest one alone; a folder of that name is none.
  file("models/rear/gapcheck.toml", "fail-on = \"error\"\n");
  fs::create_directory(folder_ / "models/rear/deep/gapcheck.toml");
  EXPECT_EQ(gapcheck("audit models/rear/deep/a.k --quiet").code, 0);
  // In the folder with .git it is found.
  file("models/front/gapcheck.toml", "fail-on = \"note\"\n");
  EXPECT_EQ(gapcheck("audit models/front/a.k --quiet").code, 1);
  // The first deck says where, a pattern by the folder before it.
  EXPECT_EQ(gapcheck("audit models/rear/a.k models/front/a.k --quiet").code, 0);
  EXPECT_EQ(json("'models/f*/*.k'")["settings"], "gapcheck.toml");
}

TEST_F(SettingsProgram, OneMayBeNamedOrNone) {
  settings("fail-on = \"note\"\n");
  file("other.toml", "ignore = \"GC\"\n");
  EXPECT_EQ(gapcheck("audit two_plates.k --quiet").code, 1);
  EXPECT_EQ(gapcheck("audit two_plates.k --quiet --no-config").code, 0);
  EXPECT_EQ(gapcheck("audit two_plates.k --quiet --config other.toml").out,
            "two_plates.k: nothing found in 1 contact, 1 not judged\n");
  EXPECT_EQ(gapcheck("audit two_plates.k --config other.toml --no-config").code, 2);
  for (const char* path : {"missing.toml", ".", ".git"}) {
    const Ended run = gapcheck(std::string("audit two_plates.k --config ") + path);
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err.find(std::string("gapcheck: error: ") + path + ": "), 0u) << run.err;
  }
}

TEST_F(SettingsProgram, WhichFileWasUsedIsSaid) {
  const std::string before = gapcheck("audit two_plates.k").out;
  EXPECT_FALSE(json("two_plates.k").contains("settings"));
  EXPECT_EQ(gapcheck("audit two_plates.k --stats").out.find("settings file"), std::string::npos);
  settings("# nothing\n");
  EXPECT_EQ(gapcheck("audit two_plates.k").out, before);
  EXPECT_EQ(json("two_plates.k")["settings"], "gapcheck.toml");
  EXPECT_EQ(json("./two_plates.k")["settings"], "gapcheck.toml");
  EXPECT_EQ(json("'" + (folder_ / "two_plates.k").string() + "'")["settings"], (folder_ / "gapcheck.toml").string());
  EXPECT_NE(gapcheck("audit two_plates.k --stats").out.find("gapcheck.toml"), std::string::npos);
  fs::create_directory(folder_ / "below");
  const Ended below = shell("cd below && " GAPCHECK_PROGRAM " audit ../two_plates.k --format json");
  EXPECT_EQ(Json::parse(below.out)["settings"], "../gapcheck.toml");
}

TEST_F(SettingsProgram, ErrorsAreAllSaidAndNothingIsDone) {
  settings(
      "selct = 1\nunits = \"furlong\"\njobs = 5000\nformat = \"xml\"\nfail-on = \"maybe\"\ntop = -1\n"
      "missing-includes = \"no\"\nptol = -1\n");
  for (const char* command : {"audit two_plates.k", "audit two_plates.k --units mm-s-t --jobs 1",
                              "fix two_plates.k -o out", "run two_plates.k -o out"}) {
    const Ended run = gapcheck(command);
    EXPECT_EQ(run.code, 2) << command;
    EXPECT_EQ(run.out, "") << command;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    for (int line = 1; line <= 8; ++line)
      EXPECT_NE(run.err.find("gapcheck: error: gapcheck.toml:" + std::to_string(line) + ": "), std::string::npos)
          << command << " line " << line << "\n"
          << run.err;
    EXPECT_NE(run.err.find(":2: units: furlong not in {"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("did you mean \"select\"?"), std::string::npos) << run.err;
  }
}

TEST_F(SettingsProgram, FilesThatAreNoSettings) {
  const auto expect = [&](const std::string& what) {
    const Ended run = gapcheck("audit two_plates.k");
    EXPECT_EQ(run.code, 2) << what;
    EXPECT_EQ(run.out, "") << what;
    EXPECT_NE(run.err.find(what), std::string::npos) << run.err;
  };
  settings(std::string(1024 * 1024 + 1, '#'));
  expect("more than a megabyte");
  settings("because = \"\xFF\xFE\"\n");
  expect("gapcheck.toml:1: is not valid TOML: ");
  settings(content(folder_ / "two_plates.k"));
  expect("gapcheck.toml:1: is not valid TOML: ");
  if (::geteuid() == 0) return;  // root may read everything
  settings("");
  fs::permissions(folder_ / "gapcheck.toml", fs::perms::none);
  expect("gapcheck: error: gapcheck.toml: ");
}

TEST_F(SettingsProgram, ExceptionsAreIgnored) {
  settings("[[exception]]\nignore = \"GC101\"\ncontact = 10\nbecause = \"welded\"\n");
  EXPECT_EQ(count(json("contact_chain.k"), "GC101"), 9u);
  EXPECT_EQ(count(json("contact_chain.k --no-config"), "GC101"), 18u);
  EXPECT_EQ(gapcheck("audit contact_chain.k --contact 10 --select GC101 --fail-on note --quiet").code, 0);
  const Json report = json("contact_chain.k");
  ASSERT_EQ(report["ignored"].size(), 1u) << report["ignored"];
  for (const auto& [lines, left] :
       std::vector<std::pair<std::string, std::size_t>>{{"node = 2001", 16},
                                                        {"node = [\"2001-2003\", 2004]", 10},
                                                        {"part = 3", 9},
                                                        {"element = 1001", 17},
                                                        {"contact = 10\nnode = 2001", 17},
                                                        {"until = 2000-01-01", 18},
                                                        {"until = 2999-12-31", 0},
                                                        {"deck = \"two*.k\"", 18},
                                                        {"deck = [\"two*.k\", \"**/contact_?hain.k\"]", 0}}) {
    settings("[[exception]]\nignore = \"initial-penetration\"\n" + lines + "\n");
    EXPECT_EQ(count(json("contact_chain.k"), "GC101"), left) << lines;
  }
}

TEST_F(SettingsProgram, AnExpiredExceptionIsAFindingAndAnUnusedOneIsNot) {
  settings("[[exception]]\nignore = \"GC101\"\ncontact = 99\n");
  const Json unused = json("contact_chain.k");
  EXPECT_EQ(unused["findings"], json("contact_chain.k --no-config")["findings"]) << "it may be for another deck";
  settings("\n[[exception]]\nignore = \"GC101\"\nuntil = 2000-01-01\n");
  const Json expired = json("contact_chain.k");
  ASSERT_EQ(count(expired, "GC514"), 1u);
  for (const Json& finding : expired["findings"])
    if (finding["id"] == "GC514") {
      EXPECT_EQ(finding["file"], "gapcheck.toml");
      EXPECT_EQ(finding["line"], 2);
    }
}

TEST_F(SettingsProgram, FilesHaveLimitsOfTheirOwn) {
  // Nodes 1xxx, 2xxx and 3xxx from files of their own, below the settings.
  fs::create_directories(folder_ / "models/lib/plates");
  std::istringstream deck(content(folder_ / "two_plates_tilted.k"));
  std::string main, nodes, line;
  for (bool in_nodes = false; std::getline(deck, line);) {
    if (line.starts_with('*')) in_nodes = line.starts_with("*NODE");
    (in_nodes ? nodes : main) += line + '\n';
  }
  const std::size_t end = main.find("*END");
  file("models/main.k", main.substr(0, end) + "*INCLUDE\nlib/plates/nodes.k\n*END\n");
  file("models/lib/plates/nodes.k", nodes);
  const std::string audit = "models/main.k --select GC1";
  ASSERT_EQ(count(json(audit), "GC101"), 20u);
  for (const auto& [lines, left] : std::vector<std::pair<std::string, std::size_t>>{
           {"path = \"models/lib/**\"\nignore = \"GC101\"", 0},
           {"path = \"models/lib/\"\nignore = \"GC101\"", 0},
           {"path = \"models/lib/*.k\"\nignore = \"GC101\"", 20},
           {"path = [\"x.k\", \"./models/lib/*/nodes.?\"]\nignore = [\"GC3\", \"GC10\"]", 0},
           {"path = \"lib/**\"\nignore = \"GC101\"", 20},
           {"path = \"**\"\nignore = \"GC102\"", 20},
           {"path = \"**/nodes.k\"\nptol = 0.3", 12},
           {"path = \"**/nodes.k\"\nratio = 0.5", 4},
           {"path = \"**/nodes.k\"\nratio = 0.5\nptol = 0.7", 0},
           {"path = \"**/nodes.k\"\nptol = 0.3\nuntil = 2000-01-01", 20},
           {"path = \"models/main.k\"\nptol = 9", 20}}) {
    settings("[[include]]\n" + lines + "\n");
    EXPECT_EQ(count(json(audit), "GC101"), left) << lines;
  }
  // The limit is that of the command line, only for some files.
  settings("[[include]]\npath = \"**\"\nptol = 0.3\n");
  const Json report = json(audit);
  settings("");
  EXPECT_EQ(report["findings"], json(audit + " --ptol 0.3")["findings"]);
  // Seen from the folder of the settings, wherever one is.
  file("models/gapcheck.toml", "[[include]]\npath = \"lib/**\"\nignore = \"GC101\"\n");
  EXPECT_EQ(count(json(audit), "GC101"), 0u);
  EXPECT_EQ(count(json("'" + (folder_ / "models/main.k").string() + "'"), "GC101"), 0u);
  const Ended inside = shell("cd models/lib && " GAPCHECK_PROGRAM " audit ../main.k --select GC1 --format json");
  EXPECT_EQ(count(Json::parse(inside.out), "GC101"), 0u);
}

TEST_F(SettingsProgram, SeveritiesReplaceThoseOfTheRules) {
  settings("[severity]\nGC101 = \"error\"\ngc308 = \"warning\"\nignore-recommended = \"error\"\n");
  const Ended text = gapcheck("audit two_plates.k --quiet");
  EXPECT_EQ(text.code, 1);
  EXPECT_EQ(text.out, "two_plates.k: 19 errors, 1 warning, 0 notes in 1 contact\n");
  const Json report = json("two_plates.k");
  for (const Json& finding : report["findings"])
    EXPECT_EQ(finding["severity"], finding["id"] == "GC308" ? "warning" : "error") << finding["id"];
  EXPECT_EQ(report["summary"]["errors"], 19);
  const Json sarif = Json::parse(gapcheck("audit two_plates.k --format sarif").out);
  for (const Json& result : sarif["runs"][0]["results"])
    EXPECT_EQ(result["level"], result["ruleId"] == "GC308" ? "warning" : "error");
  const Json& rules = sarif["runs"][0]["tool"]["driver"]["rules"];
  const auto rule = std::find_if(rules.begin(), rules.end(), [](const Json& one) { return one["id"] == "GC101"; });
  ASSERT_NE(rule, rules.end());
  EXPECT_EQ((*rule)["defaultConfiguration"]["level"], "warning") << "that of the rule itself";
  EXPECT_NE(gapcheck("audit two_plates.k --format github").out.find("::error"), std::string::npos);
  EXPECT_NE(gapcheck("audit two_plates.k --format csv").out.find("GC101,initial-penetration,error"), std::string::npos);
  EXPECT_NE(gapcheck("audit two_plates.k --format gitlab").out.find("\"major\""), std::string::npos);
  // Ties have theirs.
  use_deck("tied_then_contact.k");
  settings("[severity]\ntie-offset = \"error\"\n");
  const Json ties = json("tied_then_contact.k");
  ASSERT_GT(count(ties, "GC202"), 0u);
  EXPECT_EQ(json("tied_then_contact.k --no-config")["summary"]["errors"], 0);
  EXPECT_EQ(ties["summary"]["errors"], count(ties, "GC202"));
}

TEST_F(SettingsProgram, ABaselineIsWrittenBeforeItIsThere) {
  fs::create_directory(folder_ / "models");
  fs::copy_file(folder_ / "two_plates.k", folder_ / "models/a.k");
  settings("baseline = \"known\"\nfail-on = \"warning\"\n");
  const Ended lacks = gapcheck("audit models/a.k --quiet");
  EXPECT_EQ(lacks.code, 2);
  EXPECT_NE(lacks.err.find("known: "), std::string::npos) << lacks.err;
  EXPECT_EQ(gapcheck("audit models/a.k --quiet --write-baseline other").code, 2);
  EXPECT_EQ(gapcheck("audit models/a.k --quiet --write-baseline ./known").code, 1);
  EXPECT_EQ(gapcheck("audit models/a.k --quiet").code, 0);
  EXPECT_EQ(shell("cd models && " GAPCHECK_PROGRAM " audit a.k --quiet").code, 0) << "it is beside the settings";
  const std::string part = "audit models/a.k --quiet --select GC1 --write-baseline ./known";
  EXPECT_EQ(gapcheck(part).code, 2) << "would lose the rest";
  settings("baseline = \"known\"\nfail-on = \"warning\"\nselect = \"GC1\"\n");
  EXPECT_EQ(gapcheck("audit models/a.k --quiet --write-baseline known").code, 0) << "for good, so nothing is lost";
  EXPECT_EQ(gapcheck("audit models/a.k --quiet --no-config --baseline lacks --write-baseline lacks").code, 2);
}

TEST_F(SettingsProgram, FixAndRunReadTheDeckAsTheAuditDoes) {
  fs::create_directory(folder_ / "lib");
  fs::rename(folder_ / "two_plates.k", folder_ / "lib/mesh.k");
  file("main.k", "*KEYWORD\n*INCLUDE\nmesh.k\n*END\n");
  for (const char* command : {"fix main.k --dry-run", "run main.k -o out --cycles 3 --quiet"}) {
    fs::remove(folder_ / "gapcheck.toml");
    EXPECT_EQ(gapcheck(command).code, 2) << command;
    settings("include-directories = \"lib\"\nformat = \"sarif\"\ntop = 0\nselect = \"GC5\"\n");
    const Ended run = gapcheck(command);
    EXPECT_EQ(run.code, 0) << command << run.err;
    EXPECT_EQ(gapcheck(std::string(command) + " --no-config").code, 2) << command;
    fs::rename(folder_ / "gapcheck.toml", folder_ / "other.toml");
    EXPECT_EQ(gapcheck(std::string(command) + " --config other.toml").code, 0) << command;
  }
}

/// What stands between two marks of the page. With GAPCHECK_UPDATE_GOLDEN in the environment it is written there first.
std::string section(const std::string& name, const std::string& wanted) {
  const fs::path path = fs::path(GAPCHECK_ROOT) / "docs/settings.md";
  std::string page = content(path);
  const std::string begin = "<!-- " + name + ": begin -->\n", end = "<!-- " + name + ": end -->";
  const std::size_t first = page.find(begin) + begin.size(), last = page.find(end);
  if (std::getenv("GAPCHECK_UPDATE_GOLDEN") != nullptr) {
    std::ofstream(path, std::ios::binary) << page.replace(first, last - first, wanted);
    return wanted;
  }
  return page.substr(first, last - first);
}

TEST_F(SettingsProgram, ThePageShowsWhatHappens) {
  const std::string example = R"(units = "mm-s-t"
fail-on = "warning"
ignore = ["GC308"]              # a proposal, not a fault

[severity]
ignore-recommended = "warning"  # GC421

[[include]]
path = "lib/**"                 # bought, ours only to use
ignore = ["GC5"]
ptol = 0.05

[[exception]]
ignore = "initial-penetration"
deck = "contact_chain.k"
contact = 10
until = 2099-12-31
because = "the lower plate is pressed in"
)";
  settings(example);
  const std::string command = "audit contact_chain.k --top 2 --fail-on never";
  const Ended run = gapcheck(command);
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string shown = "```toml\n" + example + "```\n\n```\n$ gapcheck " + command + "\n" + run.out + "```\n";
  EXPECT_EQ(section("example", shown), shown);
}

TEST_F(SettingsProgram, ThePageHasAllKeys) {
  CLI::App app;
  app::Action action;
  app::add_audit(app, action);
  std::string shown;
  std::string_view table = "none";
  for (const app::SettingKey& key : app::setting_keys()) {
    if (key.table != table) {
      shown += table == "none" ? "" : "\n";
      shown += key.table.empty() ? "| key" : "| key of `[[" + std::string(key.table) + "]]`";
      shown += " | takes | says |\n|---|---|---|\n";
      table = key.table;
    }
    std::string meaning(key.meaning);
    if (!key.option.empty()) {
      const std::string option(key.option);
      meaning = "`" + option + "`: " + app.get_subcommand("audit")->get_option(option)->get_description();
    }
    shown += "| `" + std::string(key.name) + "` | " + std::string(app::expected(key.type)) + " | " + meaning + " |\n";
  }
  EXPECT_EQ(section("keys", shown), shown);
}

TEST_F(SettingsProgram, ThePageHasAllThresholds) {
  std::string shown = "| rule | threshold | value | what it is |\n|---|---|---:|---|\n";
  for (const RuleIdentity& rule : audit::rules())
    for (const audit::Threshold& threshold : audit::thresholds(rule))
      shown += fmt::format("| [{0}](rules/{0}.md) | `{1}` | {2:g} | {3} |\n", rule.name, threshold.name,
                           threshold.value, threshold.meaning);
  EXPECT_EQ(section("thresholds", shown), shown);
}

TEST_F(SettingsProgram, ThresholdsReplaceThoseOfTheRules) {
  const auto warnings = [&] { return gapcheck("audit warped_quad.k --select GC504 --quiet").out; };
  use_deck("warped_quad.k");
  settings("[threshold.warped-segment]\nangle = 180\n");
  EXPECT_NE(warnings().find("nothing found"), std::string::npos) << warnings();
  settings("[threshold.warped-segment]\nangle = 0\n");
  EXPECT_NE(warnings().find("1 warning"), std::string::npos) << warnings();
}

TEST_F(SettingsProgram, TheSameForAnyNumberOfThreads) {
  settings("[[exception]]\nignore = \"GC101\"\nnode = \"2001-2004\"\n[[include]]\npath = \"**\"\nptol = 0.15\n");
  const std::string one = gapcheck("audit contact_chain.k --list --jobs 1").out;
  EXPECT_EQ(gapcheck("audit contact_chain.k --list --jobs 4").out, one);
}

}  // namespace
}  // namespace gapcheck::settings_test
