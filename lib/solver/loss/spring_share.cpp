#include "solver/loss/spring_share.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace gapcheck::solver {

double share_of_springs(const ImpactScene& scene, std::span<const Impact* const> impacts, const Vector& normal) {
  std::map<NodeIndex, double> pushed;
  double of_bodies = 0;
  const auto push = [&](NodeIndex node, double stiffness) {
    if (scene.bodies.kind(std::array{node}) == ConnectedBodies::Kind::fixed) return;
    if (const BodyState* const body = scene.bodies.rigid(node)) {
      const Vector turn = (scene.state.x[node.value] - body->center).cross(normal);
      of_bodies += stiffness * (scene.bodies.mobility(node, normal) + turn.dot(body->turn_response * turn));
    } else {
      pushed[node] += stiffness;
    }
  };
  for (const Impact* const impact : impacts) {
    push(impact->node, impact->spring.stiffness);
    for (std::size_t c = 0; c < 4; ++c)
      if (const double weight = impact->meeting.contact.weights[c]; weight > 0)
        push(impact->corners[c], weight * impact->spring.stiffness);
  }
  double of_nodes = 0;
  for (const auto& [node, stiffness] : pushed)
    of_nodes = std::max(of_nodes, 2 * stiffness / scene.state.mass[node.value]);
  return scene.step * scene.step * (of_nodes + of_bodies);
}

}  // namespace gapcheck::solver
