#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gapcheck::api {

/// Energies and momenta of P parts at T times, as matsum or its branch of a binout has them, in the units of the model.
/// Arrays of T × P and T × P × 3 are row by row: part p at time t is entry t P + p. NaN: the file has no number there.
struct PartHistory {
  std::vector<std::int64_t> part;                         ///< P ids, as they first appear
  std::vector<std::string> title;                         ///< P, empty: none
  std::vector<double> times;                              ///< T, ascending
  std::vector<double> internal, kinetic, hourglass;       ///< T × P energies
  std::vector<double> eroded_internal, eroded_hourglass;  ///< T × P, of deleted elements, which the others leave out
  std::vector<double> momentum;                           ///< T × P × 3
  std::vector<double> velocity;                           ///< T × P × 3, of the part as a rigid body
};

}  // namespace gapcheck::api
