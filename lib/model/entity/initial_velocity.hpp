#pragma once
#include <cstdint>
#include <string>

#include "base/vector.hpp"
#include "model/entity/boundary.hpp"

namespace gapcheck::model {

/// One row of *INITIAL_VELOCITY_NODE, in the model's units and axes.
struct NodeVelocity {
  std::int64_t node = 0;
  std::int64_t system = 0;  ///< ICID; 0: global
  Vector velocity = Vector::Zero(), spin = Vector::Zero();
  Place place;
};

/// One card of *INITIAL_VELOCITY, _GENERATION or _RIGID_BODY, in the model's units and axes.
struct InitialVelocity {
  enum class Kind : std::uint8_t {
    general,     ///< nodes of a set (0: all) inside a box, with other nodes exempted
    generation,  ///< translation and rotation of a part set, part or node set about an axis
    rigid_body,  ///< one part or nodal rigid body
  };
  Kind kind = Kind::general;
  std::string keyword;
  std::int64_t id = 0;      ///< node set, set or part by `target`, part; 0: all
  std::int64_t target = 0;  ///< STYP of generation: 1 part set, 2 part, 3 node set
  std::int64_t exempted_set = 0, box = 0;
  std::int64_t irigid = 0;              ///< 1: also overrides the velocities of *PART_INERTIA
  std::int64_t system = 0;              ///< ICID; 0: global
  std::int64_t phase = 0;               ///< of generation: 1 after dynamic relaxation
  std::int64_t axis_nodes[2] = {0, 0};  ///< of generation with NX = -999: the axis runs from the first to the second
  Vector velocity = Vector::Zero(), spin = Vector::Zero();  ///< generation: spin is OMEGA times the axis
  Vector exempted_velocity = Vector::Zero(), exempted_spin = Vector::Zero();
  double rate = 0;                 ///< OMEGA, where the axis is given by nodes
  Vector origin = Vector::Zero();  ///< a point of the axis of rotation
  Place place;
};

}  // namespace gapcheck::model
