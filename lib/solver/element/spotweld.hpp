#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// N, Qs, Qt (axial force and shear forces), T, Ms, Mt (torsion and bending moments about s and t) of a weld or of a
/// beam's cross-section, in its axes r, s, t. LS-DYNA Keyword User's Manual, Vol. II, *MAT_SPOTWELD: NRR, NRS, NRT,
/// MRR, MSS, MTT.
using WeldResultants = std::array<double, 6>;

/// When beams and bricks of material 100 fail. Zero: never by that.
struct WeldLimits {
  WeldResultants strength{};  ///< Σ (resultant / strength)² >= 1, of N only tension
  double plastic_strain = 0;  ///< once all points have it
  double time = 0;
  std::size_t filter = 0;  ///< resultants count as the mean of so many evaluations
  double step = 0;         ///< DT: elements get mass until their L/c is as long

  /// By their resultants.
  [[nodiscard]] bool break_by_force() const {
    return std::any_of(strength.begin(), strength.end(), [](double value) { return value > 0; });
  }
  /// False: the weld never fails.
  [[nodiscard]] bool exist() const { return plastic_strain > 0 || time > 0 || break_by_force(); }
};

/// The last resultants of a weld with a filter, the oldest one replaced.
struct WeldHistory {
  std::vector<WeldResultants> recent;
  std::size_t oldest = 0;
};

/// True if a weld fails at `time` with these resultants. `plastic_strain`: that of the point that has least. Keeps the
/// resultants in `history` if they are filtered.
[[nodiscard]] bool weld_fails(const WeldLimits& limits, const WeldResultants& resultants, double time,
                              double plastic_strain, WeldHistory& history);

/// The least plastic strain of an element's points; 0 without points.
template <class Point>
[[nodiscard]] double least_plastic_strain(std::span<const Point> points) {
  double least = points.empty() ? 0 : std::numeric_limits<double>::infinity();
  for (const Point& point : points) least = std::min(least, point.plastic_strain);
  return least;
}

/// The resultants of a brick between two sheets from the forces on its corners (that the brick pulls with opposite
/// ones): corners 1 to 4 lie on the lower sheet, 5 to 8 on the upper one. The force is that on the upper face, the
/// moments are the means of both faces, which is the moment about the middle between them. r: normal to the
/// surface half-way between the faces; s: from its side 4-1 to its side 2-3.
[[nodiscard]] WeldResultants brick_resultants(const std::array<Vector, 8>& x, const std::array<Vector, 8>& force);

}  // namespace gapcheck::solver
