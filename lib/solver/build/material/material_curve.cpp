#include "solver/build/material/material_curve.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {

std::vector<std::array<double, 2>> material_points(const model::Model& model, const model::Curve& curve) {
  constexpr std::int64_t least = 100, most = 100000;
  const std::int64_t asked = curve.discretization != 0 ? curve.discretization : model.controls.lcint;
  const auto count = static_cast<std::size_t>(std::clamp(asked, least, most));
  const auto& points = curve.points;
  const auto rises = [](const auto& a, const auto& b) {
    return a[0] < b[0] && std::isfinite(b[0] - a[0]) && std::isfinite(a[1]) && std::isfinite(b[1]);
  };
  const auto wrong =
      std::adjacent_find(points.begin(), points.end(), [&](const auto& a, const auto& b) { return !rises(a, b); });
  if (points.size() < 3 || wrong != points.end()) return points;
  std::vector<std::array<double, 2>> result;
  result.reserve(count);
  const double first = points.front()[0], range = points.back()[0] - first;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double at = first + range * static_cast<double>(i) / static_cast<double>(count - 1);
    result.push_back({at, curve.at(at)});
  }
  result.push_back(points.back());
  return result;
}

}  // namespace gapcheck::solver
