#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "contact/search/search.hpp"
#include "contact/surface/surface.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// Motion is measured and summed in doubles; this covers their rounding.
inline constexpr double rounding_of_motion = 1 + 1e-12;

/// How much farther than the contact distance the search looks, so that its candidates last several steps: half a mean
/// side of the segments.
class SearchMargin {
 public:
  void add(const contact::Segments& segments, const std::vector<Vector>& x) {
    for (const auto& n : segments.nodes)
      for (std::size_t i = 0; i < 4; ++i) {
        if (n[i] == n[(i + 1) % 4]) continue;
        length_ += (x[n[i].value] - x[n[(i + 1) % 4].value]).norm();
        ++count_;
      }
  }
  /// 0 without any side.
  [[nodiscard]] double value() const { return count_ == 0 ? 0 : in_sides * length_ / static_cast<double>(count_); }

 private:
  static constexpr double in_sides = 0.5;
  double length_ = 0;
  std::size_t count_ = 0;
};

/// How much of the margin is used up: an upper bound of how far anything has come closer to anything else since the
/// last search.
class MarginUse {
 public:
  void set_margin(double margin) { margin_ = margin; }
  /// The nodes whose motion counts (positions in the model).
  void set_nodes(std::vector<std::uint32_t> nodes) { nodes_ = std::move(nodes); }
  [[nodiscard]] double margin() const { return margin_; }
  [[nodiscard]] double used() const { return used_; }
  void add(double way) { used_ += way; }
  /// Adds the motion of the last step.
  void add_step(const State& state) { used_ += approach(state); }
  /// To be called at each search.
  void reset(const State& state) {
    contact::Bounds velocities;
    for (const std::uint32_t node : nodes_) velocities.add(state.v[node]);
    drift_ = (velocities.low + velocities.high) / 2;
    used_ = 0;
  }

 private:
  [[nodiscard]] double approach(const State& state) const {
    constexpr std::size_t block = 4096;
    const std::size_t blocks = (nodes_.size() + block - 1) / block;
    std::vector<double> fastest(blocks, 0);
    parallel_for(blocks, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
        for (std::size_t i = b * block; i < std::min(nodes_.size(), (b + 1) * block); ++i)
          fastest[b] = std::max(fastest[b], (state.v[nodes_[i]] - drift_).squaredNorm());
    });
    double squared = 0;
    for (const double of_block : fastest) squared = std::max(squared, of_block);
    return 2 * std::sqrt(squared) * state.dt * rounding_of_motion;
  }

  std::vector<std::uint32_t> nodes_;
  Vector drift_ = Vector::Zero();  ///< middle of all velocities at the last search: common motion brings nothing closer
  double margin_ = 0, used_ = 0;
};

}  // namespace gapcheck::solver
