#pragma once
#include <array>

#include "base/vector.hpp"

namespace gapcheck::solver {

/// Ends of one beam: positions at the end of the step, velocities and angular velocities at its middle.
struct BeamEnds {
  std::array<Vector, 2> x, v, w;
};

}  // namespace gapcheck::solver
