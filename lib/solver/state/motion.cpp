#include "solver/state/motion.hpp"

#include <algorithm>

namespace gapcheck::solver {

TimeCurve::TimeCurve(std::vector<Point> points) : points_(std::move(points)), integral_(points_.size(), 0) {
  for (std::size_t i = 1; i < points_.size(); ++i)
    integral_[i] = integral_[i - 1] + (points_[i][0] - points_[i - 1][0]) * (points_[i][1] + points_[i - 1][1]) / 2;
}

std::size_t TimeCurve::after(double time) const {
  const auto above =
      std::upper_bound(points_.begin(), points_.end(), time, [](double t, const Point& point) { return t < point[0]; });
  return static_cast<std::size_t>(above - points_.begin());
}

double TimeCurve::at(double time) const {
  if (points_.empty()) return 0;
  const std::size_t next = after(time);
  if (next == 0) return points_.front()[1];
  if (next == points_.size()) return points_.back()[1];
  return points_[next - 1][1] + slope(time) * (time - points_[next - 1][0]);
}

double TimeCurve::slope(double time) const {
  const std::size_t next = after(time);
  if (next == 0 || next == points_.size()) return 0;
  const auto& [t0, v0] = points_[next - 1];
  const auto& [t1, v1] = points_[next];
  return (v1 - v0) / (t1 - t0);
}

double TimeCurve::integral(double time) const {
  if (points_.empty()) return 0;
  const std::size_t next = after(time);
  if (next == 0) return (time - points_[0][0]) * points_[0][1];
  const auto& [t0, v0] = points_[next - 1];
  return integral_[next - 1] + (time - t0) * (v0 + at(time)) / 2;
}

double Motion::velocity(double time, double dt) const {
  if (curve == nullptr) return 0;
  const double shift = birth > 0 ? curve->start() - birth : 0;
  const double from = std::max(time, birth) + shift, to = time + dt + shift,
               middle = std::max(from, time + dt / 2 + shift);
  switch (quantity) {
    case Quantity::displacement:
      return scale * (dt > 0 ? (curve->at(to) - curve->at(from)) / dt : curve->slope(from));
    case Quantity::acceleration:
      return initial + scale * (curve->integral(middle) - curve->integral(birth + shift));
    case Quantity::velocity:
      break;
  }
  return scale * curve->at(middle);
}

}  // namespace gapcheck::solver
