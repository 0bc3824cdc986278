#pragma once
#include <cstdint>
#include <limits>

#include "base/vector.hpp"
#include "model/entity/curve.hpp"

namespace gapcheck::solver {

/// How a tie yields, once its force is large enough. Source: LS-DYNA Keyword User's Manual, Vol. I, *CONTACT, card 4 of
/// TIEBREAK types.
enum class TieLaw : std::uint8_t {
  brittle,   ///< it fails at once
  linear,    ///< OPTION 6, 8: the force falls linearly with the largest elongation
  plastic,   ///< OPTION 5: it yields, at a stress that falls with the opening
  cohesive,  ///< OPTION 7, 9, 10, 11: the force falls linearly with the largest elongation, by energies of two modes
};

/// When a tie fails. Strengths are forces, energies works: stresses and energies per area count with `area`. The
/// criterion is (tension / normal)^normal_power + (across / shear)^shear_power >= 1, of the force on the node;
/// compression never counts.
struct TieStrength {
  TieLaw law = TieLaw::brittle;
  double normal = 0, shear = 0;  ///< 0: no such limit
  double normal_power = 2, shear_power = 2;
  double area = 1;     ///< of the node
  double side = 1;     ///< -1: the node is on the back of the segment
  double opening = 0;  ///< linear: the elongation at which damage is complete
  double normal_energy = 0, shear_energy = 0,
         exponent = 1;         ///< cohesive; exponent below zero: by Benzeggagh and Kenane
  double stiffness_ratio = 1;  ///< cohesive: of shear to tension
  double friction = 0;         ///< cohesive: how much of `shear` a pressure of 1 adds
  /// plastic: share of the strength over the opening; brittle: stress over the opening after the failure. nullptr:
  /// none.
  const model::Curve* curve = nullptr;
  [[nodiscard]] bool limited() const { return normal > 0 || shear > 0; }
  /// At least 1: the tie fails, or begins to.
  [[nodiscard]] double criterion(const Vector& force, const Vector& normal_of_segment) const;
};

/// What a tie carries.
struct TieResponse {
  Vector force = Vector::Zero();  ///< on the node
  double share = 1;               ///< of tension and shear that is left
  Vector flow = Vector::Zero();   ///< elongation that has become permanent
};

/// What has happened to such a tie.
struct TieDamage {
  bool broken = false;
  double onset = 0;       ///< linear: elongation, without compression, at which damage began; 0: not yet
  double elongation = 0;  ///< linear: the largest so far
  double lost = 0;        ///< cohesive: share of the stiffness
  double flowed = 0;      ///< plastic: permanent part of the opening
  double widest = 0;      ///< plastic, or after the failure: the largest opening
  /// The force of a spring with that stiffness and elongation. `normal`: unit, from the segment to its front; zero: the
  /// segment has no area.
  [[nodiscard]] TieResponse respond(const TieStrength& strength, double stiffness, const Vector& stretch,
                                    const Vector& normal);
  /// Nothing is left to tie to.
  void end() {
    broken = true;
    widest = std::numeric_limits<double>::infinity();
  }
  /// It is broken, but still resists opening: TBLCID.
  [[nodiscard]] bool bridges(const TieStrength& strength) const;

 private:
  [[nodiscard]] double share_left(const TieStrength& strength, const Vector& force, const Vector& normal,
                                  double stretched);
  [[nodiscard]] TieResponse bridge(const TieStrength& strength, double opening, const Vector& normal);
  [[nodiscard]] TieResponse yield(const TieStrength& strength, double stiffness, double opening, const Vector& slip,
                                  const Vector& normal);
  [[nodiscard]] TieResponse crack(const TieStrength& strength, double stiffness, double opening, const Vector& slip,
                                  const Vector& normal);
};

}  // namespace gapcheck::solver
