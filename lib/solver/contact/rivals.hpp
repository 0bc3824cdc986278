#pragma once
#include <span>

#include "contact/pair/candidates.hpp"
#include "geometry/follow.hpp"
#include "geometry/near_place.hpp"
#include "solver/contact/tracked_pairs.hpp"

namespace gapcheck::solver {

/// Position of a tracked node relative to the segment that counts.
struct SegmentContact {
  SegmentIndex segment;
  double s = 0, t = 0;             ///< of the closest point
  Vector way = Vector::Zero();     ///< from there to the node
  Vector normal = Vector::Zero();  ///< to the segment's free side; only used where `way` is zero
  double distance = 0;             ///< negative behind the segment
  double rounding = 0;             ///< bound of the error of `distance`
  bool on_face = false;            ///< the closest point lies inside the segment
  /// Unit vector to the free side.
  [[nodiscard]] Vector direction() const { return distance != 0 ? Vector(way / distance) : normal; }
};

/// Proofs that no candidate of a node counts instead of the segment that it touches, without a decision: those that are
/// far enough behind it for some time are left alone, the others are rivals. See docs/theory/solver-contact.md, "Nodes
/// that are followed".
class Rivals {
 public:
  explicit Rivals(TrackedPairs& pairs) : pairs_(pairs), scene_(pairs.scene()) {}

  /// Sets lead and rivals of a node whose candidates have just been decided. No lead: there are too many rivals.
  void choose(SlotIndex slot, std::span<const contact::Candidate> candidates, const SegmentContact& chosen,
              double used) const;
  /// True if no candidate of the node at a place counts instead of the chosen one. `pairs`: room for one.
  [[nodiscard]] bool stay_behind(std::size_t place, const SegmentContact& chosen, double used,
                                 geometry::FollowedPairs& pairs);

 private:
  /// True if a candidate that rests cannot count instead of the chosen one.
  [[nodiscard]] bool rests_apart(const contact::Candidate& candidate, const SegmentContact& chosen) const;
  /// Raises how far a candidate is away at least, and postpones its waking, by what geometry::distance_bound() proves.
  /// Returns that bound.
  double raise(SlotIndex slot, contact::Candidate& candidate, const geometry::NearPlace& nearest, double used) const;
  /// raise() for all candidates that may be nearer than `far`.
  void raise_all(SlotIndex slot, const SegmentContact& chosen, std::span<contact::Candidate> candidates, double used,
                 double far) const;
  /// The amount of used-up margin until which a candidate does not count instead of the chosen one.
  [[nodiscard]] double lead_over(const contact::Candidate& candidate, const SegmentContact& chosen, double used) const;
  /// The distance from a segment whose closest point lay inside it, if it still does; else negative.
  [[nodiscard]] double followed_distance(SlotIndex slot, SegmentIndex segment, geometry::NearPlace& nearest,
                                         geometry::FollowedPairs& pairs) const;
  /// True if a rival does not count instead of the chosen one at present. Keeps `nearest` up to date.
  [[nodiscard]] bool one_stays_behind(SlotIndex slot, contact::Candidate& rival, geometry::NearPlace& nearest,
                                      const SegmentContact& chosen, double used, geometry::FollowedPairs& pairs) const;

  TrackedPairs& pairs_;
  const contact::PairScene& scene_;
};

}  // namespace gapcheck::solver
