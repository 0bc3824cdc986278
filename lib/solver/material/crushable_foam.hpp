#pragma once
#include <array>
#include <vector>

namespace gapcheck::solver {

/// Material 063: Hooke's law, but principal stresses not beyond −σ(γ) and the cutoff, γ = 1 − V (keyword manual, volume
/// II; theory manual, material 63). ln V is in PointState::plastic_strain.
struct CrushableFoam {
  std::vector<std::array<double, 2>> points;  ///< γ and σ >= 0; γ rises; two or more
  double cutoff = 0;                          ///< TSC

  /// σ(γ): constant before the first point, the last slope continues.
  [[nodiscard]] double yield(double compression) const;
};

}  // namespace gapcheck::solver
