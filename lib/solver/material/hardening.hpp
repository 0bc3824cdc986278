#pragma once
#include <vector>

namespace gapcheck::solver {

/// Yield stress over effective plastic strain, linear between points. Beyond the last point the last slope continues; a
/// single point is perfect plasticity. Points have strictly rising strains from 0.
class YieldCurve {
 public:
  struct Point {
    double plastic_strain, stress;
  };
  YieldCurve() = default;
  /// σ = yield + slope · εₚ.
  YieldCurve(double yield, double slope) : points_{{0, yield}, {1, yield + slope}} {}
  /// Points out of order or with repeated strains are dropped; a first strain above 0 is extended back to 0 with its
  /// stress.
  explicit YieldCurve(const std::vector<Point>& points);

  [[nodiscard]] bool empty() const { return points_.empty(); }
  [[nodiscard]] double stress(double plastic_strain) const;

  /// Solves trial − resistance · Δ = scale · σ(plastic_strain + Δ) for Δ ≥ 0, exactly, segment by segment.
  /// `trial` is above scale · σ(plastic_strain). Softening steeper than the resistance is limited to just below the
  /// resistance, so there is always a solution.
  struct Return {
    double increment, slope;  ///< Δ and scale · dσ/dεₚ at its end
  };
  [[nodiscard]] Return solve(double trial, double resistance, double plastic_strain, double scale) const {
    return solve(trial, resistance, plastic_strain, scale, *this, 0);
  }
  /// The same for (1 − weight) σ + weight σ', where `other` has points at the same strains.
  [[nodiscard]] Return solve(double trial, double resistance, double plastic_strain, double scale,
                             const YieldCurve& other, double weight) const;

  /// Adds points at the strains of all curves to each of them; their shapes stay.
  static void align(std::vector<YieldCurve>& curves);

 private:
  [[nodiscard]] std::size_t segment(double plastic_strain) const;
  [[nodiscard]] double slope(std::size_t segment) const;
  std::vector<Point> points_;
};

/// The yield stress of one step: between two aligned curves, times a factor.
struct YieldLaw {
  const YieldCurve *low, *high;
  double weight = 0, scale = 1;

  [[nodiscard]] double stress(double plastic_strain) const {
    return scale * ((1 - weight) * low->stress(plastic_strain) + weight * high->stress(plastic_strain));
  }
  [[nodiscard]] YieldCurve::Return solve(double trial, double resistance, double plastic_strain) const {
    return low->solve(trial, resistance, plastic_strain, scale, *high, weight);
  }
};

/// Cowper and Symonds: 1 + (rate / c)^(1/p); 1 where c or p is zero.
[[nodiscard]] double rate_scale(double rate, double c, double p);

}  // namespace gapcheck::solver
