#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "model/entity/part.hpp"

namespace gapcheck::model {

/// *DEFINE_CURVE with its offsets and scales applied: (a + OFFA) SFA, (o + OFFO) SFO. Only the user of a curve knows
/// what its numbers are (times, strains, stresses), so they stay in the unit of the file.
struct Curve {
  std::vector<std::array<double, 2>> points;  ///< abscissa, ordinate, as written; abscissas should rise
  double abscissa_time = 1;                   ///< time factor of the curve's file, for curves over time
  std::int64_t relaxation = 0;                ///< SIDR: 1: for dynamic relaxation only, 2: for that and the run
  std::int64_t discretization = 0;            ///< LCINT; 0: as *CONTROL_SOLUTION has it
  Place place;
  /// Linear between the points, constant beyond them; 0 without points.
  [[nodiscard]] double at(double abscissa) const {
    if (points.empty()) return 0;
    const auto above = std::upper_bound(points.begin(), points.end(), abscissa,
                                        [](double a, const std::array<double, 2>& point) { return a < point[0]; });
    if (above == points.begin()) return points.front()[1];
    if (above == points.end()) return points.back()[1];
    const auto& [a0, o0] = *(above - 1);
    const auto& [a1, o1] = *above;
    return o0 + (o1 - o0) * (abscissa - a0) / (a1 - a0);
  }
};

/// *DEFINE_TABLE and *DEFINE_TABLE_2D: curves, each for one value of a second variable.
struct Table {
  struct Row {
    double value = 0;        ///< (value + OFFA) SFA
    std::int64_t curve = 0;  ///< 0: none came
  };
  std::vector<Row> rows;  ///< as written; values should rise
  Place place;
};

}  // namespace gapcheck::model
