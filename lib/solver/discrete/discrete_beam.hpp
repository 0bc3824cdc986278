#pragma once
#include <array>
#include <limits>
#include <optional>

#include "solver/discrete/beam_ends.hpp"
#include "solver/discrete/force_curve.hpp"
#include "solver/material/hardening.hpp"
#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// One of the six degrees of freedom of a discrete beam: a force over the way of end 2 relative to end 1, or a moment
/// over the angle.
struct DiscreteLaw {
  double stiffness = 0, damping = 0;
  double preload = 0;       ///< a constant force
  ForceCurve force = {};    ///< 067: over the way
  ForceCurve viscous = {};  ///< 067: over the rate
  YieldCurve yield = {};    ///< 068: limit of the elastic force over the plastic way
  [[nodiscard]] double largest_stiffness() const { return stiffness + force.steepest(); }
  [[nodiscard]] double largest_damping() const { return damping + viscous.steepest(); }
  [[nodiscard]] bool acts() const { return largest_stiffness() > 0 || largest_damping() > 0 || preload != 0; }
};

/// Material 071: a force along the line between the nodes that is never below zero,
/// F = max(F₀ + k (L − L₀), 0), k = E A / L₀ with the unstressed length L₀, or A σ((L − L₀) / L₀) by a curve.
struct Cable {
  double stiffness = 0;  ///< of the whole cable; 0: young · area / L₀
  double young = 0, area = 0;
  ForceCurve stress = {};  ///< replaces them
  double offset = 0;       ///< length at the start less that without stress
  double force = 0;        ///< F₀
  /// The force ramps up between these times and is then held until `end`, whatever the length does. No `end`: it acts
  /// from the start and is not held.
  double start = 0, ramp = 0, end = 0;
  double failure_strain = 0, failure_force = 0;  ///< 0: none
};

/// What all discrete beams of one part share.
struct DiscreteBeam {
  std::array<DiscreteLaw, 6> laws;  ///< along r, s, t and about them
  std::optional<Cable> cable;       ///< then the laws do not count
  double mass = 0, inertia = 0;  ///< of the whole beam; half at each end. Cables without mass: density · area · length
  double density = 0;
  double scoor = 0;             ///< below zero end 1 turns the axes, above zero end 2, otherwise the mean of both
  std::array<bool, 3> fixed{};  ///< the axes do not turn about these
  std::array<double, 6> failure_force{}, failure_way{};  ///< 0: none
  /// Forces across get the couple that balances them.
  [[nodiscard]] bool couples() const { return scoor >= 2 || scoor <= -2; }
  /// r follows the line between the ends.
  [[nodiscard]] bool follows_line() const { return scoor == 2 || scoor == -2; }
  [[nodiscard]] bool can_fail() const;
  [[nodiscard]] bool rotates() const { return laws[3].acts() || laws[4].acts() || laws[5].acts(); }
};

/// The history of one discrete beam.
struct DiscreteState {
  Matrix axes = Matrix::Identity();                                 ///< columns r, s, t at the end of the step
  double mass = 0, inertia = 0;                                     ///< of this beam; set at the start
  std::array<double, 6> way{}, plastic_way{}, elastic{}, damped{};  ///< elastic: the force of 068
  // Of cables:
  double unstressed = 0;           ///< length
  double base = 0, reference = 0;  ///< F = base + k (L − reference)
  double stored_at_start = 0;
};

/// Forces on the ends (the beam pulls its nodes with the opposite) and what the step needs to know.
struct DiscreteForces {
  std::array<Vector, 2> force{Vector::Zero(), Vector::Zero()}, moment{Vector::Zero(), Vector::Zero()};
  double axial = 0;                                       ///< along r
  double dissipated = 0;                                  ///< by plastic flow and dampers in the step
  double supplied = 0;                                    ///< by what holds the force of a cable, in the step
  double step = std::numeric_limits<double>::infinity();  ///< 2 / the highest frequency of the beam with its own masses
  bool failed = false, good = false;
};

/// Axes at the start: `axes` of a local system, or from the line between the ends and a third point (from the first
/// end) across it, or global ones where there is no line or no third point.
[[nodiscard]] Matrix discrete_axes(const DiscreteBeam& beam, const Matrix* axes, const Vector& way,
                                   const Vector& third);

/// Sets mass and inertia of a beam whose ends are `way` apart. Without an own inertia, one with which neither rotations
/// nor couples have a shorter step than translations.
void begin_discrete(const DiscreteBeam& beam, const Vector& way, DiscreteState& state);

/// Discrete beam (keyword manual, *SECTION_BEAM, ELFORM 6, SCOOR): six independent laws in axes that turn with the
/// ends. Ways are sums of rates in the middle of each step. With couples() the rate along the axes is v₂ − v₁ − ½ (ω₁ +
/// ω₂) × (x₂ − x₁), so that a rigid rotation causes none, and each end gets half of the couple that balances the forces
/// across; otherwise it is v₂ − v₁ and there is no couple: a short beam is assumed.
[[nodiscard]] DiscreteForces discrete_forces(const DiscreteBeam& beam, const BeamEnds& ends, double dt,
                                             DiscreteState& state);

/// Material 071, at `time`.
[[nodiscard]] DiscreteForces cable_forces(const Cable& cable, const BeamEnds& ends, double time, double dt,
                                          DiscreteState& state);

/// What its springs store more than at the start; `length`: at present.
[[nodiscard]] double stored_energy(const DiscreteBeam& beam, const DiscreteState& state, double length);

}  // namespace gapcheck::solver
