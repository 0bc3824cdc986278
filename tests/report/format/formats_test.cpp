#include "report/format/formats.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "report/item/item.hpp"
#include "report/sample.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report::formats_test {
namespace {

using Json = nlohmann::json;

template <class Write>
std::string written(const Write& write) {
  std::string text;
  write([&text](std::string_view piece) {
    text += piece;
    return true;
  });
  return text;
}

std::size_t items(const Report& report) {
  return report.penetrations.size() + report.tie_failures.size() + report.findings.size();
}

const std::array<RuleText, 2> two_rules{{{"GC102", "released-node", Severity::error, "too deep", "# Page\n"},
                                         {"GC106", "edge-zone-penetration", Severity::note, "beside", ""}}};

Report with_hostile_text() {
  Report report = sample_report();
  report.files[1] = "mesh, \"new\" 100%.k";
  report.contacts[0].title = "<a & 'b'>\x01\xff";
  report.findings[0].message = "two\nlines, \"quoted\" <&> \xc3\x28 :: 100%";
  report.findings[0].file = "/models/a b.k";
  return report;
}

TEST(Sarif, EveryFindingWithRuleLevelPlaceAndFingerprint) {
  const Report report = with_hostile_text();
  const Json log = Json::parse(written([&](const Sink& sink) { sarif(report, "1.2", two_rules, sink); }));
  EXPECT_EQ(log["version"], "2.1.0");
  const Json& run = log["runs"][0];
  EXPECT_EQ(run["tool"]["driver"]["rules"].size(), 2U);
  EXPECT_EQ(run["tool"]["driver"]["rules"][0]["help"]["markdown"], "# Page\n");
  EXPECT_EQ(run["automationDetails"]["id"], "gapcheck/plates.k/");
  const Json& results = run["results"];
  ASSERT_EQ(results.size(), items(report));
  EXPECT_EQ(results[0]["ruleId"], "GC102");
  EXPECT_EQ(results[0]["ruleIndex"], 0);
  EXPECT_EQ(results[0]["level"], "error");
  const Json& place = results[0]["locations"][0];
  EXPECT_EQ(place["physicalLocation"]["artifactLocation"]["uri"], "mesh%2C%20%22new%22%20100%25.k");
  EXPECT_EQ(place["physicalLocation"]["region"]["startLine"], 1234);
  EXPECT_EQ(place["logicalLocations"][1]["name"], "node 14");
  EXPECT_EQ(results[0]["properties"]["penetration"], 0.9);
  EXPECT_EQ(results[3]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "file:///models/a%20b.k");
  EXPECT_FALSE(results[3].contains("ruleIndex"));  // not among the rules that were given
  for (const Json& result : results)
    EXPECT_EQ(result["partialFingerprints"]["gapcheck/v1"].get<std::string>().size(), 16U);
}

TEST(Sarif, SeveralDecksAreOneRun) {
  std::vector<Report> reports(3, with_hostile_text());
  reports[0].input = "a, b.k";
  reports[1] = Report();
  reports[1].input = "clean.k";
  const std::vector<Unread> unread{{"c.k", "is empty"}};
  const auto log_of = [&](const Reports& all) {
    return Json::parse(written([&](const Sink& sink) { sarif(all, "1.2", two_rules, sink); }));
  };
  const Json log = log_of({reports, unread});
  ASSERT_EQ(log["runs"].size(), 1U);
  const Json& run = log["runs"][0];
  EXPECT_EQ(run["tool"], log_of(reports[0])["runs"][0]["tool"]);
  EXPECT_FALSE(run.contains("automationDetails")) << "who uploads it names the category";
  ASSERT_EQ(run["artifacts"].size(), 3U);
  EXPECT_EQ(run["artifacts"][0]["location"]["uri"], "a%2C%20b.k");
  EXPECT_EQ(run["artifacts"][1], Json::parse(R"({"location": {"uri": "clean.k"}, "roles": ["analysisTarget"]})"));
  EXPECT_EQ(run["invocations"][0]["executionSuccessful"], false);
  EXPECT_EQ(run["invocations"][0]["toolExecutionNotifications"][0]["message"]["text"], "c.k: is empty");
  // The results are those of each deck, and name it.
  const std::size_t count = items(reports[0]);
  ASSERT_EQ(run["results"].size(), 2 * count);
  for (std::size_t i = 0; i < 2 * count; ++i) {
    Json result = run["results"][i];
    const std::size_t deck = i < count ? 0 : 2;
    EXPECT_EQ(result["analysisTarget"]["index"], deck);
    EXPECT_EQ(result["analysisTarget"]["uri"], run["artifacts"][deck]["location"]["uri"]);
    EXPECT_EQ(result["partialFingerprints"]["gapcheck/deck"], reports[deck].input);
    result.erase("analysisTarget");
    result["partialFingerprints"].erase("gapcheck/deck");
    EXPECT_EQ(result, log_of(reports[deck])["runs"][0]["results"][i % count]);
  }
  EXPECT_FALSE(log_of({reports, {}})["runs"][0].contains("invocations"));
  EXPECT_TRUE(log_of({{}, std::vector<Unread>(2, unread[0])})["runs"].empty());
  // The form does not depend on how many could be read.
  EXPECT_EQ(log_of({std::span(reports).first(1), unread})["runs"][0]["artifacts"].size(), 1U);
}

TEST(Gitlab, FingerprintsAreUniqueAndEveryFindingHasAPlace) {
  Report report = with_hostile_text();
  report.penetrations.push_back(report.penetrations.back());  // as two nodes in one place would be
  const Json list = Json::parse(written([&](const Sink& sink) { gitlab(report, sink); }));
  ASSERT_EQ(list.size(), items(report));
  std::set<std::string> seen;
  for (const Json& entry : list) {
    EXPECT_TRUE(seen.insert(entry["fingerprint"]).second) << entry;
    EXPECT_GE(entry["location"]["lines"]["begin"], 1);
    EXPECT_FALSE(entry["location"]["path"].get<std::string>().empty());
  }
  const std::map<std::string, std::string> severity{{"error", "major"}, {"warning", "minor"}, {"note", "info"}};
  const Json log = Json::parse(written([&](const Sink& sink) { sarif(report, "1.2", two_rules, sink); }));
  std::set<std::string> levels;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string level = log["runs"][0]["results"][i]["level"];
    levels.insert(level);
    EXPECT_EQ(list[i]["severity"], severity.at(level)) << i;
  }
  EXPECT_EQ(levels.size(), 3U) << "the sample has findings of every severity";
  Report none;
  EXPECT_EQ(Json::parse(written([&](const Sink& sink) { gitlab(none, sink); })), Json::array());
}

TEST(Github, ErrorsFirstAndTheRestOfAGroupIsCounted) {
  Report report = with_hostile_text();
  for (int i = 0; i < 4; ++i) report.penetrations.push_back(report.penetrations[0]);
  const std::string text = written([&](const Sink& sink) { github(report, 2, sink); });
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
    lines.push_back(text.substr(at, text.find('\n', at) - at));
  // Five of GC102 in two and one more; GC501, GC503; then the warning and the note.
  ASSERT_EQ(lines.size(), 7U);
  EXPECT_EQ(lines[0].rfind("::error file=mesh%2C \"new\" 100%25.k,line=1234,title=GC102 released-node::node 14", 0),
            0U);
  EXPECT_EQ(lines[2],
            "::error file=plates.k,line=34,title=GC102 released-node::3 more in contact 7: see the whole report");
  EXPECT_NE(text.find("two%0Alines, \"quoted\" <&> "), std::string::npos);
  EXPECT_EQ(lines[5].rfind("::warning ", 0), 0U);
  EXPECT_EQ(lines[6].rfind("::notice ", 0), 0U);
}

/// Reads RFC 4180 the slow way, character by character.
std::vector<std::vector<std::string>> read_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      rows.back().back() += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      rows.back().emplace_back();
    } else if (!quoted && c == '\r' && i + 1 < text.size() && text[i + 1] == '\n') {
      ++i;
      if (i + 1 < text.size()) rows.push_back({""});
    } else {
      rows.back().back() += c;
    }
  }
  return rows;
}

/// Merge requests know the files of a repository by one name only.
TEST(Formats, PathsAreThoseOfTheRepository) {
  Report report = sample_report();
  report.input = "./plates.k";
  report.files[1] = "models/../common/./mesh.inc";
  report.findings[0].file = "";
  const std::string all = written([&](const Sink& sink) { sarif(report, "1", two_rules, sink); }) +
                          written([&](const Sink& sink) { gitlab(report, sink); }) +
                          written([&](const Sink& sink) { github(report, 100, sink); });
  for (const char* place : {"\"uri\":\"common/mesh.inc\"", "\"path\":\"common/mesh.inc\"", "file=common/mesh.inc,",
                            "\"uri\":\"plates.k\"", "\"path\":\"plates.k\"", "file=plates.k"})
    EXPECT_NE(all.find(place), std::string::npos) << place;
  for (const char* place : {"models/..", "\"path\":\"./plates", "\"uri\":\"./plates", "file=./plates"})
    EXPECT_EQ(all.find(place), std::string::npos) << place;
}

TEST(Csv, EveryLineHasTheColumnsOfTheHead) {
  const Report report = with_hostile_text();
  const auto rows = read_csv(written([&](const Sink& sink) { csv(report, sink); }));
  ASSERT_EQ(rows.size(), 1 + items(report));
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  const auto at = [&](std::size_t row, std::string_view name) {
    const auto column = std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin();
    return rows[row].at(static_cast<std::size_t>(column));
  };
  EXPECT_EQ(at(1, "penetration"), "0.9");
  EXPECT_EQ(at(1, "node"), "14");
  EXPECT_EQ(at(1, "file"), report.files[1]);
  EXPECT_EQ(at(4, "message"), "two\nlines, \"quoted\" <&> ?( :: 100%");  // what is no UTF-8 is replaced
  EXPECT_EQ(at(4, "penetration"), "");
}

TEST(Csv, NothingThatASpreadsheetCalculates) {
  Report report = sample_report();
  report.input = "@deck.k";
  report.files[1] = "=cmd.k";
  report.findings[0].message = "=HYPERLINK(1)";
  report.findings[0].file = "+mesh.k";
  std::vector<Report> both{report, report};
  const auto rows = read_csv(written([&](const Sink& sink) { csv(Reports(both, {}), sink); }));
  std::set<std::string> fields;
  for (const auto& row : rows)
    for (const std::string& field : row) {
      fields.insert(field);
      const bool number = !field.empty() && std::isdigit(static_cast<unsigned char>(field.back())) != 0;
      EXPECT_TRUE(number || field.find_first_of("=+-@") != 0) << field;
    }
  for (const char* field : {"./=cmd.k", "./+mesh.k", "./@deck.k", "'=HYPERLINK(1)"})
    EXPECT_TRUE(fields.contains(field)) << field;
}

/// Numbers of the tags in a JUnit file and its counts.
std::size_t count_of(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Junit, OneSuitePerContactAndFailuresAsTheLimitHasThem) {
  const Report report = with_hostile_text();
  const auto text = [&](const Severity* limit) {
    return written([&](const Sink& sink) { junit(report, limit, 5, sink); });
  };
  const Severity error = Severity::error, note = Severity::note;
  for (const auto& [limit, failures] : {std::pair<const Severity*, int>{nullptr, 0}, {&error, 3}, {&note, 5}}) {
    const std::string xml = text(limit);
    EXPECT_EQ(count_of(xml, "<testsuite "), 3U);  // two contacts and the model
    EXPECT_EQ(count_of(xml, "<testcase "), 5U);
    EXPECT_EQ(count_of(xml, "<failure "), static_cast<std::size_t>(failures));
    EXPECT_NE(xml.find("tests=\"5\" failures=\"" + std::to_string(failures) + "\" errors=\"0\" time="),
              std::string::npos);
    EXPECT_NE(xml.find("contact 7: &lt;a &amp; &#39;b&#39;&gt;??"), std::string::npos);
  }
  Report clean = report;
  clean.penetrations.clear();
  clean.findings.clear();
  const std::string xml = written([&](const Sink& sink) { junit(clean, &note, 5, sink); });
  EXPECT_EQ(count_of(xml, "name=\"no findings\""), 3U);
  EXPECT_NE(xml.find("penetrations not checked: SOFT = 2"), std::string::npos);
}

TEST(Junit, NewlinesOfAttributesAndCommandsInNames) {
  Report report = sample_report();
  report.input = "two\nlines.k";
  report.contacts[0].title = "a\tb";
  report.files[1] = "::error file=x::mesh.k";
  report.findings[0].file = "::warning::deck.k";
  const Severity note = Severity::note;
  const std::string xml = written([&](const Sink& sink) { junit(report, &note, 100, sink); });
  EXPECT_NE(xml.find("<testsuites name=\"two&#10;lines.k\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("contact 7: a&#9;b\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("./::error file=x::mesh.k:1234: "), std::string::npos) << xml;
  for (std::size_t at = 0; at != std::string::npos; at = xml.find('\n', at + 1)) {
    const std::size_t first = xml.find_first_not_of(" \n", at);
    EXPECT_NE(xml.compare(std::min(first, xml.size()), 2, "::"), 0) << xml.substr(at, 80);
  }
}

/// The sample with one penetration, one tie and one finding left out, by two places.
Report with_ignored() {
  Report report = sample_report();
  Ignored& ignored = report.ignored;
  ignored.penetrations = {report.penetrations[0]};
  ignored.tie_failures = {TieFailure{.contact = 1, .node = 77, .reason = TieReason::too_far}};
  ignored.findings = {report.findings[0]};
  ignored.source = {1, 0, 1};
  ignored.sources = {{"mesh.k", 9, "", true, 1}, {"gapcheck <&>.toml", 12, "agreed, \"so\" <it> is", false, 2}};
  return report;
}

TEST(Ignored, JsonHasThemPlaceByPlace) {
  const Report report = with_ignored();
  const Json read = Json::parse(json(report));
  EXPECT_EQ(read["findings"].size(), items(report));
  EXPECT_EQ(read["summary"]["ignored"], 3);
  ASSERT_EQ(read["ignored"].size(), 2U);
  EXPECT_EQ(read["ignored"][0]["file"], "mesh.k");
  EXPECT_EQ(read["ignored"][0]["line"], 9);
  EXPECT_EQ(read["ignored"][0]["by"], "comment");
  EXPECT_FALSE(read["ignored"][0].contains("reason"));
  EXPECT_EQ(read["ignored"][0]["findings"][0]["node"], 77);
  EXPECT_EQ(read["ignored"][1]["by"], "settings");
  EXPECT_EQ(read["ignored"][1]["reason"], report.ignored.sources[1].reason);
  EXPECT_EQ(read["ignored"][1]["count"], 2);
  EXPECT_EQ(read["ignored"][1]["findings"][0]["id"], "GC102");
  EXPECT_EQ(read["ignored"][1]["findings"][1]["id"], "GC501");
  const Json plain = Json::parse(json(sample_report()));
  EXPECT_FALSE(plain.contains("ignored"));
  EXPECT_FALSE(plain["summary"].contains("ignored"));
}

TEST(Ignored, SarifSuppressesThem) {
  const Report report = with_ignored();
  const Json log = Json::parse(written([&](const Sink& sink) { sarif(report, "1.2", two_rules, sink); }));
  const Json& results = log["runs"][0]["results"];
  ASSERT_EQ(results.size(), items(report) + 3);
  for (std::size_t i = 0; i < items(report); ++i) EXPECT_FALSE(results[i].contains("suppressions"));
  const Json& external = results[items(report)]["suppressions"][0];
  EXPECT_EQ(external["kind"], "external");
  EXPECT_EQ(external["justification"], report.ignored.sources[1].reason);
  EXPECT_EQ(external["location"]["physicalLocation"]["region"]["startLine"], 12);
  EXPECT_EQ(results[items(report) + 1]["suppressions"][0]["kind"], "inSource");
  EXPECT_FALSE(results[items(report) + 1]["suppressions"][0].contains("justification"));
}

TEST(Ignored, JunitSkipsThem) {
  Report report = with_ignored();
  const Severity note = Severity::note;
  const auto text = [&] { return written([&](const Sink& sink) { junit(report, &note, 5, sink); }); };
  const std::string xml = text();
  EXPECT_EQ(count_of(xml, "<failure "), items(report));
  EXPECT_EQ(count_of(xml, "<skipped "), 3U);
  EXPECT_EQ(count_of(xml, "skipped=\"1\""), 3U);
  EXPECT_EQ(count_of(xml, "<testcase "), 8U);
  EXPECT_NE(xml.find("tests=\"8\" failures=\"5\""), xml.npos);
  EXPECT_NE(xml.find("1 left out on purpose by gapcheck &lt;&amp;&gt;.toml:12: agreed, &quot;so&quot; &lt;it&gt; is"),
            xml.npos)
      << xml;
  report.penetrations.clear();
  report.findings.clear();
  const std::string left = text();
  EXPECT_EQ(count_of(left, "<failure "), 0U);
  EXPECT_EQ(count_of(left, "<testcase "), 3U) << "what is left out is not a finding";
}

TEST(Ignored, AreLeftOutOfListsOfFindings) {
  const Report report = with_ignored(), plain = sample_report();
  EXPECT_EQ(written([&](const Sink& sink) { gitlab(report, sink); }),
            written([&](const Sink& sink) { gitlab(plain, sink); }));
  EXPECT_EQ(written([&](const Sink& sink) { csv(report, sink); }),
            written([&](const Sink& sink) { csv(plain, sink); }));
  EXPECT_EQ(written([&](const Sink& sink) { github(report, 100, sink); }),
            written([&](const Sink& sink) { github(plain, 100, sink); }) +
                "::notice file=mesh.k,line=9,title=ignored::3 left out on purpose by mesh.k:9 and 1 more\n");
}

TEST(Ignored, TextNamesThePlacesAndListsTheFindings) {
  Report report = with_ignored();
  const std::string short_text = text(report, {}), list = text(report, {.list = true}),
                    quiet = text(report, {.quiet = true});
  EXPECT_NE(short_text.find("\n3 ignored\n  mesh.k:9 (1)\n  gapcheck <&>.toml:12 (2) agreed, \"so\" <it> is\n"),
            std::string::npos)
      << short_text;
  EXPECT_EQ(short_text.find("node 77"), std::string::npos);
  EXPECT_NE(list.find("mesh.k:9 (1)\n    GC201 untied-node: contact 2: node 77"), std::string::npos) << list;
  EXPECT_NE(quiet.find(", 3 ignored"), std::string::npos) << quiet;
  EXPECT_EQ(text(sample_report(), {}).find("ignored"), std::string::npos);
  EXPECT_NE(text(report, {.top = 1}).find("  … and 1 more\n"), std::string::npos);
  report.ignored.sources[0].reason = "\x1b[31m" + std::string(1000, 'x') + "ä";
  EXPECT_NE(text(report, {}).find("(1) ?[31mxxx"), std::string::npos);
  EXPECT_LT(text(report, {}).size(), short_text.size() + 300);
  EXPECT_NE(text(report, {.list = true}).find("xä\n"), std::string::npos);
}

TEST(Formats, ASinkThatClosesEndsTheWriting) {
  const Report report = random_report(30000, 3, 5);
  std::size_t pieces = 0;
  const Sink closed = [&](std::string_view) { return ++pieces < 2; };
  sarif(report, "1", two_rules, closed);
  EXPECT_EQ(pieces, 2U);
  pieces = 0;
  csv(report, closed);
  EXPECT_EQ(pieces, 2U);
}

TEST(Items, GroupsHoldEveryFindingOnce) {
  const Report report = random_report(2000, 4, 8);
  std::size_t total = 0, shown = 0;
  for (const ItemGroup& group : item_groups(report, 3)) {
    total += group.items;
    shown += group.shown.size();
    EXPECT_EQ(group.shown.size(), std::min<std::size_t>(group.items, 3));
    for (const Item& item : group.shown) EXPECT_EQ(item.id, group.id);
  }
  EXPECT_EQ(total, report.penetrations.size());
  EXPECT_EQ(shown, 4 * 6 * 3U);
}

}  // namespace
}  // namespace gapcheck::report::formats_test
