#include "report/html/html.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "report/html/html_data.hpp"
#include "report/html/html_picture.hpp"
#include "report/sample.hpp"

namespace gapcheck::report::html_test {
namespace {

HtmlOptions options() {
  HtmlOptions made;
  made.version = "1.2.3";
  return made;
}

nlohmann::json data_of(const Report& report, const NodePosition& position = {}, const HtmlOptions& with = options()) {
  return nlohmann::json::parse(html_data(report, position, with));
}

std::string bytes_of(const std::string& base64) {
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : base64) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(alphabet.find(c));
    count += 6;
    if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255u);
  }
  return bytes;
}

template <class Number>
std::vector<Number> numbers(const std::string& base64) {
  const std::string bytes = bytes_of(base64);
  std::vector<Number> values(bytes.size() / sizeof(Number));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Number));
  return values;
}

std::vector<float> floats(const std::string& base64) { return numbers<float>(base64); }
std::vector<std::uint32_t> integers(const std::string& base64) { return numbers<std::uint32_t>(base64); }

std::size_t occurrences(const std::string& text, std::string_view word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(Html, IsOnePageWithItsPolicyDataAndScripts) {
  const std::string page = html(sample_report(), {}, options());
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_EQ(occurrences(page, "Content-Security-Policy"), 1u);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_NE(page.find("REVISION=\"111\""), std::string::npos) << "three.js is not in it";
  EXPECT_EQ(page.find("<!--style-->"), std::string::npos);
  EXPECT_EQ(page.find("<!--scripts-->"), std::string::npos);
  for (const char* function :
       {"readData", "element", "showHistogram", "showMatrix", "showContacts", "makeFilters", "makeFindings",
        "makeCamera", "makeLook", "makeFocus", "makeCoats", "makeCut", "makeSelection", "makeOverlay", "makeTools",
        "makeMesh", "makeMarkers", "makeView", "showHead"})
    EXPECT_EQ(occurrences(page, std::string("function ") + function + "("), 1u) << function;
}

TEST(Html, DataHoldsWhatTheReportHolds) {
  const nlohmann::json data = data_of(sample_report());
  EXPECT_EQ(data["version"], "1.2.3");
  EXPECT_EQ(data["input"], "plates.k");
  EXPECT_EQ(data["shown"], 5);
  EXPECT_EQ(data["found"], 5);
  EXPECT_EQ(data["totals"], nlohmann::json({{"errors", 3}, {"warnings", 1}, {"notes", 1}}));
  EXPECT_EQ(data["contacts"][0]["title"], "plates");
  EXPECT_EQ(data["contacts"][1]["not_checked"], "SOFT = 2 is checked segment by segment");
  const nlohmann::json& findings = data["findings"];
  const auto text = [&](const char* column, int i) { return data["texts"][findings[column][i].get<std::size_t>()]; };
  EXPECT_EQ(findings["node"], nlohmann::json({14, 15, 16, 0, 0}));
  EXPECT_EQ(text("id", 0), "GC102");
  EXPECT_EQ(text("file", 0), "mesh.k");
  EXPECT_EQ(findings["line"], nlohmann::json({1234, 1234, 0, 40, 0}));
  EXPECT_EQ(text("id", 3), "GC501");
  EXPECT_EQ(text("message", 3), "node 12 is defined again");
  EXPECT_EQ(findings["penetration"][2], 0.3);
  EXPECT_TRUE(findings["penetration"][3].is_null());
  EXPECT_EQ(findings["segment"][0], nlohmann::json({22124, 22164, 22165, 22125}));
  EXPECT_EQ(findings["segment"][3], nlohmann::json::array());
  EXPECT_EQ(data["pairs"]["list"], nlohmann::json::parse("[[1,2,1,0.9],[0,2,1,0.3]]"));
}

TEST(Html, StatesOfFindings) {
  Report report = sample_report();
  nlohmann::json data = data_of(report);
  EXPECT_EQ(data["ignored"], 0);
  EXPECT_EQ(data["baseline"], "");
  report.ignored.penetrations = {report.penetrations[2]};
  report.ignored.findings = {report.findings[1]};
  report.ignored.source = {0, 0};
  report.ignored.sources = {{"deck.k", 9, "</script>", true, 2}};
  report.baseline.emplace();
  report.baseline->states = {BaselineState::fresh, BaselineState::worse, BaselineState::unchanged, BaselineState::fresh,
                             BaselineState::unchanged};
  data = data_of(report);
  EXPECT_EQ(data["ignored"], 2);
  EXPECT_EQ(data["baseline"], "2 new, 1 worse, 2 unchanged, 0 gone");
  EXPECT_EQ(data["found"], 7);
  EXPECT_EQ(data["shown"], 7);
  std::string states;
  for (const auto& at : data["findings"]["state"])
    states += data["texts"][at.get<std::size_t>()].get<std::string>() + " ";
  EXPECT_EQ(states, "new worse unchanged new unchanged ignored ignored ");
  EXPECT_EQ(data["texts"][data["findings"]["ignored_by"][5].get<std::size_t>()], "deck.k:9: </script>");
  EXPECT_EQ(data["findings"]["node"][5], 16);
  EXPECT_EQ(data["totals"], nlohmann::json({{"errors", 3}, {"warnings", 1}, {"notes", 1}}));
  HtmlOptions few = options();
  few.findings = 5;
  data = data_of(report, {}, few);
  EXPECT_EQ(data["shown"], 5);
  EXPECT_EQ(data["found"], 7);
  EXPECT_EQ(data["ignored"], 2);
}

TEST(Html, TextOfADeckIsNeverMarkup) {
  Report report = sample_report();
  const std::string hostile = "</script><script>alert(\"1\")</script><!--'\\\x01\n\xff\xc3\x28 \xe2\x80\xa8";
  const std::string plain = html(report, {}, options());
  report.input = report.contacts[0].title = report.contacts[0].keyword = report.files[1] = hostile;
  report.findings[0].message = report.findings[0].file = report.contacts[1].not_checked = hostile;
  report.scene.emplace();
  report.scene->parts.push_back({1, hostile, 0, 0});
  const std::string page = html(report, {}, options());
  for (const char* word : {"<script", "</script", "<!--", "<img"})
    EXPECT_EQ(occurrences(page, word), occurrences(plain, word)) << word;
  EXPECT_EQ(page.find("alert(\"1\")"), std::string::npos);
  const std::string text = html_data(report, {}, options());
  EXPECT_EQ(text.find('<'), std::string::npos);
  const nlohmann::json data = nlohmann::json::parse(text);
  EXPECT_TRUE(data["contacts"][0]["title"].get<std::string>().starts_with("</script><script>alert(\"1\")"));
  EXPECT_EQ(data["contacts"][0]["title"], data["picture"]["parts"][0]["title"]);
}

TEST(Html, MarksInTheDataAreNotReplaced) {
  Report report = sample_report();
  report.contacts[0].title = "<!--scripts--><!--three--><!--data-->";
  const std::string page = html(report, {}, options());
  EXPECT_EQ(occurrences(page, "function readData("), 1u);
  EXPECT_EQ(occurrences(page, "\\u003c!--scripts-->"), 1u);
}

TEST(Html, PositionsAndVectorsAreThoseOfTheRecords) {
  const Report report = sample_report();
  const nlohmann::json data = data_of(report);
  const std::vector<double> origin = data["picture"]["origin"];
  const std::vector<float> positions = floats(data["picture"]["positions"]),
                           vectors = floats(data["picture"]["vectors"]);
  ASSERT_EQ(positions.size(), 15u);
  ASSERT_EQ(vectors.size(), 15u);
  for (std::size_t i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(positions[3 * i + static_cast<std::size_t>(axis)] + origin[static_cast<std::size_t>(axis)],
                  report.penetrations[i].original[axis], 1e-5);
  EXPECT_TRUE(std::isnan(positions[9])) << "nobody knows where the other findings are";
  // The solver moves node 16 away from the segment; the line is as long as the penetration.
  EXPECT_FLOAT_EQ(vectors[6], 0);
  EXPECT_FLOAT_EQ(vectors[8], 0.3F);
  EXPECT_TRUE(std::isnan(vectors[12]));
}

TEST(Html, FacesAreDifferencesInFewBytes) {
  const std::vector<std::uint32_t> list{0, 1, 5, 4, 300, 4294967295U, 0};
  const std::string bytes = packed_differences(list);
  EXPECT_EQ(bytes.substr(0, 5), std::string("\0\2\x8\1\xd0", 5));
  std::vector<std::uint32_t> back;
  std::uint64_t step = 0;
  std::int64_t last = 0;
  int shift = 0;
  for (const char c : bytes) {
    step |= static_cast<std::uint64_t>(c & 127) << shift;
    shift += 7;
    if ((c & 128) != 0) continue;
    last += step % 2 == 1 ? -static_cast<std::int64_t>(step / 2) - 1 : static_cast<std::int64_t>(step / 2);
    back.push_back(static_cast<std::uint32_t>(last));
    step = 0;
    shift = 0;
  }
  EXPECT_EQ(back, list);
}

TEST(Html, IdsOfElementsAreRuns) {
  using Runs = std::vector<std::array<std::uint32_t, 2>>;
  EXPECT_EQ(id_runs({}), Runs{});
  EXPECT_EQ(id_runs({7, 8, 9, 9, 11, 3}), (Runs{{7, 3}, {9, 1}, {11, 1}, {3, 1}}));
  EXPECT_EQ(id_runs({-1, 0, 1}), (Runs{{0, 1}, {0, 1}, {1, 1}})) << "unknown ids do not count on";
  EXPECT_EQ(id_runs({std::int64_t{1} << 32, 4294967295}), (Runs{{0, 1}, {4294967295U, 1}}));
}

TEST(Html, FindingsKnowTheirPointsOfTheMesh) {
  Report report = sample_report();  // node 14 of part 1 in the segment 22124 22164 22165 22125 of part 2
  SceneMesh& scene = report.scene.emplace();
  scene.parts = {{1, "", 0, 1}, {2, "", 1, 2}};
  scene.points.resize(10);
  scene.point_nodes = {14, 1, 2, 3, 22125, 22124, 22164, 22165, 14, 99};
  scene.faces = {{0, 1, 2, 3}, {5, 6, 7, 4}, {8, 9, 4, 4}};
  scene.face_elements = {50, 60, 61};
  scene.face_thickness = {1.5F, 0.5F, 0.5F};
  const nlohmann::json picture = data_of(report)["picture"];
  const auto nodes = integers(picture["node_points"]), corners = integers(picture["corners"]);
  ASSERT_EQ(nodes.size(), 5u);
  ASSERT_EQ(corners.size(), 20u);
  EXPECT_EQ(nodes[0], 0u) << "the point of its own part";
  EXPECT_EQ(nodes[1], no_position) << "node 15 is not in the scene";
  EXPECT_EQ(nodes[3], no_position) << "no node is known";
  EXPECT_EQ(std::vector(corners.begin(), corners.begin() + 4), (std::vector<std::uint32_t>{5, 6, 7, 4}));
  EXPECT_EQ(corners[12], no_position);
  const std::string depths = bytes_of(picture["point_depths"]);
  EXPECT_EQ(depths.size(), scene.points.size());
  EXPECT_EQ(depths[0], '\xff') << "the deepest";
  EXPECT_EQ(depths[8], '\0') << "the same node in another part";
  EXPECT_EQ(picture["deepest"], report.penetrations[0].depth);
  EXPECT_EQ(integers(picture["elements"]), (std::vector<std::uint32_t>{50, 1, 60, 2}));
  EXPECT_EQ(floats(picture["thickness"]), (std::vector<float>{1.5F, 0.5F}));
  EXPECT_EQ(integers(picture["thickness_faces"]), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(bytes_of(picture["faces"]),
            packed_differences(std::vector<std::uint32_t>{0, 1, 2, 3, 5, 6, 7, 4, 8, 9, 4, 4}));
}

TEST(Html, PointsOfNodesThatMove) {
  Report report = sample_report();
  SceneMesh& scene = report.scene.emplace();
  scene.origin = Vector(1, 0, 0);
  scene.parts = {{1, "", 0, 1}};
  scene.points.resize(5);
  scene.point_nodes = {14, 1, 2, 3, 14};
  scene.faces = {{0, 1, 2, 3}};
  scene.face_elements = {50};
  scene.face_thickness = {1};
  EXPECT_FALSE(data_of(report)["picture"].contains("moved_points"));
  report.moves = {{2, Vector(4, 5, 6)}, {9, Vector(0, 0, 0)}, {14, Vector(1, 2, 3)}};
  report.said_of_moves = "3 nodes <moved>";
  const nlohmann::json data = data_of(report);
  EXPECT_EQ(integers(data["picture"]["moved_points"]), (std::vector<std::uint32_t>{0, 2, 4}));
  EXPECT_EQ(floats(data["picture"]["moved_to"]), (std::vector<float>{0, 2, 3, 3, 5, 6, 0, 2, 3}));
  EXPECT_EQ(data["moves"], "3 nodes <moved>");
}

TEST(Html, NumbersOfFindingsAreThoseOfTheReport) {
  const Report report = random_report(500, 3, 1);
  HtmlOptions with = options();
  with.findings = 40;
  with.group = 2;
  for (const HtmlFinding& finding : html_findings(report, {}, with)) {
    ASSERT_LE(finding.number, report.penetrations.size());
    EXPECT_EQ(report.penetrations[finding.number - 1].node, finding.item.node);
  }
  EXPECT_EQ(data_of(sample_report())["findings"]["number"], nlohmann::json({1, 2, 3, 4, 5}));
}

TEST(Html, PositionsComeFromTheCallerOrTheScene) {
  Report report = sample_report();
  report.penetrations.clear();
  report.findings.clear();
  TieFailure failure;
  failure.node = 5;
  report.tie_failures = {failure};
  const auto position = [](const nlohmann::json& data) { return floats(data["picture"]["positions"]); };
  EXPECT_TRUE(std::isnan(position(data_of(report))[0]));
  report.scene.emplace();
  report.scene->origin = {100, 0, 0};
  report.scene->nodes = {{4, {1, 1, 1}}, {5, {103, 2, 1}}, {9, {0, 0, 0}}};
  EXPECT_EQ(position(data_of(report)), (std::vector<float>{3, 2, 1}));
  const auto known = [](std::int64_t) { return std::optional<Vector>({101, 0, 0}); };
  EXPECT_EQ(position(data_of(report, known)), (std::vector<float>{1, 0, 0}));
}

TEST(Html, HoldsTheFirstOfEachGroupAndThenTheGravestAndDeepest) {
  const Report report = random_report(5000, 3, 1);
  HtmlOptions with = options();
  with.findings = 400;
  with.group = 10;
  const std::vector<HtmlFinding> all = html_findings(report, {}, options());
  const std::vector<HtmlFinding> some = html_findings(report, {}, with);
  ASSERT_EQ(all.size(), 5000u);
  ASSERT_EQ(some.size(), 400u);
  std::map<std::pair<std::int64_t, std::string_view>, std::size_t> groups;
  for (const HtmlFinding& finding : some) ++groups[{finding.item.contact, finding.item.id}];
  EXPECT_EQ(groups.size(), 18u) << "six kinds in three contacts";
  for (const auto& [group, count] : groups) EXPECT_GE(count, 10u);
  // Released nodes alone are errors, and there are enough of them to fill the page: the deepest must be there.
  std::vector<double> released, shown;
  for (const HtmlFinding& finding : all)
    if (finding.item.severity == Severity::error) released.push_back(finding.item.penetration);
  for (const HtmlFinding& finding : some)
    if (finding.item.severity == Severity::error) shown.push_back(finding.item.penetration);
  std::sort(released.rbegin(), released.rend());
  std::sort(shown.rbegin(), shown.rend());
  ASSERT_GT(released.size(), 400u);
  for (std::size_t i = 0; i < 150; ++i) EXPECT_EQ(shown[i], released[i]) << i;
  const nlohmann::json data = data_of(report, {}, with);
  EXPECT_EQ(data["shown"], 400);
  EXPECT_EQ(data["found"], 5000);
}

TEST(Html, HistogramsCountEveryRecordThatIsNotInTheEdgeZone) {
  const Report report = random_report(2000, 2, 7);
  HtmlOptions with = options();
  with.findings = 10;
  const nlohmann::json histogram = data_of(report, {}, with)["histogram"];
  const auto sum = [](const std::vector<int>& counts) { return std::accumulate(counts.begin(), counts.end(), 0); };
  const auto counted = std::count_if(report.penetrations.begin(), report.penetrations.end(), [](const Penetration& p) {
    return p.kind != PenetrationKind::edge_zone && p.depth > 0;
  });
  EXPECT_EQ(sum(histogram["depths"].get<std::vector<int>>()), counted);
  EXPECT_EQ(sum(histogram["ratios"].get<std::vector<int>>()), counted);
  double deepest = 0;
  for (const Penetration& p : report.penetrations)
    if (p.kind != PenetrationKind::edge_zone) deepest = std::max(deepest, p.depth);
  EXPECT_EQ(histogram["deepest"], deepest);
  EXPECT_GT(histogram["depths"].back().get<int>(), 0);
}

TEST(Html, HostileNumbersAreNoTrouble) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), huge = 1e300;
  Report report = sample_report();
  report.penetrations[0].depth = nan;
  report.penetrations[0].original = {nan, huge, 0};
  report.penetrations[1].contact_distance = 0;
  report.penetrations[1].depth = huge;
  report.penetrations[2].depth = -huge;
  report.penetrations[2].node = std::numeric_limits<std::int64_t>::max();
  report.penetrations[2].contact = 77;
  report.contacts[0].id = std::numeric_limits<std::int64_t>::min();
  report.findings[0].point = Vector(huge, huge, -huge);
  report.findings[1].penetration = nan;
  const nlohmann::json data = data_of(report);
  EXPECT_EQ(data["findings"]["node"][2], "9223372036854775807") << "a browser would round the number";
  EXPECT_EQ(data["contacts"][0]["id"], "-9223372036854775808");
  const std::vector<float> positions = floats(data["picture"]["positions"]);
  EXPECT_FALSE(positions.empty());
  for (const float x : positions) EXPECT_FALSE(std::isinf(x));
  EXPECT_EQ(data_of(Report{})["shown"], 0);
}

TEST(Html, TooManyContactsAreCounted) {
  HtmlOptions with = options();
  with.contacts = 1;
  const nlohmann::json data = data_of(sample_report(), {}, with);
  EXPECT_EQ(data["contacts"].size(), 1u);
  EXPECT_EQ(data["contacts_in_all"], 2);
}

TEST(Html, IsTheSameEachTime) {
  const Report report = random_report(3000, 4, 3);
  EXPECT_EQ(html(report, {}, options()), html(report, {}, options()));
}

}  // namespace
}  // namespace gapcheck::report::html_test
