// Times the searches for candidates on the scenes, with the points and boxes that an audit gives them:
// gapcheck_search_bench SHELLS ROUNDS JOBS [KIND…]. The pairs found are compared before anything is timed. One line per
// scene: name, shells, pairs, median seconds of the bucket grid, sorted sweep, box tree and the chosen search (choosing
// included), the chosen kinds, and the median over the rounds of chosen / best of the three in that round.
#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <ranges>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "base/system/memory.hpp"
#include "contact/pair/closest_segment.hpp"
#include "contact/pair/side_scene.hpp"
#include "contact/search/choose_search.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "scenes/scenes.hpp"

namespace gapcheck::bench {
namespace {

/// The points and boxes of one search.
struct Input {
  std::vector<Vector> points;
  std::vector<contact::Bounds> boxes;
};

/// Keeps what it is asked and finds nothing.
class Recorder final : public contact::CandidateSearch {
 public:
  explicit Recorder(std::vector<Input>& inputs) : inputs_(inputs) {}
  [[nodiscard]] std::string_view name() const override { return "recorder"; }
  void run(std::span<const Vector> points, std::span<const contact::Bounds> boxes,
           const contact::CandidateSink&) const override {
    inputs_.push_back({{points.begin(), points.end()}, {boxes.begin(), boxes.end()}});
  }

 private:
  std::vector<Input>& inputs_;
};

/// What the contacts of a deck ask a search, side by side. Empty: the deck could not be read.
std::vector<Input> inputs_of(SceneKind kind, std::uint64_t shells, SceneFacts& facts) {
  std::string text;
  facts = write_scene(kind, shells, [&](std::string_view piece) { text += piece; });
  Diagnostics diagnostics;
  auto deck = keyword::read_deck_text(std::move(text), "scene.k", {}, diagnostics);
  if (!deck) return {};
  const auto model = model::read_model(deck.value(), diagnostics);
  if (!model || diagnostics.has_errors()) return {};
  std::vector<Input> inputs;
  const Recorder recorder(inputs);
  contact::SurfaceStore store(model.value());
  for (const ContactIndex c : positions<ContactIndex>(model.value().contacts.size())) {
    const contact::ContactSurfaces& sides = store.at(c);
    for (const bool exchanged : {false, true}) {
      if (exchanged && sides.type.treatment != contact::Treatment::two_way) continue;
      const contact::SideScene side(model.value(), c, sides, exchanged, model.value().mesh.nodes.x);
      contact::SweepCounters counters;
      geometry::DecisionCounters decisions;
      const contact::PairFilter all{[](SlotIndex, SegmentIndex, bool) { return true; }};
      (void)contact::closest_segments(side.scene(), recorder, all, counters, decisions);
    }
  }
  return inputs;
}

/// Number of pairs and a sum over them that does not depend on their order.
struct Found {
  std::uint64_t pairs = 0, sum = 0;
  bool operator==(const Found&) const = default;
};

Found run(const contact::CandidateSearch& search, const std::vector<Input>& inputs) {
  // Each thread has a tally of its own: shared counters would cost more than the search.
  tbb::enumerable_thread_specific<Found> found;
  for (const Input& input : inputs)
    search.run(input.points, input.boxes, [&](std::uint32_t box, std::span<const std::uint32_t> inside) {
      Found& mine = found.local();
      mine.pairs += inside.size();
      for (const std::uint32_t point : inside)
        mine.sum += (std::uint64_t{box} << 32 | point) * 0x9E3779B97F4A7C15ULL >> 7;
    });
  Found all;
  for (const Found& mine : found) all.pairs += mine.pairs, all.sum += mine.sum;
  return all;
}

/// Seconds of one thread's work where there is one thread, which other programs disturb little; else by the clock.
double now(std::size_t jobs) {
  if (jobs == 1) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double seconds(const contact::CandidateSearch& search, const std::vector<Input>& inputs, std::size_t repeats,
               std::size_t jobs) {
  const double start = now(jobs);
  for (std::size_t i = 0; i < repeats; ++i) (void)run(search, inputs);
  return (now(jobs) - start) / static_cast<double>(repeats);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// False: the searches disagree, or the deck could not be read.
bool measure(SceneKind kind, std::uint64_t shells, std::size_t rounds, std::size_t jobs) {
  using contact::SearchKind;
  constexpr std::array kinds{SearchKind::bucket_grid, SearchKind::sorted_sweep, SearchKind::box_tree};
  constexpr double shortest = 0.02;  // a round takes at least so many seconds
  constexpr double hopeless = 20;
  SceneFacts facts;
  const std::vector<Input> inputs = inputs_of(kind, shells, facts);
  contact::SearchTally tally;
  std::vector<std::unique_ptr<contact::CandidateSearch>> searches;
  for (const SearchKind each : kinds) searches.push_back(contact::make_search(each));
  searches.push_back(contact::make_chosen_search(tally));
  const Found expected = run(*searches.back(), inputs);
  std::string chosen;
  for (const SearchKind each : kinds)
    if (tally.of(each) > 0)
      chosen += fmt::format("{}{} {}", chosen.empty() ? "" : ", ", contact::make_search(each)->name(), tally.of(each));
  std::vector<std::vector<double>> times(searches.size());
  std::vector<std::size_t> repeats;
  std::vector<double> firsts;
  double fastest = std::numeric_limits<double>::infinity();
  for (const auto& search : std::views::reverse(searches)) {
    const double start = now(jobs);
    if (run(*search, inputs) != expected) {
      fmt::print(stderr, "{}: the {} finds other pairs\n", name(kind), search->name());
      return false;
    }
    const double once = now(jobs) - start;
    fastest = std::min(fastest, once);
    firsts.push_back(once);
    // What is hopeless is not timed again.
    repeats.push_back(once > hopeless * fastest ? 0 : 1 + static_cast<std::size_t>(shortest / std::max(once, 1e-6)));
  }
  if (expected.pairs < facts.fewest_penetrations) {
    fmt::print(stderr, "{}: candidates are missing\n", name(kind));
    return false;
  }
  std::reverse(repeats.begin(), repeats.end());
  std::reverse(firsts.begin(), firsts.end());
  std::vector<double> ratios;
  for (std::size_t round = 0; round < rounds; ++round) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < searches.size(); ++i) {
      times[i].push_back(repeats[i] == 0 ? firsts[i] : seconds(*searches[i], inputs, repeats[i], jobs));
      if (i < kinds.size()) best = std::min(best, times[i].back());
    }
    ratios.push_back(times.back().back() / best);
  }
  fmt::print("{};{};{};{}", name(kind), facts.elements, inputs.size(), expected.pairs);
  for (const auto& list : times) fmt::print(";{:.6f}", median(list));
  fmt::print(";{};{:.2f}\n", chosen, median(ratios));
  std::fflush(stdout);
  return true;
}

}  // namespace
}  // namespace gapcheck::bench

int main(int argc, char** argv) {
  using namespace gapcheck::bench;
  std::vector<SceneKind> kinds;
  bool good = argc >= 4;
  for (int i = 4; i < argc; ++i) {
    const auto kind = scene_kind(argv[i]);
    good = good && kind;
    if (kind) kinds.push_back(*kind);
  }
  const long shells = good ? std::atol(argv[1]) : 0, rounds = good ? std::atol(argv[2]) : 0,
             jobs = good ? std::atol(argv[3]) : 0;
  if (!good || shells < 1000 || rounds < 1 || jobs < 1) {
    fmt::print(stderr, "usage: gapcheck_search_bench SHELLS ROUNDS JOBS [KIND...]   (SHELLS from 1000)\n");
    return 2;
  }
  if (kinds.empty()) kinds.assign(all_scenes.begin(), all_scenes.end());
  gapcheck::system::keep_freed_memory();  // as the program does
  const gapcheck::JobLimit limit(static_cast<std::size_t>(jobs));
  for (const SceneKind kind : kinds)
    if (!measure(kind, static_cast<std::uint64_t>(shells), static_cast<std::size_t>(rounds),
                 static_cast<std::size_t>(jobs)))
      return 1;
  return 0;
}
