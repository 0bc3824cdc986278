#pragma once
#include <array>
#include <cstdint>

#include "base/ids.hpp"
#include "base/vector.hpp"

namespace gapcheck::solver {

/// What one contact does at the time of the last force evaluation, and did since the start.
struct ContactState {
  std::uint32_t contact = 0;    ///< position in Model::contacts
  bool single_surface = false;  ///< then all is side A
  /// Sum of the forces on the nodes of each side; they are opposite. Of single surfaces zero: undefined.
  Vector force_a = Vector::Zero(), force_b = Vector::Zero();
  /// Moments about the origin of those forces, with what acts on rotations.
  Vector moment_a = Vector::Zero(), moment_b = Vector::Zero();
  /// Work taken from the nodes of each side (energy_a + energy_b is what the contact holds and has dissipated), of it
  /// that of friction and of damping.
  double energy_a = 0, energy_b = 0, friction = 0, damping = 0;
  std::uint64_t touching = 0, released = 0;  ///< tracked nodes with a force; without one since they were too deep
  std::uint64_t moved = 0;                   ///< shooting nodes since the start
};

/// One tracked node that is in the contact zone of a segment.
struct ContactNode {
  enum class Kind : std::uint8_t {
    touching,  ///< carries a force
    kept,      ///< IGNORE: penetrates no deeper than the depth that is forgiven
    released,  ///< too deep: no force until it has left the whole contact zone
    tied,      ///< moves with the segment
    broken,    ///< was tied, and has failed
  } kind = Kind::touching;
  NodeIndex node;
  std::array<NodeIndex, 4> segment;
  Vector force = Vector::Zero();  ///< on the node
  double penetration = 0;
  double forgiven = 0;  ///< IGNORE: penetration without force
  double pressure = 0;  ///< normal force over the segment's area
};

}  // namespace gapcheck::solver
