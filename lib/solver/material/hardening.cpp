#include "solver/material/hardening.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {

YieldCurve::YieldCurve(const std::vector<Point>& points) {
  for (const Point& point : points) {
    if (!std::isfinite(point.plastic_strain) || !std::isfinite(point.stress) || point.plastic_strain < 0) continue;
    if (points_.empty() && point.plastic_strain > 0) points_.push_back({0, point.stress});
    if (points_.empty() || point.plastic_strain > points_.back().plastic_strain) points_.push_back(point);
  }
}

std::size_t YieldCurve::segment(double plastic_strain) const {
  if (points_.size() < 3) return 0;
  const auto above = std::upper_bound(points_.begin() + 1, points_.end() - 1, plastic_strain,
                                      [](double strain, const Point& point) { return strain < point.plastic_strain; });
  return static_cast<std::size_t>(above - points_.begin()) - 1;
}

double YieldCurve::slope(std::size_t segment) const {
  if (points_.size() < 2) return 0;
  const Point &a = points_[segment], &b = points_[segment + 1];
  return (b.stress - a.stress) / (b.plastic_strain - a.plastic_strain);
}

double YieldCurve::stress(double plastic_strain) const {
  const std::size_t at = segment(plastic_strain);
  return points_[at].stress + slope(at) * (plastic_strain - points_[at].plastic_strain);
}

YieldCurve::Return YieldCurve::solve(double trial, double resistance, double plastic_strain, double scale,
                                     const YieldCurve& other, double weight) const {
  constexpr double least_resistance = 1e-6;
  const double start = (1 - weight) * stress(plastic_strain) + weight * other.stress(plastic_strain);
  double reached = 0, excess = trial - scale * start;
  for (std::size_t at = segment(plastic_strain);; ++at) {
    const double hardening = scale * ((1 - weight) * slope(at) + weight * other.slope(at));
    const double gradient = std::max(resistance + hardening, least_resistance * resistance);
    const double step = excess / gradient;
    const bool last = at + 2 >= points_.size();
    const double room = last ? 0 : points_[at + 1].plastic_strain - (plastic_strain + reached);
    if (last || !(step > room)) return {reached + step, gradient - resistance};
    reached += room;
    excess -= gradient * room;
  }
}

void YieldCurve::align(std::vector<YieldCurve>& curves) {
  std::vector<double> strains;
  for (const YieldCurve& curve : curves)
    for (const Point& point : curve.points_) strains.push_back(point.plastic_strain);
  std::sort(strains.begin(), strains.end());
  strains.erase(std::unique(strains.begin(), strains.end()), strains.end());
  if (strains.size() == 1) return;
  for (YieldCurve& curve : curves) {
    if (curve.empty()) continue;
    std::vector<Point> points;
    points.reserve(strains.size());
    for (const double strain : strains) points.push_back({strain, curve.stress(strain)});
    curve.points_ = std::move(points);
  }
}

double rate_scale(double rate, double c, double p) {
  if (c <= 0 || p <= 0 || rate <= 0) return 1;
  return 1 + std::pow(rate / c, 1 / p);
}

}  // namespace gapcheck::solver
