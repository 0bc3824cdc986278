#pragma once
#include "contact/tie/sliding_surface.hpp"
#include "model/contact/contact.hpp"
#include "solver/tie/tie.hpp"

namespace gapcheck::solver {

/// A tie whose node slides along the surface: OPTION 4 of tiebreaks. A spring holds it at its first distance from the
/// surface, in tension too; across the normal there is friction, elastic up to its limit.
class TieSlide {
 public:
  TieSlide() = default;
  /// `limit`: the largest friction, a force, where it does not depend on the pressure (PARAM = 1); 0: by `law`.
  TieSlide(const contact::SlidingSurface& surface, const model::FrictionLaw& law, double limit)
      : surface_(&surface), law_(law), limit_(limit) {}
  [[nodiscard]] bool slides() const { return surface_ != nullptr; }

  /// On the node.
  struct Load {
    Vector normal = Vector::Zero();  ///< unit, of the segment
    Vector push = Vector::Zero(), damping = Vector::Zero(), friction = Vector::Zero();
    Vector velocity = Vector::Zero();  ///< of the node relative to its point
    double stored = 0;
    bool off = false;  ///< it has left the surface
  };
  /// Moves the tie's point to where the node now is. `side`: -1 if the node is on the back of the segments.
  [[nodiscard]] Load advance(Tie& tie, double side, double stiffness, double damping, const State& state);
  void stop() { started_ = false; }

 private:
  const contact::SlidingSurface* surface_ = nullptr;
  model::FrictionLaw law_;
  double limit_ = 0, height_ = 0;
  bool started_ = false;
  Vector friction_ = Vector::Zero();
};

}  // namespace gapcheck::solver
