#pragma once
#include <cstdint>
#include <vector>

#include "model/entity/part.hpp"

namespace gapcheck::model {

/// *CONSTRAINED_SPOTWELD and *CONSTRAINED_GENERALIZED_WELD_SPOT: nodes that a rigid link without mass holds together
/// until it fails.
struct Weld {
  std::int64_t id = 0;  ///< given, or the weld's position among the welds of the deck, from 1
  bool generalized = false;
  std::vector<NodeIndex> nodes;  ///< of a spot weld two
  /// Failure at (|fn| / normal_force)^normal_power + (|fs| / shear_force)^shear_power >= 1, fn in tension only; a force
  /// of zero: no such limit. In the model's units.
  double normal_force = 0, shear_force = 0;
  double normal_power = 0, shear_power = 0;  ///< as written
  double failure_time = 0;                   ///< 0: none
  double plastic_strain = 0;                 ///< of the shells around at failure; 0: none
  Place place;
};

}  // namespace gapcheck::model
