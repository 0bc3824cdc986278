#pragma once
#include <vector>

#include "family.hpp"

namespace gapcheck::bench {

/// How far a method is from the truth on one family. Depth is contact distance less distance: both have one error.
struct Accuracy {
  std::size_t wrong = 0;                     ///< decisions
  std::size_t lost = 0;                      ///< pairs for which no finite distance came out; not in the errors
  double largest = 0, mean_square_root = 0;  ///< depth error by the longest side of the facet
  double largest_ulps = 0, median_ulps = 0;  ///< depth error in ulps of the contact distance as a double
};

/// Holds the answers of a method against the truth. Pairs whose facet is a point are left out of the errors by size.
[[nodiscard]] Accuracy accuracy(const PairFamily& family, const Method& method);

/// Nanoseconds per pair of each method: median, and the quartiles of the rounds.
struct Duration {
  double median = 0, low = 0, high = 0;
};

/// In every round each method answers all pairs, one method after the other, so that all see the same machine.
[[nodiscard]] std::vector<Duration> durations(const PairFamily& family, const std::vector<Method>& methods, int rounds);

}  // namespace gapcheck::bench
