#include "solver/contact/segment_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/prefetch.hpp"
#include "geometry/view.hpp"

namespace gapcheck::solver {

using contact::Candidate;
using contact::Hit;
using contact::PairResult;
using geometry::FollowedPairs;
using geometry::NearPlace;

namespace {

constexpr std::size_t not_followed = FollowedPairs::capacity;

}  // namespace

SegmentFinder::SegmentFinder(TrackedPairs& pairs)
    : pairs_(pairs),
      scene_(pairs.scene()),
      leads_(scene_.mode == geometry::Mode::filtered && !(scene_.contact.airbag_thickness > 0)),
      rivals_(pairs),
      rest_(pairs, leads_) {}

void SegmentFinder::follow_pairs(std::size_t first, std::size_t last, FinderScratch& scratch) const {
  scratch.first = first;
  std::size_t count = 0;
  for (std::size_t place = first; place < last; ++place) {
    std::size_t& lane = scratch.lanes[place - first];
    lane = not_followed;
    if (!may_follow(place)) continue;
    const TrackedNode& tracked = pairs_.node(pairs_.slot_at(place));
    if (!tracked.rivals.empty()) prefetch(tracked.rivals.data());
    if (!tracked.link.on_face) continue;
    lane = count++;
    set_start(pairs_.slot_at(place), scratch.followed, lane);
  }
  geometry::follow(scratch.followed, count);
}

void SegmentFinder::prefetch_place(std::size_t place) const {
  if (!may_follow(place)) return;
  const std::span<Candidate> candidates = pairs_.candidates_at(place);
  for (const std::uint32_t rival : pairs_.node(pairs_.slot_at(place)).rivals)
    if (rival < candidates.size()) prefetch(&candidates[rival]);
}

std::optional<NodeMeeting> SegmentFinder::find_meeting(std::size_t place, double used, FinderScratch& scratch,
                                                       PairCounts& counts) {
  const SlotIndex slot = pairs_.slot_at(place);
  const std::size_t lane = scratch.lanes[place - scratch.first];
  std::optional<NodeMeeting> meeting(std::in_place);
  meeting->in_zone = true;
  std::optional<SegmentContact>& contact = meeting->contact;
  if (lane != not_followed) {
    if (!prove_followed(slot, scratch.followed, lane, contact.emplace())) contact.reset();
  } else if (may_follow(place)) {
    contact = decide_last(slot);
  }
  if (contact && rivals_.stay_behind(place, *contact, used, scratch.single)) {
    ++counts.nodes;
    ++counts.pairs;
    ++counts.followed;
  } else if (pairs_.sleep(place) > used && !pairs_.node(slot).active) {
    ++counts.asleep;
    meeting.reset();
  } else {
    meeting.emplace(decide_candidates(place, used, scratch, counts));
  }
  return meeting;
}

NodeMeeting SegmentFinder::decide_candidates(std::size_t place, double used, FinderScratch& scratch,
                                             PairCounts& counts) {
  const SlotIndex slot = pairs_.slot_at(place);
  const std::span<Candidate> candidates = pairs_.candidates_at(place);
  const Sleep sleep = decide_awake(slot, candidates, used, scratch, counts);
  NodeMeeting meeting;
  meeting.in_zone = !scratch.hits.empty() || sleep.inside;
  TrackedNode* const known = pairs_.known(slot);
  // A node beside segments sleeps only if it has no memory that the zone keeps.
  const bool may_sleep = scratch.hits.empty() && (!sleep.inside || known == nullptr || known->at_rest());
  pairs_.set_sleep(place, may_sleep ? sleep.wake : 0);
  if (known != nullptr) known->lead = 0;
  if (scratch.hits.empty()) return meeting;
  const std::optional<Hit> hit = contact::choose_hit(scene_, scratch.hits, scratch.measured);
  if (!hit || !hit->in_band) return meeting;
  const auto same = [&](const Hit& other) { return other.segment == hit->segment; };
  const auto at = std::find_if(scratch.hits.begin(), scratch.hits.end(), same) - scratch.hits.begin();
  SegmentContact& contact =
      meeting.contact.emplace(contact_of(slot, hit->segment, scratch.results[static_cast<std::size_t>(at)]));
  take_followed_point(slot, contact, scratch.single);
  if (leads_) rivals_.choose(slot, candidates, contact, used);
  return meeting;
}

void SegmentFinder::decide(SlotIndex slot, Candidate& candidate, NearPlace* nearest, double used,
                           FinderScratch& scratch) const {
  const SegmentIndex s = candidate.segment;
  const PairResult pair = contact::decide_pair(scene_, slot, s);
  rest_.set_rest(candidate, slot, pair, used);
  if (nearest != nullptr) *nearest = geometry::place_of(pair.closest);
  scratch.decided.push_back({{slot, s, pair.distance, pair.in_band}, pair});
}

void SegmentFinder::take_decided(FinderScratch& scratch) const {
  for (const FinderScratch::Decided& decided : scratch.decided) {
    if (decided.result.penetrates) {
      scratch.hits.push_back(decided.hit);
      scratch.results.push_back(decided.result);
    } else if (scene_.oriented(decided.hit.segment)) {
      scratch.measured.push_back(decided.hit);
    }
  }
  scratch.decided.clear();
}

SegmentFinder::Sleep SegmentFinder::decide_awake(SlotIndex slot, std::span<Candidate> candidates, double used,
                                                 FinderScratch& scratch, PairCounts& counts) {
  scratch.clear_hits();
  // Only nodes that touch something come back for it.
  TrackedNode* const known = pairs_.known(slot);
  if (known != nullptr) known->nearest.resize(candidates.size());
  const auto decide_number = [&](std::size_t i) {
    decide(slot, candidates[i], known != nullptr ? &known->nearest[i] : nullptr, used, scratch);
  };
  std::uint64_t pairs = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].wake > used || rest_.rests_on(candidates[i], slot, used)) continue;
    decide_number(i);
    ++pairs;
    if (candidates[i].wake > used) scratch.decided.pop_back();
  }
  take_decided(scratch);
  if (const NeededPairs needed(scene_, scratch.hits, known != nullptr && known->released()); needed.any())
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (!(candidates[i].wake > used) || !needed.has(candidates[i], used)) continue;
      decide_number(i);
      ++pairs;
    }
  take_decided(scratch);
  Sleep sleep{std::numeric_limits<double>::infinity()};
  for (const Candidate& candidate : candidates) {
    sleep.wake = std::min(sleep.wake, candidate.wake);
    sleep.inside = sleep.inside || candidate.zone == Candidate::Zone::inside;
  }
  counts.pairs += pairs;
  counts.nodes += pairs > 0;
  return sleep;
}

SegmentContact SegmentFinder::contact_of(SlotIndex slot, SegmentIndex segment, const PairResult& pair) const {
  const bool flipped = !scene_.flipped.empty() && scene_.flipped[segment.value];
  SegmentContact contact;
  contact.segment = segment;
  contact.s = pair.closest.s;
  contact.t = pair.closest.t;
  contact.way = scene_.position(slot) - pair.closest.point;
  contact.normal = flipped ? Vector(-pair.closest.normal) : pair.closest.normal;
  contact.distance = pair.distance;
  contact.rounding = geometry::distance_rounding *
                     geometry::size_of(geometry::seen_from(scene_.facet(segment), scene_.position(slot)));
  contact.on_face = pair.closest.feature == Feature::face && !scene_.line(segment);
  return contact;
}

void SegmentFinder::take_followed_point(SlotIndex slot, SegmentContact& contact, FollowedPairs& pairs) const {
  const TrackedNode& tracked = pairs_.node(slot);
  if (!leads_ || !tracked.active || !tracked.link.on_face || tracked.link.segment != contact.segment) return;
  set_start(slot, pairs, 0);
  geometry::follow(pairs, 1);
  if (!(pairs.settled[0] > 0)) return;
  contact.s = pairs.s[0];
  contact.t = pairs.t[0];
  contact.way = -pairs.offset_of(0);
  contact.distance = std::copysign(std::sqrt(pairs.squared_distance[0]), contact.distance);
  contact.on_face = true;
}

bool SegmentFinder::may_follow(std::size_t place) const {
  if (place >= pairs_.near_places()) return false;
  const TrackedNode& tracked = pairs_.node(pairs_.slot_at(place));
  return tracked.active && tracked.lead > 0;
}

std::optional<SegmentContact> SegmentFinder::decide_last(SlotIndex slot) const {
  const SegmentIndex segment = pairs_.node(slot).link.segment;
  const PairResult pair = contact::decide_pair(scene_, slot, segment);
  if (!pair.penetrates || !pair.in_band || scene_.slides(slot, segment, pair.distance)) return {};
  return contact_of(slot, segment, pair);
}

void SegmentFinder::set_start(SlotIndex slot, FollowedPairs& pairs, std::size_t lane) const {
  const SegmentLink& link = pairs_.node(slot).link;
  pairs.set(lane, scene_.facet(link.segment), scene_.position(slot));
  pairs.s[lane] = link.s;
  pairs.t[lane] = link.t;
}

bool SegmentFinder::prove_followed(SlotIndex slot, const FollowedPairs& pairs, std::size_t lane,
                                   SegmentContact& contact) const {
  const double distance = std::sqrt(pairs.squared_distance[lane]);
  if (!(pairs.settled[lane] > 0) || !(distance > 0)) return false;
  contact.segment = pairs_.node(slot).link.segment;
  contact.s = pairs.s[lane];
  contact.t = pairs.t[lane];
  contact.way = -pairs.offset_of(lane);
  contact.distance = distance;
  contact.rounding = geometry::distance_rounding * pairs.size[lane];
  contact.on_face = true;
  if (scene_.slides(slot, contact.segment, distance)) return false;
  const double h = scene_.nodes.half[slot.value] + scene_.segments.half[contact.segment.value], size = pairs.size[lane];
  // The tolerance of decide_pair(), or a little more.
  const double largest = scene_.position(slot).cwiseAbs().maxCoeff() + 2 * size;
  const double tolerance = scene_.tolerance >= 0 ? scene_.tolerance : contact::default_tolerance(h, largest);
  if (scene_.oriented(contact.segment)) {
    // Behind or in front must be certain.
    const bool flipped = !scene_.flipped.empty() && scene_.flipped[contact.segment.value];
    const double turn = flipped ? -pairs.turn[lane] : pairs.turn[lane];
    if (!(std::abs(turn) > 1e-12 * size * size * size) || !(distance > 1e-9 * size)) return false;
    if (turn > 0) {
      if (!(distance <= scene_.behind(contact.segment)) || !(h > tolerance || distance > 4 * tolerance)) return false;
      contact.distance = -distance;
      return true;
    }
  }
  if (!pairs.closer_than(lane, h - tolerance)) return false;
  return true;
}

}  // namespace gapcheck::solver
