#pragma once
#include <cmath>

namespace gapcheck::solver {

/// The root of a falling function between `low`, where it is above zero, and `high`, which is doubled until it is not:
/// secant steps, halved where they leave the bracket or shorten it too little. Stops where |f| <= tolerance.
template <class Function>
double falling_root(const Function& f, double low, double high, double tolerance) {
  constexpr int most_doublings = 200, most_halvings = 200;
  double f_low = f(low), f_high = f(high);
  for (int i = 0; i < most_doublings && f_high > 0; ++i) {
    low = high;
    f_low = f_high;
    high *= 2;
    f_high = f(high);
  }
  for (int i = 0; i < most_halvings && high - low > 1e-16 * high; ++i) {
    const double secant = low + (high - low) * f_low / (f_low - f_high);
    const double x = i % 3 != 2 && secant > low && secant < high ? secant : (low + high) / 2;
    const double value = f(x);
    if (std::abs(value) <= tolerance) return x;
    (value > 0 ? low : high) = x;
    (value > 0 ? f_low : f_high) = value;
  }
  return (low + high) / 2;
}

}  // namespace gapcheck::solver
