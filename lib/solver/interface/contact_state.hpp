#pragma once
#include <array>
#include <cstdint>
#include <limits>

#include "base/ids.hpp"
#include "base/vector.hpp"

namespace gapcheck::solver {

/// The action of one contact at the time of the last force evaluation, and since the start.
struct ContactState {
  ContactIndex contact;         ///< position in Model::contacts
  bool single_surface = false;  ///< then everything is side A
  /// Sum of the forces on the nodes of each side; they are opposite. Zero for single surfaces: undefined.
  Vector force_a = Vector::Zero(), force_b = Vector::Zero();
  /// Moments of those forces about the origin, including what acts on rotations.
  Vector moment_a = Vector::Zero(), moment_b = Vector::Zero();
  /// Work taken from the nodes of each side (energy_a + energy_b is what the contact stores and has dissipated), and
  /// the parts due to friction and damping.
  double energy_a = 0, energy_b = 0, friction = 0, damping = 0;
  /// Energy of springs that ended while they pushed (released nodes, contacts that end), less what springs had at the
  /// start of the run, which nobody paid for.
  double lost = 0;
  [[nodiscard]] double work() const { return energy_a + energy_b; }
  std::uint64_t touching = 0, released = 0;  ///< tracked nodes with a force; without one because they were too deep
  std::uint64_t moved = 0;                   ///< shooting nodes since the start
};

/// One tracked node in the contact zone of a segment.
struct ContactNode {
  enum class Kind : std::uint8_t {
    touching,  ///< carries a force
    kept,      ///< IGNORE: penetrates no deeper than the forgiven depth
    released,  ///< too deep: no force until it has left the whole contact zone
    tied,      ///< moves with the segment
    broken,    ///< was tied, and has failed
  } kind = Kind::touching;
  NodeIndex node;
  std::array<NodeIndex, 4> segment;
  Vector force = Vector::Zero();  ///< on the node
  double penetration = 0;
  double forgiven = 0;                                               ///< IGNORE: penetration without force
  double pressure = 0;                                               ///< normal force over the segment's area
  double stored = 0;                                                 ///< energy of its spring
  double contact_distance = 0;                                       ///< 0 where a surface has no thickness
  double release_depth = std::numeric_limits<double>::infinity();    ///< penetration beyond which it is released
  PartIndex part = none<PartIndex>, segment_part = none<PartIndex>;  ///< none: not known
};

/// A node that a contact has moved out of a segment when it found it there suddenly.
struct ShotNode {
  ContactIndex contact;  ///< position in Model::contacts
  NodeIndex node;
  PartIndex part = none<PartIndex>, segment_part = none<PartIndex>;  ///< none: not known
  Vector from = Vector::Zero(), to = Vector::Zero();
};

}  // namespace gapcheck::solver
