#pragma once
#include <fmt/format.h>

#include <string>

namespace gapcheck::audit {

/// A reference side finer than this is a mistake rather than a matter of meshing.
inline constexpr double too_fine = 1.5;

/// Mean edges of the two sides of a contact; 0: not known.
struct SideSizes {
  double tracked = 0, reference = 0;
  /// The workshop asks for the coarser mesh on the reference side (contact rules, section 11).
  [[nodiscard]] bool reference_too_fine() const { return reference > 0 && tracked > too_fine * reference; }
  /// "the reference side B is 2 times finer than the tracked side A (mean edges 2 and 4)"
  [[nodiscard]] std::string text() const {
    return fmt::format(
        "the reference side B is {:.3g} times finer than the tracked side A (mean edges {:.4g} and {:.4g})",
        tracked / reference, reference, tracked);
  }
};

}  // namespace gapcheck::audit
