#pragma once
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "model/entity/part.hpp"
#include "solver/discrete/discrete_beam.hpp"
#include "solver/element/beam_section.hpp"
#include "solver/element/spotweld.hpp"
#include "solver/material/beam_stress.hpp"

namespace gapcheck::solver {

/// What all beams of one part share.
struct BeamProperties {
  Material material;  ///< resultant beams: elastic; others: elastic or plastic. Null has no forces
  model::BeamSection section;
  bool truss = false;              ///< axial force only
  std::vector<Fiber> fibers = {};  ///< of integrated beams; `section` is then that of these points
  double shear_factor = 1;         ///< SHRF of integrated beams
  bool torsion_free = false;       ///< ITOFF = 1
  WeldLimits weld = {};
  std::shared_ptr<const DiscreteBeam> discrete = {};  ///< ELFORM 6; then of the rest the density counts only
  [[nodiscard]] bool integrated() const { return !fibers.empty(); }
};

/// Pin releases of a resultant beam: what its ends do not carry.
struct BeamReleases {
  std::array<bool, 2> turn_s{}, turn_t{};  ///< by end: moments about s and t
  bool twist = false, axial = false;       ///< at either end
  bool operator==(const BeamReleases&) const = default;
};

/// The history of one beam.
struct BeamState {
  double length = 0;                                       ///< at the start
  Vector axis = Vector::Zero();                            ///< s, unit length, across the beam; at the end of the step
  double twist = 0;                                        ///< of end 2 relative to end 1
  std::array<double, 2> turn_s{}, turn_t{};                ///< of the ends about s and t, relative to their line
  double stress = 0, back_stress = 0, plastic_strain = 0;  ///< of trusses
  double plastic_work = 0;                                 ///< per volume, since the start; of trusses
  WeldHistory weld;                                        ///< of spotwelds
  BeamReleases released;                                   ///< of resultant beams
};

/// The motion of a beam's ends relative to its axes in one step.
struct BeamTurn {
  double twist = 0;                          ///< of end 2 relative to end 1
  std::array<double, 2> turn_s{}, turn_t{};  ///< of the ends about s and t, relative to their line
};

/// Turns the axis s with the line between the ends (`along`: its direction at the end of the step, `way`: from end 1 to
/// end 2) and about it with the mean spin of the ends. The motion is that in the middle of the step.
[[nodiscard]] BeamTurn turn_axes(const BeamEnds& ends, const Vector& way, const Vector& along, double dt, Vector& axis);

/// The stress that a preload gives to all points, and whether bending adds to it.
struct ImposedStress {
  double axial = 0;
  bool bending = false;
};

/// Internal forces on the ends (the beam pulls its nodes with the opposite) and what the step needs to know.
struct BeamForces {
  std::array<Vector, 2> force{Vector::Zero(), Vector::Zero()}, moment{Vector::Zero(), Vector::Zero()};
  double axial = 0;             ///< tension
  WeldResultants resultants{};  ///< of integrated beams
  double dissipated = 0;        ///< in this step: plastic work
  bool failed = false;          ///< of discrete beams
  double manual_step = 0;       ///< length / √(E/ρ)
  double stable_step = 0;       ///< 2 / the element's highest frequency
  bool good = false;            ///< false: no length, or not a number
};

/// Truss: axial stress from the strain increments Δl / l of the middle of each step, on the initial area. Rate
/// dependence uses the axial rate.
[[nodiscard]] BeamForces truss_forces(const BeamProperties& properties, const BeamEnds& ends, double dt,
                                      BeamState& state);

/// Resultant beam of Belytschko and Schwer (Int. J. Numer. Meth. Engng 11, 1977): axes that turn with the line between
/// the ends and their mean spin about it; axial force from the length, torsion and bending from the rotations of the
/// ends relative to these axes, with transverse shear if the section has a shear area. Elastic. Rotations are taken in
/// the middle of the step, forces at its end. An end without a moment about s or t turns there as a hinge; released
/// torsion and tension are zero.
[[nodiscard]] BeamForces resultant_beam_forces(const BeamProperties& properties, const BeamEnds& ends, double dt,
                                               BeamState& state);

/// Integrated beam after Hughes and Liu (Comput. Methods Appl. Mech. Engng 28, 1981; one point along the axis as in
/// Belytschko, Liu, Moran): the axes of the resultant beam, and at each point of the cross-section
/// ε = ε₀ + κs t − κt s, γrs = √k γs − κr t, γrt = √k γt + κr s with the stretching, curvatures and twist of the step
/// over its mean length; γs, γt: minus the mean rotation about t and that about s; k: SHRF. Forces are those that do
/// the work of the stresses. `imposed` replaces the axial stress; the point then does not yield.
[[nodiscard]] BeamForces integrated_beam_forces(const BeamProperties& properties, const BeamEnds& ends, double dt,
                                                const ImposedStress* imposed, BeamState& state,
                                                std::span<BeamPoint> points);

/// The elastic energy of an integrated beam's points.
[[nodiscard]] double stored_energy(const BeamProperties& properties, std::span<const BeamPoint> points, double length);

/// The energy that a beam of the present `length` stores: of its axial stress (trusses), or of its elongation, twist
/// and rotations.
[[nodiscard]] double stored_energy(const BeamProperties& properties, const BeamState& state, double length);

/// Mass of a beam of this length.
[[nodiscard]] double beam_mass(const BeamProperties& properties, double length);
/// Rotational inertia of an end per mass there, the same about all axes: max(l²/12, (Iss + Itt)/A), raised above the
/// physical one so that bending does not control the time step of slender beams. Of integrated beams at least
/// l²/4 g/(1 − g), g = SHRF G/E: then shear does not control it either. Trusses have none.
[[nodiscard]] double beam_inertia(const BeamProperties& properties, double length);

}  // namespace gapcheck::solver
