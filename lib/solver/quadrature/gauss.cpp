#include "solver/quadrature/gauss.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapcheck::solver {

std::vector<GaussPoint> gauss_rule(int points) {
  const int n = std::clamp(points, 1, 10);
  std::vector<GaussPoint> rule(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    // Newton's method on the Legendre polynomial, by its three-term recurrence.
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 1;
    for (int iteration = 0; iteration < 20; ++iteration) {
      double before = 1, value = x;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
      }
      slope = n * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    if (2 * i + 1 == n) x = 0;
    rule[static_cast<std::size_t>(i)] = {x, 2 / ((1 - x * x) * slope * slope)};
  }
  return rule;
}

std::vector<GaussPoint> lobatto_rule(int points) {
  const int n = std::clamp(points, 1, 10), m = n - 1;
  if (n < 3) return gauss_rule(n);
  std::vector<GaussPoint> rule(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    // The points inside are the zeros of P'ₘ; Newton's method on (1 − x²) P'ₘ = m (Pₘ₋₁ − x Pₘ), whose slope is
    // −m (m + 1) Pₘ, keeps the ends.
    double x = -std::cos(std::numbers::pi * i / m), value = 1;
    for (int iteration = 0; iteration < 50; ++iteration) {
      double before = 1;
      value = x;
      for (int k = 2; k <= m; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
      }
      x += (before - x * value) / (n * value);
    }
    if (2 * i == m) x = 0;
    rule[static_cast<std::size_t>(i)] = {x, 2 / (n * m * value * value)};
  }
  return rule;
}

}  // namespace gapcheck::solver
