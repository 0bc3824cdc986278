#include "solver/tie/tie_slide.hpp"

#include <algorithm>

#include "base/quad.hpp"
#include "contact/definition/friction.hpp"

namespace gapcheck::solver {

TieSlide::Load TieSlide::advance(Tie& tie, double side, double stiffness, double damping, const State& state) {
  const Vector& x = state.x[tie.node.value];
  const contact::SlidingSurface::Foot foot = surface_->nearest(tie.segment, x, state.x);
  const contact::Segments& segments = surface_->segments();
  tie.segment = foot.segment;
  tie.element_kind = segments.element_kind[foot.segment.value];
  tie.element = segments.element[foot.segment.value];
  tie.point = {segments.nodes[foot.segment.value], quad_weights(foot.s, foot.t)};
  Load load;
  load.off = foot.off;
  load.normal = foot.normal;
  const double height = (x - foot.point).dot(foot.normal);
  if (!started_) {
    started_ = true;
    height_ = height;
    friction_.setZero();
  }
  const double stretch = height - height_;
  load.velocity = state.v[tie.node.value] - tie.point.of(state.v);
  const double rising = load.velocity.dot(foot.normal);
  load.push = -stiffness * stretch * foot.normal;
  load.damping = -damping * rising * foot.normal;
  load.stored = stiffness * stretch * stretch / 2;
  const Vector sliding = load.velocity - rising * foot.normal;
  const double pressed = std::max(0.0, -side * stiffness * stretch);
  const double area = quad_normal(tie.point.nodes, state.x).norm() / 2;
  const double limit = limit_ > 0 ? limit_ : contact::friction_limit(law_, sliding.norm(), pressed, area);
  friction_ -= friction_.dot(foot.normal) * foot.normal + stiffness * state.dt * sliding;
  const double size = friction_.norm();
  if (size > limit) friction_ *= size > 0 ? limit / size : 0;
  load.friction = friction_;
  return load;
}

}  // namespace gapcheck::solver
