#pragma once
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solver/element/hourglass.hpp"
#include "solver/element/solid_assumed_strain.hpp"
#include "solver/element/spotweld.hpp"
#include "solver/material/material.hpp"
#include "solver/quadrature/brick_map.hpp"
#include "solver/quadrature/nodal_average.hpp"
#include "solver/state/half_step.hpp"
#include "solver/state/section_stress.hpp"

namespace gapcheck::solver {

/// What all solids of one part share.
struct SolidProperties {
  Material material;
  Hourglass hourglass;
  double quadratic_viscosity = 1.5;  ///< Q1 of the bulk viscosity
  double linear_viscosity = 0.06;    ///< Q2
  SolidRules rules = {};
  WeldLimits weld = {};  ///< of material 100
  /// A solid that loses its volume fails, instead of ending the run (PSFAIL of *CONTROL_SOLID).
  bool inverted_fails = false;
};

/// Corners of one solid: positions at the end of the step, velocities at its middle. Tetrahedra use the first four.
struct SolidCorners {
  std::array<Vector, 8> x, v;
  /// Of tetrahedra with nodal pressures: the volume strains of the step at their corners. nullptr: their own counts.
  const std::array<double, 4>* volume_strains = nullptr;
};

/// Hourglass control by stiffness of one brick, set up where it is undeformed: the shapes are orthogonal to all linear
/// displacements there, so that the amplitudes Σ shape · x vanish in every uniformly deformed and turned state and the
/// energy ½ k Σ |amplitude|² depends on positions alone. A force with such an energy gives back what it takes.
struct HourglassReference {
  std::array<std::array<double, 8>, 4> shapes{};
  double stiffness = 0;
  double squared_frequency = 0;  ///< bound of the modes' highest frequency
  /// Of control by assumed strains: the energy of the amplitudes over 8, in the brick's axes (the polar rotation of
  /// brick_axes()). Then `stiffness` is zero.
  std::shared_ptr<const AssumedStrain> assumed = {};
};

/// The state of a solid's equation of state.
struct FluidState {
  double energy = 0;            ///< internal, per reference volume: E0 and all work since the start
  double volume = 1;            ///< relative to that
  double reference_volume = 0;  ///< of the undeformed solid
  double pressure = 0;          ///< without that of the bulk viscosity
  bool spalled = false;
};

/// The history of one solid besides its integration point.
struct SolidState {
  double mass = 0;  ///< of the element; its density follows from it
  /// Generalised stresses; of control by assumed strains the amplitudes over 8, in the brick's axes.
  std::array<Vector, 4> hourglass{Vector::Zero(), Vector::Zero(), Vector::Zero(), Vector::Zero()};
  std::shared_ptr<const HourglassReference> reference;  ///< of bricks whose hourglass control is a stiffness
  double viscous_pressure = 0;                          ///< of the bulk viscosity
  /// Of rubber: the inverse of the undeformed solid's axes (brick_axes() or tetrahedron_axes()).
  std::shared_ptr<const Matrix> undeformed;
  double strain_energy = 0;           ///< of rubber
  std::vector<FiniteHistory> finite;  ///< by point, of materials with a FiniteLaw
  /// Of rubber with eight points: the undeformed brick.
  std::shared_ptr<const BrickMap> undeformed_brick;
  WeldHistory weld;  ///< of spotwelds
  FluidState fluid;  ///< of materials with an equation of state
  /// K Σ volume strain at the corners of a tetrahedron with nodal pressures, above zero in tension.
  std::array<double, 4> mean_stress{};
  /// Replaces part of each point's stress after its update; nullptr: nothing does.
  const ImposedStress3* imposed = nullptr;
  /// Of materials whose stress follows from the deformation: the least of all steps so far.
  double least_manual_step = std::numeric_limits<double>::infinity();
  double least_stable_step = std::numeric_limits<double>::infinity();
};

/// Moduli of a solid at present.
struct SolidStiffness {
  double wave = 0;       ///< of a plane wave
  double bound = 0;      ///< of the strain energy: twice it per squared gradient, max(3 K, 2 G)
  double volume = 0;     ///< K, at most
  double viscosity = 0;  ///< the stress changes at most so much with the strain rate of the step
};
/// Bounds of a rubber, per volume: of the second derivative of its energy, and the viscosity of SolidStiffness.
struct RubberBounds {
  double stiffness = 0, viscosity = 0;
};
/// `rubber`: what update_rubber() returned.
[[nodiscard]] SolidStiffness solid_stiffness(const Material& material, const SolidState& state,
                                             const RubberBounds& rubber = {});

/// Internal forces on the corners (the solid pulls its nodes with the opposite) and what the step needs to know.
struct SolidForces {
  std::array<Vector, 8> force;
  double volume = 0;          ///< at the end of the step
  double hourglass_work = 0;  ///< in this step
  double viscous_work = 0;    ///< of the bulk viscosity in this step
  double dissipated = 0;      ///< in this step: plastic work, and work of viscous hourglass control and bulk viscosity
  double manual_step = 0;     ///< characteristic length / wave speed with bulk viscosity, as in the solver manual
  double stable_step = 0;     ///< 2 / an upper bound of the element's highest frequency, bulk viscosity included
  bool good = false;          ///< false: volume not above zero, or not a number
};

/// Brick with one integration point after Flanagan and Belytschko (Int. J. Numer. Meth. Engng 17, 1981), with their
/// orthogonal hourglass control. Gradients and volume are those of the centre, V = 8 det ∂x/∂ξ, or the mean ones and
/// the exact volume (Hourglass::exact_volume); only the latter pass the patch test with bricks that are no
/// parallelepipeds. Rubber always takes its centre. Wedges and pyramids are bricks with repeated corners. The velocity
/// strain is taken in the middle of the step (x − dt v / 2), the stress turns with the spin there (Hughes–Winget form
/// of the Jaumann rate), forces belong to the end: a rigid motion causes no strain. dt = 0: forces of the present
/// stresses.
[[nodiscard]] SolidForces brick_forces(const SolidProperties& properties, const SolidCorners& corners, double dt,
                                       SolidState& state, PointState& point);

/// The reference of a brick at its corners `x`. The stiffness is scaled so that coefficient 1 lets the modes vibrate at
/// the element's highest axial frequency, as in the shell. `mass`: of the element.
[[nodiscard]] HourglassReference hourglass_reference(const SolidProperties& properties, const std::array<Vector, 8>& x,
                                                     double mass);

/// Tetrahedron with linear displacements; forces on the first four corners only. With SolidCorners::volume_strains
/// their mean takes the place of its own volume strain (Bonet and Burton, Commun. Numer. Meth. Engng 14, 1998): its
/// mean stress is then the mean of the nodal ones. The work of such tetrahedra is Σ V p ε of their nodes.
[[nodiscard]] SolidForces tetrahedron_forces(const SolidProperties& properties, const SolidCorners& corners, double dt,
                                             SolidState& state, PointState& point);

/// Volume of a tetrahedron in the middle of the step and what its own velocity gradient adds to it; zeros without
/// volume.
[[nodiscard]] NodalAverage::Share tetrahedron_share(const SolidCorners& corners, double dt);

/// Brick with 2 x 2 x 2 Gauss points and a mean dilatation (Hughes, Int. J. Numer. Meth. Engng 15, 1980): each point
/// has its own velocity gradient, but the volume rate of the brick; each stress turns with its own spin. Wedges and
/// pyramids are bricks with repeated corners. Rubber takes F at each point, its volume ratio replaced by that of the
/// brick. No hourglass control. The printed step is L / c without viscosity. `points`: the histories; one that has
/// failed is enough to say so of all.
[[nodiscard]] SolidForces eight_point_forces(const SolidProperties& properties, SolidRule rule,
                                             const SolidCorners& corners, double dt, SolidState& state,
                                             std::span<PointState, 8> points);

/// The energy that the stresses of eight points store in a brick with corners `x`.
[[nodiscard]] double eight_point_energy(const SolidProperties& properties, const SolidState& state,
                                        const std::array<Vector, 8>& x, std::span<const PointState, 8> points);

/// The largest area of a brick's sides.
[[nodiscard]] double largest_face_area(const std::array<Vector, 8>& x);

/// Volume of a brick with straight edges.
[[nodiscard]] double brick_volume(const std::array<Vector, 8>& x);
/// 8 det ∂x/∂ξ at the centre of a brick; LS-DYNA takes the mass of one-point bricks from it (read off a run).
[[nodiscard]] double one_point_volume(const std::array<Vector, 8>& x);
/// The columns are ∂x/∂ξ, ∂x/∂η and ∂x/∂ζ at the brick's centre.
[[nodiscard]] Matrix brick_axes(const std::array<Vector, 8>& x);
/// The columns are the edges from the first corner of a tetrahedron.
[[nodiscard]] Matrix tetrahedron_axes(const std::array<Vector, 8>& x);
/// The volume that a brick's forces belong to.
[[nodiscard]] double brick_volume(const SolidProperties& properties, const std::array<Vector, 8>& x);
/// Volume of the tetrahedron of the first four corners; positive when corner 4 lies on the side that the others'
/// right-hand normal points to.
[[nodiscard]] double tetrahedron_volume(const std::array<Vector, 8>& x);

/// The energy that a solid of this volume stores: ½ σ : C⁻¹ : σ or that of rubber, and that of its hourglass stiffness.
[[nodiscard]] double stored_energy(const SolidProperties& properties, const SolidState& state, double volume,
                                   const PointState& point);

/// Stress at the end of the step for a velocity gradient in its middle, with the spin's rotation.
Matrix update_solid_stress(const Material& material, const Matrix& gradient, double dt, PointState& point);

/// Pressure of the bulk viscosity against compression (von Neumann and Richtmyer, with a linear term):
/// q = ρ l (Q1 l ε̇² − Q2 c ε̇) for a volume rate ε̇ < 0, otherwise 0; and the damping that it adds to the time step. The
/// solver counts that in compression alone, but a step that switches with the sign of ε̇ feeds the vibration of a lone
/// element, so here it counts always.
struct BulkViscosity {
  double pressure = 0;
  double step_speed = 0;  ///< Q = Q2 c + Q1 l |ε̇|, in expansion too
  double damping = 0;     ///< DAMP ρ c l of foams: their viscosity against all strain rates
};
[[nodiscard]] BulkViscosity bulk_viscosity(const SolidProperties& properties, double density, double speed,
                                           double length, double volume_rate);

/// Sets the pressure of the bulk viscosity to the end of the step; returns its work over a change of volume.
[[nodiscard]] double viscous_work(double pressure, double volume_change, SolidState& state);

/// Stress and energy of rubber whose axes are now `axes`; `volume`: now, `gradient`: of the velocity in the middle of
/// the step of dt. What a FiniteLaw dissipates counts as plastic work.
RubberBounds update_rubber(const Material& material, const Matrix& axes, double volume, const Matrix& gradient,
                           double dt, SolidState& state, PointState& point);

/// Of a point with an equation of state: what its deviator stores and has dissipated, per volume; otherwise 0.
[[nodiscard]] double deviatoric_energy(const Material& material, const PointState& point);

/// What all work since the start has put into a solid with an equation of state: reference volume (E − E0).
[[nodiscard]] double fluid_energy(const Material& material, const SolidState& state);

/// Pressure and energy of an equation of state at the end of a step to `volume`; sets the points' mean stress and lets
/// them spall. The energy follows dE = −p dV and `work`, that of deviators and bulk viscosity in the step, by the
/// trapezoidal rule, which is linear in the new pressure (theory manual, equations of state). Nothing for others.
void update_pressure(const Material& material, double volume, double work, SolidState& state,
                     std::span<PointState> points);

/// Sets both time steps; `squared_gradient`: the largest eigenvalue of Σ b bᵀ, `corners`: 4 or 8.
void set_time_steps(double density, double length, double squared_gradient, double corners,
                    const BulkViscosity& viscosity, const SolidStiffness& stiffness, SolidForces& forces);

}  // namespace gapcheck::solver
