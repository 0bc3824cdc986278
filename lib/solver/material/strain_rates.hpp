#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/material/principal_law.hpp"

namespace gapcheck::solver {

/// The running mean of a quantity over a window of time, or of steps. It keeps thirteen intervals of at least a twelfth
/// of the window, in each of which the quantity counts as constant.
class RateAverage {
 public:
  /// Adds a value that lasts for `weight`, above 0. The window stays the same; the last twelve values have weights of 1
  /// and a window of 12.
  void add(double value, double weight, double window);
  /// 0 before the first value.
  [[nodiscard]] double mean() const;
  /// The share of the newest interval in the mean; 0 before the first value.
  [[nodiscard]] double newest_share() const;

 private:
  struct Interval {
    double sum = 0, weight = 0;
  };
  /// All that lies in the window.
  [[nodiscard]] Interval within() const;
  std::vector<Interval> intervals_;  ///< a ring
  std::size_t newest_ = 0;
  double window_ = 0;
};

/// Which motion the rates of a table count in (TENSION of 181). It loads where a stretch grows away from 1.
enum class RateEffects : std::uint8_t { compressive_loading, loading, always };

/// Laws over the strain rate: linear in the rate between them, constant beyond them. The first one is that of slow
/// motion.
struct RateLaws {
  std::vector<double> rates;                              ///< rising
  std::vector<std::shared_ptr<const PrincipalLaw>> laws;  ///< by rate; their shapes count
  RateEffects effects = RateEffects::compressive_loading;
  bool engineering = false;  ///< rates are dλ/dt, not d ln λ/dt
  double window = 0;         ///< time over which rates are averaged; 0: twelve steps

  /// The rate of one step for logarithms x of the principal stretches and their rates: that of the stretch whose
  /// logarithm changes fastest, and 0 where it does not count.
  [[nodiscard]] double present(const Vector& x, const Vector& rates_of_x) const;

  struct Excess {
    Vector force = Vector::Zero();
    Matrix slope = Matrix::Zero();
    Vector force_over_rate = Vector::Zero();
  };
  /// What a rate adds to the first law, without hysteresis.
  [[nodiscard]] Excess excess(const Vector& x, double rate) const;
};

}  // namespace gapcheck::solver
