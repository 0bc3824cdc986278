// Times the stages of an audit one by one. Each stage's result is checked before it is timed.
#include <benchmark/benchmark.h>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "audit/audit.hpp"
#include "contact/surface/surface.hpp"
#include "geometry/closest_point.hpp"
#include "geometry/decide.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "scenes/plates.hpp"

namespace gapcheck::bench {
namespace {

/// A deck and its model, which must stay together.
struct Loaded {
  std::string text;
  keyword::Deck deck;
  model::Model model;
  bool ok = false;
};

std::unique_ptr<Loaded> load(int n) {
  auto loaded = std::make_unique<Loaded>();
  loaded->text = plates_deck(n, false);
  Diagnostics diagnostics;
  auto deck = keyword::read_deck_text(loaded->text, "plates.k", {}, diagnostics);
  if (!deck) return loaded;
  loaded->deck = std::move(deck).value();
  auto model = model::read_model(loaded->deck, diagnostics);
  if (!model || diagnostics.has_errors()) return loaded;
  loaded->model = std::move(model).value();
  loaded->ok = loaded->model.mesh.shells.size() == 2 * static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  return loaded;
}

int size_of(const benchmark::State& state) { return static_cast<int>(state.range(0)); }

void count_shells(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * 2 * state.range(0) * state.range(0));
}

void read(benchmark::State& state) {
  const std::string text = plates_deck(size_of(state), false);
  for (auto _ : state) {
    Diagnostics diagnostics;
    auto deck = keyword::read_deck_text(text, "plates.k", {}, diagnostics);
    if (!deck) return state.SkipWithError("deck not read");
    benchmark::DoNotOptimize(deck.value().blocks().size());
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

void model(benchmark::State& state) {
  const auto loaded = load(size_of(state));
  if (!loaded->ok) return state.SkipWithError("model not read");
  for (auto _ : state) {
    Diagnostics diagnostics;
    auto result = model::read_model(loaded->deck, diagnostics);
    benchmark::DoNotOptimize(result.ok());
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(loaded->text.size()));
}

struct Surfaces {
  contact::Segments segments;
  contact::TrackedNodes nodes;
};

Surfaces make_surfaces(const model::Model& model) {
  const model::Contact& contact = model.contacts.front();
  const contact::ContactType type = contact::classify(contact);
  const auto settings = contact::settings(contact, type, model.controls);
  const auto side = contact::thickness_side(contact, settings, model.controls, false);
  contact::MeshIndex index(model);
  auto selection = contact::select(model, contact.a, type, model.mesh.nodes.x, index);
  contact::fill_thickness(selection.segments, model, side, model.mesh.nodes.x);
  auto nodes = contact::tracked_nodes(selection, model, side, model.mesh.nodes.x, index);
  return {std::move(selection.segments), std::move(nodes)};
}

void surfaces(benchmark::State& state) {
  const auto loaded = load(size_of(state));
  if (!loaded->ok) return state.SkipWithError("model not read");
  if (make_surfaces(loaded->model).segments.size() != loaded->model.mesh.shells.size())
    return state.SkipWithError("segments are missing");
  for (auto _ : state) benchmark::DoNotOptimize(make_surfaces(loaded->model).nodes.size());
  count_shells(state);
}

/// The points and boxes that the search of the plates' contact gets.
struct SearchInput {
  std::vector<Vector> points;
  std::vector<contact::Bounds> boxes;
};

SearchInput search_input(const model::Model& model) {
  SearchInput input;
  input.points = model.mesh.nodes.x;
  for (const auto& nodes : model.mesh.shells.nodes) {
    contact::Bounds box;
    for (const NodeIndex node : nodes) box.add(model.mesh.nodes.x[node.value]);
    box.low.array() -= 1.0, box.high.array() += 1.0;
    input.boxes.push_back(box);
  }
  return input;
}

std::uint64_t count_candidates(const contact::CandidateSearch& search, const SearchInput& input) {
  std::atomic<std::uint64_t> count{0};
  search.run(input.points, input.boxes,
             [&](std::uint32_t, std::span<const std::uint32_t> nodes) { count += nodes.size(); });
  return count;
}

void time_search(benchmark::State& state, const contact::CandidateSearch& search) {
  const auto loaded = load(size_of(state));
  if (!loaded->ok) return state.SkipWithError("model not read");
  const SearchInput input = search_input(loaded->model);
  // Four own nodes and at least the one of the other plate.
  if (count_candidates(search, input) < 4 * input.boxes.size()) return state.SkipWithError("candidates are missing");
  for (auto _ : state) benchmark::DoNotOptimize(count_candidates(search, input));
  count_shells(state);
}

void search_grid(benchmark::State& state) { time_search(state, *contact::make_bucket_grid()); }
void search_brute_force(benchmark::State& state) { time_search(state, *contact::make_brute_force()); }

void decide(benchmark::State& state) {
  const int n = size_of(state);
  const auto loaded = load(n);
  if (!loaded->ok) return state.SkipWithError("model not read");
  const auto& mesh = loaded->model.mesh;
  const std::size_t lower = mesh.shells.size() / 2;
  geometry::DecisionCounters counters;
  // Each shell of the lower plate with the node of the upper plate above it.
  const auto near = [&](std::size_t e) {
    geometry::Facet facet;
    for (std::size_t i = 0; i < 4; ++i) facet.x[i] = mesh.nodes.x[mesh.shells.nodes[e][i].value];
    const Vector& query = mesh.nodes.x[mesh.shells.nodes[e + lower][0].value];
    const auto closest = geometry::closest_point(facet, query);
    return geometry::closer_than(facet, query, 1.0, geometry::Mode::filtered, counters, &closest);
  };
  for (std::size_t e = 0; e < lower; ++e) {
    if (!near(e)) return state.SkipWithError("a wrong decision");
  }
  for (auto _ : state) {
    for (std::size_t e = 0; e < lower; ++e) benchmark::DoNotOptimize(near(e));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(lower));
}

void audit(benchmark::State& state) {
  const std::string text = plates_deck(size_of(state), false);
  for (auto _ : state) {
    Diagnostics diagnostics;
    auto report = audit::audit_text(text, "plates.k", {}, diagnostics);
    const auto expected = static_cast<std::size_t>(2 * state.range(0) * state.range(0));
    if (!report || report.value().penetrations.size() != expected) return state.SkipWithError("wrong findings");
  }
  count_shells(state);
}

BENCHMARK(read)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(model)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(surfaces)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(search_grid)->Arg(20)->Arg(40)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(search_brute_force)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(decide)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(audit)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace gapcheck::bench
