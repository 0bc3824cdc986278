#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "base/vector.hpp"
#include "results/history/history.hpp"

namespace gapcheck::results {

/// Motion of one rigid body at one time (rbdout).
struct BodyMotion {
  std::int64_t body = 0;  ///< id of its part or nodal rigid body
  bool nodal = false;
  Vector position = Vector::Zero();  ///< of the centre of mass
  Vector displacement = Vector::Zero(), velocity = Vector::Zero(), acceleration = Vector::Zero();
  Vector rotation = Vector::Zero(), spin = Vector::Zero(), spin_rate = Vector::Zero();  ///< about the global axes
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns a, b, c: its principal axes, as they are now
};

// The layout is that of the solver developer's own converter from binout to text (l2a). Which principal axis is called
// a is not documented; here they ascend by their inertia.
[[nodiscard]] std::string rbdout_header(const FileHeader& header);
/// `cycle`: from 1.
[[nodiscard]] std::string rbdout_text(std::uint64_t cycle, double time, std::span<const BodyMotion> bodies);
/// What is in global axes, and the axes.
[[nodiscard]] History<BodyMotion> read_rbdout(std::string_view text, const std::string& name, Diagnostics& diagnostics);

}  // namespace gapcheck::results
