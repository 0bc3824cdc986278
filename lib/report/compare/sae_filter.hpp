#pragma once
#include <string_view>

#include "base/result.hpp"
#include "report/compare/curves.hpp"

namespace gapcheck::report {

/// A channel frequency class of SAE J211-1 (ISO 6487): a Butterworth filter of second order that runs forward and
/// backward, so it shifts nothing in time. It passes up to the class's number in Hz, and 71 % at 5/3 of it.
struct SaeFilter {
  int channel_class = 0;        ///< 60, 180, 600 or 1000
  double seconds_per_unit = 1;  ///< unit of time of the model
};

/// "60", "CFC60", "cfc 1000"; 0: not a class.
[[nodiscard]] int channel_class(std::string_view text);

/// Seconds in "s", "ms", "us"; 0: another word.
[[nodiscard]] double seconds_in(std::string_view unit);

/// The curve at equidistant times, filtered: as many states as it has or twenty per period of the class's frequency,
/// whichever is more. A curve with fewer than two states stays as it is. Error: more than a million samples, which is
/// what a wrong unit of time leads to.
[[nodiscard]] Result<Curve> filtered(const Curve& curve, const SaeFilter& filter);

}  // namespace gapcheck::report
