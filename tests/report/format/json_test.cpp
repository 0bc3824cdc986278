#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "report/item/describe.hpp"
#include "report/item/fingerprint.hpp"
#include "report/sample.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report::json_test {
namespace {

using Json = nlohmann::json;

std::string to_text(const fmt::memory_buffer& buffer) { return {buffer.data(), buffer.size()}; }

Json coordinates(const Vector& x) { return Json::array({x[0], x[1], x[2]}); }

/// The slow twin: one record as a document in memory.
Json document(const Report& report, const Penetration& record) {
  fmt::memory_buffer message, cause;
  append_message(record, message);
  append_cause(record, cause);
  const RuleIdentity& rule = rule_of(record.kind);
  const std::int64_t contact = report.contacts[record.contact].id;
  Json json = {{"rule", rule.name},
               {"id", rule.id},
               {"severity", name(rule.severity)},
               {"message", to_text(message)},
               {"contact", contact},
               {"node", record.node},
               {"segment", record.segment},
               {"penetration", record.depth},
               {"remaining", record.contact_distance - record.depth},
               {"contact_distance", record.contact_distance},
               {"st", {record.s, record.t}},
               {"feature", name(record.feature)},
               {"original", coordinates(record.original)},
               {"point", coordinates(record.point)},
               {"fingerprint", fmt::format("{:016x}", fingerprint(record, contact))}};
  if (record.part != 0) json["part"] = record.part;
  if (record.element != 0) json["element"] = record.element;
  if (record.element_part != 0) json["element_part"] = record.element_part;
  if (record.outcome == Outcome::moved || record.moved_to != record.original)
    json[record.outcome == Outcome::kept ? "recommended" : "moved_to"] = coordinates(record.moved_to);
  if (record.kind != PenetrationKind::edge_zone &&
      (record.kind != PenetrationKind::edge || record.outcome != Outcome::reported))
    json["outcome"] = name(record.outcome);
  if (cause.size() > 0) json["cause"] = to_text(cause);
  if (record.line != 0) {
    json["file"] = report.files[record.file];
    json["line"] = record.line;
  }
  return json;
}

TEST(Json, HoldsTheKeysOfTheSchema) {
  const Report report = sample_report();
  const Json json = Json::parse(gapcheck::report::json(report));
  EXPECT_EQ(json["schema"], "gapcheck/1");
  EXPECT_EQ(json["source"], "deck");
  EXPECT_EQ(json["input"], "plates.k");
  EXPECT_EQ(json["model"]["nodes"], 50);
  EXPECT_EQ(json["model"]["contacts"], 2);
  ASSERT_EQ(json["contacts"].size(), 2u);
  EXPECT_EQ(json["contacts"][0]["id"], 7);
  EXPECT_EQ(json["contacts"][0]["title"], "plates");
  EXPECT_EQ(json["contacts"][0]["type"], "13");
  EXPECT_EQ(json["contacts"][0]["max_penetration"], 0.9);
  EXPECT_FALSE(json["contacts"][0].contains("not_checked"));
  EXPECT_EQ(json["contacts"][1]["not_checked"], "SOFT = 2 is checked segment by segment");
  ASSERT_EQ(json["findings"].size(), 5u);
  EXPECT_EQ(json["findings"][3]["rule"], "duplicate-id");
  EXPECT_EQ(json["findings"][3]["line"], 40);
  EXPECT_EQ(json["findings"][4]["contact"], 2);
  EXPECT_EQ(json["summary"], Json({{"errors", 3}, {"warnings", 1}, {"notes", 1}}));
  EXPECT_TRUE(json["timing"].contains("read_s"));
}

TEST(Json, TheSummaryCountsConsequences) {
  Report report = sample_report();
  report.findings[0].key = 1;
  report.findings[1].cause = 1;
  const Json json = Json::parse(gapcheck::report::json(report));
  EXPECT_EQ(json["summary"], Json({{"errors", 3}, {"warnings", 1}, {"notes", 1}, {"consequences", 1}}));
  EXPECT_EQ(json["findings"][4]["cause"], json["findings"][3]["fingerprint"]);
  // Its cause is ignored: it stands by itself.
  report.findings[0].key = 0;
  EXPECT_FALSE(Json::parse(gapcheck::report::json(report))["summary"].contains("consequences"));
}

TEST(Json, FindingsSayWhatTheyKnow) {
  Report report = sample_report();
  Finding& known = report.findings[0];
  known.node = 14;
  known.part = 1;
  known.element = 500;
  known.element_part = 2;
  known.penetration = 0.5;
  known.contact_distance = 1;
  known.point = Vector(1, 2, 3);
  known.count = 12;
  const Json json = Json::parse(gapcheck::report::json(report));
  const Json &full = json["findings"][3], &bare = json["findings"][4];
  EXPECT_EQ(full["node"], 14);
  EXPECT_EQ(full["part"], 1);
  EXPECT_EQ(full["element"], 500);
  EXPECT_EQ(full["element_part"], 2);
  EXPECT_EQ(full["penetration"], 0.5);
  EXPECT_EQ(full["contact_distance"], 1.0);
  EXPECT_EQ(full["point"], Json({1.0, 2.0, 3.0}));
  EXPECT_EQ(full["count"], 12);
  for (const char* key :
       {"node", "part", "element", "element_part", "penetration", "contact_distance", "point", "count"})
    EXPECT_FALSE(bare.contains(key)) << key;
}

TEST(Json, EqualsTheDocumentBuiltInMemory) {
  const Report report = random_report(5000, 3, 1);
  const Json json = Json::parse(gapcheck::report::json(report));
  ASSERT_EQ(json["findings"].size(), report.penetrations.size());
  for (std::size_t i = 0; i < report.penetrations.size(); ++i)
    ASSERT_EQ(json["findings"][i], document(report, report.penetrations[i])) << i;
}

TEST(Json, LeavesOutWhatTheSourceDoesNotKnow) {
  Report report = sample_report();
  report.penetrations.resize(1);
  Penetration& record = report.penetrations[0];
  record.part = record.element = record.element_part = 0;
  record.segment = {};
  record.line = 0;
  record.node_rule = record.segment_rule = ThicknessRule::none;
  const Json finding = Json::parse(gapcheck::report::json(report))["findings"][0];
  for (const char* key : {"part", "element", "element_part", "segment", "file", "line", "cause", "moved_to"})
    EXPECT_FALSE(finding.contains(key)) << key;
}

TEST(Json, NumbersReadBackExactly) {
  Report report = sample_report();
  report.penetrations.resize(1);
  for (const double value : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, 1e23, -0.0, 123456789.123456789}) {
    report.penetrations[0].depth = value;
    const double back = Json::parse(gapcheck::report::json(report))["findings"][0]["penetration"];
    EXPECT_EQ(back, value);
  }
}

TEST(Json, StaysValidForHostileContent) {
  Report report = sample_report();
  report.input = "a\"b\\c\n\x01\xff\xfe.k";
  report.contacts[0].title = std::string("\0zero\x1b[31m", 10);
  report.findings[0].message = "\xc3(";
  report.files[1] = "quote\".k";
  report.penetrations[0].depth = std::numeric_limits<double>::quiet_NaN();
  report.penetrations[0].original = Vector::Constant(std::numeric_limits<double>::infinity());
  report.penetrations[1].file = 99;
  report.penetrations[2].contact = 99;
  const Json json = Json::parse(gapcheck::report::json(report));
  EXPECT_TRUE(json["findings"][0]["penetration"].is_null());
  EXPECT_EQ(json["findings"][0]["file"], "quote\".k");
  EXPECT_FALSE(json["findings"][1].contains("file"));
  EXPECT_FALSE(json["findings"][2].contains("contact"));
}

TEST(Json, PiecesJoinToTheWhole) {
  const Report report = random_report(20000, 2, 2);
  std::string joined;
  std::size_t pieces = 0;
  json(report, [&](std::string_view piece) {
    joined += piece;
    ++pieces;
    return true;
  });
  EXPECT_GT(pieces, 3u);
  EXPECT_EQ(joined, json(report));
}

TEST(Json, EndsWhenTheSinkIsFull) {
  const Report report = random_report(20000, 2, 3);
  std::size_t pieces = 0;
  json(report, [&](std::string_view) { return ++pieces < 2; });
  EXPECT_EQ(pieces, 2u);
}

TEST(Json, EmptyReport) {
  const Json json = Json::parse(gapcheck::report::json(Report{}));
  EXPECT_TRUE(json["findings"].empty());
  EXPECT_TRUE(json["contacts"].empty());
}

TEST(Json, PortabilityOnDemandOnly) {
  Report report = sample_report();
  EXPECT_FALSE(nlohmann::json::parse(json(report)).contains("portability"));
  report.portability = Portability{{"A program"}, {}};
  EXPECT_EQ(nlohmann::json::parse(json(report))["portability"], nlohmann::json::array());
  report.portability->notes = {{"A \"program\"", PortabilityKind::option, false, "MPP", 2, "a\xff.k", 4, "https://a"},
                               {"A program", PortabilityKind::field, true, "SOFT", 3, "", 0, "https://b"}};
  EXPECT_EQ(
      nlohmann::json::parse(json(report))["portability"],
      nlohmann::json::parse(
          R"([{"program":"A \"program\"","kind":"option","name":"MPP","use":"none","count":2,"file":"a\ufffd.k",)"
          R"("line":4,"source":"https://a"},)"
          R"({"program":"A program","kind":"field","name":"SOFT","use":"other","count":3,"source":"https://b"}])"));
}

TEST(Json, StatisticsOnDemandOnly) {
  Report report = sample_report();
  report.statistics = {
      {"bytes read", "1234"}, {"note", "a \"word\""}, {"note", "007"}, {"note", ""}, {"searches", "0"}};
  const auto written = [&](bool statistics) {
    std::string text;
    json(
        report,
        [&](std::string_view piece) {
          text += piece;
          return true;
        },
        statistics);
    return Json::parse(text);
  };
  EXPECT_FALSE(written(false).contains("statistics"));
  const Json all = written(true);
  EXPECT_EQ(all["statistics"], Json::parse(R"([{"name": "bytes read", "value": 1234},
                                               {"name": "note", "value": "a \"word\""},
                                               {"name": "note", "value": "007"},
                                               {"name": "note", "value": ""},
                                               {"name": "searches", "value": 0}])"));
  EXPECT_EQ(all["findings"], written(false)["findings"]);
}

}  // namespace
}  // namespace gapcheck::report::json_test
