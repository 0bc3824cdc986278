#include "solver/contact/pair_rest.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/front_side.hpp"
#include "geometry/outside_band.hpp"

namespace gapcheck::solver {

using contact::Candidate;
using contact::PairResult;

namespace {

/// Room for rounding in bounds of a distance.
constexpr double distance_slack = 1e-8;

}  // namespace

PairRest::PairRest(const TrackedPairs& pairs, bool follows_motion)
    : pairs_(pairs), scene_(pairs.scene()), follows_motion_(follows_motion) {}

bool PairRest::has_shape(SegmentIndex segment) const {
  const bool shifted = !scene_.segments.offset.empty() && scene_.segments.offset[segment.value] != 0;
  return follows_motion_ && !shifted && !scene_.line(segment) && !scene_.type.by_segments();
}

double PairRest::motion_outside(SlotIndex slot, SegmentIndex segment, const PairResult& pair) const {
  const geometry::Facet facet = scene_.facet(segment);
  const Vector at = scene_.position(slot);
  return geometry::motion_outside_band({facet, at, pair.closest.point, pairs_.reach(slot, segment)});
}

double PairRest::motion_in_front(SlotIndex slot, SegmentIndex segment) const {
  const bool flipped = !scene_.flipped.empty() && scene_.flipped[segment.value];
  return geometry::motion_in_front(scene_.facet(segment), scene_.position(slot), flipped ? -1 : 1);
}

bool PairRest::rests_on(Candidate& candidate, SlotIndex slot, double used) const {
  const SegmentIndex segment = candidate.segment;
  if (scene_.nodes.half[slot.value] > 0 || scene_.segments.half[segment.value] > 0) return false;
  if (!scene_.oriented(segment) || !has_shape(segment)) return false;
  const double motion = motion_in_front(slot, segment);
  if (!(motion > 0)) return false;
  candidate.wake = used + motion;
  candidate.zone = Candidate::Zone::outside;
  return true;
}

PairRest::Rest PairRest::of_hit(SlotIndex slot, SegmentIndex segment, const PairResult& pair) const {
  if (pair.in_band || !has_shape(segment)) return {};
  // Where a segment has a back, the node may get behind it, where another distance counts.
  if (scene_.oriented(segment)) return {motion_outside(slot, segment, pair), Candidate::Zone::unknown};
  const double bound = contact::penetration_bound(scene_, slot, segment, scene_.facet(segment), scene_.position(slot));
  const double in_zone = bound * (1 - distance_slack) - pair.distance;
  return {in_zone > 0 ? std::min(in_zone, motion_outside(slot, segment, pair)) : 0, Candidate::Zone::inside};
}

PairRest::Rest PairRest::of_gap(SlotIndex slot, SegmentIndex segment, const PairResult& pair) const {
  const double out_of_reach = std::abs(pair.distance) - pairs_.reach(slot, segment);
  if (out_of_reach > 0 || !scene_.oriented(segment) || !has_shape(segment)) return {out_of_reach};
  const double half = scene_.nodes.half[slot.value] + scene_.segments.half[segment.value];
  // A face looks as far behind itself as its own solid reaches, whatever others do.
  if (scene_.segments.kind[segment.value] == contact::SegmentKind::solid)
    if (const double motion = std::abs(pair.distance) * (1 - distance_slack) - std::max(half, scene_.behind(segment));
        motion > 0)
      return {motion};
  // A node in front stays there until it is level with the segment.
  if (pair.distance > half) {
    const double apart = pair.distance * (1 - distance_slack) - half;
    if (const double motion = std::min(motion_in_front(slot, segment), apart); motion > 0) return {motion};
  }
  return {pair.in_band ? 0 : motion_outside(slot, segment, pair), Candidate::Zone::unknown};
}

void PairRest::set_rest(Candidate& candidate, SlotIndex slot, const PairResult& pair, double used) const {
  const Rest rest = pair.penetrates ? of_hit(slot, candidate.segment, pair) : of_gap(slot, candidate.segment, pair);
  candidate.apart = used + std::abs(pair.distance);
  candidate.wake = used + rest.motion;
  candidate.zone = rest.motion > 0 ? rest.zone : Candidate::Zone::outside;
}

}  // namespace gapcheck::solver
