#include "solver/constraints.hpp"

#include <algorithm>

namespace gapcheck::solver {

double VelocityCurve::at(double time) const {
  if (points.empty()) return 0;
  const auto above = std::upper_bound(points.begin(), points.end(), time,
                                      [](double t, const std::array<double, 2>& point) { return t < point[0]; });
  if (above == points.begin()) return points.front()[1];
  if (above == points.end()) return points.back()[1];
  const auto& [t0, v0] = *(above - 1);
  const auto& [t1, v1] = *above;
  return v0 + (v1 - v0) * (time - t0) / (t1 - t0);
}

void Constraints::move(NodeIndex node, std::size_t freedom, VelocityCurve curve) {
  mask_[node.value] |= static_cast<std::uint8_t>(1u << freedom);
  moved_.push_back({6 * std::uint64_t{node.value} + freedom, std::move(curve)});
}

void Constraints::finish() {
  std::stable_sort(moved_.begin(), moved_.end(), [](const Moved& a, const Moved& b) { return a.key < b.key; });
  // Of equal keys the last stays.
  const auto kept =
      std::unique(moved_.rbegin(), moved_.rend(), [](const Moved& a, const Moved& b) { return a.key == b.key; });
  moved_.erase(moved_.begin(), kept.base());
}

double Constraints::velocity(std::size_t node, std::size_t freedom, double time) const {
  const std::uint64_t key = 6 * std::uint64_t{node} + freedom;
  const auto found = std::lower_bound(moved_.begin(), moved_.end(), key,
                                      [](const Moved& moved, std::uint64_t wanted) { return moved.key < wanted; });
  return found != moved_.end() && found->key == key ? found->curve.at(time) : 0;
}

}  // namespace gapcheck::solver
