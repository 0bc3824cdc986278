#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "report/compare/curves.hpp"

namespace gapcheck::report {

/// How well one curve follows another by the metric of ISO/TS 18571 (Objective rating metric for non-ambiguous signals;
/// described by Barbat, Fu, Zhan, Yang and Gehre, ESV 2013, paper 13-0448). Scores from 0 to 1; 1: the same curve.
struct Rating {
  double corridor = 1;   ///< Z: share of the samples near the reference
  double phase = 1;      ///< shift in time with the best correlation
  double magnitude = 1;  ///< values, after that shift and after dynamic time warping
  double slope = 1;      ///< slopes, after that shift

  /// R = 0.4 Z + 0.2 (phase + magnitude + slope).
  [[nodiscard]] double overall() const { return (2 * corridor + phase + magnitude + slope) / 5; }
};

/// The samples that a rating takes of the curves' common range. The standard samples at 10 kHz, whatever the unit of
/// time of a model is: 1000 intervals are its 100 ms.
inline constexpr std::size_t rating_samples = 1001;

/// Values of the two curves at the same, equidistant times, at least ten of each. Nothing if there are fewer, if one is
/// not finite, or if the reference is zero throughout.
[[nodiscard]] std::optional<Rating> rate(std::span<const double> reference, std::span<const double> curve);

/// The curves over their common range, linear between their states. Nothing if that has no width, and as above.
[[nodiscard]] std::optional<Rating> rate(const Curve& reference, const Curve& curve);

}  // namespace gapcheck::report
