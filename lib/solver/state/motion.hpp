#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace gapcheck::solver {

/// A quantity over time, linear between points, constant beyond them; zero without points.
class TimeCurve {
 public:
  using Point = std::array<double, 2>;  ///< time, value
  TimeCurve() = default;
  /// Times must not descend; of points at one time the last counts from then on.
  explicit TimeCurve(std::vector<Point> points);
  [[nodiscard]] double at(double time) const;
  /// Rate of change just after a time.
  [[nodiscard]] double slope(double time) const;
  /// Integral from the first point's time; before that negative for a positive value.
  [[nodiscard]] double integral(double time) const;
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  [[nodiscard]] double start() const { return points_.empty() ? 0 : points_.front()[0]; }

 private:
  /// The first point later than a time.
  [[nodiscard]] std::size_t after(double time) const;
  std::vector<Point> points_;
  std::vector<double> integral_;  ///< up to each point
};

/// When a curve is used, SIDR of *DEFINE_CURVE: in the run, or in the dynamic relaxation before it, or in both.
struct Phases {
  bool run = true, relaxation = false;
  [[nodiscard]] bool now(bool relaxing) const { return relaxing ? relaxation : run; }
  [[nodiscard]] bool meet(const Phases& other) const { return (run && other.run) || (relaxation && other.relaxation); }
};

/// Motion of a degree of freedom between birth and death, given by a curve of its velocity, acceleration or
/// displacement over time. With a birth above zero the curve begins at the birth.
struct Motion {
  enum class Quantity : std::uint8_t { velocity, acceleration, displacement };
  Quantity quantity = Quantity::velocity;
  std::shared_ptr<const TimeCurve> curve;
  double scale = 1;
  double birth = 0, death = std::numeric_limits<double>::infinity();
  double initial = 0;  ///< velocity at birth that an acceleration adds to
  Phases phases;
  bool support = false;   ///< its birth and death count in the run only; in a relaxation it acts all the time
  bool relaxing = false;  ///< the present phase

  Motion() = default;
  /// A velocity over time.
  explicit Motion(std::vector<TimeCurve::Point> velocity)
      : curve(std::make_shared<const TimeCurve>(std::move(velocity))) {}

  /// Whether it controls the step from `time` over dt, or with dt = 0 the velocity at `time`: what moves from the start
  /// has its velocity then, and does not jump to it in the first step.
  [[nodiscard]] bool active(double time, double dt) const {
    if (!phases.now(relaxing)) return false;
    if (relaxing && support) return true;
    return (dt > 0 ? time + dt > birth : time >= birth) && time < death;
  }
  /// The velocity of that step: for a displacement the mean, so that it is met at the step's end, otherwise that in its
  /// middle. dt = 0: at `time`.
  [[nodiscard]] double velocity(double time, double dt) const;
};

}  // namespace gapcheck::solver
