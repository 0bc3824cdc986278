#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/entity/boundary.hpp"

namespace gapcheck::model {

/// *CONSTRAINED_INTERPOLATION: a dependent node whose motion is the weighted average of that of independent nodes.
/// Numbers are as written, but for defaults; digits name degrees of freedom: 1 … 3 the translations, 4 … 6 the
/// rotations.
struct Interpolation {
  /// A card of independent nodes.
  struct Independent {
    NodeChoice nodes;
    std::int64_t freedoms = 123456;
    std::array<double, 6> weights{1, 1, 1, 1, 1, 1};  ///< of the translations, then the rotations
    std::int64_t system = 0;                          ///< CIDI; 0: global axes
    Place place;
  };
  std::string keyword;
  std::int64_t id = 0;
  std::int64_t dependent = 0;  ///< node
  std::int64_t freedoms = 123456;
  std::int64_t system = 0;    ///< CIDD; 0: global axes
  std::int64_t by_set = 0;    ///< ITYP: 0 nodes, 1 node sets
  std::int64_t deletion = 1;  ///< IDNSW: 1 ends the run when a node is deleted, 2 goes on
  std::vector<Independent> independents;
  Place place;
};

}  // namespace gapcheck::model
