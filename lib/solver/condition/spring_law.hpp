#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "solver/discrete/force_curve.hpp"
#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// What a spring remembers besides its elongation.
struct SpringHistory {
  Vector elongation = Vector::Zero();  ///< at the last update
  Vector inner = Vector::Zero();       ///< plastic elongation; or the force of the Maxwell element; or where the
                                       ///< unloading line of S08 has no force, in [0]
  double reached = 0;                  ///< sum of plastic elongation; of S08 the farthest elongation on its curve
  double force = 0;                    ///< of S08, without its sign
  double work = 0;                     ///< of S07: ∫ F du
};

/// The force of a spring or damper as a function of its elongation u, its rate, and of its history (Keyword User's
/// Manual, Vol. II, *MAT_S01 … *MAT_S08). For torsion: angle and moment.
struct SpringLaw {
  enum class Kind : std::uint8_t {
    elastic,        ///< S01, S02, S04, S05: no history
    elastoplastic,  ///< S03
    maxwell,        ///< S07
    inelastic,      ///< S08
  } kind = Kind::elastic;
  double stiffness = 0;  ///< force = stiffness u; K of S03, KI of S07, KU of S08
  double damping = 0;    ///< + damping du/dt
  /// + a curve over u, linear between points, continued with the end slopes; points ascending in u.
  std::vector<std::array<double, 2>> curve;
  ForceCurve rates;      ///< + a curve over du/dt
  ForceCurve loading;    ///< S08: over what is stretched (or pressed)
  double yield = 0;      ///< S03: FY
  double hardening = 0;  ///< S03: growth of the yield force with the plastic elongation, K KT / (K - KT)
  double transient = 0;  ///< S07: K0 - KI
  double decay = 0;      ///< S07: BETA
  double cutoff = std::numeric_limits<double>::infinity();  ///< S07: TC
  double cutoff_force = 0;                                  ///< S07: FC
  double sense = 1;                                         ///< S08: 1 tension, -1 compression

  [[nodiscard]] double force(double elongation) const;
  /// ∫ F du from zero, without damping.
  [[nodiscard]] double energy(double elongation) const;
  /// The largest |dF/du|.
  [[nodiscard]] double largest_stiffness() const;
  /// The largest |dF/d(du/dt)|.
  [[nodiscard]] double largest_damping() const;

  [[nodiscard]] bool has_history() const { return kind != Kind::elastic; }
  /// The force of a law with history at a new elongation, after a step `dt` in which it grew evenly. Along a line
  /// only the first component of elongation and force counts. `time`: below it the spring relaxes as it is.
  [[nodiscard]] Vector update(const Vector& elongation, double dt, double time, SpringHistory& history) const;
  /// What a law with history has stored and dissipated.
  [[nodiscard]] double held(const SpringHistory& history) const;

 private:
  [[nodiscard]] Vector flow(const Vector& elongation, SpringHistory& history) const;
  [[nodiscard]] Vector relax(const Vector& elongation, double dt, bool cut, SpringHistory& history) const;
  [[nodiscard]] Vector load(double elongation, SpringHistory& history) const;
};

}  // namespace gapcheck::solver
