#include "solver/build/build_forces.hpp"

#include "solver/build/build_springs.hpp"
#include "solver/condition/rigid_walls.hpp"

namespace gapcheck::solver {

SolverStatus add_walls_and_springs(const model::Model& model, const Structure& structure,
                                   std::vector<std::unique_ptr<Force>>& forces, Diagnostics& diagnostics) {
  if (SolverStatus checked = check_walls(model); !checked.ok()) return checked;
  if (!model.rigid_walls.empty()) forces.push_back(std::make_unique<RigidWalls>(model, structure, diagnostics));
  auto springs = build_springs(model, structure, diagnostics);
  if (!springs) return springs.error();
  if (springs.value() != nullptr) forces.push_back(std::move(springs).value());
  return {};
}

}  // namespace gapcheck::solver
