#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/vector.hpp"
#include "results/text/file_header.hpp"

namespace gapcheck::results {

/// Motion of one node at one time.
struct NodeState {
  std::int64_t node = 0;
  Vector displacement = Vector::Zero(), velocity = Vector::Zero(), acceleration = Vector::Zero();
  Vector position = Vector::Zero();
  Vector rotation = Vector::Zero(), angular_velocity = Vector::Zero(), angular_acceleration = Vector::Zero();
};

/// All nodes of the file at one time.
struct NodeStates {
  std::uint64_t cycle = 0;  ///< from 1; 0: not in the file
  double time = 0;
  std::vector<NodeState> nodes;
};

/// What a nodout file says over the whole run.
struct NodeHistory {
  std::vector<LegendEntry> titles;
  std::vector<NodeStates> states;  ///< in order of the file
};

/// Nodes have titles only if the deck gives them.
[[nodiscard]] std::string nodout_header(const FileHeader& header, std::vector<LegendEntry> nodes);
/// Two blocks: translations, rotations. `cycle`: from 1.
[[nodiscard]] std::string nodout_text(std::uint64_t cycle, double time, std::span<const NodeState> nodes);

/// The states of a nodout file; columns have a width of 12, so values may touch. A last state with fewer rows than the
/// one before it is left out; `diagnostics` say so, and name rows and numbers that cannot be read. The latter, and NaN
/// of the run, are NaN.
[[nodiscard]] NodeHistory read_nodout(std::string_view text, const std::string& name, Diagnostics& diagnostics);

}  // namespace gapcheck::results
