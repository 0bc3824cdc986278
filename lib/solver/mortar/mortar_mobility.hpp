#pragma once
#include <cstdint>
#include <vector>

#include "solver/mortar/mortar_surface.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// How easily the faces of a mortar surface move: the reciprocal of the mass per area that their springs see.
class MortarMobility {
 public:
  explicit MortarMobility(const MortarSurface& surface) : surface_(surface) {}
  /// Measures the faces if this is the first call, or a body has gained or lost an imposed motion. Returns whether it
  /// did.
  bool follow(const State& state);
  /// Of a face with elements of its own their reciprocal mass per area. Of a face of a rigid body the greatest that all
  /// pressed faces of the body together can have, whatever it does: 0 if it follows no force.
  [[nodiscard]] double of(std::uint32_t face) const { return mobility_[face]; }
  [[nodiscard]] bool rigid(std::uint32_t face) const { return body_[face] != no_position; }

 private:
  const MortarSurface& surface_;
  std::vector<double> mobility_;     ///< by face
  std::vector<std::uint32_t> body_;  ///< by face: position in State::bodies; no_position: none
  std::vector<unsigned> imposed_;    ///< by body, at the last measurement
  bool measured_ = false;
};

/// The squared frequency, per stiffness per area, of a rigid body on springs that stand on all these faces along their
/// normals: with g = (n, r × n) at each place the greatest eigenvalue of ∫ g gᵀ dA over mass and inertia. Fewer springs
/// have a lower one.
[[nodiscard]] double body_mobility(const BodyState& body, const std::vector<std::array<Vector, 4>>& faces);

}  // namespace gapcheck::solver
