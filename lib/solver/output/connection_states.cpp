#include "solver/output/connection_states.hpp"

#include <algorithm>

namespace gapcheck::solver {

std::vector<results::SpringForce> spring_states(const Run& run) {
  std::vector<results::SpringForce> list;
  const Springs* springs = run.conditions().springs;
  const model::Mesh& mesh = run.model().mesh;
  for (std::size_t i = 0; springs != nullptr && i < springs->size(); ++i) {
    const SpringInput& input = springs->input(i);
    if (input.element < mesh.discrete_values.size() && !mesh.discrete_values[input.element].printed) continue;
    list.push_back({mesh.discrete.id[input.element], input.torsional, springs->pull(i), springs->tension(i),
                    springs->elongation(i)});
  }
  return list;
}

std::vector<results::AirbagRow> airbag_states(const Run& run) {
  const Airbags* airbags = run.conditions().airbags;
  std::vector<results::AirbagRow> list;
  if (airbags == nullptr) return list;
  for (const AirbagState& now : airbags->states())
    list.push_back({run.model().airbags[now.airbag].id, now.volume, now.pressure, now.energy, now.rate_in, now.density,
                    now.rate_out, now.mass, now.temperature, now.area});
  return list;
}

std::vector<results::JointForce> joint_states(const Run& run) {
  std::vector<results::JointForce> list;
  const std::vector<RigidJoint>& joints = run.stepper().structure().rigid.joints();
  const std::vector<model::Joint>& cards = run.model().joints;
  for (std::size_t i = 0; i < std::min(joints.size(), cards.size()); ++i)
    list.push_back({cards[i].id, false, joints[i].force, joints[i].moment});
  return list;
}

}  // namespace gapcheck::solver
