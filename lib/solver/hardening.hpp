#pragma once
#include <vector>

namespace gapcheck::solver {

/// Yield stress over effective plastic strain, linear between points. Beyond the last point the last slope goes on;
/// a single point is perfect plasticity. Points have strictly rising strains from 0.
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
  /// `trial` is above scale · σ(plastic_strain). Softening steeper than the resistance is taken as the resistance just
  /// missed, so that there is always an answer.
  struct Return {
    double increment, slope;  ///< Δ and scale · dσ/dεₚ where it ends
  };
  [[nodiscard]] Return solve(double trial, double resistance, double plastic_strain, double scale) const;

 private:
  [[nodiscard]] std::size_t segment(double plastic_strain) const;
  [[nodiscard]] double slope(std::size_t segment) const;
  std::vector<Point> points_;
};

/// Cowper and Symonds: 1 + (rate / c)^(1/p); 1 where c or p is zero.
[[nodiscard]] double rate_scale(double rate, double c, double p);

}  // namespace gapcheck::solver
