#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/entity/boundary.hpp"
#include "model/entity/part.hpp"
#include "model/entity/sets.hpp"

namespace gapcheck::model {

/// *LOAD_NODE_POINT, _SET and *LOAD_RIGID_BODY: a force or moment by a curve over time.
struct ConcentratedLoad {
  std::string keyword;
  NodeChoice nodes;
  bool rigid = false;        ///< acts on the centre of `part`, otherwise on `nodes`
  std::int64_t part = 0;     ///< rigid part or nodal rigid body
  std::int64_t freedom = 0;  ///< DOF as written: 1 … 3 forces, 5 … 7 moments, 4 and 8 follow nodes
  std::int64_t curve = 0;
  double scale = 1;  ///< SF in the model's units
  std::int64_t system = 0;
  std::array<std::int64_t, 3> followed{};  ///< M1 … M3: nodes whose normal DOF 4 and 8 follow
  Place place;
};

/// *LOAD_SEGMENT, _SET, *LOAD_SHELL_ELEMENT and _SET: a pressure by a curve over time.
struct PressureLoad {
  enum class Kind : std::uint8_t { segment, segment_set, shell, shell_set };
  Kind kind = Kind::segment;
  std::string keyword;
  std::int64_t id = 0;                  ///< set or shell
  std::array<std::int64_t, 4> nodes{};  ///< of a segment; a triangle has three, or repeats the third
  std::int64_t curve = 0;
  double scale = 1;    ///< SF in the model's units
  double arrival = 0;  ///< AT: the curve begins at this time
  Place place;
};

/// *LOAD_BODY_X, _Y, _Z: the acceleration of the frame; _RX, _RY, _RZ: its angular velocity about an axis.
struct BodyLoad {
  std::string keyword;
  int axis = 0;
  bool rotation = false;
  bool by_vector = false;             ///< _VECTOR: along `direction` instead of an axis
  Vector direction = Vector::Zero();  ///< as written
  Vector center = Vector::Zero();     ///< of a rotation: a point of its axis
  std::int64_t curve = 0;
  std::int64_t relaxation_curve = 0;  ///< LCIDDR: takes the place of `curve` in dynamic relaxation; 0: none
  double scale = 1;
  std::int64_t system = 0;
  Place place;
};

/// *LOAD_BODY_PARTS: the parts to which body loads apply.
struct BodyLoadParts {
  std::int64_t part_set = 0;
  Place place;
};

/// *DAMPING_GLOBAL: a force against the velocity of every mass.
struct GlobalDamping {
  std::int64_t curve = 0;           ///< of the damping constant; 0: `value`
  double value = 0, scale = 1;      ///< scale: on the curve's ordinates
  std::array<double, 6> factors{};  ///< x y z, rotations; all zero as written: all one
  Place place;
};

/// *DAMPING_PART_MASS, _SET: the same for the masses of some parts.
struct PartDamping {
  std::string keyword;
  std::int64_t id = 0;  ///< part or part set
  bool set = false;
  std::int64_t curve = 0;           ///< of the damping constant
  double scale = 1;                 ///< SF, on the curve's ordinates
  std::array<double, 6> factors{};  ///< x y z, rotations
  Place place;
};

/// *DAMPING_RELATIVE: the same against the velocity relative to that of a rigid body.
struct RelativeDamping {
  double fraction = 0;    ///< CDAMP, of critical damping at `frequency`
  double frequency = 0;   ///< FREQ
  std::int64_t body = 0;  ///< PIDRB
  std::int64_t part_set = 0;
  double squared = 0;      ///< DV2, as written
  std::int64_t curve = 0;  ///< LCID: the fraction over time; 0: `fraction`
  Place place;
};

struct Loads {
  std::vector<ConcentratedLoad> concentrated;
  std::vector<PressureLoad> pressures;
  std::vector<BodyLoad> bodies;
  std::vector<BodyLoadParts> body_parts;
  std::vector<PartDamping> part_dampings;
  std::vector<RelativeDamping> relative_dampings;
  std::optional<GlobalDamping> damping;  ///< the last one of the deck
};

}  // namespace gapcheck::model
