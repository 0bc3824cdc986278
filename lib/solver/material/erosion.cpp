#include "solver/material/erosion.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace gapcheck::solver {
namespace {

/// Ascending.
Vector principal_values(const Symmetric& a) {
  return Eigen::SelfAdjointEigenSolver<Matrix>(to_matrix(a), Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace

double greatest_principal_value(const Symmetric& a) { return principal_values(a)[2]; }

ErosionMeasures erosion_measures(const Symmetric& stress, const Symmetric& strain, double plastic_strain) {
  const Symmetric s = deviator(stress), e = deviator(strain);
  const Vector stresses = principal_values(stress), strains = principal_values(strain);
  ErosionMeasures of;
  of.pressure = -trace(stress) / 3;
  of.principal_stress = stresses[2];
  of.von_mises = std::sqrt(1.5 * contract(s, s));
  of.least_strain = strains[0];
  of.greatest_strain = strains[2];
  of.shear_strain = (strains[2] - strains[0]) / 2;
  of.effective_strain = std::sqrt(2.0 / 3 * contract(e, e));
  of.volume_strain = trace(strain);
  of.thinning = -strain[zz];
  of.in_plane_strain = (strain[xx] + strain[yy]) / 2 + std::hypot((strain[xx] - strain[yy]) / 2, strain[xy]);
  of.plastic_strain = plastic_strain;
  return of;
}

int Erosion::met(const ErosionMeasures& of, double impulse_so_far) const {
  // A pressure of exactly MNPRES is no tension yet: with MNPRES = 0 a body at rest stays.
  return static_cast<int>(of.pressure >= max_pressure) + static_cast<int>(of.pressure < min_pressure) +
         static_cast<int>(of.least_strain <= min_strain) + static_cast<int>(of.greatest_strain >= max_strain) +
         static_cast<int>(of.principal_stress >= principal_stress) + static_cast<int>(of.von_mises >= von_mises) +
         static_cast<int>(of.shear_strain >= shear_strain) + static_cast<int>(of.effective_strain >= effective_strain) +
         static_cast<int>(of.plastic_strain >= plastic_strain) + static_cast<int>(of.volume_strain >= growth) +
         static_cast<int>(of.thinning >= thinning) + static_cast<int>(of.in_plane_strain >= in_plane_strain) +
         static_cast<int>(of.volume_strain <= shrinkage) + static_cast<int>(impulse_so_far >= impulse);
}

int Erosion::given() const {
  int count = 0;
  for (const double limit :
       {max_pressure, min_pressure, min_strain, max_strain, principal_stress, von_mises, shear_strain, effective_strain,
        plastic_strain, growth, shrinkage, impulse, thinning, in_plane_strain})
    count += static_cast<int>(std::isfinite(limit));
  return count;
}

}  // namespace gapcheck::solver
