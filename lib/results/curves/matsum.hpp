#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/vector.hpp"
#include "results/text/file_header.hpp"

namespace gapcheck::results {

/// Energies and momentum of one part at one time.
struct PartState {
  std::int64_t part = 0;
  double internal = 0, kinetic = 0, hourglass = 0;
  double eroded_internal = 0, eroded_hourglass = 0;  ///< of deleted elements; not in the ones above
  Vector momentum = Vector::Zero();
  Vector velocity = Vector::Zero();  ///< of the rigid body
};

/// All parts at one time.
struct PartStates {
  double time = 0;
  std::vector<PartState> parts;
};

/// What a matsum file says over the whole run.
struct PartHistory {
  std::vector<LegendEntry> titles;
  std::vector<PartStates> states;  ///< in order of the file
};

[[nodiscard]] std::string matsum_header(const FileHeader& header, std::vector<LegendEntry> parts);
[[nodiscard]] std::string matsum_text(double time, std::span<const PartState> parts);

/// The states of a matsum file, without eroded kinetic energy and added mass. A last state with fewer parts or rows
/// than the one before it is left out; `diagnostics` say so, and name numbers that cannot be read. Those, and NaN of
/// the run, are NaN.
[[nodiscard]] PartHistory read_matsum(std::string_view text, const std::string& name, Diagnostics& diagnostics);

}  // namespace gapcheck::results
