// Random scenes: slow search = fast search, exact = filtered, any number of threads, and all of it = the reference.
#include "audit/random_scene.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

#include "audit/run.hpp"
#include "base/parallel.hpp"
#include "model/model.hpp"
#include "reference/penetration_reference.hpp"

namespace gapcheck::audit_test::random_scene_test {
namespace {

constexpr std::uint64_t scenes = 200;
using Key = std::pair<std::int64_t, std::int64_t>;  ///< contact, node

std::string audited(const Scene& scene, const audit::AuditOptions& options = {}) {
  const AuditRun run = run_text(scene.text(), options);
  EXPECT_TRUE(clean(run));
  return dump(run.report);
}

TEST(RandomScene, SlowSearchFindsTheSame) {
  audit::AuditOptions slow;
  slow.brute_force = true;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    const Scene scene = random_scene(seed);
    ASSERT_EQ(audited(scene), audited(scene, slow)) << "seed " << seed;
  }
}

TEST(RandomScene, ExactDecisionsAreTheSame) {
  audit::AuditOptions exact;
  exact.exact = true;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    const Scene scene = random_scene(seed);
    ASSERT_EQ(audited(scene), audited(scene, exact)) << "seed " << seed;
  }
}

TEST(RandomScene, ThreadsChangeNothing) {
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    const Scene scene = random_scene(seed);
    std::string one, two;
    {
      const JobLimit limit(1);
      one = audited(scene);
    }
    {
      const JobLimit limit(2);
      two = audited(scene);
    }
    ASSERT_EQ(one, two) << "seed " << seed;
  }
}

reference::Findings reference_of(const Scene& scene) {
  Diagnostics diagnostics;
  auto deck = keyword::read_deck_text(scene.text(), "scene.k", {}, diagnostics);
  EXPECT_TRUE(deck.ok());
  if (!deck.ok()) return {};
  auto model = model::read_model(deck.value(), diagnostics);
  EXPECT_TRUE(model.ok());
  return model.ok() ? reference::find_penetrations(model.value()) : reference::Findings{};
}

struct Tally {
  std::size_t compared = 0, doubtful = 0, released = 0, edge_zone = 0;
};

void compare(const Report& report, const reference::Findings& expected, Tally& tally) {
  std::set<Key> doubts;
  for (const auto& d : expected.doubts) doubts.emplace(d.contact, d.node);
  const std::set<std::int64_t> judged(expected.judged.begin(), expected.judged.end());
  std::map<Key, const Penetration*> found;
  for (const auto& p : report.penetrations) {
    const Key key{report.contacts.at(p.contact).id, p.node};
    if (judged.contains(key.first) && !doubts.contains(key)) found.emplace(key, &p);
  }
  tally.doubtful += doubts.size();
  for (const auto& r : expected.records) {
    const Key key{r.contact, r.node};
    if (!judged.contains(r.contact) || doubts.contains(key)) continue;
    const auto match = found.find(key);
    if (match == found.end()) {
      ADD_FAILURE() << "missed: contact " << r.contact << " node " << r.node << " depth " << r.depth << " of "
                    << r.contact_distance << " kind " << static_cast<int>(r.kind);
      continue;
    }
    const Penetration& p = *match->second;
    SCOPED_TRACE("contact " + std::to_string(r.contact) + " node " + std::to_string(r.node));
    EXPECT_EQ(static_cast<int>(p.kind), static_cast<int>(r.kind));
    EXPECT_NEAR(p.depth, r.depth, 1e-6 * std::max(r.contact_distance, 1e-3));
    EXPECT_NEAR(p.contact_distance, r.contact_distance, 1e-12);
    if (r.kind == PenetrationKind::initial) {
      EXPECT_EQ(p.outcome, r.outcome);
    }
    ++tally.compared;
    tally.released += r.kind == PenetrationKind::released;
    tally.edge_zone += r.kind == PenetrationKind::edge_zone;
    found.erase(match);
  }
  for (const auto& [key, p] : found)
    ADD_FAILURE() << "extra: contact " << key.first << " node " << key.second << " depth " << p->depth << " of "
                  << p->contact_distance << " kind " << static_cast<int>(p->kind);
}

TEST(RandomScene, AgreesWithTheReference) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    const Scene scene = random_scene(seed);
    const AuditRun run = run_text(scene.text());
    ASSERT_TRUE(clean(run)) << "seed " << seed;
    SCOPED_TRACE("seed " + std::to_string(seed));
    compare(run.report, reference_of(scene), tally);
  }
  // The scenes must be worth their while.
  EXPECT_GT(tally.compared, 1000u);
  EXPECT_GT(tally.released, 20u);
  EXPECT_GT(tally.edge_zone, 20u);
  EXPECT_LT(tally.doubtful, tally.compared / 40);  // among them nodes next to faces of solids
}

}  // namespace
}  // namespace gapcheck::audit_test::random_scene_test
