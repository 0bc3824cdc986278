#include "contact/search/choose_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "contact/initial.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "scenes/scenes.hpp"

namespace gapcheck::contact::choose_search_test {
namespace {

using bench::SceneFacts;
using bench::SceneKind;

/// What a contact finds in one record, as far as the search could change it.
std::string text(const std::vector<Penetration>& list) {
  std::string all;
  for (const Penetration& p : list)
    all += std::to_string(p.contact) + ' ' + std::to_string(p.node) + ' ' + std::to_string(p.segment_number) + ' ' +
           std::to_string(std::bit_cast<std::uint64_t>(p.depth)) + '\n';
  return all;
}

TEST(ChooseSearch, AllSearchesFindTheSameOnAllScenesAndAsMuchAsIsInThem) {
  for (const SceneKind kind : bench::all_scenes) {
    SCOPED_TRACE(bench::name(kind));
    std::string deck_text, again;
    const SceneFacts facts = bench::write_scene(kind, 1500, [&](std::string_view piece) { deck_text += piece; });
    bench::write_scene(kind, 1500, [&](std::string_view piece) { again += piece; });
    EXPECT_EQ(deck_text, again);
    Diagnostics diagnostics;
    const auto deck = keyword::read_deck_text(deck_text, "scene.k", {}, diagnostics);
    ASSERT_TRUE(deck);
    const auto model = model::read_model(deck.value(), diagnostics);
    ASSERT_TRUE(model);
    EXPECT_FALSE(diagnostics.has_errors());
    EXPECT_EQ(model.value().mesh.nodes.size(), facts.nodes);
    EXPECT_EQ(model.value().mesh.shells.size() + model.value().mesh.solids.size(), facts.elements);
    const auto run = [&](std::optional<SearchKind> search, SearchTally& tally) {
      InitialOptions options;
      options.search = search;
      InitialCounters counters;
      SurfaceStore surfaces(model.value());
      const InitialState state = initialise_contacts(model.value(), surfaces, options, counters);
      tally = counters.searches_by_kind;
      std::uint64_t found = 0;
      for (const ContactSummary& contact : state.contacts) found += contact.penetrations + contact.edge_zone;
      EXPECT_GE(found, facts.fewest_penetrations);
      EXPECT_LE(found, facts.most_penetrations);
      return text(state.penetrations);
    };
    SearchTally tally;
    const std::string expected = run(std::nullopt, tally);
    std::uint64_t searches = 0;
    for (const std::uint64_t runs : tally.runs) searches += runs;
    EXPECT_GE(searches, model.value().contacts.size());
    for (const SearchKind search : all_searches) {
      EXPECT_EQ(run(search, tally), expected) << make_search(search)->name();
      EXPECT_EQ(tally.of(search), searches);
    }
  }
}

/// Pairs of a deck's scene as its largest search gets them: all nodes, all shells.
SearchKind choice(SceneKind kind, std::uint64_t shells, decltype(choose_search)& choose = choose_search) {
  std::string deck_text;
  bench::write_scene(kind, shells, [&](std::string_view piece) { deck_text += piece; });
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(deck_text, "scene.k", {}, diagnostics);
  const auto model = model::read_model(deck.value(), diagnostics);
  const model::Mesh& mesh = model.value().mesh;
  std::vector<Bounds> boxes;
  for (const auto& nodes : mesh.shells.nodes) {
    Bounds box;
    for (const NodeIndex n : nodes) box.add(mesh.nodes.x[n.value]);
    boxes.push_back(grown(box, 0.02));
  }
  return choose(mesh.nodes.x, boxes);
}

TEST(ChooseSearch, TakesWhatFitsTheScene) {
  EXPECT_EQ(choice(SceneKind::plates, 1500), SearchKind::sorted_sweep);
  EXPECT_EQ(choice(SceneKind::plates, 20000), SearchKind::bucket_grid);
  EXPECT_EQ(choice(SceneKind::airbag, 20000), SearchKind::bucket_grid);
  EXPECT_EQ(choice(SceneKind::cluster, 20000), SearchKind::box_tree);
}

TEST(ChooseSearch, RepeatedSearchesTakeTheGridUnlessItIsTooCoarse) {
  EXPECT_EQ(choice(SceneKind::plates, 1500, choose_repeated_search), SearchKind::bucket_grid);
  EXPECT_EQ(choice(SceneKind::plates, 20000, choose_repeated_search), SearchKind::bucket_grid);
  EXPECT_EQ(choice(SceneKind::airbag, 20000, choose_repeated_search), SearchKind::bucket_grid);
  EXPECT_EQ(choice(SceneKind::cluster, 20000, choose_repeated_search), SearchKind::box_tree);
}

/// Two layers of points 0.01 apart with boxes around those of the lower one, and a third one, half as large, `far`
/// away.
struct Layers {
  std::vector<Vector> points;
  std::vector<Bounds> boxes;

  Layers(int n, double far) {
    for (const double z : {0.0, 0.01})
      for (int i = 0; i < n * n; ++i) points.emplace_back(1.0 * (i % n) / n, 1.0 * (i / n) / n, z);
    for (int i = 0; i < n * n; ++i) boxes.push_back(grown(Bounds{points[i], points[i]}, 0.6 / n));
    for (int i = 0; i < n * n / 2; ++i) points.emplace_back(far + 1.0 * (i % n) / n, 1.0 * (i / n) / n, 0);
  }
};

// A part of many nodes far away leaves one cell for everything else. The pairs that the search hands over stay the
// same, as only those in the boxes count.
TEST(ChooseSearch, RepeatedSearchesTakeTheTreeBesideALargePartFarAway) {
  const Layers near(50, 100), far(50, 1e8);
  EXPECT_EQ(choose_repeated_search(near.points, near.boxes), SearchKind::bucket_grid);
  EXPECT_EQ(choose_repeated_search(far.points, far.boxes), SearchKind::box_tree);
  const auto pairs = [](const CandidateSearch& search, const Layers& layers) {
    std::mutex mutex;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
    search.run(layers.points, layers.boxes, [&](std::uint32_t box, std::span<const std::uint32_t> inside) {
      const std::lock_guard lock(mutex);
      for (const std::uint32_t point : inside) all.emplace_back(box, point);
    });
    std::sort(all.begin(), all.end());
    return all;
  };
  const auto found = pairs(*make_repeated_search(), far);
  EXPECT_EQ(found.size(), 2 * 50U * 50U);
  EXPECT_EQ(found, pairs(*make_bucket_grid(), far));
  EXPECT_EQ(found, pairs(*make_brute_force(), far));
  EXPECT_EQ(found, pairs(*make_repeated_search(), near));
}

TEST(ChooseSearch, StrangeInputsAreChosenForToo) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double strange : {0.0, nan, infinity, 1e300}) {
    const std::vector<Vector> points(5000, Vector::Constant(strange));
    const std::vector<Bounds> boxes(5000, Bounds{Vector::Constant(strange), Vector::Constant(strange)});
    SearchTally tally;
    std::atomic<std::uint64_t> found{0};
    make_chosen_search(tally)->run(
        points, std::span(boxes).first(10),
        [&](std::uint32_t, std::span<const std::uint32_t> inside) { found += inside.size(); });
    EXPECT_EQ(found, std::isnan(strange) ? 0U : 50000U);
  }
  SearchTally tally;
  make_chosen_search(tally)->run({}, {}, [](std::uint32_t, std::span<const std::uint32_t>) { FAIL(); });
}

}  // namespace
}  // namespace gapcheck::contact::choose_search_test
