#pragma once
#include "solver/tie/tie.hpp"
#include "solver/tie/tie_slide.hpp"
#include "solver/tie/tie_strength.hpp"

namespace gapcheck::solver {

/// A tie by a spring, and what it did in the last step.
struct TieSpring {
  Tie tie;
  double stiffness = 0, rotational = 0, damping = 0;
  double percent = 0;  ///< of the critical damping: VDC
  bool active = false;
  TieStrength strength;
  TieDamage damage;
  TieSlide slide;
  bool told = false;  ///< its end is already reported
  TieOffset offset;
  Vector turned = Vector::Zero();  ///< rotation of the node relative to the segment
  TieLoads loads;
  double on_node = 0, on_segment = 0, damped = 0, rubbed = 0;  ///< work taken in the last step
  Vector friction = Vector::Zero();                            ///< of a node that slides
  double stored = 0, lost = 0;  ///< energy, and what the end of the tie in this step left of it
};

/// Sets its loads, and the work in the step that led to this state. `active`: the contact acts at this time.
void advance(TieSpring& spring, const State& state, bool active);

}  // namespace gapcheck::solver
