#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/vector.hpp"
#include "results/history/history.hpp"

namespace gapcheck::results {

/// What one rigid wall does to its nodes (rwforc).
struct WallForce {
  std::int64_t wall = 0;
  double normal = 0;              ///< sum along the normals, not below zero
  Vector force = Vector::Zero();  ///< on the nodes, with friction
};

// The layout is that of the solver developer's own converter from binout to text (l2a). It does not say which side the
// force acts on; here it is that on the nodes.
[[nodiscard]] std::string rwforc_header(const FileHeader& header, std::vector<LegendEntry> walls);
[[nodiscard]] std::string rwforc_text(double time, std::span<const WallForce> walls);
/// Forces on the segments of a wall are left out.
[[nodiscard]] History<WallForce> read_rwforc(std::string_view text, const std::string& name, Diagnostics& diagnostics);

}  // namespace gapcheck::results
