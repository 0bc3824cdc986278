#pragma once
#include <cmath>

#include "solver/element/shell.hpp"

namespace gapcheck::solver {

/// Factors on εxx + εyy, and on εxx − εyy and 2εxy, whose squares add up to twice the energy per mass in plane stress:
/// what bounds of the frequency take.
struct PlateRoots {
  double sum, difference;

  explicit PlateRoots(const ShellProperties& properties) {
    const Material& material = properties.material;
    const double plate = properties.stiffest * material.plate_modulus() / material.density, nu = material.poisson;
    // Of a material that is not isotropic no more is known than the bound of its moduli. Plies may differ in ν.
    const bool isotropic = material.kind != MaterialKind::orthotropic && properties.layer_materials.empty();
    const double largest = (1 + std::abs(nu)) / 2;
    sum = std::sqrt(plate * (isotropic ? (1 + nu) / 2 : largest));
    difference = std::sqrt(plate * (isotropic ? (1 - nu) / 2 : largest));
  }
};

}  // namespace gapcheck::solver
