#pragma once
#include <cstddef>
#include <cstdint>
#include <gapcheck/result.hpp>
#include <string>
#include <vector>

namespace gapcheck::api {

/// What is read of a d3plot.
struct MotionOptions {
  std::vector<std::size_t> states = {};  ///< positions of states, from 0, in this order; empty: all
  bool velocities = true;                ///< read them too
};

/// Where n nodes are in T states of a d3plot, in the model's units. Values are those of the file: with single precision
/// they have its digits, and a node that ran away may be NaN or infinite.
struct Motion {
  std::vector<std::int64_t> node;  ///< n ids
  std::vector<double> start;       ///< n × 3, the mesh before the states
  std::vector<double> times;       ///< T
  std::vector<double> positions;   ///< T × n × 3
  std::vector<double> velocities;  ///< T × n × 3; empty: the file has none, or they were not asked for
};

/// Reads the states of a d3plot and its file family. `path`: the first file, or a directory with a file d3plot. Errors:
/// no such file; truncated, damaged or compressed files; models with particles, fluids, airbags or road surfaces;
/// states without coordinates; a position of a state that is not there. Memory: 24 bytes per node and state, with
/// velocities 48.
///
///     const auto motion = gapcheck::api::read_motion("out");
///     if (!motion) return fail(motion.error());
///     print(motion.value().times.back(), motion.value().positions.size());
[[nodiscard]] Result<Motion> read_motion(const std::string& path, const MotionOptions& options = {});

}  // namespace gapcheck::api
