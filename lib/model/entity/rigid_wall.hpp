#pragma once
#include <cstdint>
#include <limits>
#include <string>

#include "base/vector.hpp"
#include "model/entity/part.hpp"

namespace gapcheck::model {

/// Friction of _ORTHO in the directions a and b of a wall, with b = n x d and a = b x n.
struct OrthotropicFriction {
  double static_a = 0, static_b = 0, dynamic_a = 0, dynamic_b = 0;
  double decay_a = 0, decay_b = 0;      ///< time per length
  std::int64_t node_1 = 0, node_2 = 0;  ///< d from one to the other; 0: as given
  Vector direction = Vector::Zero();    ///< d
};

/// *RIGIDWALL_PLANAR and *RIGIDWALL_GEOMETRIC: a surface that stops nodes, without a mesh. Its shape at t = 0.
struct RigidWall {
  enum class Shape : std::uint8_t {
    plane,     ///< tail, normal; an infinite plane or the rectangle from tail along edge_l and edge_m
    prism,     ///< the rectangle, with material as far as length_p behind it
    cylinder,  ///< axis from tail along normal, as far as length_l
    sphere,    ///< centre in tail
  };
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  std::int64_t id = 0;  ///< given, or the wall's position among the walls of the deck, from 1
  std::string title;    ///< empty: none
  Shape shape = Shape::plane;
  bool interior = false;  ///< cylinder, sphere: keeps its nodes inside
  Vector tail = Vector::Zero();
  Vector normal = Vector::UnitZ();  ///< unit length; of a plane or prism: away from the material
  Vector edge_l = Vector::UnitX(), edge_m = Vector::UnitY();  ///< unit length; only where a length is finite
  double length_l = infinite, length_m = infinite, length_p = infinite;
  double radius = 0;
  std::int64_t node_set = 0;      ///< its nodes; 0: all nodes of the model
  std::int64_t exempted_set = 0;  ///< exempted nodes; 0: none
  std::int64_t box = 0;           ///< only nodes inside; 0: no box
  double offset = 0;              ///< planar walls: only nodes within this distance; 0: any distance
  double birth = 0, death = 0;    ///< active in between; death 0: for ever
  double friction = 0;            ///< FRIC: 0 smooth, below 1 Coulomb, 1 no sliding; 2 and 3 weld what comes fast
  double weld_velocity = 0;       ///< WVEL: FRIC 2 and 3 weld what is faster along the normal
  double stiffness_scale = 1;     ///< RWKSF, of penalties
  bool moving = false;            ///< _MOVING, _MOTION
  double mass = 0, velocity = 0;  ///< _MOVING: of the wall, along the normal at the start
  /// _MOTION: a curve of velocity (option 0) or displacement (1) over time, along a direction as written.
  std::int64_t motion_curve = 0, motion_option = 0;
  Vector motion_direction = Vector::Zero();
  bool orthotropic = false;  ///< _ORTHO: friction differs by direction
  OrthotropicFriction ortho;
  std::int64_t soft = 0;  ///< _FORCES: cycles over which the velocity is taken
  std::string keyword;    ///< "RIGIDWALL_PLANAR_FINITE"
  Place place;
};

}  // namespace gapcheck::model
