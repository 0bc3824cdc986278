// What a settings file may say, and what is said of one that is wrong.
#include "settings/settings_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace gapcheck::app::settings_file_test {
namespace {

struct Outcome {
  Settings settings;
  std::vector<Diagnostic> errors;
};

Outcome read(const std::string& text, const std::string& path = "gapcheck.toml") {
  Diagnostics diagnostics;
  Outcome outcome{read_settings(text, path, diagnostics), {}};
  outcome.errors = diagnostics.sorted();
  return outcome;
}

/// The only error, as "LINE: message".
std::string error_of(const std::string& text) {
  const Outcome outcome = read(text);
  if (outcome.errors.size() != 1) return std::to_string(outcome.errors.size()) + " errors";
  EXPECT_EQ(outcome.errors[0].file, "gapcheck.toml");
  EXPECT_EQ(outcome.errors[0].severity, Severity::error);
  return std::to_string(outcome.errors[0].line) + ": " + outcome.errors[0].message;
}

std::vector<std::string> values(const Outcome& outcome, std::string_view key) {
  for (const Setting& setting : outcome.settings.options)
    if (setting.key->name == key) return setting.values;
  return {};
}

using Words = std::vector<std::string>;

TEST(SettingsFile, OptionsAreTextAsTheCommandLineHasIt) {
  const Outcome outcome = read(R"(units = "mm-ms-kg"
select = ["GC1", "tie-offset"]
ignore = "GC106"
contact = 3
part = [1, 2]
ptol = 0.05
rtol = 1
ratio = 1e-3
top = 20
)");
  EXPECT_TRUE(outcome.errors.empty());
  EXPECT_EQ(outcome.settings.options.size(), 9u);
  EXPECT_EQ(values(outcome, "units"), Words{"mm-ms-kg"});
  EXPECT_EQ(values(outcome, "select"), (Words{"GC1", "tie-offset"}));
  EXPECT_EQ(values(outcome, "ignore"), Words{"GC106"});
  EXPECT_EQ(values(outcome, "contact"), Words{"3"});
  EXPECT_EQ(values(outcome, "part"), (Words{"1", "2"}));
  EXPECT_EQ(values(outcome, "ptol"), Words{"0.05"});
  EXPECT_EQ(values(outcome, "rtol"), Words{"1"});
  EXPECT_EQ(std::stod(values(outcome, "ratio").at(0)), 1e-3);
  EXPECT_EQ(values(outcome, "top"), Words{"20"});
  EXPECT_EQ(outcome.settings.options[0].line, 4u) << "contact, the first by name";
}

TEST(SettingsFile, NothingIsSaidByAnEmptyFile) {
  for (const char* text : {"", "\n", "# only a comment", "\xEF\xBB\xBF", "select = []\n"}) {
    const Outcome outcome = read(text);
    EXPECT_TRUE(outcome.errors.empty()) << text;
    EXPECT_TRUE(outcome.settings.options.empty() && outcome.settings.ignores.empty()) << text;
    EXPECT_EQ(outcome.settings.path, "gapcheck.toml");
  }
}

TEST(SettingsFile, PathsStartAtItsFolder) {
  const std::string text = "baseline = \"known\"\ninclude-directories = [\"lib\", \"../common\", \"/abs\"]\n";
  Outcome outcome = read(text);
  EXPECT_EQ(values(outcome, "baseline"), Words{"known"});
  EXPECT_EQ(values(outcome, "include-directories"), (Words{"lib", "../common", "/abs"}));
  outcome = read(text, "a/b/gapcheck.toml");
  EXPECT_EQ(values(outcome, "baseline"), Words{"a/b/known"});
  EXPECT_EQ(values(outcome, "include-directories"), (Words{"a/b/lib", "a/common", "/abs"}));
}

TEST(SettingsFile, AnIncludeIsOneDemandPerPatternAndLimit) {
  const Outcome outcome = read(R"(
[[include]]
path = ["./lib/*.k", "dummy/"]
ignore = ["GC5", "tie-offset"]
ptol = 0.25
ratio = 0.5
until = 2027-01-31
because = "bought,
 not ours"
)",
                               "a/gapcheck.toml");
  ASSERT_EQ(outcome.errors.size(), 1u) << "a line break in a text of one line is not valid TOML";
  const Outcome good = read(R"(
[[include]]
path = ["./lib/*.k", "dummy/"]
ignore = ["GC5", "tie-offset"]
ptol = 0.25
ratio = 0.5
until = 2027-01-31
because = """bought,
not ours"""
)",
                            "a/gapcheck.toml");
  ASSERT_TRUE(good.errors.empty()) << good.errors[0].message;
  std::vector<audit::IgnoreEntry> list;
  for (const SettingsIgnore& ignore : good.settings.ignores) list.push_back(ignore.entry);
  ASSERT_EQ(list.size(), 6u);
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_TRUE(good.settings.ignores[i].decks.empty());
    EXPECT_EQ(list[i].files, i < 3 ? "lib/*.k" : "dummy/**");
    EXPECT_EQ(list[i].base, "a");
    EXPECT_EQ(list[i].file, "a/gapcheck.toml");
    EXPECT_EQ(list[i].line, 2u);
    EXPECT_EQ(list[i].reason, "bought, not ours");
    ASSERT_TRUE(list[i].until);
    EXPECT_EQ(*list[i].until, std::chrono::year(2027) / 1 / 31);
    EXPECT_EQ(list[i].rules, i % 3 == 0 ? (Words{"GC5", "tie-offset"}) : Words{"GC1"});
    EXPECT_EQ(list[i].ptol, i % 3 == 1 ? 0.25 : -1);
    EXPECT_EQ(list[i].ratio, i % 3 == 2 ? 0.5 : -1);
    EXPECT_TRUE(list[i].contacts.empty() && list[i].nodes.empty() && list[i].parts.empty() && list[i].elements.empty());
  }
}

TEST(SettingsFile, AnExceptionNamesIdsAndRanges) {
  const Outcome outcome = read(R"([[exception]]
ignore = "GC101"
deck = "./models/*.k"
contact = 3
node = ["1-500", 7]
part = "9223372036854775807"
element = [1]
until = "2028-02-29"
[[exception]]
ignore = ["released-node"]
)");
  ASSERT_TRUE(outcome.errors.empty()) << outcome.errors[0].message;
  ASSERT_EQ(outcome.settings.ignores.size(), 2u);
  const audit::IgnoreEntry& entry = outcome.settings.ignores[0].entry;
  const auto is = [](const audit::IdRange& range, std::int64_t first, std::int64_t last) {
    return range.first == first && range.last == last;
  };
  EXPECT_EQ(entry.rules, Words{"GC101"});
  ASSERT_EQ(entry.contacts.size(), 1u);
  EXPECT_TRUE(is(entry.contacts[0], 3, 3));
  ASSERT_EQ(entry.nodes.size(), 2u);
  EXPECT_TRUE(is(entry.nodes[0], 1, 500));
  EXPECT_TRUE(is(entry.nodes[1], 7, 7));
  ASSERT_EQ(entry.parts.size(), 1u);
  EXPECT_TRUE(is(entry.parts[0], 9223372036854775807, 9223372036854775807));
  ASSERT_EQ(entry.elements.size(), 1u);
  EXPECT_EQ(*entry.until, std::chrono::year(2028) / 2 / 29);
  EXPECT_EQ(entry.files, "");
  EXPECT_LT(entry.ptol, 0);
  EXPECT_EQ(outcome.settings.ignores[0].decks, Words{"models/*.k"});
  EXPECT_EQ(outcome.settings.ignores[1].entry.line, 9u);
  EXPECT_TRUE(outcome.settings.ignores[1].entry.nodes.empty() && outcome.settings.ignores[1].decks.empty());
}

TEST(SettingsFile, LettersOfAllKindsMayStandInTexts) {
  const std::string text = "für ¡Ю 中 \xF0\x9F\x98\x80";
  const Outcome outcome = read("[[exception]] # ü\nignore = \"GC1\"\nbecause = \"" + text + "\"\n");
  ASSERT_TRUE(outcome.errors.empty()) << outcome.errors[0].message;
  EXPECT_EQ(outcome.settings.ignores.at(0).entry.reason, text);
  EXPECT_EQ(read("ü = 1\n").errors.size(), 1u);
}

TEST(SettingsFile, SeveritiesByIdOrName) {
  const Outcome outcome = read("[severity]\nGC106 = \"error\"\ntie-offset = \"note\"\ngc101 = \"warning\"\n");
  ASSERT_TRUE(outcome.errors.empty()) << outcome.errors[0].message;
  EXPECT_EQ(outcome.settings.severities,
            (Severities{{"GC106", Severity::error}, {"GC202", Severity::note}, {"GC101", Severity::warning}}));
}

TEST(SettingsFile, ThresholdsByIdOrName) {
  const Outcome outcome =
      read("[threshold.warped-segment]\nangle = 15\n[threshold]\nGC411 = {highest = 0.2, lowest = 1e-2}\n");
  ASSERT_TRUE(outcome.errors.empty()) << outcome.errors[0].message;
  EXPECT_EQ(outcome.settings.thresholds,
            (audit::Thresholds{{"GC504.angle", 15}, {"GC411.highest", 0.2}, {"GC411.lowest", 0.01}}));
}

TEST(SettingsFile, WrongOnesAreNamedWithTheirLine) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"\nselct = [\"GC1\"]\n", "2: unknown key \"selct\"; did you mean \"select\"?"},
      {"fail_on = \"note\"\n", "1: unknown key \"fail_on\"; did you mean \"fail-on\"?"},
      {"[exceptions]\n", "1: unknown key \"exceptions\"; did you mean \"exception\"?"},
      {"xyzzy = 1\n", "1: unknown key \"xyzzy\""},
      {"\"\" = 1\n", "1: unknown key \"\""},
      {"units = 1\n", "1: units must be a word in quotes"},
      {"units = [\"mm-s-t\"]\n", "1: units must be a word in quotes"},
      {"units = \"\"\n", "1: units: is empty"},
      {"units.length = \"mm\"\n", "1: units must be a word in quotes"},
      {"select = [\n  \"GC1\",\n  2]\n", "3: select must be rules: \"GC101\" or [\"GC101\", \"tie-offset\"]"},
      {"select = [[\"GC1\"]]\n", "1: select must be rules: \"GC101\" or [\"GC101\", \"tie-offset\"]"},
      {"ignore = \"GC999\"\n", "1: ignore: 'GC999' is not a rule on decks; gapcheck rules lists them"},
      {"ignore = \"GC1,GC2\"\n", "1: ignore: 'GC1,GC2' is not a rule on decks; gapcheck rules lists them"},
      {"contact = 1.5\n", "1: contact must be ids: 3 or [1, 2]"},
      {"contact = \"1-5\"\n", "1: contact must be ids: 3 or [1, 2]"},
      {"ptol = -1\n", "1: ptol: must be a number of 0 or more"},
      {"ptol = \"1\"\n", "1: ptol must be a number of 0 or more"},
      {"ptol = nan\n", "1: ptol: must be a number of 0 or more"},
      {"ratio = inf\n", "1: ratio: must be a number of 0 or more"},
      {"top = 1.0\n", "1: top must be a whole number of 0 or more"},
      {"baseline = \"a\\u0000b\"\n", "1: baseline: has control characters"},
      {"baseline = \"" + std::string(5000, 'a') + "\"\n", "1: baseline: has more than 4096 characters"},
      {"include = 1\n", "1: include must be written as [[include]]"},
      {"[include]\npath = \"a\"\n", "1: include must be written as [[include]]"},
      {"include = []\n", "1: include must be written as [[include]]"},
      {"[[include]]\nignore = \"GC5\"\n", "1: [[include]] names no files: path = \"lib/*.k\""},
      {"[[include]]\npath = \"a.k\"\n", "1: [[include]] says nothing of its files; give ignore, ptol or ratio"},
      {"[[include]]\npath = \"/a/*.k\"\nptol = 1\n",
       "2: path: is absolute; write it as seen from the folder of this file"},
      {"[[include]]\npath = 'a\\b.k'\nptol = 1\n", "2: path: has a \\; folders are parted by /"},
      {"[[include]]\npath = []\nptol = 1\n", "2: path is empty; leave it out"},
      {"[[include]]\npath = \"a\"\nnode = 1\nptol = 1\n", "3: unknown key \"node\" of [[include]]"},
      {"[[exception]]\nnode = 1\n", "1: [[exception]] names no rules: ignore = \"GC101\""},
      {"[[exception]]\nignore = []\n", "2: ignore is empty; leave it out"},
      {"[[exception]]\nignore = \"GC1\"\nnode = []\n", "3: node is empty; leave it out"},
      {"[[exception]]\nignore = \"GC1\"\nnode = \"5-3\"\n",
       "3: node: must be ids above 0: 3, \"1-500\" or [3, \"7-9\"]"},
      {"[[exception]]\nignore = \"GC1\"\nnode = 0\n", "3: node: must be ids above 0: 3, \"1-500\" or [3, \"7-9\"]"},
      {"[[exception]]\nignore = \"GC1\"\nnode = \"1-99999999999999999999\"\n",
       "3: node: must be ids above 0: 3, \"1-500\" or [3, \"7-9\"]"},
      {"[[exception]]\nignore = \"GC1\"\nuntil = \"2027-02-29\"\n", "3: until: must be a day: 2027-01-31"},
      {"[[exception]]\nignore = \"GC1\"\nuntil = \"31.1.2027\"\n", "3: until: must be a day: 2027-01-31"},
      {"[[exception]]\nignore = \"GC1\"\nuntil = 2027-01-31T12:00:00\n", "3: until must be a day: 2027-01-31"},
      {"[[exception]]\nignore = \"GC1\"\nbecause = 1\n", "3: because must be a text in quotes"},
      {"threshold = 5\n", "1: threshold must be a table: [threshold.RULE]"},
      {"[threshold]\nGC504 = 5\n", "2: threshold.GC504 must be a table: [threshold.GC504]"},
      {"[threshold.warped]\nangle = 5\n", "1: 'warped' is not a rule on decks; gapcheck rules lists them"},
      {"[threshold.GC101]\nangle = 5\n", "2: initial-penetration has no threshold that can be set"},
      {"[threshold.GC411]\nhigest = 5\n", "2: soft-scale has no threshold \"higest\"; it has highest, lowest"},
      {"[threshold.GC504]\nangle = 181\n", "2: threshold.warped-segment.angle must be a number from 0 to 180"},
      {"[threshold.GC504]\nangle = nan\n", "2: threshold.warped-segment.angle must be a number from 0 to 180"},
      {"[threshold.GC504]\nangle = \"5\"\n", "2: threshold.warped-segment.angle must be a number from 0 to 180"},
      {"[threshold.GC504]\nangle = 5\n[threshold.warped-segment]\nangle = 6\n",
       "4: angle of GC504 is given twice: by id and by name"},
      {"severity = \"error\"\n", "1: severity must be a table: [severity]"},
      {"[severity]\nGC999 = \"error\"\n", "2: 'GC999' is not a rule on decks; gapcheck rules lists them"},
      {"[severity]\nGC601 = \"error\"\n", "2: 'GC601' is not a rule on decks; gapcheck rules lists them"},
      {"[severity]\nGC1 = \"error\"\n", "2: 'GC1' is not a rule on decks; gapcheck rules lists them"},
      {"[severity]\nGC101 = \"off\"\n", "2: GC101 must be \"error\", \"warning\" or \"note\""},
      {"[severity]\nGC101 = 1\n", "2: GC101 must be \"error\", \"warning\" or \"note\""},
      {"[severity]\nGC101 = \"note\"\ninitial-penetration = \"error\"\n",
       "3: the severity of GC101 is given twice: by id and by name"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(error_of(text), expected) << text;
}

TEST(SettingsFile, AllErrorsAtOnce) {
  const Outcome outcome =
      read("selct = 1\nptol = -1\n[[exception]]\nnode = 0\nfoo = 1\n[[include]]\n[severity]\nx = 1\n");
  EXPECT_EQ(outcome.errors.size(), 6u);
  EXPECT_TRUE(outcome.settings.options.empty() && outcome.settings.ignores.empty());
}

TEST(SettingsFile, FaultsOfSyntaxHaveTheirLine) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"ptol = 1\nptol = 2\n", "2: is not valid TOML: "},
      {"ptol =\n", "1: is not valid TOML: "},
      {"\n\nselect = [\"GC1\"\n", ": is not valid TOML: "},
      {"units = \"mm\nptol = 1\n", "1: is not valid TOML: "},
      {"ignore = []\n[[ignore]]\n", "2: is not valid TOML: "},
      {"because = \"\xFF\"\n", "1: is not valid TOML: "},
      {std::string("ptol = 1\0", 9), "1: is not valid TOML: "},
      {"until = 2027-02-30\n", "1: is not valid TOML: "},
      {"contact = 99999999999999999999\n", "1: is not valid TOML: "},
      {"[.a]\n", "1: is not valid TOML: "},
  };
  for (const auto& [text, expected] : cases)
    EXPECT_NE(error_of(text).find(expected), std::string::npos) << error_of(text);
}

/// `text` so many times.
std::string times(const std::string& text, std::size_t number) {
  std::string all;
  for (std::size_t i = 0; i < number; ++i) all += text;
  return all;
}

TEST(SettingsFile, WhatIsNestedDeeplyEndsEarly) {
  constexpr std::size_t many = 200000;
  for (const std::string& text :
       {"a = " + times("[", many), "a = " + times("[", many) + times("]", many), "a = " + times("{a = ", many),
        times("a.", many) + "a = 1", "[" + times("a.", many) + "a]", "[[" + times("a.", many) + "a]]",
        times("\"a\".", many) + "a = 1", "a = " + times("{" + times("a.", 90) + "a = ", 5000),
        "a = " + times("[\n{" + times("a.", 90) + "a = ", 5000)}) {
    const Outcome outcome = read(text);
    EXPECT_EQ(outcome.errors.size(), 1u) << text.substr(0, 20);
  }
  // Just allowed: unknown, but read.
  EXPECT_EQ(error_of(times("a.", 98) + "a = 1"), "1: unknown key \"a\"");
}

TEST(SettingsFile, ManyErrorsAreBounded) {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += "k" + std::to_string(i) + " = 1\n";
  EXPECT_EQ(read(text).errors.size(), 1000u);
}

TEST(SettingsFile, AnyBytesAreEitherReadOrRefused) {
  const std::string good =
      "units = \"mm-s-t\"\nselect = [\"GC1\"]\n[[include]]\npath = \"*.k\"\nptol = 1e-3\n"
      "until = 2027-01-31\n[severity]\nGC101 = \"note\"\n[[exception]]\nignore = \"GC5\"\n"
      "node = \"1-5\"\n";
  std::mt19937 random(11);
  std::size_t refused = 0;
  for (int round = 0; round < 5000; ++round) {
    std::string text = good;
    for (auto changes = 1 + random() % 4; changes > 0; --changes) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0:
          text[at] = static_cast<char>(random() % 256);
          break;
        case 1:
          text.erase(at, 1 + random() % 5);
          break;
        default:
          text.insert(at, 1, "=[]{}\"'.,\n-#0"[random() % 13]);
      }
    }
    const Outcome outcome = read(text);
    for (const Diagnostic& error : outcome.errors) EXPECT_FALSE(error.message.empty());
    refused += outcome.errors.empty() ? 0 : 1;
    for (const SettingsIgnore& ignore : outcome.settings.ignores) EXPECT_FALSE(ignore.entry.rules.empty());
  }
  EXPECT_GT(refused, 2000u);
}

TEST(SettingsFile, EveryKeyOfTheTopLevelIsAnOption) {
  ASSERT_FALSE(setting_keys().empty());
  for (const SettingKey& key : setting_keys()) {
    EXPECT_EQ(key.table.empty(), !key.option.empty()) << key.name;
    EXPECT_EQ(find_setting_key(key.table, key.name), &key);
    if (key.option.starts_with("--")) {
      EXPECT_EQ(key.option, "--" + std::string(key.name));
    }
  }
}

TEST(SettingsFile, FoldersAreAllThatIsInThem) {
  namespace fs = std::filesystem;
  std::string pattern = (fs::temp_directory_path() / "gapcheck-XXXXXX").string();
  const fs::path folder = ::mkdtemp(pattern.data());
  fs::create_directories(folder / "lib/deep");
  const std::vector<std::pair<std::string, std::string>> meant{{".", "**"},
                                                               {"./", "**"},
                                                               {"lib/..", "**"},
                                                               {"lib", "lib/**"},
                                                               {"lib/", "lib/**"},
                                                               {"./lib", "lib/**"},
                                                               {"lib/deep", "lib/deep/**"},
                                                               {"lob", "lob"},
                                                               {"lib/*", "lib/*"},
                                                               {"**", "**"}};
  for (const auto& [written, read_as] : meant) {
    const Outcome include =
        read("[[include]]\npath = \"" + written + "\"\nignore = \"GC1\"\n", (folder / "gapcheck.toml").string());
    ASSERT_EQ(include.settings.ignores.size(), 1u) << written;
    EXPECT_EQ(include.settings.ignores[0].entry.files, read_as) << written;
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace gapcheck::app::settings_file_test
