// Comments of the deck and entries of settings that leave findings out, on two plates whose 18 nodes penetrate.
#include "audit/ignores.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

#include "audit/audit.hpp"
#include "audit/rules/rule_deck.hpp"
#include "audit/run.hpp"
#include "base/parallel.hpp"

namespace gapcheck::audit_test::ignores_test {
namespace {

using audit::AuditOptions;
using audit::IgnoreEntry;

constexpr std::chrono::sys_days day = std::chrono::year(2027) / 6 / 15;

std::string data(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(std::string(GAPCHECK_ROOT) + "/data/" + name + ".k").rdbuf();
  EXPECT_FALSE(text.str().empty());
  return text.str();
}

AuditRun audited(const std::string& text, AuditOptions options = {}) {
  options.today = day;
  AuditRun run = run_text(text, options);
  EXPECT_TRUE(clean(run)) << describe(run.diagnostics);
  return run;
}

/// The example deck with lines before its first keyword.
Report plates(const std::string& comments, const AuditOptions& options = {}) {
  return audited(comments + data("two_plates"), options).report;
}

std::size_t of_rule(const Report& report, std::string_view id) {
  return static_cast<std::size_t>(
      std::count_if(report.findings.begin(), report.findings.end(), [&](const Finding& f) { return f.id == id; }));
}

std::set<std::int64_t> nodes(const std::vector<Penetration>& records) {
  std::set<std::int64_t> ids;
  for (const Penetration& record : records) ids.insert(record.node);
  return ids;
}

TEST(Ignores, TakeFindingsOutOfListAndCounts) {
  const Report before = plates(""), after = plates("$ gapcheck: ignore GC101 node=1-1999 because welded\n");
  ASSERT_EQ(before.penetrations.size(), 18U);
  ASSERT_EQ(after.ignored.penetrations.size(), 9U);
  EXPECT_EQ(after.penetrations.size(), 9U);
  EXPECT_EQ(after.contacts[0].penetrations, 9U);
  EXPECT_EQ(after.ignored.source, std::vector<std::uint32_t>(9, 0));
  ASSERT_EQ(after.ignored.sources.size(), 1U);
  EXPECT_EQ(after.ignored.sources[0].reason, "welded");
  EXPECT_EQ(after.ignored.sources[0].line, 1U);
  EXPECT_EQ(after.ignored.sources[0].matched, 9U);
  EXPECT_TRUE(after.ignored.sources[0].in_deck);
  EXPECT_EQ(of_rule(after, "GC513"), 0U);
  std::set<std::int64_t> all = nodes(after.penetrations);
  all.merge(nodes(after.ignored.penetrations));
  EXPECT_EQ(all, nodes(before.penetrations));
  EXPECT_LT(*nodes(after.ignored.penetrations).rbegin(), 2000);
  EXPECT_GT(*nodes(after.penetrations).begin(), 2000);
}

TEST(Ignores, EachConditionNarrows) {
  const auto ignored = [](const std::string& conditions) {
    return plates("$ gapcheck: ignore " + conditions + "\n").ignored.size();
  };
  EXPECT_EQ(ignored("GC101"), 18U);
  EXPECT_EQ(ignored("GC1"), 18U);
  EXPECT_EQ(ignored("initial-pen"), 18U);
  EXPECT_EQ(ignored("GC102,GC101"), 18U);
  EXPECT_EQ(ignored("GC102"), 0U);
  EXPECT_EQ(ignored("GC101 contact=1"), 18U);
  EXPECT_EQ(ignored("GC101 contact=2-9"), 0U);
  EXPECT_EQ(ignored("GC101 part=1"), 18U) << "part of the node or of the segment";
  EXPECT_EQ(ignored("GC101 part=3"), 0U);
  EXPECT_EQ(ignored("GC101 node=2001"), 1U);
  EXPECT_EQ(ignored("GC101 node=2001 part=3"), 0U);
  EXPECT_EQ(ignored("GC101 node=1-9223372036854775807"), 18U);
  EXPECT_EQ(ignored("GC101 node=2001 until=2027-06-15"), 1U) << "holds on its last day";
  EXPECT_EQ(ignored("GC101 node=2001 until=2027-06-14"), 0U);
  const Report report = plates("");
  EXPECT_EQ(
      ignored(fmt::format("GC101 element={}", report.penetrations[0].element)),
      static_cast<std::size_t>(std::count_if(report.penetrations.begin(), report.penetrations.end(),
                                             [&](auto& p) { return p.element == report.penetrations[0].element; })));
}

TEST(Ignores, FindingsWithoutANodeAreInNoRangeOfNodes) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.plate(101, 2, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.contact(4, "TIED_SURFACE_TO_SURFACE", "1,2,3,3", "0.2,0.1\n1.,1.\n1.,1.\n");
  const auto ignored = [&](const std::string& comment) {
    return audited(comment + deck.text()).report.ignored.findings.size();
  };
  EXPECT_EQ(ignored("$ gapcheck: ignore tied-friction\n"), 1U);
  EXPECT_EQ(ignored("$ gapcheck: ignore tied-friction contact=4\n"), 1U);
  EXPECT_EQ(ignored("$ gapcheck: ignore tied-friction node=1-9223372036854775807\n"), 0U);
  EXPECT_EQ(ignored("$ gapcheck: ignore tied-friction part=1-9223372036854775807\n"), 0U);
}

TEST(Ignores, TiesAreLeftOutAndCountedAnew) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.node(50, Vector(2, 2, 0.7)).node(51, Vector(3, 2, 0.7)).node(52, Vector(4, 2, 0.7));
  deck.raw("SET_NODE_LIST", "7\n50,51,52\n").contact(1, "TIED_NODES_TO_SURFACE", "7,1,4,3");
  EXPECT_EQ(audited(deck.text()).report.contacts[0].untied, 3U);
  const Report after = audited("$gapcheck: ignore untied-node node=51\n" + deck.text()).report;
  ASSERT_EQ(after.ignored.tie_failures.size(), 1U);
  EXPECT_EQ(after.ignored.tie_failures[0].node, 51);
  EXPECT_EQ(after.tie_failures.size(), 2U);
  EXPECT_EQ(after.contacts[0].untied, 2U);
  EXPECT_EQ(audited("$gapcheck: ignore GC201 part=1\n" + deck.text()).report.contacts[0].untied, 3U);
}

TEST(Ignores, OfSeveralTheFirstCountsAndNoneIsUnused) {
  const Report report = plates("$ gapcheck: ignore GC101 node=2001\n$ gapcheck: ignore GC101 part=1\n");
  ASSERT_EQ(report.ignored.sources.size(), 2U);
  EXPECT_EQ(report.ignored.sources[0].matched, 1U);
  EXPECT_EQ(report.ignored.sources[1].matched, 17U);
  EXPECT_EQ(of_rule(report, "GC513"), 0U);
  const Report same = plates("$ gapcheck: ignore GC101\n$ gapcheck: ignore GC101\n");
  EXPECT_EQ(same.ignored.sources.size(), 1U);
  EXPECT_EQ(of_rule(same, "GC513"), 0U);
}

TEST(Ignores, OfSettings) {
  IgnoreEntry entry;
  entry.rules = {"GC101"};
  entry.reason = "known";
  entry.file = "gapcheck.toml";
  entry.line = 7;
  AuditOptions options;
  options.ignores = {entry};
  Report report = plates("$ gapcheck: ignore GC101 node=2001\n", options);
  ASSERT_EQ(report.ignored.sources.size(), 2U);
  EXPECT_EQ(report.ignored.sources[1].matched, 17U);
  EXPECT_FALSE(report.ignored.sources[1].in_deck);
  const auto ignored = [&](auto set) {
    options.ignores = {entry};
    set(options.ignores[0]);
    return plates("", options).ignored.size();
  };
  EXPECT_EQ(ignored([](IgnoreEntry& e) { e.ptol = 0.29; }), 0U);
  EXPECT_EQ(ignored([](IgnoreEntry& e) { e.ptol = 0.31; }), 18U);
  EXPECT_EQ(ignored([](IgnoreEntry& e) { e.ptol = 0.3; }), 18U) << "1 - 0.7, as --ptol decides";
  EXPECT_EQ(ignored([](IgnoreEntry& e) { e.ptol = 0.29999999999; }), 0U);
  EXPECT_EQ(ignored([](IgnoreEntry& e) { e.ratio = 0.3; }), 18U);
  EXPECT_EQ(ignored([](IgnoreEntry& e) { e.ratio = 0.29; }), 0U);
  EXPECT_EQ(ignored([](IgnoreEntry& e) { e.ratio = 0.31; }), 18U);
  EXPECT_EQ(ignored([](IgnoreEntry& e) { e.rules = {}; }), 0U);
  EXPECT_EQ(ignored([](IgnoreEntry& e) { e.base = ".", e.files = "*.key"; }), 0U) << "the deck is scene.k";
  EXPECT_EQ(ignored([](IgnoreEntry& e) { e.base = ".", e.files = "sc*.k"; }), 18U);
  EXPECT_EQ(ignored([](IgnoreEntry& e) { e.base = "..", e.files = "**/scene.k"; }), 18U);
  EXPECT_EQ(ignored([](IgnoreEntry& e) { e.base = "nowhere", e.files = "scene.k"; }), 0U);
}

TEST(Ignores, OfSettingsLeaveOutWhatIsSaidOfComments) {
  const std::string comments =
      "$ gapcheck: ignore GC101 node=9\n$ gapcheck: ignr GC1\n"
      "$ gapcheck: ignore GC101 node=2001 until=2020-01-01\n";
  IgnoreEntry entry;
  entry.rules = {"GC513", "bad-ignore", "GC514"};
  entry.files = "*.k";
  entry.base = ".";
  entry.file = "gapcheck.toml";
  entry.line = 7;
  IgnoreEntry over = entry;
  over.rules = {"GC101"};
  over.line = 9;
  over.until = std::chrono::year(2027) / 6 / 14;
  AuditOptions options;
  options.ignores = {over, entry};
  const Report report = plates(comments, options);
  ASSERT_EQ(report.ignored.findings.size(), 3U);
  EXPECT_EQ(report.ignored.source, (std::vector<std::uint32_t>{0, 0, 0}));
  ASSERT_EQ(report.ignored.sources.size(), 1U);
  EXPECT_EQ(report.ignored.sources[0].matched, 3U);
  EXPECT_EQ(of_rule(report, "GC513") + of_rule(report, "GC515"), 0U);
  EXPECT_EQ(of_rule(report, "GC514"), 1U) << "of the entry itself";
  options.ignores[1].files = "lib/*.k";
  EXPECT_EQ(plates(comments, options).ignored.size(), 0U);
  options.ignores[1].files = "";
  options.ignores[1].until = over.until;
  EXPECT_EQ(of_rule(plates(comments, options), "GC515"), 1U) << "its last day is over";
}

TEST(Ignores, OneLineOfSettingsIsOnePlace) {
  IgnoreEntry entry;
  entry.rules = {"GC5"};
  entry.reason = "bought";
  entry.file = "gapcheck.toml";
  entry.line = 7;
  entry.until = std::chrono::year(2027) / 6 / 14;
  AuditOptions options;
  options.ignores = {entry, entry, entry};
  options.ignores[1].rules = options.ignores[2].rules = {"GC1"};
  options.ignores[1].ptol = 0.31;
  options.ignores[2].ratio = 0.31;
  const auto messages = [&] {
    std::vector<std::string> texts;
    for (const Finding& f : plates("", options).findings)
      if (f.id == "GC514") texts.push_back(f.message);
    return texts;
  };
  EXPECT_EQ(messages(),
            std::vector<std::string>{"the ignore of GC5, GC1 held until 2027-06-14; the 18 findings that it "
                                     "would leave out count again: mend them, or give a later day"});
  options.ignores[1].ptol = options.ignores[2].ratio = 0.1;
  EXPECT_TRUE(messages().empty()) << "it may serve another deck";
}

/// Files of a deck in a folder of their own.
class IgnoresInIncludes : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "gapcheck-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  [[nodiscard]] Report audited(const std::string& path) const {
    AuditOptions options;
    options.today = day;
    const AuditRun run = run_file(path, options);
    EXPECT_TRUE(clean(run)) << describe(run.diagnostics);
    return run.report;
  }
  std::filesystem::path folder_;
};

TEST_F(IgnoresInIncludes, IdsAreThoseOfTheFile) {
  std::string text = data("two_plates");
  text.resize(text.find("*END"));
  const std::string transform =
      "*INCLUDE_TRANSFORM\nplates.k\n     10000     20000     30000     40000     50000     60000     70000\n     "
      "80000\n\n\n";
  const auto ignored = [&](const std::string& comment, const std::string& above = "") {
    write("plates.k", text + comment + "\n*END\n");
    return audited(write("main.k", above + "*KEYWORD\n" + transform + "*END\n"));
  };
  Report report = ignored("$ gapcheck: ignore GC101 node=2001 part=1 contact=1 because ours");
  ASSERT_EQ(report.ignored.penetrations.size(), 1U);
  EXPECT_EQ(report.ignored.penetrations[0].node, 12001);
  EXPECT_TRUE(report.ignored.sources[0].file.ends_with("plates.k"));
  EXPECT_EQ(ignored("", "$ gapcheck: ignore GC101 node=12001\n").ignored.size(), 1U) << "the main file sees the whole";
  EXPECT_EQ(ignored("", "$ gapcheck: ignore GC101 node=2001\n").ignored.size(), 0U);
  report = ignored("$ gapcheck: ignore GC101 node=9223372036854775807");
  EXPECT_EQ(report.ignored.size(), 0U);
  EXPECT_EQ(of_rule(report, "GC513"), 1U);
}

TEST_F(IgnoresInIncludes, AFileThatIsIncludedTwiceIsOnePlace) {
  std::string text = data("two_plates");
  text.resize(text.find("*END"));
  write("comment.k",
        "$ gapcheck: ignore GC101 node=1\n$ gapcheck: ignore GC101 node=2 until=2020-01-01\n$ gapcheck: ignore "
        "GC8\n*COMMENT\n");
  const std::string twice =
      "*INCLUDE_TRANSFORM\ncomment.k\n      2000\n\n\n\n*INCLUDE_TRANSFORM\ncomment.k\n      5000\n\n\n\n";
  const Report report = audited(write("main.k", text + twice + "*END\n"));
  EXPECT_EQ(report.ignored.size(), 1U);
  EXPECT_EQ(of_rule(report, "GC513"), 0U) << "used by one of the two";
  EXPECT_EQ(of_rule(report, "GC514"), 1U);
  EXPECT_EQ(of_rule(report, "GC515"), 1U);
}

TEST_F(IgnoresInIncludes, FilesBehindLinksHaveBothNames) {
  std::filesystem::create_directories(folder_ / "real/deep");
  std::filesystem::create_directory_symlink("real", folder_ / "link");
  write("real/deep/mesh.k", data("two_plates"));
  const std::string deck = write("main.k", "*KEYWORD\n*INCLUDE\nlink/deep/mesh.k\n*END\n");
  for (const auto& [pattern, left] : std::vector<std::pair<std::string, std::size_t>>{
           {"link/**", 0}, {"real/**", 0}, {"**/deep/*", 0}, {"*", 18}, {"rea/**", 18}, {"link/real/**", 18}}) {
    IgnoreEntry entry;
    entry.rules = {"GC101"};
    entry.files = pattern;
    entry.base = folder_.string();
    entry.file = "gapcheck.toml";
    AuditOptions options;
    options.ignores = {entry};
    EXPECT_EQ(run_file(deck, options).report.penetrations.size(), left) << pattern;
  }
}

TEST(Ignores, AnywhereInTheDeck) {
  const std::string deck = data("two_plates"), comment = "$  gapCheck:ignore GC101 node=2001\n";
  for (const char* mark : {"*NODE\n", "*CONTACT", "*TITLE\n", "    2001  ", "*END"}) {
    std::string text = deck;
    const auto at = text.find(mark);
    ASSERT_NE(at, std::string::npos) << mark;
    text.insert(at, comment);
    EXPECT_EQ(audited(text).report.ignored.size(), 1U) << mark;
  }
  EXPECT_EQ(audited(deck + comment).report.ignored.size(), 0U) << "nothing behind *END is read";
}

TEST(Ignores, HostileComments) {
  std::string many;
  for (int i = 0; i < 30'000; ++i) many += "$ gapcheck: ignore GC101 node=1-9223372036854775807\n";
  const Report same = plates(many);
  EXPECT_EQ(same.ignored.size(), 18U);
  EXPECT_EQ(of_rule(same, "GC513"), 0U);
  many.clear();
  for (int i = 0; i < 30'000; ++i)
    many += fmt::format("$ gapcheck: ignore GC101 node={}-9223372036854775807\n", 3000 + i);
  EXPECT_EQ(of_rule(plates(many), "GC513"), 30'000U);
  const std::string megabyte(1 << 20, '7');
  EXPECT_EQ(of_rule(plates("$ gapcheck: ignore GC101 node=" + megabyte + "\n"), "GC515"), 1U);
  EXPECT_EQ(of_rule(plates("$ gapcheck: " + megabyte + "\n"), "GC515"), 1U);
  const std::string end = data("two_plates");
  const auto at = end.find("*END");
  EXPECT_EQ(of_rule(audited(end.substr(0, at) + "$ gapcheck: ignore GC101 node=").report, "GC515"), 1U);
  EXPECT_EQ(of_rule(audited(end.substr(0, at) + "$ gapcheck:").report, "GC515"), 1U);
  EXPECT_EQ(
      of_rule(audited(end.substr(0, at) + "$ gapcheck: ign" + std::string(5000, 'x') + std::string("\0\xff\x01\0", 4))
                  .report,
              "GC515"),
      1U);
}

/// Every comment against every finding.
TEST(Ignores, ManyAreWhatTheyAreOneByOne) {
  const std::vector<Penetration> all = plates("").penetrations;
  std::mt19937 random(7);
  const auto below = [&](std::int64_t n) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint32_t>(n));
  };
  for (int trial = 0; trial < 40; ++trial) {
    std::string comments;
    std::vector<std::uint64_t> matched;
    std::set<std::size_t> taken;
    std::size_t unused = 0;
    for (int line = 0; line < 60; ++line) {
      audit::IdRange node{1, 9999}, element = node, part = node;
      std::string text = below(5) == 0 ? "GC102" : below(5) == 0 ? "GC102,GC101" : "GC1";
      const auto narrow = [&](const char* key, audit::IdRange& range, std::int64_t first, std::int64_t count) {
        range.first = first + below(count);
        range.last = range.first + below(4);
        text += fmt::format(" {}={}-{}", key, range.first, range.last);
      };
      if (below(2) == 0) narrow("node", node, below(2) == 0 ? 1000 : 2000, 18);
      if (below(4) == 0) narrow("element", element, below(2) == 0 ? 1000 : 2009, 12);
      if (below(4) == 0) narrow("part", part, 1, 3);
      const auto in = [](const audit::IdRange& range, std::int64_t id) {
        return range.first <= id && id <= range.last;
      };
      std::uint64_t mine = 0;
      bool used = false;
      for (std::size_t i = 0; i < all.size(); ++i) {
        const Penetration& p = all[i];
        if (text.starts_with("GC102") && !text.starts_with("GC102,")) continue;
        if (!in(node, p.node) || !in(element, p.element) || !(in(part, p.part) || in(part, p.element_part))) continue;
        used = true;
        mine += taken.insert(i).second ? 1 : 0;
      }
      if (mine > 0) matched.push_back(mine);
      unused += used ? 0 : 1;
      comments += "$ gapcheck: ignore " + text + "\n";
    }
    const Report report = plates(comments);
    std::vector<std::uint64_t> found;
    for (const IgnoreSource& source : report.ignored.sources) found.push_back(source.matched);
    EXPECT_EQ(found, matched) << comments;
    EXPECT_EQ(report.ignored.size(), taken.size());
    EXPECT_EQ(of_rule(report, "GC513"), unused) << comments;
  }
}

TEST(Ignores, TheSameForAnyNumberOfThreads) {
  std::string comments;
  for (int i = 0; i < 1000; ++i) comments += fmt::format("$ gapcheck: ignore GC1 node={}-{}\n", 1001 + i, 1001 + 2 * i);
  const auto one = [&] {
    const JobLimit limit(1);
    return dump(plates(comments));
  }();
  const JobLimit limit(4);
  EXPECT_EQ(one, dump(plates(comments)));
}

}  // namespace
}  // namespace gapcheck::audit_test::ignores_test
