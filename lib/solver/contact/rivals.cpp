#include "solver/contact/rivals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/pair/hit.hpp"

namespace gapcheck::solver {

using contact::Candidate;
using geometry::FollowedPairs;
using geometry::NearPlace;

namespace {

/// Another segment must be farther away by this share of the distance, which is far more than what choose_hit() treats
/// as equally near; sums in doubles are trusted up to this share.
constexpr double lead_slack = 1e-8, rounding_share = 1e-13;
/// Of rivals it is asked on which side of choose_hit()'s bound they lie, with this share of it for rounding.
constexpr double tie_slack = 0.02 * contact::equally_near;
/// Candidates that count at the earliest when motion has used up this share of the distance are not rivals.
constexpr double rival_share = 0.02;
constexpr std::size_t most_rivals = 24;
/// For segments farther away than this many times the one that counts, the exact distance does not matter.
constexpr double far_away = 1.5;
constexpr double anywhere = std::numeric_limits<double>::infinity();

}  // namespace

bool Rivals::rests_apart(const Candidate& candidate, const SegmentContact& chosen) const {
  // What rests penetrates nothing, or is out of its band. But a node is behind the nearest oriented segment alone.
  return !std::signbit(chosen.distance) || !scene_.oriented(candidate.segment);
}

double Rivals::raise(SlotIndex slot, Candidate& candidate, const NearPlace& nearest, double used) const {
  const double bound = geometry::distance_bound(scene_.facet(candidate.segment), scene_.position(slot), nearest);
  candidate.apart = std::max(candidate.apart, used + bound);
  if (candidate.zone == Candidate::Zone::outside)
    candidate.wake = std::max(candidate.wake, candidate.apart - pairs_.reach(slot, candidate.segment));
  return bound;
}

void Rivals::raise_all(SlotIndex slot, const SegmentContact& chosen, std::span<Candidate> candidates, double used,
                       double far) const {
  const std::vector<NearPlace>& nearest = pairs_.node(slot).nearest;
  if (nearest.size() != candidates.size()) return;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    Candidate& candidate = candidates[i];
    if (candidate.segment == chosen.segment || candidate.apart - used > far) continue;
    if (candidate.wake > used && rests_apart(candidate, chosen)) continue;
    raise(slot, candidate, nearest[i], used);
  }
}

double Rivals::lead_over(const Candidate& candidate, const SegmentContact& chosen, double used) const {
  const double gap = candidate.apart - used - std::abs(chosen.distance) * (1 + lead_slack) -
                     rounding_share * (used + pairs_.greatest_reach());
  // One distance may grow by what the other one loses.
  const double by_distance = used + gap / 2;
  return rests_apart(candidate, chosen) ? std::max(by_distance, candidate.wake) : by_distance;
}

void Rivals::choose(SlotIndex slot, std::span<const Candidate> candidates, const SegmentContact& chosen,
                    double used) const {
  TrackedNode& tracked = pairs_.touch(slot);
  const double soon = used + rival_share * std::abs(chosen.distance);
  tracked.rivals.clear();
  tracked.lead = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].segment == chosen.segment) continue;
    const double until = lead_over(candidates[i], chosen, used);
    if (until > soon)
      tracked.lead = std::min(tracked.lead, until);
    else
      tracked.rivals.push_back(i);
  }
  if (tracked.rivals.size() <= most_rivals) return;
  tracked.rivals.clear();
  tracked.lead = 0;
}

double Rivals::followed_distance(SlotIndex slot, SegmentIndex segment, NearPlace& nearest, FollowedPairs& pairs) const {
  if (!nearest.known || nearest.feature != Feature::face) return -1;
  pairs.set(0, scene_.facet(segment), scene_.position(slot));
  pairs.s[0] = nearest.s;
  pairs.t[0] = nearest.t;
  geometry::follow(pairs, 1);
  if (!(pairs.settled[0] > 0)) return -1;
  nearest.s = pairs.s[0];
  nearest.t = pairs.t[0];
  return std::sqrt(pairs.squared_distance[0]) - geometry::distance_rounding * pairs.size[0];
}

bool Rivals::one_stays_behind(SlotIndex slot, Candidate& rival, NearPlace& nearest, const SegmentContact& chosen,
                              double used, FollowedPairs& pairs) const {
  if (rival.wake > used && rests_apart(rival, chosen)) return true;
  // Of equally near segments the first one counts.
  const double tie =
      rival.segment < chosen.segment ? contact::equally_near + tie_slack : tie_slack - contact::equally_near;
  const double farther = std::abs(chosen.distance) * (1 + tie) + chosen.rounding;
  if (rival.apart - used > farther + rounding_share * used || raise(slot, rival, nearest, used) > farther) return true;
  if (followed_distance(slot, rival.segment, nearest, pairs) > farther) return true;
  // A node that presses on one segment does not slide along another.
  return scene_.slides(slot, rival.segment, anywhere);
}

bool Rivals::stay_behind(std::size_t place, const SegmentContact& chosen, double used, FollowedPairs& pairs) {
  const SlotIndex slot = pairs_.slot_at(place);
  TrackedNode& tracked = pairs_.touch(slot);
  const std::span<Candidate> candidates = pairs_.candidates_at(place);
  if (tracked.nearest.size() != candidates.size()) return false;
  if (!(tracked.lead > used)) {
    raise_all(slot, chosen, candidates, used, far_away * std::abs(chosen.distance));
    choose(slot, candidates, chosen, used);
    if (!(tracked.lead > used)) return false;
  }
  return std::ranges::all_of(tracked.rivals, [&](std::uint32_t i) {
    return one_stays_behind(slot, candidates[i], tracked.nearest[i], chosen, used, pairs);
  });
}

}  // namespace gapcheck::solver
