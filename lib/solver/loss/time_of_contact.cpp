#include "solver/loss/time_of_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/quad.hpp"

namespace gapcheck::solver {
namespace {

/// Two are in contact if their distance exceeds the contact distance by less than this share of it and of their size.
constexpr double of_distance = 1e-9, of_size = 1e-11;
/// Beside the band: steps of this share of the contact distance.
constexpr double beside_share = 1.0 / 16;
constexpr std::uint32_t most_steps = 2000;
constexpr int halvings = 60;

/// Follows one pair.
class Advancement {
 public:
  Advancement(const Flight& flight, const MovingPair& pair, double until)
      : flight_(flight), pair_(pair), until_(until), size_(0) {
    for (const Vector& corner : pair.facet.x) size_ = std::max(size_, (corner - pair.facet.x[0]).norm());
    tolerance_ = of_distance * pair.contact_distance + of_size * size_;
    for (std::size_t i = 0; i < corners(); ++i)
      steady_ = steady_ && flight.course(pair.corners[i]) == flight.course(pair.node);
  }

  TimeOfContact run() {
    double time = 0, beside = -1;
    while (result_.steps < most_steps) {
      look(time);
      const double gap = distance_ - pair_.contact_distance;
      if (gap > tolerance_) {
        beside = -1;
        const double step = std::max(by_speed(time, gap), by_plane(gap));
        if (!(time + step < until_)) return finish(TimeOfContact::Kind::none, until_);
        time += step;
        continue;
      }
      if (counts()) {
        if (time == 0 && gap < -tolerance_) return finish(TimeOfContact::Kind::begun, 0);
        return meet(beside >= 0 ? first_that_counts(beside, time) : time);
      }
      if (!(time < until_)) return finish(TimeOfContact::Kind::none, until_);
      beside = time;
      time = std::min(time + beside_step(time), until_);
    }
    return finish(TimeOfContact::Kind::undecided, time);
  }

 private:
  [[nodiscard]] std::size_t corners() const { return pair_.line ? 2 : 4; }

  void look(double time) {
    ++result_.steps;
    point_ = pair_.point + flight_.way(pair_.node, time);
    for (std::size_t i = 0; i < 4; ++i) facet_.x[i] = pair_.facet.x[i] + flight_.way(pair_.corners[i], time);
    facet_.triangle = pair_.facet.triangle;
    if (pair_.line) {
      const geometry::LineClosest line = geometry::closest_point_on_line(facet_.x[0], facet_.x[1], point_);
      closest_ = {};
      closest_.point = line.point;
      closest_.squared_distance = line.squared_distance;
      closest_.s = line.s;
      closest_.free_s = line.free_s;
      closest_.normal = Vector::Zero();
    } else {
      closest_ = geometry::closest_point(facet_, point_);
    }
    distance_ = std::sqrt(closest_.squared_distance);
    if (distance_ > of_size * size_) side_ = point_ - closest_.point;
    if (!std::isfinite(distance_)) distance_ = std::numeric_limits<double>::infinity();
  }

  [[nodiscard]] bool counts() const { return !pair_.counts || pair_.counts(closest_); }

  [[nodiscard]] double bound(double from, double to) const {
    double fastest = 0;
    for (std::size_t i = 0; i < corners(); ++i)
      fastest = std::max(fastest, flight_.relative_speed(pair_.node, pair_.corners[i], from, to));
    return fastest;
  }

  /// The greatest speed in the time that it takes, not in all that is left.
  [[nodiscard]] double by_speed(double time, double gap) const {
    double to = until_;
    for (int i = 0; i < 4; ++i) {
      const double fastest = bound(time, to), step = fastest > 0 ? gap / fastest : to - time;
      if (!(time + step < to)) return to - time;
      if (steady_ || time + 8 * step >= to) return step;
      to = time + 4 * step;
    }
    const double fastest = bound(time, to);
    return fastest > 0 ? std::min(gap / fastest, to - time) : to - time;
  }

  /// The segment lies in the hull of its corners: as long as all of these are beyond the plane at the contact distance,
  /// so is the segment.
  [[nodiscard]] double by_plane(double gap) const {
    if (!steady_ || !(distance_ > 0) || !std::isfinite(distance_)) return 0;
    const Vector way = (point_ - closest_.point) / distance_;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners(); ++i) {
      // Of a flat segment the closest point is as far as its corners; rounding must not make it less.
      const double beyond = way.dot(closest_.point - facet_.x[i]), ahead = gap + beyond;
      const double closing = way.dot(flight_.base(pair_.corners[i]) - flight_.base(pair_.node));
      if (!(ahead > 0)) return 0;
      if (closing > 0) least = std::min(least, ahead / closing);
    }
    return least;
  }

  /// How far time may go on beside the segment.
  [[nodiscard]] double beside_step(double time) const {
    const double fastest = bound(time, until_);
    const double length = beside_share * std::max(pair_.contact_distance, of_size * size_);
    return fastest > 0 ? std::max(length / fastest, until_ / most_steps) : until_;
  }

  double first_that_counts(double before, double after) {
    for (int i = 0; i < halvings && before < after; ++i) {
      const double middle = before + (after - before) / 2;
      if (middle == before || middle == after) break;
      look(middle);
      (distance_ - pair_.contact_distance <= tolerance_ && counts() ? after : before) = middle;
    }
    look(after);
    return after;
  }

  TimeOfContact meet(double time) {
    // On the surface itself the node is where it has come from.
    result_.normal = side_.stableNormalized();
    if (!(distance_ > of_size * size_) && closest_.normal != Vector::Zero())
      result_.normal = side_.dot(closest_.normal) < 0 ? Vector(-closest_.normal) : closest_.normal;
    result_.weights = pair_.line ? std::array<double, 4>{(1 - closest_.s) / 2, (1 + closest_.s) / 2, 0, 0}
                                 : quad_weights(closest_.s, closest_.t);
    result_.velocity = flight_.velocity(pair_.node, time);
    for (std::size_t i = 0; i < 4; ++i)
      if (result_.weights[i] != 0) result_.velocity -= result_.weights[i] * flight_.velocity(pair_.corners[i], time);
    return finish(TimeOfContact::Kind::met, time);
  }

  TimeOfContact finish(TimeOfContact::Kind kind, double time) {
    result_.kind = kind;
    result_.time = time;
    return result_;
  }

  const Flight& flight_;
  const MovingPair& pair_;
  double until_, size_, tolerance_ = 0;
  bool steady_ = true;  ///< the relative velocities do not change
  TimeOfContact result_;
  Vector point_ = Vector::Zero();
  geometry::Facet facet_;
  geometry::ClosestPoint closest_;
  double distance_ = 0;
  Vector side_ = Vector::Zero();  ///< from the segment to the node, when they were last apart
};

}  // namespace

TimeOfContact time_of_contact(const Flight& flight, const MovingPair& pair, double until) {
  return Advancement(flight, pair, until).run();
}

}  // namespace gapcheck::solver
