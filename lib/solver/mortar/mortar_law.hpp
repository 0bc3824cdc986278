#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

namespace gapcheck::solver {

/// Contact pressure of mortar contact over the penetration d:
///
///     σ = κ ε d_c f(d / (ε d_c))    f(x) = x² / 4    κ = α K / d_c
///
/// of the tracked segment, α = SLSFAC · SFSA, d_c its characteristic length. Where the slope κ x / 2 reaches `steepest`
/// the pressure goes on in a straight line, so that a small pressure has the depth of the formula and no pressure a
/// slope that the time step does not bear. Source: T. Borrvall, Mortar contact algorithm for implicit stamping analyses
/// in LS-DYNA, 10th Int. LS-DYNA Users Conference, 2008, as commonly quoted; the straight line is our own choice.
struct MortarLaw {
  double slope = 0;                                           ///< κ
  double knee = 0;                                            ///< ε d_c; 0: linear from the first contact on
  double steepest = std::numeric_limits<double>::infinity();  ///< slope that is not exceeded

  [[nodiscard]] bool operator==(const MortarLaw&) const = default;

  /// ε
  static constexpr double relative_knee = 0.03;

  /// Where the straight line begins.
  [[nodiscard]] double straight_from() const { return knee > 0 && slope > 0 ? 2 * knee * (steepest / slope) : 0; }
  [[nodiscard]] double pressure(double depth) const {
    if (!(depth > 0)) return 0;
    const double straight = straight_from();
    if (depth > straight) return line() * (depth - straight / 2);
    return slope * depth * depth / (4 * knee);
  }
  /// Energy per area that the pressure stores.
  [[nodiscard]] double energy(double depth) const {
    if (!(depth > 0)) return 0;
    const double straight = straight_from();
    if (!(depth > straight)) return slope * depth * depth * depth / (12 * knee);
    return line() * (depth * depth / 2 - straight * depth / 2 + straight * straight / 6);
  }
  /// The depth that gives a pressure; 0 where there is no stiffness.
  [[nodiscard]] double depth_of(double pressure) const {
    if (!(pressure > 0) || !(line() > 0)) return 0;
    const double straight = straight_from();
    const double curved = straight > 0 ? 2 * std::sqrt(pressure / slope * knee) : 0;
    return curved < straight ? curved : pressure / line() + straight / 2;
  }
  /// The slope κ, as far as it is allowed: that of friction, which sticks elastically, and of damping.
  [[nodiscard]] double stiffness() const { return std::min(slope, steepest); }

 private:
  /// The slope of the straight line.
  [[nodiscard]] double line() const {
    if (!(slope > 0)) return 0;
    return knee > 0 ? steepest : stiffness();
  }
};

}  // namespace gapcheck::solver
