#include "solver/mortar/mortar_offsets.hpp"

#include <algorithm>
#include <cstdlib>

namespace gapcheck::solver {

MortarOffsets::MortarOffsets(std::int64_t ignore, double mpar1, std::size_t faces)
    : ignore_(ignore == 0 ? 2 : std::abs(ignore)), mpar1_(mpar1), depth_(2 * faces, 0) {}

std::vector<double> MortarOffsets::deepest(std::span<const MortarPair> pairs) const {
  std::vector<double> depths(depth_.size(), 0);
  for (const MortarPair& pair : pairs) {
    double& depth = depths[place(pair.tracked, pair)];
    depth = std::max(depth, pair.deepest);
  }
  return depths;
}

void MortarOffsets::begin(std::span<const MortarPair> pairs, double time) {
  start_ = time;
  depth_ = deepest(pairs);
}

void MortarOffsets::follow(std::span<const MortarPair> pairs) {
  if (ignore_ != 1 || std::none_of(depth_.begin(), depth_.end(), [](double depth) { return depth > 0; })) return;
  const std::vector<double> now = deepest(pairs);
  for (std::size_t i = 0; i < depth_.size(); ++i) depth_[i] = std::min(depth_[i], now[i]);
}

double MortarOffsets::forgiven(const MortarPair& pair, double time, const MortarLaw& law) const {
  const double depth = depth_[place(pair.tracked, pair)];
  if (!(depth > 0)) return 0;
  if (ignore_ == 1) return depth;
  return presses_out() ? depth * share_left(time) : depth - law.depth_of(mpar1_);
}

double MortarOffsets::grown(const MortarPair& pair, double time, double dt) const {
  const double depth = depth_[place(pair.tracked, pair)];
  return depth > 0 && presses_out() ? depth * (share_left(time - dt) - share_left(time)) : 0;
}

double MortarOffsets::share_left(double time) const {
  return mpar1_ > 0 ? std::clamp(1 - (time - start_) / mpar1_, 0.0, 1.0) : 0;
}

void MortarOffsets::take(std::uint32_t face, const MortarOffsets& from, std::uint32_t of) {
  for (std::size_t side = 0; side < 2; ++side)
    depth_[2 * std::size_t{face} + side] = from.depth_[2 * std::size_t{of} + side];
}

}  // namespace gapcheck::solver
