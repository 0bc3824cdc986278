#include "report/compare/compare_curves.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <unordered_map>

#include "base/work_watch.hpp"
#include "report/compare/curve_samples.hpp"

namespace gapcheck::report {
namespace {

/// The times of both curves within their common range.
std::vector<double> common_times(const Curve& a, const Curve& b) {
  if (a.times.empty() || b.times.empty()) return {};
  const double begin = std::max(a.times.front(), b.times.front()), end = std::min(a.times.back(), b.times.back());
  std::vector<double> times;
  std::set_union(a.times.begin(), a.times.end(), b.times.begin(), b.times.end(), std::back_inserter(times));
  std::erase_if(times, [&](double time) { return time < begin || time > end; });
  return times;
}

/// One unit of the last of `digits` digits, as a share of `scale`; a little more against rounding.
double printed_unit(double value, double scale, int digits) {
  if (value == 0) return 0;
  return std::pow(10.0, std::floor(std::log10(value)) - (digits - 1)) / scale * (1 + 1e-6);
}

/// Integral of the square of a function that is linear between two times.
double square_integral(double from, double to, double duration) {
  return duration * (from * from + from * to + to * to) / 3;
}

/// Values are shares of the larger curve's largest value, so that nothing overflows.
struct Sample {
  double a = 0, b = 0;
};

/// Square roots of integrals over time; of sums over the samples if there is only one time.
double l2_difference(const std::vector<double>& times, const std::vector<Sample>& samples) {
  double difference = 0, first = 0, second = 0;
  const double length = times.back() - times.front();
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const Sample &p = samples[i], &q = samples[i + 1];
    const double share = (times[i + 1] - times[i]) / length;
    difference += square_integral(p.a - p.b, q.a - q.b, share);
    first += square_integral(p.a, q.a, share);
    second += square_integral(p.b, q.b, share);
  }
  if (times.size() == 1) {
    const Sample& only = samples.front();
    difference = (only.a - only.b) * (only.a - only.b);
    first = only.a * only.a;
    second = only.b * only.b;
  }
  const double larger = std::max(first, second);
  return larger > 0 ? std::sqrt(difference / larger) : 0;
}

/// Fills in the norms. `negligible`: curves that stay below it agree.
void compare_pair(const Curve& a, const Curve& b, double tolerance, double negligible, CurvePair& pair) {
  pair.not_numbers = (a.not_numbers > 0) != (b.not_numbers > 0);
  if (pair.not_numbers) pair.verdict = CurvePair::Verdict::differs;
  const std::vector<double> times = common_times(a, b);
  if (times.empty()) {
    if (!pair.not_numbers) pair.verdict = CurvePair::Verdict::no_common_times;
    return;
  }
  CurveSampler first(a), second(b);
  std::vector<Sample> samples;
  samples.reserve(times.size());
  for (const double time : times) {
    const Sample sample{first.at(time), second.at(time)};
    samples.push_back(sample);
    pair.largest_first = std::max(pair.largest_first, std::abs(sample.a));
    pair.largest_second = std::max(pair.largest_second, std::abs(sample.b));
  }
  const double scale = std::max(pair.largest_first, pair.largest_second);
  pair.time = times.front();
  if (scale == 0) return;
  double counted = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double larger = std::max(std::abs(samples[i].a), std::abs(samples[i].b));
    samples[i] = {samples[i].a / scale, samples[i].b / scale};
    const double difference = std::abs(samples[i].a - samples[i].b);
    if (difference > pair.relative_difference) {
      pair.relative_difference = difference;
      pair.time = times[i];
    }
    if (difference > printed_unit(larger, scale, a.digits)) counted = std::max(counted, difference);
  }
  pair.largest_difference = pair.relative_difference * scale;
  pair.l2_difference = l2_difference(times, samples);
  pair.rating = rate(a, b);
  if (counted > tolerance && scale > negligible) pair.verdict = CurvePair::Verdict::differs;
}

/// Largest value of each file and quantity in both runs.
class Sizes {
 public:
  void add(const std::vector<Curve>& list) {
    for (const Curve& curve : list) {
      double& largest = largest_[key(curve)];
      for (const double value : curve.values) largest = std::max(largest, std::abs(value));
    }
  }
  [[nodiscard]] double of(const Curve& curve) const { return largest_.at(key(curve)); }

 private:
  static std::pair<std::string, std::string> key(const Curve& curve) { return {curve.file, curve.quantity}; }
  std::map<std::pair<std::string, std::string>, double> largest_;
};

using Positions = std::unordered_map<std::string_view, std::size_t>;

Positions curve_positions(const std::vector<Curve>& list) {
  Positions result;
  for (std::size_t i = 0; i < list.size(); ++i) result.emplace(list[i].name, i);
  return result;
}

bool chosen(const Curve& curve, const std::vector<std::string>& names) {
  return names.empty() || std::any_of(names.begin(), names.end(), [&](const std::string& part) {
           return curve.name.find(part) != std::string::npos;
         });
}

/// Names of the chosen curves that `other` lacks; only the file's name if it has none from that file.
std::vector<std::string> only_in(const std::vector<Curve>& list, const std::vector<Curve>& others,
                                 const Positions& other, const CurveOptions& options) {
  std::set<std::string_view> files;
  for (const Curve& curve : others) files.insert(curve.file);
  std::vector<std::string> names;
  for (const Curve& curve : list) {
    if (!chosen(curve, options.names) || other.contains(curve.name)) continue;
    const bool file_known = files.contains(curve.file);
    if (file_known || names.empty() || names.back() != curve.file)
      names.push_back(file_known ? curve.name : curve.file);
  }
  return names;
}

double end(const std::vector<Curve>& list) {
  double latest = 0;
  for (const Curve& curve : list)
    if (!curve.times.empty()) latest = std::max(latest, curve.times.back());
  return latest;
}

}  // namespace

CurveComparison compare_curves(const std::vector<Curve>& first, const std::vector<Curve>& second,
                               const CurveOptions& options) {
  CurveComparison result;
  result.tolerance = options.tolerance;
  result.end_first = end(first);
  result.end_second = end(second);
  Sizes sizes;
  sizes.add(first);
  sizes.add(second);
  const Positions in_first = curve_positions(first), in_second = curve_positions(second);
  for (std::size_t i = 0; i < first.size() && !work_stopped(); ++i) {
    const auto other = in_second.find(first[i].name);
    if (other == in_second.end() || !chosen(first[i], options.names)) continue;
    CurvePair pair;
    pair.name = first[i].name;
    pair.first = i;
    pair.second = other->second;
    compare_pair(first[i], second[other->second], options.tolerance, negligible_share * sizes.of(first[i]), pair);
    using enum CurvePair::Verdict;
    ++(pair.verdict == agrees ? result.agree : pair.verdict == differs ? result.differ : result.without_common_times);
    result.pairs.push_back(pair);
  }
  std::stable_sort(result.pairs.begin(), result.pairs.end(), [](const CurvePair& a, const CurvePair& b) {
    const auto key = [](const CurvePair& p) {
      return std::tuple(p.verdict != CurvePair::Verdict::differs, !p.not_numbers, -p.relative_difference);
    };
    return key(a) < key(b);
  });
  result.only_first = only_in(first, second, in_second, options);
  result.only_second = only_in(second, first, in_first, options);
  return result;
}

}  // namespace gapcheck::report
