#pragma once
#include "base/vector.hpp"

namespace gapcheck::solver {

/// When the tie of a tiebreak contact fails: (tension / normal)^normal_power + (across / shear)^shear_power >= 1, of
/// the force on the node. Compression never counts.
struct TieStrength {
  double normal = 0, shear = 0;  ///< forces; 0: no such limit
  double normal_power = 2, shear_power = 2;
  double opening =
      0;  ///< the elongation at which damage that grows linearly from the criterion on is complete; 0: brittle
  double side = 1;  ///< -1: the node is on the back of the segment
  [[nodiscard]] bool limited() const { return normal > 0 || shear > 0; }
};

/// The remaining strength of such a tie.
struct TieDamage {
  bool broken = false;
  double onset = 0;       ///< elongation, without compression, at which damage began; 0: not yet
  double elongation = 0;  ///< the largest so far
  /// The share of tension and shear that an elongation of the spring leaves. `force`: of the sound spring, on the node;
  /// `normal`: unit, from the segment to its front.
  [[nodiscard]] double share(const TieStrength& strength, const Vector& force, const Vector& normal, double stretched);
};

}  // namespace gapcheck::solver
