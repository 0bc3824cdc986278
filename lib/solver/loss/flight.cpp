#include "solver/loss/flight.hpp"

#include <algorithm>
#include <cmath>

#include "solver/state/constraints.hpp"

namespace gapcheck::solver {
namespace {

constexpr unsigned moved_axes = 7;

bool is_at_rest(const Motion& motion, double until) {
  const std::array<double, 2> range = speeds_of(motion, 0, until);
  return range[0] == 0 && range[1] == 0;
}

/// The motion is that of its curve from the start to the end, and its way is known.
bool can_be_followed(const Motion& motion, double until) {
  if (motion.birth > 0 || motion.death < until) return false;
  return motion.curve == nullptr || motion.quantity != Motion::Quantity::acceleration;
}

/// Calls visit(time) at both ends and at the points of the curve in between.
template <class Visit>
void for_each_time(const Motion& motion, double from, double to, const Visit& visit) {
  visit(from);
  if (motion.curve != nullptr)
    for (const TimeCurve::Point& point : motion.curve->points())
      if (point[0] > from && point[0] < to) visit(point[0]);
  visit(to);
}

}  // namespace

StartMotion::StartMotion(const State& state) : v(state.v), bodies(state.bodies) {
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (!state.in_body(i)) continue;
    const BodyState& body = bodies[state.body[i]];
    v[i] = body.velocity + body.spin.cross(state.x[i] - body.center);
  }
}

double way_of(const Motion& motion, double time) {
  if (motion.curve == nullptr) return 0;
  const TimeCurve& curve = *motion.curve;
  return motion.scale * (motion.quantity == Motion::Quantity::displacement ? curve.at(time) - curve.at(0)
                                                                           : curve.integral(time) - curve.integral(0));
}

std::array<double, 2> speeds_of(const Motion& motion, double from, double to) {
  std::array<double, 2> range{0, 0};
  if (motion.curve == nullptr) return range;
  bool first = true;
  const auto take = [&](double speed) {
    range = first ? std::array{speed, speed} : std::array{std::min(range[0], speed), std::max(range[1], speed)};
    first = false;
  };
  for_each_time(motion, from, to, [&](double time) { take(motion.velocity(time, 0)); });
  // A curve of velocities may jump: what it had before the jump counts too.
  if (motion.quantity == Motion::Quantity::velocity)
    for (const TimeCurve::Point& point : motion.curve->points())
      if (point[0] >= from && point[0] <= to) take(motion.scale * point[1]);
  return range;
}

std::array<double, 2> ways_of(const Motion& motion, double until) {
  std::array<double, 2> range{0, 0};
  const auto take = [&](double time) {
    const double way = way_of(motion, time);
    range = {std::min(range[0], way), std::max(range[1], way)};
  };
  double last = 0;
  for_each_time(motion, 0, until, [&](double time) {
    take(time);
    // Within a piece of its curve a velocity changes its sign once at most; the way has an end there.
    const double before = motion.velocity(last, 0), after = motion.velocity(time, 0);
    if (motion.quantity == Motion::Quantity::velocity && before * after < 0)
      take(last + (time - last) * (before / (before - after)));
    last = time;
  });
  return range;
}

Flight::Flight(const Structure& structure, const StartMotion& start, double until) : v_(start.v) {
  const Constraints& constraints = structure.constraints;
  const RigidBodies& rigid = structure.rigid;
  for (std::uint32_t i = 0; i < v_.size(); ++i) {
    Course course;
    if (const std::optional<std::size_t> body = rigid.body_of(i)) {
      std::array<std::vector<const Motion*>, 3> motions;
      for (const auto& [freedom, motion] : rigid.motions(*body)) {
        if (freedom < 3)
          motions[freedom].push_back(&motion);
        else if (!can_be_followed(motion, until) || !is_at_rest(motion, until))
          set_unknown(i);
      }
      for (int axis = 0; axis < 3; ++axis)
        if ((rigid.held(*body) >> axis & 1u) != 0)
          continue;  // its velocity has none along it
        else if (const auto& list = motions[static_cast<std::size_t>(axis)]; !list.empty())
          impose(i, Vector::Unit(axis), list, until, course);
    } else if (const unsigned moved = constraints.mask(i) & ~unsigned{constraints.held(i)} & moved_axes; moved != 0) {
      const Matrix* const axes = constraints.axes(i);
      for (int axis = 0; axis < 3; ++axis)
        if ((moved >> axis & 1u) != 0)
          impose(i, axes != nullptr ? Vector(axes->col(axis)) : Vector(Vector::Unit(axis)),
                 constraints.motions(i, static_cast<std::size_t>(axis)), until, course);
    }
    if (!course.empty()) set_course(i, course);
  }
}

void Flight::impose(std::uint32_t node, const Vector& axis, std::span<const Motion* const> motions, double until,
                    Course& course) {
  if (motions.size() != 1 || !can_be_followed(*motions.front(), until)) return set_unknown(node);
  const Motion& motion = *motions.front();
  const std::array<double, 2> range = speeds_of(motion, 0, until);
  const bool constant = range[0] == range[1];
  v_[node] += ((constant ? range[0] : 0) - v_[node].dot(axis)) * axis;
  if (!constant) course.push_back({axis, &motion});
}

void Flight::set_unknown(std::uint32_t node) {
  unknown_.resize(v_.size(), false);
  if (!unknown_[node]) ++unknown_count_;
  unknown_[node] = true;
}

void Flight::set_course(std::uint32_t node, const Course& course) {
  course_.resize(v_.size(), no_position);
  // Nodes of one set follow each other; they share the last course or one near it.
  constexpr std::size_t looked_back = 8;
  for (std::size_t back = 0; back < std::min(looked_back, courses_.size()); ++back) {
    const std::size_t position = courses_.size() - 1 - back;
    if (courses_[position] != course) continue;
    course_[node] = static_cast<std::uint32_t>(position);
    return;
  }
  course_[node] = static_cast<std::uint32_t>(courses_.size());
  courses_.push_back(course);
}

bool Flight::any() const {
  return !courses_.empty() || unknown_count_ > 0 ||
         std::any_of(v_.begin(), v_.end(), [](const Vector& v) { return v != Vector::Zero(); });
}

Vector Flight::way(NodeIndex node, double time) const {
  Vector way = v_[node.value] * time;
  if (course(node) != no_position)
    for (const Term& term : courses_[course(node)]) way += way_of(*term.motion, time) * term.axis;
  return way;
}

Vector Flight::velocity(NodeIndex node, double time) const {
  Vector velocity = v_[node.value];
  if (course(node) != no_position)
    for (const Term& term : courses_[course(node)]) velocity += term.motion->velocity(time, 0) * term.axis;
  return velocity;
}

contact::Bounds Flight::ways(NodeIndex node, double until) const {
  contact::Bounds box;
  box.add(Vector::Zero());
  box.add(v_[node.value] * until);
  if (course(node) == no_position) return box;
  for (const Term& term : courses_[course(node)]) {
    const std::array<double, 2> range = ways_of(*term.motion, until);
    const Vector a = range[0] * term.axis, b = range[1] * term.axis;
    box.low += a.cwiseMin(b);
    box.high += a.cwiseMax(b);
  }
  return box;
}

double Flight::course_speed(std::uint32_t course, double from, double to) const {
  if (course == no_position) return 0;
  double squared = 0;
  for (const Term& term : courses_[course]) {
    const std::array<double, 2> range = speeds_of(*term.motion, from, to);
    squared += std::pow(std::max(-range[0], range[1]), 2);
  }
  return std::sqrt(squared);
}

double Flight::relative_speed(NodeIndex a, NodeIndex b, double from, double to) const {
  const double constant = (v_[a.value] - v_[b.value]).norm();
  if (course(a) == course(b)) return constant;
  return constant + course_speed(course(a), from, to) + course_speed(course(b), from, to);
}

}  // namespace gapcheck::solver
