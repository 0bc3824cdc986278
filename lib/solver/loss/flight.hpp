#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "contact/search/search.hpp"
#include "solver/state/motion.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// Velocities at the start of a run, before its first forces.
struct StartMotion {
  std::vector<Vector> v;          ///< by node
  std::vector<BodyState> bodies;  ///< as State::bodies
  explicit StartMotion(const State& state);
};

/// The motion of all nodes along straight lines, as if no force acted on them: with their initial velocity, or as their
/// prescribed velocity or displacement says. Nodes of turning bodies go straight on.
class Flight {
 public:
  /// Nodes with these constant velocities.
  explicit Flight(std::vector<Vector> v) : v_(std::move(v)) {}
  /// The nodes of a structure up to a time. Both references must outlive it.
  Flight(const Structure& structure, const StartMotion& start, double until);

  /// Something moves.
  [[nodiscard]] bool any() const;
  /// Nodes whose motion is not followed: prescribed accelerations and rotations, motions that begin or end on the way.
  [[nodiscard]] std::uint64_t unknown() const { return unknown_count_; }
  [[nodiscard]] bool known(NodeIndex node) const { return unknown_.empty() || !unknown_[node.value]; }
  /// The velocity does not change.
  [[nodiscard]] bool steady(NodeIndex node) const { return course(node) == no_position && known(node); }
  /// Two nodes move in the same way.
  [[nodiscard]] bool alike(NodeIndex a, NodeIndex b) const {
    return v_[a.value] == v_[b.value] && course(a) == course(b);
  }
  /// The constant part of the velocity, and what is added to it; no_position: nothing.
  [[nodiscard]] const Vector& base(NodeIndex node) const { return v_[node.value]; }
  [[nodiscard]] std::uint32_t course(NodeIndex node) const {
    return course_.empty() ? no_position : course_[node.value];
  }
  /// From the start to a time.
  [[nodiscard]] Vector way(NodeIndex node, double time) const;
  [[nodiscard]] Vector velocity(NodeIndex node, double time) const;
  /// The box of all ways up to a time.
  [[nodiscard]] contact::Bounds ways(NodeIndex node, double until) const;
  /// An upper bound of the speed between two times.
  [[nodiscard]] double greatest_speed(NodeIndex node, double from, double to) const {
    return v_[node.value].norm() + course_speed(course(node), from, to);
  }
  /// An upper bound of the relative speed of two nodes between two times.
  [[nodiscard]] double relative_speed(NodeIndex a, NodeIndex b, double from, double to) const;

 private:
  /// A prescribed velocity or displacement along an axis.
  struct Term {
    Vector axis;
    const Motion* motion;
    bool operator==(const Term&) const = default;
  };
  using Course = std::vector<Term>;
  /// Takes a degree of freedom out of the constant velocity and gives it its motion.
  void impose(std::uint32_t node, const Vector& axis, std::span<const Motion* const> motions, double until,
              Course& course);
  void set_unknown(std::uint32_t node);
  void set_course(std::uint32_t node, const Course& course);
  [[nodiscard]] double course_speed(std::uint32_t course, double from, double to) const;

  std::vector<Vector> v_;
  std::vector<Course> courses_;
  std::vector<std::uint32_t> course_;  ///< by node; empty: all velocities are constant
  std::vector<bool> unknown_;          ///< by node; empty: all are known
  std::uint64_t unknown_count_ = 0;
};

/// The way of a prescribed velocity or displacement from the start to a time, and its velocity then.
[[nodiscard]] double way_of(const Motion& motion, double time);
/// The least and the greatest velocity between two times.
[[nodiscard]] std::array<double, 2> speeds_of(const Motion& motion, double from, double to);
/// The least and the greatest way up to a time.
[[nodiscard]] std::array<double, 2> ways_of(const Motion& motion, double until);

}  // namespace gapcheck::solver
