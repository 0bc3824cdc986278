#include <fmt/format.h>

#include <cmath>
#include <string>

#include "solver/condition/rigid_walls.hpp"

namespace gapcheck::solver {
namespace {

/// What is wrong with the friction by direction; empty: nothing.
std::string wrong_friction(const model::Model& model, const model::RigidWall& wall) {
  const model::OrthotropicFriction& ortho = wall.ortho;
  for (const double value : {ortho.static_a, ortho.static_b, ortho.dynamic_a, ortho.dynamic_b})
    if (!(value >= 0) || !std::isfinite(value))
      return fmt::format("a friction coefficient is {:g}; set numbers from 0 up", value);
  if (!(ortho.decay_a >= 0) || !(ortho.decay_b >= 0)) return "DECAYA or DECAYB is below 0; set numbers from 0 up";
  if (ortho.node_1 != 0 || ortho.node_2 != 0) {
    for (const std::int64_t node : {ortho.node_1, ortho.node_2})
      if (!model.mesh.nodes.lookup.find(node))
        return fmt::format("node {} of NODE1 and NODE2 is not defined; define it, or give D1 to D3", node);
    return "";
  }
  if (wall.normal.cross(ortho.direction).norm() > 1e-9 * ortho.direction.norm()) return "";
  return "D1 to D3 give no direction along the wall; give a vector that is not along its normal";
}

std::string wrong_motion(const model::Model& model, const model::RigidWall& wall) {
  if (wall.keyword.find("MOVING") != std::string::npos) {
    if (wall.mass > 0 && std::isfinite(wall.mass) && std::isfinite(wall.velocity)) return "";
    return fmt::format(
        "its mass is {:g} and its velocity {:g}; give it a mass above 0 (MASS), or use "
        "*RIGIDWALL_GEOMETRIC_FLAT_MOTION",
        wall.mass, wall.velocity);
  }
  const auto curve = model.curves.find(wall.motion_curve);
  if (wall.motion_curve == 0 || curve == model.curves.end() || curve->second.points.empty())
    return fmt::format("curve {} of its motion is not defined by a *DEFINE_CURVE", wall.motion_curve);
  double last = -std::numeric_limits<double>::infinity();
  for (const auto& [time, value] : curve->second.points) {
    if (!(time >= last) || !std::isfinite(time) || !std::isfinite(value))
      return fmt::format("the times of curve {} do not rise or are not numbers", wall.motion_curve);
    last = time;
  }
  if (!(wall.motion_direction.norm() > 0) || !wall.motion_direction.allFinite())
    return "VX, VY and VZ give no direction; give one";
  return "";
}

std::string unknown_nodes(const model::Model& model, const model::RigidWall& wall) {
  for (const std::int64_t set : {wall.node_set, wall.exempted_set})
    if (set != 0 && model.sets.nodes.find(set) == model.sets.nodes.end())
      return fmt::format("node set {} is not defined; define it or set 0", set);
  if (wall.box != 0 && model.boxes.find(wall.box) == model.boxes.end())
    return fmt::format("box {} is not defined; define it or set 0", wall.box);
  return "";
}

}  // namespace

std::string_view wall_not_calculated(const model::RigidWall& wall) {
  if (wall.orthotropic) return {};
  const bool welds = wall.friction == 2 || wall.friction == 3;
  if (!(wall.friction >= 0)) return "FRIC below 0 is not calculated";
  if (welds && !wall.keyword.starts_with("RIGIDWALL_PLANAR"))
    return "FRIC 2 and 3 are calculated for planar walls only";
  return {};
}

SolverStatus check_walls(const model::Model& model) {
  for (const model::RigidWall& wall : model.rigid_walls) {
    if (!wall_not_calculated(wall).empty()) continue;
    const auto fail = [&](Failure::Kind kind, const std::string& what) {
      return Failure{kind, fmt::format("*{}, wall {}: {}", wall.keyword, wall.id, what), wall.place};
    };
    if (const std::string what = unknown_nodes(model, wall); !what.empty())
      return fail(Failure::Kind::unknown_reference, what);
    if (wall.moving)
      if (const std::string what = wrong_motion(model, wall); !what.empty())
        return fail(Failure::Kind::contradiction, what);
    if (wall.orthotropic)
      if (const std::string what = wrong_friction(model, wall); !what.empty())
        return fail(Failure::Kind::contradiction, what);
    if (!(wall.stiffness_scale > 0) || wall.soft < 0 || !(wall.weld_velocity >= 0))
      return fail(Failure::Kind::contradiction,
                  fmt::format("RWKSF is {:g}, SOFT {} and WVEL {:g}; set numbers from 0 up", wall.stiffness_scale,
                              wall.soft, wall.weld_velocity));
  }
  return {};
}

}  // namespace gapcheck::solver
