#include "report/compare/curve_samples.hpp"

namespace gapcheck::report {

double CurveSampler::at(double time) {
  const auto& t = curve_.times;
  while (next_ < t.size() && t[next_] < time) ++next_;
  if (next_ == t.size()) return curve_.values.back();
  if (next_ == 0 || t[next_] == time) return curve_.values[next_];
  const double share = (time - t[next_ - 1]) / (t[next_] - t[next_ - 1]);
  return curve_.values[next_ - 1] * (1 - share) + curve_.values[next_] * share;
}

std::vector<double> uniform_samples(const Curve& curve, double begin, double end, std::size_t count) {
  std::vector<double> values;
  values.reserve(count);
  CurveSampler sampler(curve);
  const auto intervals = static_cast<double>(count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / intervals;
    values.push_back(sampler.at(begin * (1 - share) + end * share));
  }
  return values;
}

}  // namespace gapcheck::report
