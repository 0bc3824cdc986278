#include "solver/material/strain_rates.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {

void RateAverage::add(double value, double weight, double window) {
  constexpr std::size_t most = 13;
  constexpr double parts = 12;
  window_ = window;
  if (intervals_.empty()) {
    intervals_.push_back({});
  } else if (intervals_[newest_].weight >= window / parts) {
    if (intervals_.size() < most) intervals_.push_back({});
    newest_ = (newest_ + 1) % intervals_.size();
    intervals_[newest_] = {};
  }
  intervals_[newest_].sum += weight * value;
  intervals_[newest_].weight += weight;
}

RateAverage::Interval RateAverage::within() const {
  Interval all;
  for (std::size_t back = 0; back < intervals_.size() && all.weight < window_; ++back) {
    const Interval& one = intervals_[(newest_ + intervals_.size() - back) % intervals_.size()];
    const double part = std::min(1.0, (window_ - all.weight) / one.weight);
    all.sum += part * one.sum;
    all.weight += part * one.weight;
  }
  return all;
}

double RateAverage::mean() const {
  const Interval all = within();
  return all.weight > 0 ? all.sum / all.weight : 0;
}

double RateAverage::newest_share() const {
  const Interval all = within();
  return all.weight > 0 ? std::min(1.0, intervals_[newest_].weight / all.weight) : 0;
}

double RateLaws::present(const Vector& x, const Vector& rates_of_x) const {
  Eigen::Index fastest = 0;
  rates_of_x.cwiseAbs().maxCoeff(&fastest);
  const double rate = rates_of_x[fastest], at = x[fastest];
  const bool loads = rate * at > 0,
             counts = effects == RateEffects::always || (loads && (effects == RateEffects::loading || at < 0));
  return counts ? std::abs(rate) * (engineering ? std::exp(at) : 1) : 0;
}

RateLaws::Excess RateLaws::excess(const Vector& x, double rate) const {
  Excess result;
  if (!(rate > rates.front())) return result;
  const auto above = static_cast<std::size_t>(std::upper_bound(rates.begin(), rates.end(), rate) - rates.begin());
  const PrincipalResponse slow = laws.front()->shape(x, false), low = laws[above - 1]->shape(x, false);
  result.force = low.force - slow.force;
  result.slope = low.slope - slow.slope;
  if (above == rates.size()) return result;
  const PrincipalResponse high = laws[above]->shape(x, false);
  const double part = (rate - rates[above - 1]) / (rates[above] - rates[above - 1]);
  result.force += part * (high.force - low.force);
  result.slope += part * (high.slope - low.slope);
  result.force_over_rate = (high.force - low.force) / (rates[above] - rates[above - 1]);
  return result;
}

}  // namespace gapcheck::solver
