#pragma once
#include <algorithm>
#include <cmath>

namespace gapcheck::solver {

/// Contact pressure of mortar contact over the penetration d:
///
///     σ = κ ε d_c f(d / (ε d_c))    f(x) = x² / 4 up to x = 2, then x − 1
///
/// so it begins without a kink and has the slope κ (pressure over depth) from 2 ε d_c on. κ = α K / d_c of the tracked
/// segment, α = SLSFAC · SFSA, d_c its characteristic length. Source: T. Borrvall, Mortar contact algorithm for
/// implicit stamping analyses in LS-DYNA, 10th Int. LS-DYNA Users Conference, 2008, as commonly quoted; the linear
/// branch continues the quadratic one with the same slope.
struct MortarLaw {
  double slope = 0;  ///< κ
  double knee = 0;   ///< ε d_c; 0: linear from the first contact on

  /// ε: where the quadratic branch ends, as a share of d_c / 2.
  static constexpr double relative_knee = 0.03;

  [[nodiscard]] double pressure(double depth) const {
    if (!(depth > 0)) return 0;
    if (depth >= 2 * knee) return slope * (depth - knee);
    return slope * depth * depth / (4 * knee);
  }
  /// Energy per area that the pressure stores.
  [[nodiscard]] double energy(double depth) const {
    if (!(depth > 0)) return 0;
    if (depth >= 2 * knee) return slope * (depth * depth / 2 - knee * depth + 2 * knee * knee / 3);
    return slope * depth * depth * depth / (12 * knee);
  }
  /// The depth that gives a pressure; 0 where there is no stiffness.
  [[nodiscard]] double depth_of(double pressure) const {
    if (!(pressure > 0) || !(slope > 0)) return 0;
    const double linear = pressure / slope;
    return linear < knee ? 2 * std::sqrt(linear * knee) : linear + knee;
  }
};

}  // namespace gapcheck::solver
