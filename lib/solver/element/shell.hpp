#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/element/full/shell_axes.hpp"
#include "solver/element/hourglass.hpp"
#include "solver/element/warped_frequency.hpp"
#include "solver/material/material.hpp"
#include "solver/quadrature/gauss.hpp"
#include "solver/state/half_step.hpp"

namespace gapcheck::solver {

/// One point in the plane with hourglass control (ELFORM 2), or four (16).
enum class ShellForm : std::uint8_t { one_point, full };

/// Of one-point quads: BWC and PROJ of *CONTROL_SHELL. What is taken out of the motion of a quad whose warp counts.
enum class ShellProjection : std::uint8_t {
  none,   ///< the quad counts as flat (Belytschko and Tsay)
  drill,  ///< rotations about the normals at the corners
  full,   ///< these, and the rigid rotation
};

/// Bulk viscosity of shells; off where both are zero.
struct ShellViscosity {
  double quadratic = 0, linear = 0;  ///< Q1, Q2
  bool in_energy = false;            ///< its work is in the internal energy that is printed (TYPE = −2)
  [[nodiscard]] bool on() const { return quadratic > 0 || linear > 0; }
};

/// Rotational inertia of a corner per mass: max(h²/12, A/8), raised above the physical one so that bending does not
/// control the time step (Hughes, Cohen and Haroun 1978). `shift`: of the mid-surface from the corners.
[[nodiscard]] inline double rotational_inertia(double area, double thickness, double shift = 0) {
  return std::max(thickness * thickness / 12 + shift * shift, area / 8);
}

/// What becomes of a quad that is distorted until a corner is folded in (NFAIL1 and NFAIL4 of *CONTROL_SHELL).
enum class FoldedShell : std::uint8_t {
  allowed,  ///< nothing, as long as its integration points are good
  fails,
  ends_run,
};

/// What all shells of one part share.
struct ShellProperties {
  Material material;                               ///< of composites: mean density and plate modulus
  std::vector<GaussPoint> layers = gauss_rule(2);  ///< integration points from the lower to the upper side
  double shear_factor = 1;                         ///< SHRF
  bool thins = false;                              ///< ISTUPD = 1: the thickness follows the strain
  bool thins_by_flow = false;                      ///< ISTUPD = 4: it follows the plastic part of the strain
  Hourglass hourglass;                             ///< of shells with one point
  ShellForm form = ShellForm::one_point;
  ShellProjection projection = ShellProjection::none;
  std::vector<Material> layer_materials;  ///< of composites, parallel to `layers`; otherwise empty
  double stiffest = 1;                    ///< of composites: the largest plate modulus of a layer over the mean one
  /// NLOC: where the nodes lie, in half thicknesses from the mid-surface along the normal.
  double reference = 0;
  ShellViscosity viscosity;
  bool sides_shear = false;  ///< ELFORM 10: the transverse shear comes from the sides; with a projection only
  bool membrane = false;     ///< ELFORM 5 and 9: neither bending nor transverse shear
  bool sorts = true;         ///< triangles are C0 triangles; false: quads with two equal corners (full ones only)
  FoldedShell folded = FoldedShell::allowed;
  ShellAxes axes = ShellAxes::side;  ///< of quads
  /// Triangles bend as those of Batoz (ELFORM 17, ESORT = 2), otherwise as C0 triangles.
  bool discrete_kirchhoff = false;

  [[nodiscard]] double inertia(double area, double thickness) const {
    return reference == 0 ? rotational_inertia(area, thickness)
                          : rotational_inertia(area, thickness, reference * thickness / 2);
  }
};

/// A corner of a quad has 180 degrees or more, so that its area map has a Jacobian that is not above zero there; that
/// is where the Jacobian, linear in the plane, is least. Triangles never are.
[[nodiscard]] bool is_folded(const std::array<Vector, 4>& x);

/// Corners of one shell: positions at the end of the step, velocities and angular velocities at its middle.
struct ShellCorners {
  std::array<Vector, 4> x, v, w;
};

/// A number for each hourglass mode of a quad: membrane x, y, deflection, rotation x, y.
using HourglassModes = std::array<double, 5>;

/// The history of one shell besides its integration points.
struct ShellState {
  double thickness = 0;
  double axis = 0;              ///< of orthotropic materials: PointState::axis
  HourglassModes hourglass{};   ///< generalised stresses
  HourglassModes stiffness{};   ///< of quads whose hourglass control is a stiffness; zero: there is none
  double viscous_pressure = 0;  ///< of the bulk viscosity
  WarpedFrequency warped;       ///< of quads with four points
};

/// Internal forces on the corners (the shell pulls its nodes with the opposite) and what the step needs to know.
struct ShellForces {
  std::array<Vector, 4> force, moment;
  double hourglass_work = 0;  ///< in this step
  double dissipated = 0;      ///< in this step: plastic work, and work of viscous hourglass control
  double viscous_work = 0;    ///< of the bulk viscosity in this step, where it is not in the printed internal energy
  double damping_speed = 0;   ///< of the bulk viscosity: what it adds to the stress over density and rate of the area
  double manual_step = 0;     ///< characteristic length / wave speed, as in the solver manual
  double stable_step = 0;     ///< 2 / an upper bound of the element's highest frequency
  bool good = false;          ///< false: no area, or not a number
  /// Of a shell that has failed: it limits no step.
  [[nodiscard]] static ShellForces none();
};

/// Quadrilateral of Belytschko, Lin and Tsay (Comput. Methods Appl. Mech. Engng 42, 1984): one point in the plane,
/// velocity strain in axes that turn with the element, hourglass control. Strains are taken in the middle of the step
/// (x − dt v / 2), forces at its end, so a rigid motion causes no strain. dt = 0: forces of the present stresses.
[[nodiscard]] ShellForces quad_forces(const ShellProperties& properties, const ShellCorners& corners, double dt,
                                      ShellState& state, std::span<PointState> points);

/// The same quad with warping stiffness (Belytschko, Wong and Chiang 1992): properties.projection says which.
[[nodiscard]] ShellForces warped_quad_forces(const ShellProperties& properties, const ShellCorners& corners, double dt,
                                             ShellState& state, std::span<PointState> points);

/// Stiffness of the modes of a quad with undeformed corners `x` (Belytschko, Lin and Tsay, eq. 24). It stays constant,
/// so that the stresses Q have the energy Σ Q² / (2 stiffness): a stiffness that follows the shape has none, and gives
/// back more or less than it takes.
[[nodiscard]] HourglassModes hourglass_stiffness(const ShellProperties& properties, const std::array<Vector, 4>& x,
                                                 double thickness);

/// Triangle with constant membrane strain, constant curvature and a transverse shear made from the mean rotations
/// along its sides (after Kennedy, Belytschko and Lin 1986). Corner 3 repeats corner 2 and gets no force.
[[nodiscard]] ShellForces triangle_forces(const ShellProperties& properties, const ShellCorners& corners, double dt,
                                          ShellState& state, std::span<PointState> points);

/// Triangle with constant membrane strain that bends as the discrete Kirchhoff triangle (Batoz, Bathe and Ho, Int. J.
/// Numer. Meth. Engng 15, 1980): no transverse shear, three points in the plane. `points`: the layers of the first,
/// then those of the next. Corner 3 as in triangle_forces().
[[nodiscard]] ShellForces kirchhoff_forces(const ShellProperties& properties, const ShellCorners& corners, double dt,
                                           ShellState& state, std::span<PointState> points);

/// What such a triangle of this area stores.
[[nodiscard]] double kirchhoff_stored_energy(const ShellProperties& properties, const ShellState& state, double area,
                                             std::span<const PointState> points);

/// Quadrilateral with 2 x 2 points in the plane (ELFORM 16): transverse shear from the middles of the sides (Bathe and
/// Dvorkin, Int. J. Numer. Meth. Engng 21, 1985), membrane strain of five parameters (Pian and Sumihara, ibid. 20,
/// 1984; Engelmann, Whirley and Goudreau 1989), slopes of the warped mid-surface in the membrane strain, so that no
/// rigid motion strains it. `points`: the layers of the first point in the plane, then those of the next, in the order
/// of the corners. Axes and times as in quad_forces; corners 3 and 4 may be the same.
[[nodiscard]] ShellForces full_forces(const ShellProperties& properties, const ShellCorners& corners, double dt,
                                      ShellState& state, std::span<PointState> points);

/// What such a shell stores with its corners at `x`.
[[nodiscard]] double full_stored_energy(const ShellProperties& properties, const ShellState& state,
                                        const std::array<Vector, 4>& x, std::span<const PointState> points);

/// Strain increments of the mid-surface, of the curvature and of the transverse shear (tensor components).
struct ShellStrain {
  double xx = 0, yy = 0, xy = 0;
  double bend_xx = 0, bend_yy = 0, bend_xy = 0;
  double yz = 0, zx = 0;
};

/// Forces and moments per length.
struct ShellResultants {
  double xx = 0, yy = 0, xy = 0;
  double bend_xx = 0, bend_yy = 0, bend_xy = 0;
  double yz = 0, zx = 0;
  double plastic_work = 0;  ///< of the step, per area
};

/// The energy that a shell of this area stores: ½ σ : C⁻¹ : σ of its layers, and that of its hourglass stiffness.
[[nodiscard]] double stored_energy(const ShellProperties& properties, const ShellState& state, double area,
                                   std::span<const PointState> points);

/// Updates the layers' stresses and integrates them through the thickness, which follows if the section says so.
[[nodiscard]] ShellResultants integrate_layers(const ShellProperties& properties, const ShellStrain& strain, double dt,
                                               double& thickness, std::span<PointState> points);

/// A shell fails: all its layers have, or as many as NUMFIP of its erosion says, or its time is over.
[[nodiscard]] bool fails(const ShellProperties& properties, std::span<const PointState> points, double time);

/// Adds the bulk viscosity's pressure q = ρ l (Q1 l ε̇² − Q2 c ε̇) to the membrane forces of a shell whose area shrinks
/// at the rate −ε̇, l = √A, c² = E / ρ (1 − ν²) (TYPE = −1 and −2 of *CONTROL_BULK_VISCOSITY). `strain`: ε̇ dt. For
/// set_time_steps() it counts in expansion too (see BulkViscosity of solids).
void add_bulk_viscosity(const ShellProperties& properties, double area, double strain, double dt, ShellState& state,
                        ShellResultants& resultants, ShellForces& out);

/// Gram matrix of an element's gradient operator in the plane, Σ b bᵀ, and its larger eigenvalue.
struct Gram {
  double xx = 0, xy = 0, yy = 0;
  void add(double x, double y) {
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  [[nodiscard]] double largest() const {
    const double half = (xx - yy) / 2;
    return (xx + yy) / 2 + std::sqrt(half * half + xy * xy);
  }
};

/// By how much in-plane and transverse motion are coupled in a warped quad; zero in a flat one.
struct WarpShape {
  double slope = 0;      ///< of the mid-surface: deflections strain the membrane
  double tilt = 0;       ///< of the normals at the corners: motion in the plane is a transverse shear
  double curvature = 0;  ///< change of the normal over the length: motion in the plane bends
};

/// What the time step of a shell depends on.
struct ShellShape {
  double corners = 4, area = 0, thickness = 0;
  double squared_length = 0;  ///< characteristic
  // Larger eigenvalues of the Gram matrices.
  double gradient = 0;  ///< of the membrane
  double shear = 0;     ///< of the transverse shear, rotations divided by the root of their inertia per mass
  WarpShape warp = {};
};

/// Squared highest frequency: an upper bound, and the largest of the parts (in the plane, bending, transverse shear) of
/// which it is made.
struct ShellFrequency {
  double bound = 0, largest = 0;
};
[[nodiscard]] ShellFrequency squared_frequency(const ShellProperties& properties, const ShellShape& shape);

/// Sets both time steps; the stable one from that bound, or from another upper bound of the squared highest frequency.
void set_time_steps(const ShellProperties& properties, const ShellShape& shape, ShellForces& forces);
void set_time_steps(const ShellProperties& properties, const ShellShape& shape, double squared_frequency,
                    ShellForces& forces);

}  // namespace gapcheck::solver
