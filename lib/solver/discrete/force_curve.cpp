#include "solver/discrete/force_curve.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {

ForceCurve::ForceCurve(const std::vector<Point>& points) {
  for (const Point& point : points)
    if (points_.empty() || point[0] > points_.back()[0]) points_.push_back(point);
  if (!points_.empty() && points_.front()[0] >= 0) {
    std::vector<Point> odd;
    for (auto point = points_.rbegin(); point != points_.rend(); ++point)
      if ((*point)[0] > 0) odd.push_back({-(*point)[0], -(*point)[1]});
    odd.insert(odd.end(), points_.begin(), points_.end());
    points_ = std::move(odd);
  }
  if (points_.size() < 2) points_.clear();
  for (std::size_t i = 1; i < points_.size(); ++i)
    steepest_ =
        std::max(steepest_, std::abs((points_[i][1] - points_[i - 1][1]) / (points_[i][0] - points_[i - 1][0])));
}

double ForceCurve::at(double way) const {
  if (points_.empty()) return 0;
  const auto above = std::upper_bound(points_.begin() + 1, points_.end() - 1, way,
                                      [](double u, const Point& point) { return u < point[0]; });
  const auto& [u0, f0] = *(above - 1);
  const auto& [u1, f1] = *above;
  return f0 + (f1 - f0) * (way - u0) / (u1 - u0);
}

/// Σ piece(from, to) over the intervals between breaks.
template <class Piece>
double ForceCurve::sum_of_pieces(double way, const Piece& piece) const {
  const double low = std::min(0.0, way), high = std::max(0.0, way);
  double sum = 0, from = low;
  for (const Point& point : points_) {
    if (!(point[0] > low && point[0] < high)) continue;
    sum += piece(from, point[0]);
    from = point[0];
  }
  sum += piece(from, high);
  return way < 0 ? -sum : sum;
}

double ForceCurve::integral(double way) const {
  return sum_of_pieces(way, [&](double from, double to) { return (to - from) * (at(from) + at(to)) / 2; });
}

double ForceCurve::integral_above_zero(double way, double base, double scale) const {
  return sum_of_pieces(way, [&](double from, double to) {
    const double a = base + scale * at(from), b = base + scale * at(to), top = std::max(a, b), low = std::min(a, b);
    if (top <= 0) return 0.0;
    return (to - from) * (low >= 0 ? (a + b) / 2 : top / 2 * top / (top - low));
  });
}

}  // namespace gapcheck::solver
