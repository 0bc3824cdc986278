#pragma once
#include <memory>

#include "solver/material/principal_law.hpp"
#include "solver/material/strain_rates.hpp"

namespace gapcheck::solver {

/// Materials whose stress follows from the deformation gradient F since the start, besides 027: foams and rubbers.
struct FiniteLaw {
  std::shared_ptr<const PrincipalLaw> elastic;
  double wave = 0;           ///< modulus of the sound speed
  bool compressible = true;  ///< solids with eight points take F at each point, not with the volume of the whole brick
  bool bulk_viscosity = true;
  /// Hysteresis: after its energy has been W_max the law is weakened by d = (1 − HU) (1 − (W / W_max)^SHAPE).
  double unloading = 1, shape = 1;
  double healing = 0;  ///< BETA: rate at which W_max falls back to W
  // One Maxwell branch, ED and BETA1, without coupling of directions.
  double branch_modulus = 0, branch_decay = 0;
  /// The laws of a table; its first one is `elastic`. What the others add counts as dissipated.
  std::shared_ptr<const RateLaws> rates = {};

  [[nodiscard]] bool weakens() const { return unloading < 1; }
};

struct FiniteHistory {
  double most_energy = 0;  ///< W_max
  bool torn = false;
  double lost = 0;     ///< dissipated since the start, per undeformed volume
  Symmetric branch{};  ///< stress of the Maxwell branch
  RateAverage rate;    ///< of laws over the strain rate
  Symmetric excess{};  ///< Kirchhoff stress that the rate adds
};

/// The present of a point after a step of `dt`.
struct FinitePoint {
  Symmetric stress{};    ///< Cauchy
  double energy = 0;     ///< that comes back when it unloads, per undeformed volume
  double bound = 0;      ///< of the second derivative, as principal_stiffness_bound()
  double viscosity = 0;  ///< at most so much does the stress, times J, change with the strain rate of the step
};

/// `gradient`: of the velocity in the middle of the step; it moves the Maxwell branch alone.
[[nodiscard]] FinitePoint update_finite(const FiniteLaw& law, const Matrix& f, const Matrix& gradient, double dt,
                                        FiniteHistory& history);

}  // namespace gapcheck::solver
