#include "solver/loss/impact_depth.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

/// The square of W at which central differences become unstable.
constexpr double stable_share = 4;

double greatest_force(std::span<const PressedNode> nodes) {
  double sum = 0;
  for (const PressedNode& node : nodes) sum += node.stiffness * node.release;
  return sum;
}

double deepest(std::span<const PressedNode> nodes) {
  double depth = 0;
  for (const PressedNode& node : nodes) depth = std::max(depth, node.release);
  return depth;
}

}  // namespace

std::optional<DepthRange> depth_of_one_mass(double speed, double mobility, double stiffness, double step) {
  const double share = step * step * stiffness * mobility;
  if (!(share < stable_share) || !(stiffness * mobility > 0)) return std::nullopt;
  const double depth = speed / std::sqrt(stiffness * mobility), factor = std::sqrt(1 - share / stable_share);
  return DepthRange{depth * factor, depth / factor};
}

std::optional<double> depth_of_energy(double energy, double stiffness, double share) {
  if (!(share < stable_share) || !(stiffness > 0)) return std::nullopt;
  return std::sqrt(2 * energy / stiffness) / (1 - share / stable_share);
}

double speed_of_release(std::span<const PressedNode> first, std::span<const PressedNode> all, double mass) {
  return std::sqrt(27.0 / 4 * greatest_force(all) * deepest(first) / mass);
}

double speed_of_release_of_sheet(std::span<const PressedNode> nodes, double mass, double step) {
  const double slowing = greatest_force(nodes) / mass;
  // In steps the parabola begins up to one step earlier, and none may meet its top.
  return slowing * step / 2 + std::sqrt(2 * slowing * (deepest(nodes) + slowing * step * step / 8));
}

}  // namespace gapcheck::solver
