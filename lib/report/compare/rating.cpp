#include "report/compare/rating.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "report/compare/curve_samples.hpp"

namespace gapcheck::report {
namespace {

using Values = std::span<const double>;

// The constants of the standard.
constexpr double inner_corridor = 0.05, outer_corridor = 0.5;  // half widths over the reference's largest value
constexpr double largest_shift = 0.2, warping_window = 0.1;    // of the samples
constexpr double worst_magnitude_error = 0.5, worst_slope_error = 2;

double score(double error, double worst) { return std::clamp((worst - error) / worst, 0.0, 1.0); }

/// Of values over the reference's largest one.
double corridor_score(Values reference, Values curve) {
  double sum = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const double distance = std::abs(reference[i] - curve[i]);
    const double share = score(distance - inner_corridor, outer_corridor - inner_corridor);
    sum += share * share;
  }
  return sum / static_cast<double>(reference.size());
}

/// Pearson's coefficient; -1 where one of them is constant and so follows nothing.
double correlation(Values a, Values b) {
  const auto count = static_cast<double>(a.size());
  double mean_a = 0, mean_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i] / count;
    mean_b += b[i] / count;
  }
  double ab = 0, aa = 0, bb = 0, size_a = 0, size_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double da = a[i] - mean_a, db = b[i] - mean_b;
    ab += da * db;
    aa += da * da;
    bb += db * db;
    size_a += a[i] * a[i];
    size_b += b[i] * b[i];
  }
  constexpr double rounding_squared = 1e-24;
  if (aa <= rounding_squared * size_a || bb <= rounding_squared * size_b) return -1;
  return ab / (std::sqrt(aa) * std::sqrt(bb));
}

/// The two curves over the part that remains when one is shifted.
struct Shifted {
  Values reference, curve;
  std::size_t by = 0;
};

/// The shift with the best correlation, up to a fifth of the samples either way. A periodic curve fits after each
/// period to rounding, so a larger shift must be better by more than that.
Shifted best_shift(Values reference, Values curve) {
  const std::size_t count = reference.size();
  const auto limit = static_cast<std::size_t>(largest_shift * static_cast<double>(count));
  Shifted best{reference, curve, 0};
  double highest = correlation(reference, curve);
  for (std::size_t by = 1; by <= limit; ++by) {
    const std::array tries{Shifted{reference.subspan(by), curve.first(count - by), by},
                           Shifted{reference.first(count - by), curve.subspan(by), by}};
    for (const Shifted& shifted : tries) {
      const double value = correlation(shifted.reference, shifted.curve);
      if (value <= highest + 1e-9) continue;
      highest = value;
      best = shifted;
    }
  }
  return best;
}

/// A way through the pairs of samples, with its cost (sum of squared differences) and what the error needs.
struct WarpingPath {
  double cost = std::numeric_limits<double>::infinity();
  double difference = 0, reference = 0;  ///< sums of |c - t| and |t| along it
};

/// Sum of |c - t| over sum of |t| along the cheapest way of dynamic time warping, in a band around the diagonal.
double magnitude_error(Values reference, Values curve) {
  const std::size_t count = reference.size();
  const auto band = static_cast<std::size_t>(std::ceil(warping_window * static_cast<double>(count))) - 1;
  std::vector<WarpingPath> before(count + 1), row(count + 1);  // entry j + 1: ways that end at reference[j]
  before[0].cost = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = i > band ? i - band : 0, last = std::min(count, i + band + 1);
    row[first] = {};
    for (std::size_t j = first; j < last; ++j) {
      const WarpingPath* from = &before[j];
      if (before[j + 1].cost < from->cost) from = &before[j + 1];
      if (row[j].cost < from->cost) from = &row[j];
      const double difference = std::abs(curve[i] - reference[j]);
      row[j + 1] = {from->cost + difference * difference, from->difference + difference,
                    from->reference + std::abs(reference[j])};
    }
    if (last < count) row[last + 1] = {};
    std::swap(before, row);
  }
  const WarpingPath& best = before[count];
  if (best.difference == 0) return 0;
  return best.reference > 0 ? best.difference / best.reference : worst_magnitude_error;
}

/// Slopes per sample (the step cancels in the error), smoothed by a mean of nine, fewer towards the ends.
std::vector<double> smooth_slopes(Values values) {
  const std::size_t count = values.size();
  std::vector<double> slopes(count), smooth(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t low = i > 0 ? i - 1 : 0, high = std::min(i + 1, count - 1);
    slopes[i] = (values[high] - values[low]) / static_cast<double>(high - low);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t reach = std::min({i, count - 1 - i, std::size_t{4}});
    for (std::size_t k = i - reach; k <= i + reach; ++k) smooth[i] += slopes[k] / static_cast<double>(2 * reach + 1);
  }
  return smooth;
}

double slope_error(Values reference, Values curve) {
  const std::vector<double> a = smooth_slopes(reference), b = smooth_slopes(curve);
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference += std::abs(a[i] - b[i]);
    size += std::abs(a[i]);
  }
  if (difference == 0) return 0;
  return size > 0 ? difference / size : worst_slope_error;
}

double largest_value(Values values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Shares of a scale, so that no square overflows; what is 1e100 times the reference is rated as that.
std::vector<double> scaled(Values values, double scale) {
  std::vector<double> result;
  result.reserve(values.size());
  for (const double value : values) result.push_back(std::clamp(value / scale, -1e100, 1e100));
  return result;
}

}  // namespace

std::optional<Rating> rate(Values reference, Values curve) {
  if (reference.size() < 10 || curve.size() != reference.size()) return std::nullopt;
  const auto finite = [](double value) { return std::isfinite(value); };
  if (!std::all_of(reference.begin(), reference.end(), finite) || !std::all_of(curve.begin(), curve.end(), finite))
    return std::nullopt;
  const double largest = largest_value(reference);
  if (largest == 0) return std::nullopt;
  if (std::equal(reference.begin(), reference.end(), curve.begin())) return Rating{};
  const std::vector<double> t = scaled(reference, largest), c = scaled(curve, largest);
  const Shifted shifted = best_shift(t, c);
  Rating rating;
  rating.corridor = corridor_score(t, c);
  rating.phase = score(static_cast<double>(shifted.by), largest_shift * static_cast<double>(t.size()));
  rating.magnitude = score(magnitude_error(shifted.reference, shifted.curve), worst_magnitude_error);
  rating.slope = score(slope_error(shifted.reference, shifted.curve), worst_slope_error);
  return rating;
}

std::optional<Rating> rate(const Curve& reference, const Curve& curve) {
  if (reference.times.empty() || curve.times.empty()) return std::nullopt;
  const double begin = std::max(reference.times.front(), curve.times.front());
  const double end = std::min(reference.times.back(), curve.times.back());
  if (!(begin < end)) return std::nullopt;
  return rate(uniform_samples(reference, begin, end, rating_samples),
              uniform_samples(curve, begin, end, rating_samples));
}

}  // namespace gapcheck::report
