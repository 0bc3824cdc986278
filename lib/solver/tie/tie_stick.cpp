#include "solver/tie/tie_stick.hpp"

#include <algorithm>
#include <cstdlib>

namespace gapcheck::solver {

bool ties_stick(const model::Contact& contact) {
  const std::int64_t option = std::abs(contact.tiebreak_option);
  return contact.kind->automatic_tiebreak() && (option == 1 || option == 3);
}

TieSpring stuck_spring(const model::Contact& contact, const Tie& tie, const Touch& touch, const TieStrengths& strengths,
                       const State& state) {
  TieSpring spring;
  spring.tie = tie;
  spring.percent = std::max(0.0, contact.vdc);
  spring.damping = ContactSprings::damping(touch.spring, spring.percent);
  spring.stiffness = touch.push.norm() / touch.depth;
  spring.strength = strengths.of(tie, state.x);
  const SegmentAxes axes(tie.point.nodes, state.x);
  const Vector stretch = -touch.push / spring.stiffness;
  spring.offset.start(axes, state.x[tie.node.value] - tie.point.of(state.x) - stretch);
  spring.active = true;
  spring.stored = spring.stiffness * stretch.squaredNorm() / 2;
  return spring;
}

}  // namespace gapcheck::solver
