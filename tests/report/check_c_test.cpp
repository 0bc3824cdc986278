// The views of check-c on records made here. The program itself, with its options and whole outputs, is tested in
// tests/apps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "report/item/contact_keyword.hpp"
#include "report/item/describe_tie.hpp"
#include "report/text/check_c_tables.hpp"
#include "report/text/check_c_view.hpp"
#include "sample.hpp"

namespace gapcheck::report::check_c_test {
namespace {

TieFailure tie(std::uint32_t contact, std::int64_t node, TieReason reason, double distance = -1) {
  TieFailure failure;
  failure.contact = contact;
  failure.node = node;
  failure.reason = reason;
  failure.distance = distance;
  return failure;
}

SolverMessage solver_message(std::string kind, std::uint32_t line) {
  SolverMessage message;
  message.code = 49001;
  message.kind = std::move(kind);
  message.line = line;
  return message;
}

/// Random penetrations, tie failures of all reasons, time steps, messages, rigid walls.
Report solver_report(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  Report report = random_report(count, 4, seed);
  report.source = "messag";
  for (Penetration& record : report.penetrations)
    if (random() % 7 == 0) record.contact_distance = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto reason = static_cast<TieReason>(random() % 8);
    report.tie_failures.push_back(tie(static_cast<std::uint32_t>(i * 4 / count),
                                      static_cast<std::int64_t>(random() % 1000), reason,
                                      random() % 2 == 0 ? -1 : static_cast<double>(random() % 100) / 50));
  }
  report.run.emplace();
  for (std::uint32_t i = 0; i < 4; ++i) report.run->surface_timesteps.push_back({i, 'A', "13", 1e-6, 1, 1});
  for (std::int64_t i = 1; i < 5; ++i) report.run->rigidwalls.push_back({i, 1, static_cast<double>(i) / 2, 0, 0});
  report.run->messages = {solver_message("soft2-intersection", 30), solver_message("soft2-intersection", 10),
                          solver_message("soft2-switched-off", 5), solver_message("", 1)};
  return report;
}

std::multiset<std::int64_t> nodes(const Report& report, std::int64_t contact_id) {
  std::multiset<std::int64_t> result;
  for (const Penetration& record : report.penetrations)
    if (report.contacts[record.contact].id == contact_id) result.insert(record.node);
  return result;
}

TEST(CheckC, PickAgreesWithTheOptionsTakenOneByOne) {
  const Report report = solver_report(400, 1);
  CheckCOptions options;
  options.sid = {2, 4, 99};
  options.ptol = 0.05;
  options.rtol = 300;
  const Report picked = pick(report, options);
  ASSERT_EQ(picked.contacts.size(), 2u);
  EXPECT_EQ(picked.contacts[0].id, 2);
  EXPECT_EQ(picked.contacts[1].id, 4);
  for (const std::int64_t id : {2, 4}) {
    std::multiset<std::int64_t> expected;
    for (const Penetration& p : report.penetrations) {
      const bool remaining = p.contact_distance == 0 || p.contact_distance - p.depth < 300;
      const bool deep = p.depth > 0.05 || p.depth == 0;
      if (report.contacts[p.contact].id == id && deep && remaining) expected.insert(p.node);
    }
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(nodes(picked, id), expected);
  }
  std::size_t ties = 0;
  for (const TieFailure& t : report.tie_failures)
    ties += (t.contact == 1 || t.contact == 3) && (t.distance < 0 || t.distance > 0.05);
  EXPECT_EQ(picked.tie_failures.size(), ties);
  EXPECT_EQ(picked.run->surface_timesteps.size(), 2u);
  EXPECT_TRUE(picked.run->rigidwalls.empty()) << "a rigid wall is not an interface";
}

TEST(CheckC, CountsOfContactsFollowTheRecords) {
  CheckCOptions options;
  options.ptol = 0.1;
  const Report picked = pick(solver_report(300, 2), options);
  std::map<std::uint32_t, std::size_t> initial, untied_nodes;
  for (const Penetration& record : picked.penetrations)
    initial[record.contact] += record.kind == PenetrationKind::initial;
  for (const TieFailure& failure : picked.tie_failures) untied_nodes[failure.contact] += untied(failure.reason);
  ASSERT_EQ(picked.contacts.size(), 4u);
  for (std::uint32_t i = 0; i < picked.contacts.size(); ++i) {
    EXPECT_GT(initial[i] * untied_nodes[i], 0u) << "nothing to count";
    EXPECT_EQ(picked.contacts[i].penetrations, initial[i]);
    EXPECT_EQ(picked.contacts[i].untied, untied_nodes[i]);
  }
}

/// What a word of -sel leaves.
struct Left {
  std::size_t penetrations = 0, ties = 0, messages = 0;
  bool operator==(const Left&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Left& left) {
  return out << left.penetrations << ' ' << left.ties << ' ' << left.messages;
}

Left left(const Report& report, const std::string& sel) {
  CheckCOptions options;
  options.sel = sel;
  const Report picked = pick(report, options);
  return {picked.penetrations.size(), picked.tie_failures.size(), picked.run->messages.size()};
}

TEST(CheckC, SelectionsOfTypes) {
  Report report = solver_report(500, 3);
  std::map<TieReason, std::size_t> reasons;
  std::map<PenetrationKind, std::size_t> kinds;
  for (const TieFailure& failure : report.tie_failures) ++reasons[failure.reason];
  for (const Penetration& record : report.penetrations) ++kinds[record.kind];
  ASSERT_EQ(reasons.size(), 8u);
  EXPECT_EQ(left(report, ""), (Left{500, 500, 4}));
  EXPECT_EQ(left(report, "tied"), (Left{0, 500, 0}));
  EXPECT_EQ(left(report, "untied"), (Left{0, 500 - reasons[TieReason::sep] - reasons[TieReason::offset], 0}));
  for (const TieReason reason : tie_reasons)
    EXPECT_EQ(left(report, std::string(name(reason))), (Left{0, reasons[reason], 0})) << name(reason);
  EXPECT_EQ(left(report, "typ13"), (Left{500, 0, 0}));
  EXPECT_EQ(left(report, "pen"), (Left{kinds[PenetrationKind::initial], 0, 0}));
  for (const char* word : {"mid", "del", "below"})
    EXPECT_EQ(left(report, word), (Left{kinds[PenetrationKind::released], 0, 0}));
  for (const char* word : {"soft2", "war"}) EXPECT_EQ(left(report, word), (Left{0, 0, 3}));
  EXPECT_EQ(left(report, "inter"), (Left{0, 0, 2}));
  for (const auto& [word, line] : {std::pair("first", 10u), std::pair("last", 30u)}) {
    CheckCOptions options;
    options.sel = word;
    const Report picked = pick(report, options);
    ASSERT_EQ(picked.run->messages.size(), 1u);
    EXPECT_EQ(picked.run->messages[0].line, line);
  }
}

TEST(CheckC, KnownSelections) {
  for (const char* word :
       {"tied",  "sep", "offset", "far", "short", "notfound", "rigslav", "rigmast", "conflict", "untied",
        "typ13", "pen", "mid",    "del", "below", "soft2",    "inter",   "war",     "first",    "last"})
    EXPECT_TRUE(known_selection(word)) << word;
  for (const char* word : {"", "all", "TIED", "tie", "pens"}) EXPECT_FALSE(known_selection(word)) << word;
}

TEST(CheckC, PickSurvivesRecordsOfContactsThatDoNotExist) {
  Report report;
  report.source = "messag";
  report.penetrations.resize(3);
  report.penetrations[1].contact = 4'000'000'000u;
  report.tie_failures.push_back(tie(7, 1, TieReason::conflict));
  const Report picked = pick(report, {});
  EXPECT_TRUE(picked.penetrations.empty());
  EXPECT_TRUE(picked.tie_failures.empty());
  EXPECT_NE(check_c_text(picked, {}).find("total: 0 nodes"), std::string::npos);
}

TEST(CheckC, OrderIsThatOfASortedCopy) {
  const Report report = solver_report(300, 4);
  for (const bool rsort : {false, true}) {
    const auto order = in_view_order(report, report.penetrations, rsort);
    ASSERT_EQ(order.size(), report.penetrations.size());
    for (std::size_t i = 1; i < order.size(); ++i) {
      const Penetration &a = *order[i - 1], &b = *order[i];
      if (!rsort) {
        EXPECT_TRUE(a.depth > b.depth || (a.depth == b.depth && a.node <= b.node));
      } else if (knows_remaining(report, b)) {
        EXPECT_TRUE(knows_remaining(report, a) && a.remaining() <= b.remaining());
      }
    }
  }
}

TEST(CheckC, TopOnlyTakesTheFirstOfEachInterfaceAndReason) {
  const Report report = solver_report(200, 5);
  CheckCOptions options;
  options.top = 3;
  const Report top = top_only(report, options);
  std::map<std::uint32_t, std::vector<double>> all, taken;
  for (const Penetration& record : report.penetrations) all[record.contact].push_back(record.depth);
  for (const Penetration& record : top.penetrations) taken[record.contact].push_back(record.depth);
  for (auto& [contact, depths] : all) {
    std::sort(depths.rbegin(), depths.rend());
    depths.resize(std::min<std::size_t>(3, depths.size()));
    EXPECT_EQ(taken[contact], depths);
  }
  std::map<std::pair<std::uint32_t, TieReason>, std::size_t> all_ties, ties;
  for (const TieFailure& failure : report.tie_failures) ++all_ties[{failure.contact, failure.reason}];
  for (const TieFailure& failure : top.tie_failures) ++ties[{failure.contact, failure.reason}];
  ASSERT_EQ(ties.size(), all_ties.size());
  ASSERT_FALSE(ties.empty());
  for (const auto& [key, count] : ties) EXPECT_EQ(count, std::min<std::size_t>(3, all_ties[key]));
}

TEST(CheckC, BucketsHoldEveryValueOnce) {
  std::mt19937 random(6);
  std::vector<double> values(1000);
  for (double& value : values) value = std::uniform_real_distribution(0.0, 3.0)(random);
  values.insert(values.end(), {0.0, 3.0, -1.0});
  const auto counts = buckets(values, 3.0);
  for (std::size_t i = 0; i < bucket_count; ++i) {
    const double from = i == 0 ? -10 : 0.3 * static_cast<double>(i),
                 to = i == 9 ? 10 : 0.3 * static_cast<double>(i + 1);
    const auto inside = std::count_if(values.begin(), values.end(), [&](double v) { return v >= from && v < to; });
    EXPECT_EQ(counts[i], static_cast<std::size_t>(inside)) << i;
  }
  EXPECT_EQ(buckets(std::vector<double>{0.0, 0.0}, 0.0)[0], 2u) << "nothing to divide by";
}

TEST(CheckC, CountsWithoutAListAreWarnings) {
  Report report;
  report.source = "messag";
  report.contacts.push_back(make_contact(2, 0, "", "", 0, 0));
  report.contacts[0].reported_penetrations = 3;
  EXPECT_EQ(warning_count(pick(report, {})), 3u);
  Penetration record;
  record.node = 5;
  report.penetrations.push_back(record);
  report.contacts[0].penetrations = 1;
  const Report picked = pick(report, {});
  EXPECT_EQ(warning_count(picked), 3u) << "one of the three is listed";
  const std::string text = check_c_text(picked, {});
  EXPECT_NE(text.find("pen, counted without a list: 2 nodes"), std::string::npos) << text;
  EXPECT_NE(text.find("total: 3 nodes penetrating"), std::string::npos) << text;
  CheckCOptions tied;
  tied.sel = "tied";
  EXPECT_EQ(warning_count(pick(report, tied)), 0u);
}

TEST(CheckC, TextOfTheFileCannotSteerTheTerminal) {
  Report report = solver_report(10, 7);
  report.contacts[0].title = "a\x1b[31mred\n";
  report.contacts[0].type = "\x07";
  report.run->messages[3].text = "\x1b]0;x\x07";
  report.run->version = "\x1b";
  CheckCOptions options;
  options.title = options.type_code = options.type_keyword = options.list = true;
  EXPECT_EQ(check_c_text(report, options).find_first_of("\x1b\x07"), std::string::npos);
}

TEST(CheckC, NumbersThatAreNoneAreSorted) {
  Report report = solver_report(50, 8);
  report.penetrations[0].depth = INFINITY;
  report.penetrations[1].depth = NAN;
  CheckCOptions options;
  options.bucket = options.rsort = options.psum = true;
  const std::string text = check_c_text(report, options);
  EXPECT_NE(text.find("total: 50 nodes"), std::string::npos) << text;
  for (const bool rsort : {false, true}) {
    const auto order = in_view_order(report, report.penetrations, rsort);
    EXPECT_EQ(std::set(order.begin(), order.end()).size(), 50u) << "each once";
  }
}

TEST(ContactKeyword, CodesAndKeywords) {
  const auto keyword = [](const std::string& code) { return contact_keyword(make_contact(1, 1, "", code, 0, 0)); };
  EXPECT_EQ(keyword("13"), "AUTOMATIC_SINGLE_SURFACE");
  EXPECT_EQ(keyword("a13"), "AIRBAG_SINGLE_SURFACE");
  EXPECT_EQ(keyword("a3"), "AUTOMATIC_SURFACE_TO_SURFACE");
  EXPECT_EQ(keyword("m10"), "FORMING_ONE_WAY_SURFACE_TO_SURFACE");
  EXPECT_EQ(keyword("o6"), "TIED_NODES_TO_SURFACE_OFFSET");
  EXPECT_EQ(keyword("b7"), "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET");
  EXPECT_EQ(keyword("c2"), "TIED_SURFACE_TO_SURFACE_CONSTRAINED_OFFSET");
  EXPECT_EQ(keyword("i26"), "AUTOMATIC_GENERAL_INTERIOR");
  EXPECT_EQ(keyword("*"), "MORTAR");
  for (const char* code : {"", "99", "z3", "a99", "a"}) EXPECT_EQ(keyword(code), "?") << code;
  EXPECT_EQ(contact_keyword(make_contact(1, 1, "CONTACT_TIED_SURFACE_TO_SURFACE", "2", 0, 0)),
            "TIED_SURFACE_TO_SURFACE");
}

}  // namespace
}  // namespace gapcheck::report::check_c_test
