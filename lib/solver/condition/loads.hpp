#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "model/entity/sets.hpp"
#include "solver/state/force.hpp"
#include "solver/state/motion.hpp"

namespace gapcheck::solver {

/// A value over time: scale times a curve that begins at `arrival`; zero before it, and in phases without the curve.
struct TimedValue {
  std::shared_ptr<const TimeCurve> curve;
  double scale = 1, arrival = 0;
  Phases phases{};
  [[nodiscard]] double at(const State& state) const {
    const bool silent = state.time < arrival || curve == nullptr || !phases.now(state.relaxing);
    return silent ? 0 : scale * curve->at(state.time - arrival);
  }
};

/// Forces and moments of given direction on nodes and on the centres of rigid bodies.
class ConcentratedLoads : public Force {
 public:
  /// The direction of one degree of freedom: 0 … 2 force, 3 … 5 moment.
  void add_node(NodeIndex node, std::size_t freedom, const TimedValue& value);
  void add_body(std::size_t body, std::size_t freedom, const TimedValue& value);
  /// A force, or moment, on a node or body that follows the normal of three nodes: (x₂ − x₁) × (x₃ − x₁).
  void follow_normal(std::size_t target, bool body, bool moment, const std::array<NodeIndex, 3>& nodes,
                     const TimedValue& value);
  void add(State& state, Forces& forces) override { add_at(state, forces); }
  void add_at(const State& state, Forces& forces) const;
  /// Nodes, or rigid bodies, that it acts on, each once, ascending.
  [[nodiscard]] std::vector<std::uint32_t> targets(bool bodies) const;

 private:
  struct Entry {
    std::uint32_t target;
    std::uint8_t freedom;
    bool body;
    std::uint32_t value;
  };
  struct Follower {
    std::uint32_t target;
    bool body, moment;
    std::array<NodeIndex, 3> nodes;
    std::uint32_t value;
  };
  std::vector<Entry> entries_;
  std::vector<Follower> followers_;
  std::vector<TimedValue> values_;
};

/// Pressures on segments in their current position. Positive: against the normal that the order of the nodes gives by
/// the right-hand rule, into the segment. p A / 4 goes to each corner (p A / 3 of a triangle), where A is half the
/// cross product of the diagonals, so a closed surface has no resultant.
class Pressures : public Force {
 public:
  void add_segment(const model::SegmentNodes& nodes, const TimedValue& value);
  void add(State& state, Forces& forces) override { add_at(state, forces); }
  void add_at(const State& state, Forces& forces) const;
  /// Nodes that it acts on, each once, ascending.
  [[nodiscard]] std::vector<std::uint32_t> nodes() const;

 private:
  std::vector<model::SegmentNodes> segments_;
  std::vector<std::uint32_t> value_of_;
  std::vector<TimedValue> values_;
};

/// Body forces of an accelerated frame: −a m on every mass; and of one that turns about an axis: m ω² r away from it,
/// at the present places (no Euler and Coriolis forces; Keyword User's Manual, Vol. I, *LOAD_BODY).
class Gravity : public Force {
 public:
  /// `masses`: of the nodes, if it acts only on some parts; empty: all masses of the state, rigid bodies at their
  /// centres.
  explicit Gravity(std::vector<double> masses) : masses_(std::move(masses)) {}
  void add_axis(int axis, const TimedValue& value) { axes_.push_back({axis, value}); }
  /// Along a direction of length 1.
  void add_direction(const Vector& direction, const TimedValue& value) { directions_.push_back({direction, value}); }
  /// Turns with the value of `rate` about an axis through `center`.
  void add_rotation(int axis, const Vector& center, const TimedValue& rate) {
    rotations_.push_back({axis, rate, center});
  }
  void add(State& state, Forces& forces) override;

 private:
  struct Axis {
    int axis;
    TimedValue value;
  };
  struct Direction {
    Vector along;
    TimedValue value;
  };
  struct Rotation {
    int axis;
    TimedValue rate;
    Vector center;
  };
  void add_one(const Rotation& rotation, const State& state, Forces& forces) const;
  std::vector<double> masses_;
  std::vector<Axis> axes_;
  std::vector<Direction> directions_;
  std::vector<Rotation> rotations_;
};

/// −D m v on nodes, −D J ω on their rotations, −D M V and −D L on rigid bodies, with the velocities of the step that
/// led here: a free mass has v⁺ = (1 − D dt) v⁻.
class GlobalDamping : public Force {
 public:
  GlobalDamping(TimedValue constant, const std::array<double, 6>& factors)
      : constant_(std::move(constant)),
        move_(factors[0], factors[1], factors[2]),
        turn_(factors[3], factors[4], factors[5]) {}
  void add(State& state, Forces& forces) override;
  void absorbed(Absorbed& work) const override { work.damping += work_; }
  [[nodiscard]] double stable_step() const override { return stable_step_; }

 private:
  TimedValue constant_;
  Vector move_, turn_;
  double work_ = 0;
  double stable_step_ = std::numeric_limits<double>::infinity();
  Forces last_;  ///< at the start of the step that led here
};

/// The same with a constant for each of some parts: on the masses that their elements give to nodes, and on rigid
/// bodies. With a frame, a rigid body, velocities are relative to its motion at their place; it feels no reaction, and
/// the work of its motion against the damping is external.
class PartDampings : public Force {
 public:
  /// `masses`: of the parts, by node.
  void add_part(const TimedValue& constant, const std::array<double, 6>& factors, const std::vector<double>& masses,
                std::vector<std::size_t> bodies, std::optional<std::size_t> frame = std::nullopt);
  void add(State& state, Forces& forces) override;
  void absorbed(Absorbed& work) const override { work.damping += work_; }
  [[nodiscard]] double stable_step() const override { return stable_step_; }

 private:
  struct Node {
    std::uint32_t node;
    double mass;
    Vector force = Vector::Zero(), moment = Vector::Zero();  ///< at the start of the step that led here
  };
  struct Body {
    std::size_t body;
    Vector force = Vector::Zero(), moment = Vector::Zero();
  };
  struct Entry {
    TimedValue constant;
    Vector move, turn;
    std::vector<Node> nodes;
    std::vector<Body> bodies;
    std::optional<std::size_t> frame;
  };
  std::vector<Entry> entries_;
  double work_ = 0;
  double stable_step_ = std::numeric_limits<double>::infinity();
};

}  // namespace gapcheck::solver
