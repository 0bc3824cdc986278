#pragma once
#include <array>

#include "model/entity/part.hpp"
#include "solver/material/material.hpp"

namespace gapcheck::solver {

/// What all beams of one part share.
struct BeamProperties {
  Material material;  ///< trusses: elastic or plastic; others: elastic. Null has no forces
  model::BeamSection section;
  bool truss = false;  ///< axial force only
};

/// Ends of one beam: positions at the end of the step, velocities and angular velocities at its middle.
struct BeamEnds {
  std::array<Vector, 2> x, v, w;
};

/// The history of one beam.
struct BeamState {
  double length = 0;                                       ///< at the start
  Vector axis = Vector::Zero();                            ///< s, unit length, across the beam; at the end of the step
  double twist = 0;                                        ///< of end 2 relative to end 1
  std::array<double, 2> turn_s{}, turn_t{};                ///< of the ends about s and t, relative to their line
  double stress = 0, back_stress = 0, plastic_strain = 0;  ///< of trusses
  double plastic_work = 0;                                 ///< per volume, since the start; of trusses
};

/// Internal forces on the ends (the beam pulls its nodes with the opposite) and what the step needs to know.
struct BeamForces {
  std::array<Vector, 2> force{Vector::Zero(), Vector::Zero()}, moment{Vector::Zero(), Vector::Zero()};
  double axial = 0;        ///< tension
  double dissipated = 0;   ///< in this step: plastic work
  double manual_step = 0;  ///< length / √(E/ρ)
  double stable_step = 0;  ///< 2 / the element's highest frequency
  bool good = false;       ///< false: no length, or not a number
};

/// Truss: axial stress from the strain increments Δl / l of the middle of each step, on the initial area. Rate
/// dependence uses the axial rate.
[[nodiscard]] BeamForces truss_forces(const BeamProperties& properties, const BeamEnds& ends, double dt,
                                      BeamState& state);

/// Resultant beam of Belytschko and Schwer (Int. J. Numer. Meth. Engng 11, 1977): axes that turn with the line between
/// the ends and their mean spin about it; axial force from the length, torsion and bending from the rotations of the
/// ends relative to these axes, with transverse shear if the section has a shear area. Elastic. Rotations are taken in
/// the middle of the step, forces at its end.
[[nodiscard]] BeamForces resultant_beam_forces(const BeamProperties& properties, const BeamEnds& ends, double dt,
                                               BeamState& state);

/// The energy that a beam of the present `length` stores: of its axial stress (trusses), or of its elongation, twist
/// and rotations.
[[nodiscard]] double stored_energy(const BeamProperties& properties, const BeamState& state, double length);

/// Mass of a beam of this length.
[[nodiscard]] double beam_mass(const BeamProperties& properties, double length);
/// Rotational inertia of an end per mass there, the same about all axes: max(l²/12, (Iss + Itt)/A), raised above the
/// physical one so that bending does not control the time step of slender beams. Trusses have none.
[[nodiscard]] double beam_inertia(const BeamProperties& properties, double length);

}  // namespace gapcheck::solver
