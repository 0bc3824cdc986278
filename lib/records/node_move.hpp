#pragma once
#include <cstdint>

#include "base/vector.hpp"

namespace gapcheck {

/// Where a node of a deck goes: in a correction, or before the first cycle of a run.
struct NodeMove {
  std::int64_t node = 0;  ///< id
  Vector to = Vector::Zero();
};

}  // namespace gapcheck
