// Every deck of data/ gives exactly the findings beside it: penetrations as computed in closed form, others by number.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "audit/run.hpp"
#include "base/parallel.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit_test::data_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Key = std::pair<std::int64_t, std::int64_t>;  ///< contact, node

const fs::path data_folder = fs::path(GAPCHECK_ROOT) / "data";
constexpr const char* suffix = ".expected.json";

std::vector<std::string> deck_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(data_folder)) {
    const std::string file = entry.path().filename().string();
    if (file.ends_with(suffix)) names.push_back(file.substr(0, file.size() - std::string(suffix).size()));
  }
  std::sort(names.begin(), names.end());
  return names;
}

void expect_same_point(const Vector& got, const json& expected, double scale) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], expected[static_cast<std::size_t>(i)].get<double>(), 1e-9 * scale);
}

void expect_same(const Penetration& p, const json& expected) {
  EXPECT_EQ(rule_of(p.kind).name, expected["rule"]);
  EXPECT_EQ(std::string(name(p.outcome)), expected["outcome"]);
  EXPECT_EQ(std::string(name(p.feature)), expected["feature"]);
  const double depth = expected["penetration"], h = expected["contact_distance"];
  EXPECT_NEAR(p.depth, depth, 1e-9 * depth);
  EXPECT_NEAR(p.contact_distance, h, 1e-9 * h);
  // A position is known to the digits of its coordinates only.
  const double scale = std::max(1.0, p.original.cwiseAbs().maxCoeff());
  EXPECT_EQ(p.recommended(), expected.contains("recommended"));
  if (expected.contains("moved_to"))
    expect_same_point(p.moved_to, expected["moved_to"], scale);
  else if (expected.contains("recommended"))
    expect_same_point(p.moved_to, expected["recommended"], scale);
  else
    EXPECT_EQ(p.moved_to, p.original);
}

/// Findings that the expectations only count, by name of the rule: all but the penetrations of nodes.
std::map<std::string, std::size_t> others(const Report& report) {
  std::map<std::string, std::size_t> counts;
  for (const auto& finding : report.findings) ++counts[finding.rule];
  for (const auto& p : report.penetrations)
    if (p.kind == PenetrationKind::segment || p.kind == PenetrationKind::mortar)
      ++counts[std::string(rule_of(p.kind).name)];
  for (const auto& failure : report.tie_failures) ++counts[std::string(rule_of(failure).name)];
  return counts;
}

class Data : public testing::TestWithParam<std::string> {};

TEST_P(Data, GivesTheExpectedFindings) {
  const fs::path deck = data_folder / (GetParam() + ".k");
  std::ifstream file(data_folder / (GetParam() + suffix));
  const json expected = json::parse(file);
  const AuditRun run = run_file(deck.string());
  ASSERT_TRUE(clean(run));
  EXPECT_TRUE(run.diagnostics.empty()) << describe(run.diagnostics);
  EXPECT_EQ(others(run.report), (expected["others"].get<std::map<std::string, std::size_t>>()));

  std::map<Key, const Penetration*> found;
  for (const auto& p : run.report.penetrations) {
    if (p.kind == PenetrationKind::segment || p.kind == PenetrationKind::mortar) continue;  // counted above
    const bool first = found.emplace(Key{run.report.contacts.at(p.contact).id, p.node}, &p).second;
    EXPECT_TRUE(first) << "node " << p.node << " twice in one contact";
  }
  for (const json& entry : expected["findings"]) {
    SCOPED_TRACE("contact " + entry["contact"].dump() + " node " + entry["node"].dump());
    const auto match = found.find({entry["contact"], entry["node"]});
    if (match == found.end()) {
      ADD_FAILURE() << "not found; expected " << entry.dump();
      continue;
    }
    expect_same(*match->second, entry);
    found.erase(match);
  }
  for (const auto& [key, p] : found)
    ADD_FAILURE() << "unexpected: contact " << key.first << " node " << key.second << " " << rule_of(p->kind).name
                  << " depth " << p->depth << " of " << p->contact_distance;
}

// Contacts that work by segments have no node to judge. Rules on segments judge them, and are left out here.
TEST_P(Data, SaysWhatWasNotChecked) {
  std::ifstream file(data_folder / (GetParam() + suffix));
  const std::vector<std::int64_t> not_checked = json::parse(file)["not_checked"];
  audit::AuditOptions options;
  options.select = {"GC101", "GC102", "GC106"};
  const AuditRun run = run_file((data_folder / (GetParam() + ".k")).string(), options);
  ASSERT_TRUE(clean(run));
  std::size_t found = 0;
  for (const auto& contact : run.report.contacts) {
    const bool expected = std::find(not_checked.begin(), not_checked.end(), contact.id) != not_checked.end();
    EXPECT_EQ(!contact.not_checked.empty(), expected) << "contact " << contact.id << ": " << contact.not_checked;
    found += expected ? 1 : 0;
  }
  EXPECT_EQ(found, not_checked.size()) << "a contact that is expected is not there";
}

// The slow search, decisions without the filter, and one thread give the same bytes.
TEST_P(Data, AllSearchesAgree) {
  const std::string deck = (data_folder / (GetParam() + ".k")).string();
  const std::string fast = dump(run_file(deck).report);
  audit::AuditOptions slow, exact;
  slow.brute_force = true;
  exact.exact = true;
  EXPECT_EQ(fast, dump(run_file(deck, slow).report));
  EXPECT_EQ(fast, dump(run_file(deck, exact).report));
  const JobLimit one(1);
  EXPECT_EQ(fast, dump(run_file(deck).report));
}

std::string test_name(const testing::TestParamInfo<std::string>& instance) { return instance.param; }

INSTANTIATE_TEST_SUITE_P(AllDecks, Data, testing::ValuesIn(deck_names()), test_name);

TEST(DataFolder, HasADeckForEveryExpectation) {
  const auto names = deck_names();
  EXPECT_GE(names.size(), 37u);
  for (const auto& name : names) EXPECT_TRUE(fs::exists(data_folder / (name + ".k"))) << name;
}

}  // namespace
}  // namespace gapcheck::audit_test::data_test
