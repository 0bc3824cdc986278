#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "results/d3plot/d3plot_states.hpp"

namespace gapcheck::report {

/// How far the nodes of one part lie apart in two runs; lengths of the model.
struct PartMotion {
  std::int64_t part = 0;              ///< 0: nodes of no element
  std::size_t nodes = 0;              ///< that both runs have
  std::vector<double> largest, mean;  ///< distance, at each of the compared times
  double largest_distance = 0, time = 0;
  std::int64_t node = 0;     ///< that lies so far apart
  bool not_numbers = false;  ///< a coordinate of one run is not finite
  bool differs = false;
};

struct MotionComparison {
  double tolerance = 0;
  std::vector<double> times;                    ///< of A's states within the common range
  double largest_displacement = 0;              ///< of any node in either run
  std::vector<PartMotion> parts;                ///< largest distance first
  std::size_t differ = 0;                       ///< parts
  std::size_t only_first = 0, only_second = 0;  ///< nodes that the other run lacks
  double end_first = 0, end_second = 0;
};

/// Nodes are matched by id; their part is that of their first element, shells before solids. The states of B are
/// interpolated to the times of A. A part differs if a distance is above `tolerance` of the largest displacement; a
/// distance of a few units in the last place of single precision coordinates is none. No times if one has no states
/// with coordinates in the common range.
[[nodiscard]] MotionComparison compare_motion(const results::D3plotStates& first, const results::D3plotStates& second,
                                              double tolerance);

/// The same for the d3plots in two directories; nothing if one of them has none. One that cannot be read is a warning.
[[nodiscard]] std::optional<MotionComparison> compare_motion(const std::string& first_directory,
                                                             const std::string& second_directory, double tolerance,
                                                             Diagnostics& diagnostics);

}  // namespace gapcheck::report
