#pragma once
#include <cstdint>
#include <vector>

#include "base/ids.hpp"
#include "model/entity/part.hpp"

namespace gapcheck::model {

/// *CONSTRAINED_LINEAR_GLOBAL and _LOCAL: Σ cₖ uₖ = 0 of degrees of freedom, each in axes of its own; as written.
struct LinearConstraint {
  struct Term {
    std::int64_t node = 0;
    std::int64_t freedom = 0;  ///< 1 … 3 translations, 4 … 6 rotations
    std::int64_t system = 0;   ///< CID of _LOCAL; 0: global axes
    double factor = 0;
    Place place;
  };
  std::int64_t id = 0;
  bool local = false;  ///< _LOCAL
  std::vector<Term> terms;
  Place place;
};

/// *CONSTRAINED_NODE_SET: nodes that share translations.
struct JoinedSet {
  std::int64_t id = 0;        ///< given, or 0
  std::int64_t node_set = 0;  ///< NSID
  std::int64_t code = 0;      ///< DOF: 1 x, 2 y, 3 z, 4 x and y, 5 y and z, 6 z and x, 7 all
  double failure_time = 0;    ///< TF; 0: none
  Place place;
};

}  // namespace gapcheck::model
