// Baselines of decks that change.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>

#include "audit/random_scene.hpp"
#include "audit/run.hpp"
#include "report/baseline/baseline.hpp"

namespace gapcheck::report::baseline_decks_test {
namespace {

using enum BaselineState;
using audit_test::Scene;

/// `before` written to a file and read back, then compared with `now`.
BaselineComparison compared(const Report& before, const Report& now) {
  const auto read = read_baseline(baseline_text(known_findings(before)), "baseline");
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.error().message);
  if (!read) return {};
  return compare_with_baseline(now, read.value(), [](const KnownFinding&) { return true; });
}

std::string outcome(const Report& before, const Report& now) { return summary(compared(before, now)); }

/// What is gone, new or worse, line by line.
std::string differences(const BaselineComparison& comparison, const Report& now) {
  std::string text;
  for (const KnownFinding& known : comparison.gone) text += "gone: " + describe(known) + '\n';
  const std::vector<KnownFinding> list = known_findings(now);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (comparison.states[i] != BaselineState::unchanged)
      text += fmt::format("{}: {}\n", name(comparison.states[i]), describe(list[i]));
  return text;
}

Report audited(const std::string& text) {
  const audit_test::AuditRun run = audit_test::run_text(text);
  EXPECT_TRUE(run.ok);
  return run.report;
}

std::string data(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(std::string(GAPCHECK_ROOT) + "/data/" + name).rdbuf();
  EXPECT_FALSE(text.str().empty());
  return text.str();
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  std::size_t times = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size(), ++times)
    text.replace(at, what.size(), by);
  EXPECT_GT(times, 0U);
  return text;
}

std::size_t size_of(const Report& report) {
  return report.penetrations.size() + report.tie_failures.size() + report.findings.size();
}

/// What the audit says of penetrating nodes, without ids: contact, kind, place, depth.
std::vector<std::string> penetrations(const Report& report) {
  std::vector<std::string> list;
  for (const Penetration& p : report.penetrations)
    list.push_back(fmt::format("{} {} {:.9g} {:.9g} {:.9g} {:.6g}", p.contact, static_cast<int>(p.kind), p.original.x(),
                               p.original.y(), p.original.z(), p.depth));
  std::sort(list.begin(), list.end());
  return list;
}

TEST(BaselineOfDecks, RenumberedAndShuffled) {
  std::mt19937_64 random(3);
  std::size_t findings = 0, scenes = 0;
  for (std::uint64_t seed = 2001; seed <= 2060; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = audit_test::random_scene(seed);
    Scene other = scene;
    const auto renumber = [](std::int64_t id) { return 9000001 - 7 * id; };
    for (auto& node : other.nodes) node.id = renumber(node.id);
    for (auto& element : other.elements) {
      element.id = 5000000 - 3 * element.id;
      for (auto& node : element.nodes) node = renumber(node);
    }
    std::shuffle(other.nodes.begin(), other.nodes.end(), random);
    std::shuffle(other.elements.begin(), other.elements.end(), random);
    std::shuffle(other.parts.begin(), other.parts.end(), random);
    Report before = audited(scene.text()), after = audited(other.text());
    // Of segments equally near to a node the first in the deck counts, and with it its thickness: the order of elements
    // may change what the solver does, and then the audit rightly says so.
    if (penetrations(before) != penetrations(after)) continue;
    ++scenes;
    findings += size_of(after);
    EXPECT_EQ(outcome(before, after), fmt::format("0 new, 0 worse, {} unchanged, 0 gone", size_of(after)))
        << differences(compared(before, after), after);
  }
  EXPECT_GE(scenes, 55U);
  EXPECT_GT(findings, 500U);
}

TEST(BaselineOfDecks, APlateThatMovesDeeper) {
  const std::string deck = data("two_plates.k");
  const Report before = audited(deck), after = audited(replaced(deck, "             0.7\n", "             0.6\n"));
  ASSERT_EQ(after.penetrations.size(), 18U);
  const BaselineComparison comparison = compared(before, after);
  for (std::size_t i = 0; i < 18; ++i) EXPECT_EQ(comparison.states[i], worse);
  EXPECT_EQ(comparison.count(fresh), 0U) << summary(comparison);
  EXPECT_TRUE(comparison.gone.empty());
  const BaselineComparison back = compared(after, before);
  EXPECT_EQ(summary(back), fmt::format("0 new, 0 worse, {} unchanged, 0 gone", size_of(before)));
}

}  // namespace
}  // namespace gapcheck::report::baseline_decks_test
