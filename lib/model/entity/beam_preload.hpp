#pragma once
#include <cstdint>

#include "model/entity/part.hpp"

namespace gapcheck::model {

/// *INITIAL_AXIAL_FORCE_BEAM: beams whose axial force is given while the curve lasts.
struct BeamPreload {
  std::int64_t set = 0;    ///< BSID, of beams
  std::int64_t curve = 0;  ///< LCID, over time
  double scale = 1;        ///< with the unit of force of the file
  std::int64_t kbend = 0;  ///< 0: no bending moment during the preload; 1: bending as without it
  Place place;
};

}  // namespace gapcheck::model
