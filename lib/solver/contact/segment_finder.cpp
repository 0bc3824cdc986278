#include "solver/contact/segment_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/outside_band.hpp"

namespace gapcheck::solver {

using contact::Candidate;
using contact::Hit;
using contact::PairResult;
using geometry::FollowedPairs;

namespace {

constexpr std::size_t not_followed = FollowedPairs::capacity;

/// Another segment must be farther away by this share of the distance, which is far more than what choose_hit() treats
/// as equally near; sums in doubles are trusted up to this share.
constexpr double lead_slack = 1e-8, rounding_share = 1e-13;
/// For segments farther away than this many times the one that counts, the exact distance does not matter.
constexpr double far_away = 1.5;

}  // namespace

SegmentFinder::SegmentFinder(TrackedPairs& pairs)
    : pairs_(pairs),
      scene_(pairs.scene()),
      leads_(scene_.mode == geometry::Mode::filtered && !(scene_.contact.airbag_thickness > 0)) {}

void SegmentFinder::follow_pairs(std::size_t first, std::size_t last, FinderScratch& scratch) const {
  scratch.first = first;
  std::size_t count = 0;
  for (std::size_t place = first; place < last; ++place) {
    std::size_t& lane = scratch.lanes[place - first];
    lane = not_followed;
    if (!may_follow(place)) continue;
    lane = count++;
    set_start(pairs_.slot_at(place), scratch.followed, lane);
  }
  geometry::follow(scratch.followed, count);
}

std::optional<NodeMeeting> SegmentFinder::find_meeting(std::size_t place, double used, FinderScratch& scratch,
                                                       PairCounts& counts) {
  const SlotIndex slot = pairs_.slot_at(place);
  const std::size_t lane = scratch.lanes[place - scratch.first];
  if (lane != not_followed) {
    NodeMeeting meeting{prove_followed(slot, scratch.followed, lane), true};
    if (meeting.contact && keeps_lead(place, *meeting.contact, used)) {
      ++counts.nodes;
      ++counts.pairs;
      ++counts.followed;
      return meeting;
    }
  }
  if (pairs_.sleep(place) > used && !pairs_.node(slot).active) {
    ++counts.asleep;
    return {};
  }
  return decide_candidates(place, used, scratch, counts);
}

NodeMeeting SegmentFinder::decide_candidates(std::size_t place, double used, FinderScratch& scratch,
                                             PairCounts& counts) {
  const SlotIndex slot = pairs_.slot_at(place);
  const std::span<Candidate> candidates = pairs_.candidates_at(place);
  const Sleep sleep = decide_awake(slot, candidates, used, scratch, counts);
  NodeMeeting meeting;
  meeting.in_zone = !scratch.hits.empty() || sleep.beside;
  TrackedNode* const known = pairs_.known(slot);
  // A node beside segments sleeps only if it has no memory that the zone keeps.
  const bool may_sleep = scratch.hits.empty() && (!sleep.beside || known == nullptr || known->at_rest());
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
  if (leads_ && contact.on_face) pairs_.touch(slot).lead = lead_of(slot, candidates, contact, used);
  return meeting;
}

double SegmentFinder::motion_beside(SlotIndex slot, SegmentIndex segment, const PairResult& pair) const {
  // Oriented segments and faces of solids that may slide compare hits outside of bands too.
  const bool compared =
      scene_.oriented(segment) || scene_.line(segment) ||
      (scene_.own_neighbours != nullptr && scene_.segments.kind[segment.value] == contact::SegmentKind::solid);
  const bool shifted = !scene_.segments.offset.empty() && scene_.segments.offset[segment.value] != 0;
  if (pair.in_band || compared || shifted || !leads_ || scene_.type.by_segments()) return 0;
  const geometry::Facet facet = scene_.facet(segment);
  const Vector at = scene_.position(slot);
  const double in_zone =
      contact::penetration_bound(scene_, slot, segment, facet, at) * (1 - lead_slack) - pair.distance;
  if (!(in_zone > 0)) return 0;
  return std::min(in_zone, geometry::motion_outside_band({facet, at, pair.closest.point, pairs_.reach(slot, segment)}));
}

SegmentFinder::Sleep SegmentFinder::decide_awake(SlotIndex slot, std::span<Candidate> candidates, double used,
                                                 FinderScratch& scratch, PairCounts& counts) const {
  scratch.clear_hits();
  // Only nodes that touch something come back for it.
  TrackedNode* const known = pairs_.known(slot);
  if (known != nullptr) known->towards.resize(candidates.size(), Vector::Zero());
  Sleep sleep{std::numeric_limits<double>::infinity()};
  std::uint64_t pairs = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    Candidate& candidate = candidates[i];
    if (!(candidate.wake > used)) {
      const SegmentIndex s = candidate.segment;
      const PairResult pair = contact::decide_pair(scene_, slot, s);
      ++pairs;
      candidate.wake = used + std::abs(pair.distance) - pairs_.reach(slot, s);
      candidate.beside = false;
      const double distance = std::sqrt(pair.closest.squared_distance);
      if (known != nullptr)
        known->towards[i] =
            distance > 0 ? Vector((pair.closest.point - scene_.position(slot)) / distance) : Vector::Zero();
      if (const double motion = pair.penetrates ? motion_beside(slot, s, pair) : 0; motion > 0) {
        candidate.wake = used + motion;
        candidate.beside = true;
      } else if (pair.penetrates) {
        scratch.hits.push_back({slot, s, pair.distance, pair.in_band});
        scratch.results.push_back(pair);
      } else if (scene_.oriented(s)) {
        scratch.measured.push_back({slot, s, pair.distance, pair.in_band});
      }
    }
    sleep.wake = std::min(sleep.wake, candidate.wake);
    sleep.beside = sleep.beside || candidate.beside;
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

double SegmentFinder::nearest_other(SlotIndex slot, SegmentIndex segment, std::span<const Candidate> candidates,
                                    double used) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : candidates)
    if (candidate.segment != segment && !candidate.beside)
      least = std::min(least, candidate.wake - used + pairs_.reach(slot, candidate.segment));
  return least;
}

void SegmentFinder::separate_others(SlotIndex slot, SegmentIndex segment, std::span<Candidate> candidates, double used,
                                    double far) const {
  const std::vector<Vector>& towards = pairs_.node(slot).towards;
  if (towards.size() != candidates.size()) return;
  const Vector at = scene_.position(slot);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    Candidate& candidate = candidates[i];
    const double reach = pairs_.reach(slot, candidate.segment);
    if (candidate.segment == segment || candidate.beside || candidate.wake - used + reach > far) continue;
    const geometry::Facet facet = scene_.facet(candidate.segment);
    double least = std::numeric_limits<double>::infinity(), size = 0;
    for (const Vector& corner : facet.x) {
      const Vector from_node = corner - at;
      least = std::min(least, towards[i].dot(from_node));
      size = std::max(size, from_node.cwiseAbs().maxCoeff());
    }
    candidate.wake = std::max(candidate.wake, used + least - rounding_share * size - reach);
  }
}

double SegmentFinder::lead_of(SlotIndex slot, std::span<const Candidate> candidates, const SegmentContact& chosen,
                              double used) const {
  const double gap = nearest_other(slot, chosen.segment, candidates, used) -
                     std::abs(chosen.distance) * (1 + lead_slack) - rounding_share * (used + pairs_.greatest_reach());
  // One distance may grow by what the other one loses. Segments beside the node do not count before they wake.
  double lead = used + gap / 2;
  for (const Candidate& candidate : candidates)
    if (candidate.beside && candidate.segment != chosen.segment) lead = std::min(lead, candidate.wake);
  return lead;
}

bool SegmentFinder::may_follow(std::size_t place) const {
  if (place >= pairs_.near_places()) return false;
  const TrackedNode& tracked = pairs_.node(pairs_.slot_at(place));
  return tracked.active && tracked.link.on_face && tracked.lead > 0;
}

bool SegmentFinder::keeps_lead(std::size_t place, const SegmentContact& contact, double used) {
  const SlotIndex slot = pairs_.slot_at(place);
  TrackedNode& tracked = pairs_.touch(slot);
  if (tracked.lead > used) return true;
  const std::span<Candidate> candidates = pairs_.candidates_at(place);
  separate_others(slot, contact.segment, candidates, used, far_away * std::abs(contact.distance));
  tracked.lead = lead_of(slot, candidates, contact, used);
  return tracked.lead > used;
}

void SegmentFinder::set_start(SlotIndex slot, FollowedPairs& pairs, std::size_t lane) const {
  const SegmentLink& link = pairs_.node(slot).link;
  pairs.set(lane, scene_.facet(link.segment), scene_.position(slot));
  pairs.s[lane] = link.s;
  pairs.t[lane] = link.t;
}

std::optional<SegmentContact> SegmentFinder::prove_followed(SlotIndex slot, const FollowedPairs& pairs,
                                                            std::size_t lane) const {
  const double distance = std::sqrt(pairs.squared_distance[lane]);
  if (!(pairs.settled[lane] > 0) || !(distance > 0)) return {};
  SegmentContact contact;
  contact.segment = pairs_.node(slot).link.segment;
  contact.s = pairs.s[lane];
  contact.t = pairs.t[lane];
  contact.way = -pairs.offset_of(lane);
  contact.distance = distance;
  contact.on_face = true;
  const double h = scene_.nodes.half[slot.value] + scene_.segments.half[contact.segment.value], size = pairs.size[lane];
  // The tolerance of decide_pair(), or a little more.
  const double largest = scene_.position(slot).cwiseAbs().maxCoeff() + 2 * size;
  const double tolerance = scene_.tolerance >= 0 ? scene_.tolerance : contact::default_tolerance(h, largest);
  if (scene_.oriented(contact.segment)) {
    // Behind or in front must be certain.
    const bool flipped = !scene_.flipped.empty() && scene_.flipped[contact.segment.value];
    const double turn = flipped ? -pairs.turn[lane] : pairs.turn[lane];
    if (!(std::abs(turn) > 1e-12 * size * size * size) || !(distance > 1e-9 * size)) return {};
    if (turn > 0) {
      if (!(distance <= scene_.behind(contact.segment)) || !(h > tolerance || distance > 4 * tolerance)) return {};
      contact.distance = -distance;
      return contact;
    }
  }
  if (!pairs.closer_than(lane, h - tolerance)) return {};
  return contact;
}

}  // namespace gapcheck::solver
