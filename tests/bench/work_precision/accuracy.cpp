#include "accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../stopwatch.hpp"

namespace gapcheck::bench {
namespace {

double ulp(double value) { return std::nextafter(value, std::numeric_limits<double>::infinity()) - value; }

/// The value below which a share of the samples lies. Reorders them.
double quantile(std::vector<double>& samples, double share) {
  if (samples.empty()) return 0;
  const auto at = samples.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(samples.size() - 1));
  std::nth_element(samples.begin(), at, samples.end());
  return *at;
}

}  // namespace

Accuracy accuracy(const PairFamily& family, const Method& method) {
  std::vector<Answer<double>> answers(family.pairs.size());
  method.run(family.pairs, answers);
  Accuracy result;
  std::vector<double> ulps;
  long double squares = 0;
  std::size_t sized = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const Truth& truth = family.truth[i];
    if (answers[i].closer != truth.closer) ++result.wrong;
    if (method.distances == Distances::none || (method.distances == Distances::nearer && !truth.closer)) continue;
    if (!std::isfinite(answers[i].distance)) {
      ++result.lost;
      continue;
    }
    const double error = static_cast<double>(std::abs(answers[i].distance - truth.distance));
    ulps.push_back(error / ulp(family.pairs.in_double[i].bound));
    if (!(truth.size > 0)) continue;
    const double relative = error / truth.size;
    result.largest = std::max(result.largest, relative);
    squares += static_cast<long double>(relative) * relative;
    ++sized;
  }
  if (sized > 0) result.mean_square_root = static_cast<double>(std::sqrt(squares / static_cast<long double>(sized)));
  result.median_ulps = quantile(ulps, 0.5);
  result.largest_ulps = quantile(ulps, 1);
  return result;
}

std::vector<Duration> durations(const PairFamily& family, const std::vector<Method>& methods, int rounds) {
  std::vector<Answer<double>> answers(family.pairs.size());
  std::vector<std::vector<double>> samples(methods.size());
  const double pairs = static_cast<double>(family.pairs.size());
  for (int round = -1; round < rounds; ++round) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      Stopwatch watch;
      methods[m].run(family.pairs, answers);
      const double seconds = watch.lap();
      if (round >= 0) samples[m].push_back(seconds * 1e9 / pairs);  // the first one warms the caches
    }
  }
  std::vector<Duration> result;
  for (auto& sample : samples) {
    result.push_back({quantile(sample, 0.5), quantile(sample, 0.25), quantile(sample, 0.75)});
  }
  return result;
}

}  // namespace gapcheck::bench
