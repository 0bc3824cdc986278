// Nodes whose contact goes on where it was in the last cycle. The decision is that of the long way: a proof that the
// segment is near enough, and one that no other segment counts.
#include <cmath>
#include <limits>

#include "solver/contact/contact_pass.hpp"

namespace gapcheck::solver {

using contact::Candidate;
using geometry::FollowedPairs;

namespace {

/// Another segment must be farther away by this share of the distance, which is far more than what choose_hit() takes for
/// equally near; and what is summed up in doubles is trusted up to this share.
constexpr double lead_slack = 1e-8, rounding_share = 1e-13;
/// Segments farther away than so many times the one that counts need not be asked how far exactly.
constexpr double far_away = 1.5;

}  // namespace

void ContactPass::improve(std::uint32_t slot, const Tracked& tracked, Contact& contact, FollowedPairs& pairs) const {
  if (!leads_ || !tracked.active || !tracked.link.on_face || tracked.link.segment != contact.segment) return;
  prepare(slot, pairs, 0);
  geometry::follow(pairs, 1);
  if (!(pairs.settled[0] > 0)) return;
  contact.s = pairs.s[0];
  contact.t = pairs.t[0];
  contact.way = -pairs.offset_of(0);
  contact.distance = std::copysign(std::sqrt(pairs.squared_distance[0]), contact.distance);
  contact.on_face = true;
}

double ContactPass::nearest_other(std::uint32_t slot, std::uint32_t segment, std::span<const Candidate> candidates,
                                  double used) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : candidates)
    if (candidate.segment != segment)
      least = std::min(least, candidate.wake - used + reach(slot, candidate.segment));
  return least;
}

void ContactPass::separate(std::uint32_t slot, std::uint32_t segment, std::span<Candidate> candidates,
                           double used, double far) const {
  const Vector at = scene_.position(slot);
  for (Candidate& candidate : candidates) {
    const double reach = this->reach(slot, candidate.segment);
    if (candidate.segment == segment || candidate.wake - used + reach > far) continue;
    const geometry::Facet facet = scene_.facet(candidate.segment);
    double least = std::numeric_limits<double>::infinity(), size = 0;
    for (const Vector& corner : facet.x) {
      const Vector from_node = corner - at;
      least = std::min(least, candidate.towards.dot(from_node));
      size = std::max(size, from_node.cwiseAbs().maxCoeff());
    }
    candidate.wake = std::max(candidate.wake, used + least - rounding_share * size - reach);
  }
}

double ContactPass::lead(double nearest_other, const Contact& chosen, double used) const {
  const double gap =
      nearest_other - std::abs(chosen.distance) * (1 + lead_slack) - rounding_share * (used + greatest_reach_);
  // One distance may grow by what the other one loses.
  return used + gap / 2;
}

bool ContactPass::may_follow(std::size_t place) const {
  if (place >= candidates_.slots().size()) return false;
  const Tracked& tracked = tracked_[candidates_.slots()[place]];
  return tracked.active && tracked.link.on_face && tracked.lead > 0;
}

void ContactPass::prepare(std::uint32_t slot, FollowedPairs& pairs, std::size_t lane) const {
  const Link& link = tracked_[slot].link;
  pairs.set(lane, scene_.facet(link.segment), scene_.position(slot));
  pairs.s[lane] = link.s;
  pairs.t[lane] = link.t;
}

std::optional<ContactPass::Contact> ContactPass::followed(std::uint32_t slot, const FollowedPairs& pairs,
                                                          std::size_t lane) const {
  const double distance = std::sqrt(pairs.squared_distance[lane]);
  if (!(pairs.settled[lane] > 0) || !(distance > 0)) return {};
  Contact contact;
  contact.segment = tracked_[slot].link.segment;
  contact.s = pairs.s[lane];
  contact.t = pairs.t[lane];
  contact.way = -pairs.offset_of(lane);
  contact.distance = distance;
  contact.on_face = true;
  const double h = scene_.nodes.half[slot] + scene_.segments.half[contact.segment], size = pairs.size[lane];
  // The tolerance of decide_pair(), or a little more.
  const double largest = scene_.position(slot).cwiseAbs().maxCoeff() + 2 * size;
  const double tolerance = scene_.tolerance >= 0 ? scene_.tolerance : contact::default_tolerance(h, largest);
  if (scene_.oriented(contact.segment)) {
    // Behind or in front must be beyond doubt.
    const bool flipped = !scene_.flipped.empty() && scene_.flipped[contact.segment];
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

bool ContactPass::keeps_lead(std::size_t place, const Contact& contact, double used) {
  const std::uint32_t slot = slot_at(place);
  Tracked& tracked = tracked_[slot];
  if (tracked.lead > used) return true;
  const std::span<Candidate> candidates = candidates_.of(place);
  separate(slot, contact.segment, candidates, used, far_away * std::abs(contact.distance));
  tracked.lead = lead(nearest_other(slot, contact.segment, candidates, used), contact, used);
  return tracked.lead > used;
}

}  // namespace gapcheck::solver
