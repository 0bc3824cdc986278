#pragma once
#include "contact/pair/candidates.hpp"
#include "contact/pair/pair.hpp"
#include "solver/contact/tracked_pairs.hpp"

namespace gapcheck::solver {

/// How long a pair that has been decided may rest, since it can neither touch nor change what other pairs of its node
/// mean. Bounds of motion are those of MarginUse: how far anything comes closer to anything else. See
/// docs/theory/solver-contact.md, "What is left out".
class PairRest {
 public:
  /// `follows_motion`: nothing but the motion of nodes changes distances and thicknesses.
  PairRest(const TrackedPairs& pairs, bool follows_motion);

  /// Sets the sleep of a pair that was decided when `used` of the margin was used up.
  void set_rest(contact::Candidate& candidate, SlotIndex slot, const contact::PairResult& pair, double used) const;
  /// Sets the sleep of a pair that awakes, without a decision, if it needs none: segment and node have no thickness,
  /// and the node is still in front.
  [[nodiscard]] bool rests_on(contact::Candidate& candidate, SlotIndex slot, double used) const;

 private:
  struct Rest {
    double motion = 0;
    contact::Candidate::Zone zone = contact::Candidate::Zone::outside;
  };
  /// Of a pair that penetrates.
  [[nodiscard]] Rest of_hit(SlotIndex slot, SegmentIndex segment, const contact::PairResult& pair) const;
  /// Of a pair that does not.
  [[nodiscard]] Rest of_gap(SlotIndex slot, SegmentIndex segment, const contact::PairResult& pair) const;
  /// Bounds by the shape of the segment hold.
  [[nodiscard]] bool has_shape(SegmentIndex segment) const;
  /// How far the two may move before the node is level with the segment.
  [[nodiscard]] double motion_in_front(SlotIndex slot, SegmentIndex segment) const;
  /// How far the two may move before the projection enters the segment's band.
  [[nodiscard]] double motion_outside(SlotIndex slot, SegmentIndex segment, const contact::PairResult& pair) const;

  const TrackedPairs& pairs_;
  const contact::PairScene& scene_;
  bool follows_motion_;
};

}  // namespace gapcheck::solver
