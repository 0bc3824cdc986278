#pragma once
#include <array>
#include <cstdint>
#include <functional>

#include "geometry/closest_point.hpp"
#include "model/contact/contact.hpp"
#include "model/entity/faces.hpp"
#include "solver/loss/flight.hpp"

namespace gapcheck::solver {

/// A node and a segment that move. References must outlive it.
struct MovingPair {
  geometry::Facet facet;  ///< corners at the start
  Vector point;           ///< of the node at the start
  NodeIndex node;
  model::SegmentNodes corners;
  bool line = false;            ///< a beam axis between the first two corners
  double contact_distance = 0;  ///< they meet where they are as near
  /// Whether a closest point counts for the segment; null: all do.
  std::function<bool(const geometry::ClosestPoint&)> counts;
};

/// When and how they meet.
struct TimeOfContact {
  enum class Kind : std::uint8_t {
    none,       ///< not before the end
    met,        ///< at `time`
    begun,      ///< nearer than the contact distance from the start on
    undecided,  ///< not before `time`, and after that it is not known
  } kind = Kind::none;
  double time = 0;
  Vector normal = Vector::Zero();    ///< unit vector from the segment to the node
  Vector velocity = Vector::Zero();  ///< of the node relative to the segment's point
  std::array<double, 4> weights{};   ///< of the segment's corners there
  std::uint32_t steps = 0;           ///< closest points that it took
  [[nodiscard]] double speed() const { return -velocity.dot(normal); }
};

/// The first time up to `until` at which the node is as near to the segment as the contact distance, by conservative
/// advancement: from a distance d the two cannot be nearer than h before (d - h) / (greatest relative speed), and with
/// constant velocities not before a corner reaches the plane at h across the shortest way. So no contact is missed, and
/// flat contact is met in one step. Nearer than h where nothing counts (beside the segment's band) time goes on in
/// steps of a small share of h. Source: Mirtich: Impulse-based dynamic simulation of rigid body systems, 1996.
[[nodiscard]] TimeOfContact time_of_contact(const Flight& flight, const MovingPair& pair, double until);

}  // namespace gapcheck::solver
