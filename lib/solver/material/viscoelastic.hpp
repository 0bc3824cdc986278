#pragma once

namespace gapcheck::solver {

/// Material 006 after Herrmann and Peterson (7th ICRPG, 1968): elastic pressure K; the deviator relaxes with
/// G(t) = G∞ + (G₀ − G∞) exp(−β t). The part that relaxes is in PointState::back_stress.
struct Viscoelastic {
  double bulk = 0, long_shear = 0, relaxing_shear = 0, decay = 0;  ///< K, G∞, G₀ − G∞, β
};

}  // namespace gapcheck::solver
