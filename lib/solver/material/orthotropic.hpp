#pragma once

namespace gapcheck::solver {

/// Orthotropic elastic law in plane stress, materials 002 and 034 in shells: moduli of the axes a, b, and of shears.
struct OrthotropicPlane {
  double ea = 0, eb = 0, poisson_ba = 0, gab = 0, gbc = 0, gca = 0;
  double thinning_a = 0, thinning_b = 0;  ///< −εcc of unit stresses along a and b
  /// CSE = 1: principal stresses below zero are taken out; PointState::back_stress has the stress without that.
  bool only_tension = false;
};

}  // namespace gapcheck::solver
