#pragma once
#include <array>
#include <span>

#include "solver/element/shell.hpp"
#include "solver/element/solid.hpp"
#include "solver/state/half_step.hpp"

namespace gapcheck::solver {

/// The history of one thick shell besides its layers.
struct ThickShellState {
  ShellState shell;                 ///< thickness and hourglass stresses of its mid-surface
  std::array<double, 4> pressed{};  ///< stress that holds the thickness, at each pair of corners
  double mass = 0;
  double mass_factor = 1;  ///< by mass scaling; part of the mass
};

/// Internal forces on the eight corners (the shell pulls its nodes with the opposite).
struct ThickShellForces {
  std::array<Vector, 8> force;
  double hourglass_work = 0, dissipated = 0;  ///< in this step
  double manual_step = 0;                     ///< volume over the largest face, over the speed of a plane wave
  double stable_step = 0;                     ///< 2 / an upper bound of the highest frequency
  bool good = false;
};

/// The middle of each pair of a lower and an upper corner.
[[nodiscard]] std::array<Vector, 4> mid_surface(const std::array<Vector, 8>& x);

/// Mean length of the fibres along the normal of the mid-surface.
[[nodiscard]] double fibre_thickness(const std::array<Vector, 8>& x);

/// Thick shell with one point in the plane (ELFORM 1): corners 1 to 4 lie on the lower, 5 to 8 on the upper side. The
/// fibres from each lower corner to the upper one turn as the corners of a shell of Belytschko, Lin and Tsay on the
/// mid-surface do (degenerated solid after Hughes and Liu, Comput. Methods Appl. Mech. Engng 26, 1981), whose layers
/// are in plane stress. A fibre that leans against the normal turns with the part of its velocity that the slope of the
/// mid-surface does not give it, so that no rigid motion strains the shell. The thickness that plane stress asks for is
/// held by a stress of modulus E between each pair of corners (penalty; its size is our choice), which acts in the
/// plane by ν / (1 − ν). All stresses of the shell belong to shell.thickness, which follows the strain.
[[nodiscard]] ThickShellForces thick_shell_forces(const ShellProperties& properties, const SolidCorners& corners,
                                                  double dt, ThickShellState& state, std::span<PointState> points);

/// A thick shell begins with its hourglass stiffness and thickness at its corners `x`.
[[nodiscard]] ThickShellState begin_thick_shell(const ShellProperties& properties, const std::array<Vector, 8>& x);

/// What it stores with its corners at `x`.
[[nodiscard]] double stored_energy(const ShellProperties& properties, const ThickShellState& state,
                                   const std::array<Vector, 8>& x, std::span<const PointState> points);

}  // namespace gapcheck::solver
