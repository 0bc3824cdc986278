#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/pair/hit.hpp"
#include "contact/pair/pair.hpp"
#include "geometry/follow.hpp"
#include "solver/contact/needed_pairs.hpp"
#include "solver/contact/pair_rest.hpp"
#include "solver/contact/pass_block.hpp"
#include "solver/contact/tracked_pairs.hpp"

namespace gapcheck::solver {

/// Position of a tracked node relative to the segment that counts.
struct SegmentContact {
  SegmentIndex segment;
  double s = 0, t = 0;             ///< of the closest point
  Vector way = Vector::Zero();     ///< from there to the node
  Vector normal = Vector::Zero();  ///< to the segment's free side; only used where `way` is zero
  double distance = 0;             ///< negative behind the segment
  bool on_face = false;            ///< the closest point lies inside the segment
  /// Unit vector to the free side.
  [[nodiscard]] Vector direction() const { return distance != 0 ? Vector(way / distance) : normal; }
};

/// Position of a tracked node relative to the segments of the other side.
struct NodeMeeting {
  std::optional<SegmentContact> contact;  ///< in the segment's band
  bool in_zone = false;                   ///< some segment is nearer than the contact distance
};

/// Working data of one thread.
struct FinderScratch {
  // Pairs of one node.
  std::vector<contact::Hit> hits, measured;
  std::vector<contact::PairResult> results;  ///< of the hits
  struct Decided {
    contact::Hit hit;
    contact::PairResult result;
  };
  std::vector<Decided> decided;  ///< not yet among these
  // Pairs of several nodes.
  geometry::FollowedPairs followed, single;
  std::size_t first = 0;                                               ///< place of the first of them
  std::array<std::size_t, geometry::FollowedPairs::capacity> lanes{};  ///< in `followed`, by place from `first` on
  void clear_hits() {
    hits.clear();
    measured.clear();
    results.clear();
  }
};

/// Finds the segment that counts for a tracked node. A node that stays inside its segment is followed from its position
/// in the last cycle: a proof that the segment is near enough, and one that no other segment counts. If a proof fails,
/// the node goes the long way: all candidates that may be near are decided. The result is the same. See
/// docs/theory/solver-contact.md.
class SegmentFinder {
 public:
  explicit SegmentFinder(TrackedPairs& pairs);

  /// Follows the pairs of the places [`first`, `last`), at most FollowedPairs::capacity of them. To be called before
  /// find_meeting() for these places.
  void follow_pairs(std::size_t first, std::size_t last, FinderScratch& scratch) const;
  /// Position of the node at a place relative to the segments; nothing if it still sleeps when `used` of the margin is
  /// used up. Sets how long the node and its candidates sleep.
  [[nodiscard]] std::optional<NodeMeeting> find_meeting(std::size_t place, double used, FinderScratch& scratch,
                                                        PairCounts& counts);

 private:
  /// Decides the candidates that may be near, and which segment counts.
  [[nodiscard]] NodeMeeting decide_candidates(std::size_t place, double used, FinderScratch& scratch,
                                              PairCounts& counts);
  /// How long all candidates of a node sleep, and whether it is in the zone of one that does.
  struct Sleep {
    double wake;
    bool inside = false;
  };
  /// Decides the candidates that are awake or needed and sets their sleep. Writes those that penetrate, and the other
  /// oriented segments, to `scratch`.
  Sleep decide_awake(SlotIndex slot, std::span<contact::Candidate> candidates, double used, FinderScratch& scratch,
                     PairCounts& counts);
  /// Decides one and sets its sleep and, unless null, its direction.
  void decide(SlotIndex slot, contact::Candidate& candidate, Vector* towards, double used,
              FinderScratch& scratch) const;
  /// Sorts what was decided into hits and other oriented segments.
  void take_decided(FinderScratch& scratch) const;
  [[nodiscard]] SegmentContact contact_of(SlotIndex slot, SegmentIndex segment, const contact::PairResult& pair) const;
  /// Takes the closest point that following the pair of the last cycle finds: whether the node was followed or decided
  /// the long way must not show in the last bit.
  void take_followed_point(SlotIndex slot, SegmentContact& contact, geometry::FollowedPairs& pairs) const;
  /// Whether a candidate counts instead of `segment` as soon as it is nearer.
  [[nodiscard]] bool comes_nearer(const contact::Candidate& candidate, SegmentIndex segment) const;
  /// Postpones waking candidates other than `segment` as far as the plane of their last decision separates them from
  /// the node; only those that may be nearer than `far`.
  void separate_others(SlotIndex slot, SegmentIndex segment, std::span<contact::Candidate> candidates, double used,
                       double far) const;
  /// The amount of used-up margin until which no other candidate can come as near as the chosen one; 0: none.
  [[nodiscard]] double lead_of(std::span<const contact::Candidate> candidates, const SegmentContact& chosen,
                               double used) const;
  /// True if probably only the pair of the last cycle counts.
  [[nodiscard]] bool may_follow(std::size_t place) const;
  /// True if no candidate other than that of the contact can count.
  [[nodiscard]] bool keeps_lead(std::size_t place, const SegmentContact& contact, double used);
  /// Sets the pair to follow in a lane: the node and the segment of its link, starting from the last closest point.
  void set_start(SlotIndex slot, geometry::FollowedPairs& pairs, std::size_t lane) const;
  /// The contact of a pair that was followed; nothing if it must be decided the long way.
  [[nodiscard]] std::optional<SegmentContact> prove_followed(SlotIndex slot, const geometry::FollowedPairs& pairs,
                                                             std::size_t lane) const;

  TrackedPairs& pairs_;
  const contact::PairScene& scene_;
  bool leads_;     ///< present leading segments lead until motion has used that up; not if thickness changes
  PairRest rest_;  ///< how long pairs sleep
};

}  // namespace gapcheck::solver
