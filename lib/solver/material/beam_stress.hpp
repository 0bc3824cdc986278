#pragma once
#include <array>

#include "solver/material/material.hpp"

namespace gapcheck::solver {

/// Stress along r and shear on the cross-section along s and t at a point of a beam; or strain, with engineering shear.
using BeamTensor = std::array<double, 3>;

/// The history of an integration point of a beam.
struct BeamPoint {
  BeamTensor stress{};
  BeamTensor back_stress{};   ///< centre of the yield surface, as a stress
  double plastic_strain = 0;  ///< effective
  double plastic_work = 0;    ///< per volume, since the start
  bool failed = false;        ///< no stress from then on
};

/// Adds a strain increment (over dt) to a point of a beam, where only σrr, σrs and σrt can differ from zero: elastic,
/// or plastic with von Mises' q² = σrr² + 3 (σrs² + σrt²). The return is implicit; what is left is one equation for
/// Δε̄/q, exact where the stress is purely axial or purely shear (Simo and Taylor 1986 for plane stress). The total rate
/// of rate dependence is √(ε̇rr² + (γ̇rs² + γ̇rt²)/2). Materials 001, 003, 024, 100.
void update_beam_stress(const Material& material, const BeamTensor& increment, double dt, BeamPoint& point);

/// Elastic energy per volume: σrr²/2E + (σrs² + σrt²)/2G.
[[nodiscard]] double elastic_energy(const Material& material, const BeamTensor& stress);

}  // namespace gapcheck::solver
