#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "model/entity/part.hpp"

namespace gapcheck::model {

/// *MAT_ADD_EROSION: when elements of a material are deleted (keyword manual, volume II). Stresses, times and impulses
/// are in the model's units. Criteria that EXCL leaves out are empty.
struct Erosion {
  std::int64_t material_id = 0;
  std::optional<double> mxpres, mneps, effeps, voleps, mnpres, sigp1, sigvm, mxeps, epssh, sigth, impulse;
  double failtm = 0;           ///< 0: none
  double numfip = 1, ncs = 1;  ///< integration points that must fail; criteria that must be met
  std::string unread;          ///< the first field of further cards that is not zero, "IDAM = 1"; empty: none
  Place place;
};

}  // namespace gapcheck::model
