#pragma once
#include <array>
#include <vector>

namespace gapcheck::solver {

/// A force over a way or rate: linear between points, continued with the end slopes; zero without points.
class ForceCurve {
 public:
  using Point = std::array<double, 2>;
  ForceCurve() = default;
  /// Points that do not ascend are dropped. Without points below zero the curve is odd.
  explicit ForceCurve(const std::vector<Point>& points);

  [[nodiscard]] bool empty() const { return points_.empty(); }
  [[nodiscard]] double at(double way) const;
  /// ∫ at(u) du from 0 to `way`.
  [[nodiscard]] double integral(double way) const;
  /// ∫ max(base + scale · at(u), 0) du from 0 to `way`.
  [[nodiscard]] double integral_above_zero(double way, double base, double scale) const;
  /// The largest |slope|.
  [[nodiscard]] double steepest() const { return steepest_; }

 private:
  template <class Piece>
  [[nodiscard]] double sum_of_pieces(double way, const Piece& piece) const;
  std::vector<Point> points_;
  double steepest_ = 0;
};

}  // namespace gapcheck::solver
