#pragma once
#include <limits>
#include <optional>

#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// What the criteria of erosion look at, of one point. Pressure is positive in compression.
struct ErosionMeasures {
  double pressure = 0, principal_stress = 0, von_mises = 0;
  double least_strain = 0, greatest_strain = 0;  ///< principal
  double shear_strain = 0;                       ///< (ε₁ − ε₃) / 2
  double effective_strain = 0;                   ///< √(2/3 dev ε : dev ε)
  double volume_strain = 0;                      ///< tr ε
  double thinning = 0, in_plane_strain = 0;      ///< −εzz; larger principal strain of xx, yy, xy
  double plastic_strain = 0;                     ///< effective
};

[[nodiscard]] double greatest_principal_value(const Symmetric& a);

[[nodiscard]] ErosionMeasures erosion_measures(const Symmetric& stress, const Symmetric& strain, double plastic_strain);

/// Limits of *MAT_ADD_EROSION (keyword manual, volume II); those that are not given are infinite and never met.
struct Erosion {
  static constexpr double never = std::numeric_limits<double>::infinity();
  double max_pressure = never, min_pressure = -never;
  double min_strain = -never, max_strain = never;  ///< principal
  double principal_stress = never, von_mises = never, shear_strain = never;
  double effective_strain = never, plastic_strain = never;
  double growth = never, shrinkage = -never;  ///< of the volume strain
  double threshold = 0, impulse = never;  ///< Tuler and Butcher: ∫ (σ₁ − threshold)² dt over σ₁ > threshold
  // Of 123 in shells, whose axes are the element's:
  double thinning = never, in_plane_strain = never;  ///< −εzz; larger principal strain in the plane
  double time = never;                               ///< the element goes then, whatever else is met
  /// NUMFIP: points of a shell that must be eroded before it goes; below zero per cent of its layers. A solid goes with
  /// its first point.
  double points = 1;
  int conditions = 1;  ///< NCS: criteria that one point must meet at once

  /// How many criteria are met.
  [[nodiscard]] int met(const ErosionMeasures& of, double impulse_so_far) const;
  /// How many criteria have a limit; time is not counted.
  [[nodiscard]] int given() const;
};

/// FAILTM is over.
[[nodiscard]] inline bool past_time(const std::optional<Erosion>& erosion, double time) {
  return erosion && time >= erosion->time;
}

}  // namespace gapcheck::solver
