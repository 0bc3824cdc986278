#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/compare/curves.hpp"
#include "report/compare/rating.hpp"

namespace gapcheck::report {

/// Curves whose largest value is below this share of the largest one of their file and quantity agree with each other:
/// forces of 1e-12 next to forces of 1e+3 are rounding in the run.
inline constexpr double negligible_share = 1e-9;

struct CurveOptions {
  double tolerance = 1e-3;         ///< of the relative difference
  std::vector<std::string> names;  ///< only curves with one of these words in their name; empty: all
};

/// One curve that both runs have, sampled at the times of both within their common range; linear in between.
struct CurvePair {
  enum class Verdict : std::uint8_t { agrees, differs, no_common_times } verdict = Verdict::agrees;
  std::string name;
  std::size_t first = 0, second = 0;             ///< positions in the lists that were compared
  double largest_first = 0, largest_second = 0;  ///< absolute values in the common range
  double largest_difference = 0, time = 0;       ///< largest |a - b|, and when
  double relative_difference = 0;                ///< the same over the larger of the two largest values
  double l2_difference = 0;      ///< square root of the integral of (a - b)², over the larger one of a² and b²
  bool not_numbers = false;      ///< only one of them has NaN values, so it differs
  std::optional<Rating> rating;  ///< of the second curve, the first one being the reference; nothing: none is defined
};

struct CurveComparison {
  double tolerance = 0;
  std::vector<CurvePair> pairs;  ///< largest relative difference first, those that differ before all
  std::vector<std::string> only_first, only_second;  ///< names of curves, or of a file with no curve in the other run
  std::size_t agree = 0, differ = 0, without_common_times = 0;
  double end_first = 0, end_second = 0;  ///< last time of any curve
};

/// Curves are matched by name. Two differ if their relative difference, counted only where |a - b| is more than one
/// unit of the last printed digit of the larger value, is above the tolerance. A curve that only one run has is listed
/// and not a difference.
[[nodiscard]] CurveComparison compare_curves(const std::vector<Curve>& first, const std::vector<Curve>& second,
                                             const CurveOptions& options);

}  // namespace gapcheck::report
