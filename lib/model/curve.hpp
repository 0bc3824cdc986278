#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "model/part.hpp"

namespace gapcheck::model {

/// *DEFINE_CURVE with its offsets and scales applied: (a + OFFA) SFA, (o + OFFO) SFO. What the numbers are (times,
/// strains, stresses) is known to their user only, so they stay in the unit of the file.
struct Curve {
  std::vector<std::array<double, 2>> points;  ///< abscissa, ordinate, as written; abscissas should rise
  double abscissa_time = 1;                   ///< time factor of the curve's file, for curves over time
  Place place;
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
