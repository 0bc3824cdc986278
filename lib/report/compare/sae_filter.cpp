#include "report/compare/sae_filter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <ranges>
#include <vector>

#include "report/compare/curve_samples.hpp"

namespace gapcheck::report {
namespace {

constexpr double samples_per_period = 20, run_up_periods = 2;
constexpr std::size_t most_samples = 1'000'000;

/// y(t) = a0 x(t) + a1 x(t-1) + a2 x(t-2) + b1 y(t-1) + b2 y(t-2), appendix C of J211-1.
class Butterworth {
 public:
  /// `step`: seconds.
  Butterworth(int channel_class, double step) {
    const double wd = 2 * std::numbers::pi * 2.0775 * channel_class;
    const double wa = std::tan(wd * step / 2), root = std::numbers::sqrt2 * wa, square = wa * wa;
    const double divisor = 1 + root + square;
    a0_ = square / divisor;
    b1_ = 2 * (1 - square) / divisor;
    b2_ = (root - 1 - square) / divisor;
  }

  /// Starts as if the first value had lasted for ever.
  template <class Iterator>
  void run(Iterator begin, Iterator end) const {
    double x1 = *begin, x2 = x1, y1 = x1, y2 = x1;
    for (; begin != end; ++begin) {
      double& value = *begin;
      const double y = a0_ * (value + 2 * x1 + x2) + b1_ * y1 + b2_ * y2;
      x2 = x1;
      x1 = value;
      y2 = y1;
      y1 = value = y;
    }
  }

 private:
  double a0_ = 0, b1_ = 0, b2_ = 0;
};

/// Both ends go on as their reflection in the end point: the filter needs a run-up.
std::vector<double> with_run_up(const std::vector<double>& values, std::size_t length) {
  std::vector<double> longer;
  longer.reserve(values.size() + 2 * length);
  for (std::size_t i = length; i > 0; --i) longer.push_back(2 * values.front() - values[i]);
  longer.insert(longer.end(), values.begin(), values.end());
  for (std::size_t i = 1; i <= length; ++i) longer.push_back(2 * values.back() - values[values.size() - 1 - i]);
  return longer;
}

}  // namespace

int channel_class(std::string_view text) {
  if (text.size() > 3 &&
      std::ranges::equal(text.substr(0, 3), std::string_view("cfc"), [](char a, char b) { return (a | 0x20) == b; })) {
    text.remove_prefix(3);
    while (text.starts_with(' ')) text.remove_prefix(1);
  }
  int number = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failed != std::errc() || end != text.data() + text.size()) return 0;
  constexpr std::array classes{60, 180, 600, 1000};
  return std::ranges::find(classes, number) != classes.end() ? number : 0;
}

double seconds_in(std::string_view unit) {
  if (unit == "s") return 1;
  if (unit == "ms") return 1e-3;
  return unit == "us" ? 1e-6 : 0;
}

Result<Curve> filtered(const Curve& curve, const SaeFilter& filter) {
  if (curve.times.size() < 2) return curve;
  const double begin = curve.times.front(), end = curve.times.back();
  const double seconds = (end - begin) * filter.seconds_per_unit;
  const double periods = seconds * filter.channel_class;
  const double intervals =
      std::max(static_cast<double>(curve.times.size() - 1), std::ceil(periods * samples_per_period));
  if (!(intervals < static_cast<double>(most_samples)))
    return plain_error(fmt::format("{} lasts {:g} s: CFC {} needs more than {} samples of it; check the unit of time",
                                   curve.name, seconds, filter.channel_class, most_samples));
  const auto count = static_cast<std::size_t>(intervals) + 1;
  const auto run_up = static_cast<std::size_t>(std::min(intervals, std::ceil(run_up_periods * intervals / periods)));
  std::vector<double> values = with_run_up(uniform_samples(curve, begin, end, count), run_up);
  const Butterworth butterworth(filter.channel_class, seconds / intervals);
  butterworth.run(values.begin(), values.end());
  butterworth.run(values.rbegin(), values.rend());
  Curve result = curve;
  result.times.clear();
  result.values.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / intervals;
    result.add(begin * (1 - share) + end * share, values[run_up + i]);
  }
  return result;
}

}  // namespace gapcheck::report
