#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/vector.hpp"
#include "model/entity/part.hpp"

namespace gapcheck::model {

/// Nodes of a condition, as written: one node or a set of them.
struct NodeChoice {
  std::int64_t id = 0;
  bool set = false;
};

/// Times between which a condition applies, in the model's unit. LS-DYNA treats a death of zero as never.
struct Lifetime {
  static constexpr double forever = 1e20;
  double birth = 0, death = forever;
  [[nodiscard]] bool always() const { return birth <= 0 && death >= forever; }
};

/// *BOUNDARY_SPC_NODE and _SET: degrees of freedom that stay at rest.
struct SinglePointConstraint {
  NodeChoice nodes;
  std::uint8_t freedoms = 0;  ///< bits 0 … 2: x y z, bits 3 … 5: rotations about them
  std::int64_t system = 0;    ///< CID of a local coordinate system; 0: global
  Lifetime lifetime;
  Place place;
};

/// The constraint codes TC and RC of *NODE: nodes with the same freedoms, block by block.
struct NodeConstraint {
  std::uint8_t freedoms = 0;
  std::vector<NodeIndex> nodes;
  Place place;  ///< of the first of them
};

/// *BOUNDARY_PRESCRIBED_MOTION_NODE, _SET and _RIGID: a freedom that follows a curve over time.
struct PrescribedMotion {
  std::string keyword;
  NodeChoice nodes;
  bool rigid = false;         ///< _RIGID: moves `part`, otherwise `nodes`
  std::int64_t part = 0;      ///< the part or nodal rigid body
  std::int64_t freedom = 0;   ///< DOF as written
  std::int64_t quantity = 0;  ///< VAD: 0 velocity, 1 acceleration, 2 displacement; others as written
  std::int64_t curve = 0;
  double scale = 1;         ///< SF in the model's units: of translations, with a length
  double turn_scale = 1;    ///< of rotations
  std::int64_t vector = 0;  ///< VID
  Lifetime lifetime;
  Place place;
};

/// A local system that a condition names (CID).
struct LocalSystem {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns: local x, y, z at the start
  std::string fault;                                   ///< why the axes are not known; empty: they are
};

/// *DEFINE_VECTOR in the global system: from tail to head.
struct DirectionVector {
  Vector direction = Vector::Zero();
  std::int64_t system = 0;  ///< CID; 0: global
  Place place;
};

/// The freedoms of a constraint code 0 … 7: none, x, y, z, xy, yz, zx, xyz, in bits 0 … 2. Other codes: none.
[[nodiscard]] std::uint8_t freedoms_of_code(std::int64_t code);

}  // namespace gapcheck::model
