#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/vector.hpp"
#include "results/file_header.hpp"

namespace gapcheck::results {

/// Energies and momentum of one part at one time.
struct PartState {
  std::int64_t part = 0;
  double internal = 0, kinetic = 0, hourglass = 0;
  Vector momentum = Vector::Zero();
  Vector velocity = Vector::Zero();  ///< of the rigid body
};

[[nodiscard]] std::string matsum_header(const FileHeader& header, std::vector<LegendEntry> parts);
[[nodiscard]] std::string matsum_text(double time, std::span<const PartState> parts);

}  // namespace gapcheck::results
