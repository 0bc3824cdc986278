#include "solver/output/body_states.hpp"

#include <Eigen/Eigenvalues>

namespace gapcheck::solver {
namespace {

/// Ascending by their inertia, right-handed.
Matrix principal_axes(const Matrix& inertia) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(inertia);
  Matrix axes = solver.eigenvectors();
  axes.col(2) = Vector(axes.col(0)).cross(Vector(axes.col(1)));
  return axes;
}

}  // namespace

std::vector<ListedBody> listed_bodies(const Run& run) {
  const Structure& structure = run.stepper().structure();
  std::vector<ListedBody> list;
  std::vector<bool> seen(structure.rigid.size(), false);
  const auto add = [&](std::int64_t id, bool nodal) {
    const auto found = structure.body_of_id.find(id);
    if (found == structure.body_of_id.end() || seen[found->second]) return;
    seen[found->second] = true;
    list.push_back({found->second, id, nodal});
  };
  for (const model::Part& part : run.model().parts) add(part.id.value, false);
  for (const model::RigidGroup& group : run.model().rigid_groups)
    if (group.kind == model::RigidGroup::Kind::nodal_rigid_body) add(group.id, true);
  return list;
}

BodyTurns::BodyTurns(const Run& run) {
  for (const ListedBody& listed : listed_bodies(run)) {
    const RigidBody& body = run.stepper().structure().rigid[listed.body];
    Body entry;
    entry.listed = listed;
    entry.start = body.center();
    entry.axes = principal_axes(body.inertia());
    bodies_.push_back(entry);
  }
}

void BodyTurns::advance(const Run& run) {
  for (Body& body : bodies_) {
    body.rotation += run.stepper().state().dt * body.spin;
    body.spin = run.stepper().structure().rigid[body.listed.body].angular_velocity();
  }
}

std::vector<results::BodyMotion> BodyTurns::states(const Run& run) const {
  const RigidBodies& rigid = run.stepper().structure().rigid;
  std::vector<results::BodyMotion> list;
  for (const Body& entry : bodies_) {
    const RigidBody& body = rigid[entry.listed.body];
    const RigidBodies::Response& response = rigid.response(entry.listed.body);
    results::BodyMotion motion;
    motion.body = entry.listed.id;
    motion.nodal = entry.listed.nodal;
    motion.position = body.center();
    motion.displacement = body.center() - entry.start;
    motion.velocity = body.velocity();
    motion.acceleration = response.acceleration;
    motion.rotation = entry.rotation;
    motion.spin = body.angular_velocity();
    motion.spin_rate = response.spin_rate;
    motion.axes = body.rotation() * entry.axes;
    list.push_back(motion);
  }
  return list;
}

std::vector<results::WallForce> wall_states(const Run& run) {
  std::vector<results::WallForce> list;
  if (run.conditions().walls == nullptr) return list;
  for (const WallState& state : run.conditions().walls->states())
    list.push_back({run.model().rigid_walls[state.wall].id, state.normal_force, state.force});
  return list;
}

}  // namespace gapcheck::solver
