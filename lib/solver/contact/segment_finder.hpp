#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/pair/hit.hpp"
#include "contact/pair/pair.hpp"
#include "geometry/follow.hpp"
#include "geometry/near_place.hpp"
#include "solver/contact/needed_pairs.hpp"
#include "solver/contact/pair_rest.hpp"
#include "solver/contact/pass_block.hpp"
#include "solver/contact/rivals.hpp"
#include "solver/contact/tracked_pairs.hpp"

namespace gapcheck::solver {

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

/// Finds the segment that counts for a tracked node. A node in contact is followed: its segment is looked at alone,
/// from its position in the last cycle where it lies inside the segment, and a bound proves for each other candidate
/// that it does not count. If a proof fails, the node goes the long way: all candidates that may be near are decided.
/// The result is the same. See docs/theory/solver-contact.md.
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
  /// Asks the processor for what find_meeting() will read at a place, whose node's state it has been asked for. No
  /// other thread may be at that place.
  void prefetch_place(std::size_t place) const;

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
  /// Decides one and sets its sleep and, unless null, where it is nearest.
  void decide(SlotIndex slot, contact::Candidate& candidate, geometry::NearPlace* nearest, double used,
              FinderScratch& scratch) const;
  /// Sorts what was decided into hits and other oriented segments.
  void take_decided(FinderScratch& scratch) const;
  [[nodiscard]] SegmentContact contact_of(SlotIndex slot, SegmentIndex segment, const contact::PairResult& pair) const;
  /// Takes the closest point that following the pair of the last cycle finds: whether the node was followed or decided
  /// the long way must not show in the last bit.
  void take_followed_point(SlotIndex slot, SegmentContact& contact, geometry::FollowedPairs& pairs) const;
  /// True if probably the pair of the last cycle counts.
  [[nodiscard]] bool may_follow(std::size_t place) const;
  /// Decides the pair of the last cycle; nothing if the node must go the long way.
  [[nodiscard]] std::optional<SegmentContact> decide_last(SlotIndex slot) const;
  /// Sets the pair to follow in a lane: the node and the segment of its link, starting from the last closest point.
  void set_start(SlotIndex slot, geometry::FollowedPairs& pairs, std::size_t lane) const;
  /// Sets the contact of a pair that was followed; false: it must be decided the long way.
  [[nodiscard]] bool prove_followed(SlotIndex slot, const geometry::FollowedPairs& pairs, std::size_t lane,
                                    SegmentContact& contact) const;

  TrackedPairs& pairs_;
  const contact::PairScene& scene_;
  bool leads_;  ///< leading segments lead until motion has used that up; not if thickness changes
  Rivals rivals_;
  PairRest rest_;  ///< how long pairs sleep
};

}  // namespace gapcheck::solver
