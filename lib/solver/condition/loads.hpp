#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "model/entity/sets.hpp"
#include "solver/state/force.hpp"
#include "solver/state/motion.hpp"

namespace gapcheck::solver {

/// A value over time: scale times a curve that begins at `arrival`; zero before it.
struct TimedValue {
  std::shared_ptr<const TimeCurve> curve;
  double scale = 1, arrival = 0;
  [[nodiscard]] double at(double time) const {
    return time < arrival || curve == nullptr ? 0 : scale * curve->at(time - arrival);
  }
};

/// Forces and moments of given direction on nodes and on the centres of rigid bodies.
class ConcentratedLoads : public Force {
 public:
  /// The direction of one degree of freedom: 0 … 2 force, 3 … 5 moment.
  void add_node(NodeIndex node, std::size_t freedom, const TimedValue& value);
  void add_body(std::size_t body, std::size_t freedom, const TimedValue& value);
  /// A force, or moment, on a node or body that follows the normal of three nodes: (x₂ − x₁) × (x₃ − x₁).
  void follow(std::size_t target, bool body, bool moment, const std::array<NodeIndex, 3>& nodes,
              const TimedValue& value);
  void add(State& state, Forces& forces) override;

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
  void add(State& state, Forces& forces) override;

 private:
  std::vector<model::SegmentNodes> segments_;
  std::vector<std::uint32_t> value_of_;
  std::vector<TimedValue> values_;
};

/// Body forces of an accelerated frame: −a m on every mass.
class Gravity : public Force {
 public:
  /// `masses`: of the nodes, if it acts only on some parts; empty: all masses of the state, rigid bodies at their
  /// centres.
  explicit Gravity(std::vector<double> masses) : masses_(std::move(masses)) {}
  void add_axis(int axis, const TimedValue& value) { axes_.push_back({axis, value}); }
  void add(State& state, Forces& forces) override;

 private:
  struct Axis {
    int axis;
    TimedValue value;
  };
  std::vector<double> masses_;
  std::vector<Axis> axes_;
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

}  // namespace gapcheck::solver
