// Measures what methods of finding a node's depth cost and how far they are from the truth; writes JSON.
// usage: gapcheck_work_precision DATA_FOLDER [PAIRS_PER_FAMILY] [ROUNDS]
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "accuracy.hpp"

namespace gapcheck::bench {
namespace {

std::string method_json(const Method& method, const Accuracy& a, const Duration& d) {
  return fmt::format(R"({{"name": "{}", "precision": "{}", "wrong": {}, "lost": {}, "largest": {}, "rms": {}, )"
                     R"("largest_ulps": {}, "median_ulps": {}, "ns": {:.2f}, "ns_low": {:.2f}, "ns_high": {:.2f}}})",
                     method.name, method.precision, a.wrong, a.lost, a.largest, a.mean_square_root, a.largest_ulps,
                     a.median_ulps, d.median, d.low, d.high);
}

std::string family_json(const PairFamily& family, int rounds) {
  const std::vector<Duration> times = durations(family, methods(), rounds);
  const double pairs = static_cast<double>(family.pairs.size());
  std::string text = fmt::format(
      R"({{"name": "{}", "group": "{}", "pairs": {}, "triangulated": {}, "exact_ns": {:.0f}, "methods": [)",
      family.name, family.group, family.pairs.size(), family.triangulated, family.exact_seconds * 1e9 / pairs);
  for (std::size_t m = 0; m < methods().size(); ++m) {
    text += (m > 0 ? ",\n    " : "\n    ") + method_json(methods()[m], accuracy(family, methods()[m]), times[m]);
  }
  return text + "]}";
}

int measure(const std::string& data, std::size_t count, int rounds) {
  std::vector<PairFamily> families = made_families(count);
  int decks = 0;
  families.push_back(deck_family(data, decks));
  if (families.back().pairs.size() == 0) {
    fmt::print(stderr, "{}: no pairs in {} decks\n", data, decks);
    return 2;
  }
  for (const PairFamily& family : families) {
    if (family.disagreements == 0) continue;
    fmt::print(stderr, "{}: exact decision and reference differ on {} pairs\n", family.name, family.disagreements);
    return 2;
  }
  fmt::print(R"({{"count": {}, "rounds": {}, "decks": {}, "families": [)", count, rounds, decks);
  for (std::size_t i = 0; i < families.size(); ++i) {
    fmt::print("{}\n  {}", i > 0 ? "," : "", family_json(families[i], rounds));
  }
  fmt::print("]}}\n");
  return 0;
}

}  // namespace
}  // namespace gapcheck::bench

int main(int argc, char** argv) {
  const int count = argc > 2 ? std::atoi(argv[2]) : 2000, rounds = argc > 3 ? std::atoi(argv[3]) : 25;
  if (argc < 2 || argc > 4 || count < 1 || count > 1'000'000 || rounds < 1 || rounds > 10'000) {
    std::fputs("usage: gapcheck_work_precision DATA_FOLDER [PAIRS_PER_FAMILY] [ROUNDS]\n", stderr);
    return 2;
  }
  return gapcheck::bench::measure(argv[1], static_cast<std::size_t>(count), rounds);
}
