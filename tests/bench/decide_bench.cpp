// Certified decisions beside the same decisions in plain doubles, on the candidate pairs of decks and on families of
// hard pairs. The certified ones are compared with those in exact numbers before anything is timed.
// usage: gapcheck_decide_bench [--rounds N] [--count PAIRS_PER_FAMILY] [--width 2|4|8] [--only NAME] deck...
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "decision_pairs.hpp"
#include "geometry/batch/pair_batch.hpp"
#include "geometry/decide.hpp"
#include "plain_decision.hpp"

namespace {

using namespace gapcheck;
using bench::DecisionPair;
using bench::PairSet;

using Answers = std::vector<std::uint8_t>;

void plain_scalar(const std::vector<DecisionPair>& pairs, Answers& out) {
  for (std::size_t i = 0; i < pairs.size(); ++i) out[i] = bench::plain_closer(pairs[i]);
}

bool certified(const DecisionPair& pair) {
  return geometry::decide(pair.facet, pair.query, pair.bound, geometry::Mode::filtered).closer;
}

void certified_scalar(const std::vector<DecisionPair>& pairs, Answers& out) {
  for (std::size_t i = 0; i < pairs.size(); ++i) out[i] = certified(pairs[i]);
}

/// Answers what an axis separates and fills batches of quads and of triangles with the rest; `flush(batch, indices)`
/// answers a full one and clears it.
template <class Batch, class Add, class Flush>
void in_batches(const std::vector<DecisionPair>& pairs, Answers& out, std::array<Batch, 2>& batches, const Add& add,
                const Flush& flush) {
  std::array<std::array<std::uint32_t, 64>, 2> index;
  std::array<std::size_t, 2> filled{};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::size_t kind = pairs[i].facet.triangle ? 1 : 0;
    const geometry::Corners e = geometry::seen_from(pairs[i].facet, pairs[i].query);
    if (geometry::separated_by_axis(e, pairs[i].bound)) {
      out[i] = 0;
      continue;
    }
    add(batches[kind], filled[kind], e, pairs[i].bound);
    index[kind][filled[kind]++] = static_cast<std::uint32_t>(i);
    if (filled[kind] < 64) continue;
    flush(batches[kind], kind == 1, index[kind], 64);
    filled[kind] = 0;
  }
  for (std::size_t kind = 0; kind < 2; ++kind)
    if (filled[kind] > 0) flush(batches[kind], kind == 1, index[kind], filled[kind]);
}

void plain_batch(const std::vector<DecisionPair>& pairs, Answers& out, geometry::BatchWidth width) {
  static std::array<geometry::PairArrays, 2> batches;
  in_batches(
      pairs, out, batches,
      [](geometry::PairArrays& p, std::size_t i, const geometry::Corners& e, double bound) {
        for (std::size_t corner = 0; corner < 4; ++corner)
          for (int axis = 0; axis < 3; ++axis) p.corner[corner][axis][i] = e[corner][axis];
        p.bound[i] = bound;
      },
      [&](geometry::PairArrays& p, bool triangles, const auto& index, std::size_t size) {
        p.size = size;
        bench::plain_batch(p, triangles, width);
        for (std::size_t i = 0; i < size; ++i) out[index[i]] = p.closer >> i & 1;
      });
}

void certified_batch(const std::vector<DecisionPair>& pairs, Answers& out, geometry::BatchWidth width,
                     std::size_t* open = nullptr) {
  static std::array<geometry::PairBatch, 2> batches{geometry::PairBatch(false), geometry::PairBatch(true)};
  in_batches(
      pairs, out, batches,
      [](geometry::PairBatch& p, std::size_t, const geometry::Corners& e, double bound) { p.add(e, bound); },
      [&](geometry::PairBatch& p, bool, const auto& index, std::size_t size) {
        p.decide(width);
        for (std::size_t i = 0; i < size; ++i) out[index[i]] = p.closer() >> i & 1;
        for (std::uint64_t rest = p.open(); rest != 0; rest &= rest - 1) {
          const std::uint32_t at = index[static_cast<std::size_t>(std::countr_zero(rest))];
          out[at] = certified(pairs[at]);
        }
        if (open != nullptr) *open += static_cast<std::size_t>(std::popcount(p.open()));
        p.clear();
      });
}

/// Time of the processor, which other programs take no part of.
double processor_ns() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

struct Way {
  std::string name;
  std::function<void(const std::vector<DecisionPair>&, Answers&)> run;
  std::vector<double> ns = {};  ///< per pair, one per round
  std::size_t wrong = 0;        ///< decisions that differ from those in exact numbers
};

/// Shares of the stages of the scalar way, in per cent.
std::array<double, 4> stages(const std::vector<DecisionPair>& pairs) {
  std::array<double, 4> share{};
  for (const DecisionPair& pair : pairs) {
    const auto decision = geometry::decide(pair.facet, pair.query, pair.bound, geometry::Mode::filtered);
    share[static_cast<std::size_t>(decision.stage)] += 100.0 / static_cast<double>(pairs.size());
  }
  return share;
}

std::string ratio(const Way& way, const Way& to) {
  std::vector<double> ratios(way.ns.size());
  for (std::size_t i = 0; i < ratios.size(); ++i) ratios[i] = way.ns[i] / to.ns[i];
  const auto [low, high] = std::minmax_element(ratios.begin(), ratios.end());
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", median(ratios), *low, *high);
}

bool compare(const PairSet& set, std::vector<Way>& ways) {
  Answers exact(set.pairs.size()), answers(set.pairs.size());
  for (std::size_t i = 0; i < set.pairs.size(); ++i) {
    const DecisionPair& pair = set.pairs[i];
    exact[i] = geometry::decide(pair.facet, pair.query, pair.bound, geometry::Mode::exact).closer;
  }
  for (Way& way : ways) {
    way.run(set.pairs, answers);
    for (std::size_t i = 0; i < exact.size(); ++i) way.wrong += exact[i] != answers[i];
    if (way.wrong > 0 && !way.name.starts_with("plain")) {
      fmt::print(stderr, "{}: {}: {} of {} decisions are wrong\n", set.name, way.name, way.wrong, exact.size());
      return false;
    }
  }
  return true;
}

void report(const PairSet& set, std::vector<Way>& ways, std::size_t rounds) {
  if (!compare(set, ways)) std::exit(1);
  Answers answers(set.pairs.size());
  const std::size_t repeats = 1 + 100'000 / std::max<std::size_t>(set.pairs.size(), 5'000);
  for (std::size_t round = 0; round < rounds; ++round) {
    for (Way& way : ways) {
      const double start = processor_ns();
      for (std::size_t i = 0; i < repeats; ++i) way.run(set.pairs, answers);
      way.ns.push_back((processor_ns() - start) / static_cast<double>(repeats * set.pairs.size()));
    }
  }
  const std::array<double, 4> share = stages(set.pairs);
  std::size_t open = 0;
  certified_batch(set.pairs, answers, geometry::batch_widths().back(), &open);
  fmt::print("| {} | {} |", set.name, set.pairs.size());
  for (const Way& way : ways) fmt::print(" {:.1f} |", median(way.ns));
  fmt::print(" {} | {} |", ways[0].wrong, ways[2].wrong);
  fmt::print(" {} | {} | {} |", ratio(ways[1], ways[0]), ratio(ways[3], ways[0]), ratio(ways[3], ways[2]));
  fmt::print(" {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n",
             100.0 * static_cast<double>(open) / static_cast<double>(set.pairs.size()), share[0], share[1],
             share[2] + share[3]);
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  std::size_t rounds = 7, per_family = 20'000, width = static_cast<std::size_t>(geometry::batch_widths().back());
  std::vector<std::string> decks;
  std::string only;
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    const bool value = i + 1 < count;
    if (argument == "--rounds" && value)
      rounds = std::strtoull(arguments[++i], nullptr, 10);
    else if (argument == "--count" && value)
      per_family = std::strtoull(arguments[++i], nullptr, 10);
    else if (argument == "--width" && value)
      width = std::strtoull(arguments[++i], nullptr, 10);
    else if (argument == "--only" && value)
      only = arguments[++i];
    else
      decks.emplace_back(argument);
  }
  const auto widths = geometry::batch_widths();
  const auto chosen = static_cast<geometry::BatchWidth>(width);
  if (rounds == 0 || per_family < 16 || std::find(widths.begin(), widths.end(), chosen) == widths.end()) return 2;
  std::vector<PairSet> sets;
  for (const std::string& deck : decks)
    for (const double margin : {0.0, 0.5}) sets.push_back(bench::pairs_of_deck(deck, margin));
  for (PairSet& set : bench::pairs_of_families(per_family)) sets.push_back(std::move(set));
  fmt::print(
      "| pairs | number | plain, ns | certified, ns | plain batch, ns | certified batch, ns | plain wrong | plain "
      "batch wrong "
      "| certified / plain "
      "| certified batch / plain | certified batch / plain batch | open after the batch, % | filter, % "
      "| enclosure, % | exact, % |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const PairSet& set : sets) {
    if (set.name.find(only) == std::string::npos) continue;
    if (set.pairs.empty()) {
      fmt::print(stderr, "{}: no pairs\n", set.name);
      continue;
    }
    std::vector<Way> ways{
        {"plain", plain_scalar},
        {"certified", certified_scalar},
        {"plain batch", [&](const auto& pairs, Answers& out) { plain_batch(pairs, out, chosen); }},
        {"certified batch", [&](const auto& pairs, Answers& out) { certified_batch(pairs, out, chosen); }}};
    report(set, ways, rounds);
  }
}
