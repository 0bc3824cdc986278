#include "model/entity/faces.hpp"
#include "solver/element/solid_elements.hpp"

namespace gapcheck::solver {

std::size_t SolidElements::corners(std::size_t solid) const { return model::is_tetrahedron(nodes_[solid]) ? 4 : 8; }

Symmetric ImposedStress3::on(const Symmetric& stress_of_material) const {
  Matrix result = to_matrix(stress_of_material);
  const Vector traction = result * normal;
  const double own = traction.dot(normal);
  result += (stress - own) * normal * normal.transpose();
  if (!shear) {
    const Vector across = traction - own * normal;
    result -= across * normal.transpose() + normal * across.transpose();
  }
  return to_symmetric(result);
}

std::uint32_t SolidElements::add_section(SectionStress section) {
  section_of_.resize(size(), no_position);
  const auto position = static_cast<std::uint32_t>(sections_.size());
  for (const auto& [solid, front] : section.solids) section_of_[solid] = position;
  sections_.push_back(std::move(section));
  return position;
}

double SolidElements::section_force(std::size_t section) const {
  double sum = 0;
  for (const auto& [solid, front] : sections_[section].solids)
    for (std::size_t k = 0; k < 8; ++k)
      if ((front >> k & 1u) != 0) sum += force_[8 * std::size_t{solid} + k].dot(sections_[section].imposed.normal);
  return sum;
}

SolidForces SolidElements::preloaded_forces(const State& state, std::size_t solid, const SolidCorners& corners,
                                            double& supplied) {
  std::array<Vector, 8> before;
  for (std::size_t k = 0; k < 8; ++k) before[k] = corners.x[k] - state.dt * corners.v[k];
  const double stored = stored_at(solid, before);
  state_[solid].imposed = &sections_[section_of_[solid]].imposed;
  const SolidForces forces = forces_of(solid, corners, state.dt);
  state_[solid].imposed = nullptr;
  supplied = stored_at(solid, corners.x) - stored + forces.dissipated;
  for (std::size_t k = 0; k < 8; ++k)
    supplied -= state.dt / 2 * (force_[8 * solid + k] + forces.force[k]).dot(corners.v[k]);
  return forces;
}

}  // namespace gapcheck::solver
