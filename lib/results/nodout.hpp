#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/vector.hpp"
#include "results/file_header.hpp"

namespace gapcheck::results {

/// Motion of one node at one time.
struct NodeState {
  std::int64_t node = 0;
  Vector displacement = Vector::Zero(), velocity = Vector::Zero(), acceleration = Vector::Zero();
  Vector position = Vector::Zero();
  Vector rotation = Vector::Zero(), angular_velocity = Vector::Zero(), angular_acceleration = Vector::Zero();
};

/// Nodes have titles only where the deck gives them.
[[nodiscard]] std::string nodout_header(const FileHeader& header, std::vector<LegendEntry> nodes);
/// Two blocks: translations, rotations. `cycle`: from 1.
[[nodiscard]] std::string nodout_text(std::uint64_t cycle, double time, std::span<const NodeState> nodes);

}  // namespace gapcheck::results
