#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace gapcheck::results {

/// Stress (xx yy zz xy yz zx, global axes) and effective plastic strain at one point of an element.
struct StressPoint {
  std::array<double, 6> stress{};
  double plastic_strain = 0;
};

/// What a d3plot says about one shell besides its layers.
struct ShellValues {
  std::array<double, 8> resultants{};  ///< mxx myy mxy qxz qyz nxx nyy nxy, per length, axes of the element
  double thickness = 0;
  double internal_energy = 0;  ///< per volume
};

/// What a d3plot says about one part.
struct PartValues {
  double internal = 0, kinetic = 0, mass = 0, hourglass = 0;
  std::array<double, 3> velocity{};
};

/// One state of a d3plot; arrays parallel to those of D3plot. An empty array: the database lacks these values.
struct D3plotState {
  double time = 0;
  double kinetic = 0, internal = 0, total = 0;  ///< energies of the model
  std::array<double, 3> velocity{};             ///< of its centre of mass
  std::vector<PartValues> parts;                ///< by number of the part
  std::vector<std::array<double, 3>> coordinates, velocities;
  std::vector<StressPoint> solids;
  /// Points of one shell: middle, lower, upper surface; databases may have fewer.
  static constexpr std::size_t surfaces = 3;
  std::size_t layers = surfaces;
  std::vector<StressPoint> shell_points;  ///< `layers` per shell
  std::vector<ShellValues> shells;
  std::vector<StressPoint> thick_shell_points;  ///< `surfaces` per thick shell; written, not read. Empty: zeros
  static constexpr std::size_t beam_values = 6;
  /// Of beams: axial force, shear forces s t, bending moments s t, torsion; their own axes.
  std::vector<std::array<double, beam_values>> beams;
  std::vector<bool> deleted_solids, deleted_shells, deleted_beams;  ///< failed elements
};

/// The word that ends a file of the family.
inline constexpr double d3plot_end = -999999.0;

}  // namespace gapcheck::results
