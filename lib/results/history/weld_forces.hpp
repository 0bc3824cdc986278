#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "results/history/history.hpp"

namespace gapcheck::results {

/// What one weld carries at one time (swforc).
struct WeldForce {
  enum class Kind : std::uint8_t { link, generalized, beam, solid } kind = Kind::link;
  std::int64_t id = 0;
  double axial = 0;         ///< above zero in tension
  double shear = 0;         ///< resultant, not below zero
  bool failed = false;      ///< it then carries nothing
  double failure_time = 0;  ///< where it has failed
  double length = 0;        ///< of beams and solids
  /// Of beams and solids: resultant bending moment and torsion. The text has no columns for them.
  double moment = 0, torsion = 0;
};

/// "constraint/weld", "generalized weld", "spotweld beam", "spotweld solid".
[[nodiscard]] std::string_view name(WeldForce::Kind kind);

// The layout is that of the solver developer's own converter from binout to text (l2a). Newer releases also print
// moments.
[[nodiscard]] std::string swforc_header(const FileHeader& header);
[[nodiscard]] std::string swforc_text(double time, std::span<const WeldForce> welds);
[[nodiscard]] History<WeldForce> read_swforc(std::string_view text, const std::string& name, Diagnostics& diagnostics);

}  // namespace gapcheck::results
