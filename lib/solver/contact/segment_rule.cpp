#include "solver/contact/segment_rule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/quad.hpp"
#include "contact/stiffness/segment_mass.hpp"
#include "contact/stiffness/stiffness.hpp"
#include "solver/contact/segment_finder.hpp"

namespace gapcheck::solver {

using contact::corner_count;

namespace {

/// How two segments are connected, and whether their node orders give them the same front.
enum class Joint : std::uint8_t { none, corner, same_front, other_front };

Joint joint(const model::SegmentNodes& a, const model::SegmentNodes& b) {
  Joint found = Joint::none;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      if (a[i] != b[k]) continue;
      const NodeIndex next = a[(i + 1) % 4];
      if (next != a[i] && next == b[(k + 3) % 4]) return Joint::same_front;
      if (next != a[i] && next == b[(k + 1) % 4]) return Joint::other_front;
      found = Joint::corner;
    }
  return found;
}

/// Cosine below which no segment at a node faces the other one.
constexpr double edge_on = 0.01;

}  // namespace

SegmentRule::SegmentRule(const ContactSetting& setting, const TrackedPairs& pairs)
    : model_(setting.model),
      scene_(pairs.scene()),
      own_segments_(pairs.side().tracked().selection.segments),
      node_mass_(setting.masses.mass),
      side_(scene_.nodes.size()) {
  const model::Contact& card = scene_.contact;
  const double scale = model_.controls.slsfac * (pairs.exchanged() ? card.sfm : card.sfs);
  const auto mass = [&](const contact::Segments& segments, std::size_t i) {
    return contact::segment_mass(model_, setting.masses.sizes, node_mass_, segments, i);
  };
  const contact::Segments& own = own_segments_;
  const contact::Neighbours around(own, model_.mesh);
  for (const NodeIndex node : scene_.nodes.node) {
    start_.push_back(static_cast<std::uint32_t>(own_.size()));
    for (const SegmentIndex at : around.at(node)) {
      const std::size_t i = at.value;
      if (own.kind[i] == contact::SegmentKind::line) continue;
      const PartIndex part = contact::part_of(model_.mesh, own, i);
      const auto* options =
          part != none<PartIndex> && model_.part(part).contact ? &*model_.part(part).contact : nullptr;
      const double factor = options != nullptr && options->ssf > 0 ? options->ssf : 1;
      own_.push_back({at, mass(own, i), scale * factor / static_cast<double>(corner_count(own.nodes[i]))});
    }
    if (own_.size() == start_.back()) own_.push_back({none<SegmentIndex>, node_mass_[node.value], scale});
  }
  start_.push_back(static_cast<std::uint32_t>(own_.size()));
  for (std::size_t s = 0; s < scene_.segments.size(); ++s) mass_.push_back(mass(scene_.segments, s));
}

bool SegmentRule::begin_cycle(const State& state) {
  reduction_ = contact::baseline_reduction(model_, scene_.contact, state.time);
  return false;
}

double SegmentRule::facing(SegmentIndex own, const Vector& normal) const {
  if (own == none<SegmentIndex>) return 1;
  return std::abs(quad_normal(own_segments_.nodes[own.value], scene_.x).stableNormalized().dot(normal));
}

ContactSprings::Spring SegmentRule::spring(SlotIndex slot, SegmentIndex segment) const {
  ContactSprings::Spring spring;
  const std::span<const Own> own =
      std::span(own_).subspan(start_[slot.value], start_[slot.value + 1] - start_[slot.value]);
  const Vector normal = quad_normal(scene_.facet(segment).x).stableNormalized();
  double most = 0;
  for (const Own& o : own) most = std::max(most, facing(o.segment, normal));
  for (const Own& o : own) {
    // Of an edge or tip that no segment has in front of it, all count.
    const double share = most > edge_on ? facing(o.segment, normal) / most : 1;
    spring.stiffness += contact::soft_2_stiffness(share * o.share, o.mass, mass_[segment.value], timestep_);
  }
  spring.node_mass = node_mass_[scene_.nodes.node[slot.value].value];
  const model::SegmentNodes& corners = scene_.segments.nodes[segment.value];
  for (std::size_t c = 0; c < corner_count(corners); ++c) spring.segment_mass += node_mass_[corners[c].value];
  return spring;
}

double SegmentRule::release_depth(SlotIndex /*slot*/, SegmentIndex /*segment*/) const {
  return std::numeric_limits<double>::infinity();
}

bool SegmentRule::passed(const Side& before, SegmentIndex segment, const Vector& direction) const {
  if (before.segment == none<SegmentIndex> || before.segment == segment) return before.direction.dot(direction) < 0;
  // The surface continues over a common edge. A segment without one is another surface.
  const Vector was = quad_normal(scene_.facet(before.segment).x), is = quad_normal(scene_.facet(segment).x);
  bool same_front = false;
  switch (joint(scene_.segments.nodes[before.segment.value], scene_.segments.nodes[segment.value])) {
    case Joint::none:
      return false;
    case Joint::same_front:
      same_front = true;
      break;
    case Joint::other_front:
      break;
    case Joint::corner:
      same_front = was.dot(is) > 0;
  }
  return (before.direction.dot(was) > 0) == (direction.dot(is) > 0) ? !same_front : same_front;
}

void SegmentRule::bring_back(SlotIndex slot, SegmentContact* contact) {
  Side& side = side_[slot.value];
  if (contact == nullptr) {
    side = {};
    return;
  }
  // Oriented segments know their front. A node on the surface gives no new information.
  if (contact->distance < 0 || !(contact->way.squaredNorm() > 0)) return;
  const Vector direction = contact->way.stableNormalized();
  const bool behind = passed(side, contact->segment, direction);
  if (behind) contact->distance = -contact->distance;
  side = {behind ? Vector(-direction) : direction, contact->segment};
}

contact::NodeAction SegmentRule::decide_action(contact::NodeContact& memory,
                                               const contact::NodeEncounter& encounter) const {
  return contact::advance_from_baseline(memory, encounter, reduction_);
}

void SegmentRule::continue_from(const NodeRule& before) {
  const auto* old = dynamic_cast<const SegmentRule*>(&before);
  if (old == nullptr) return;
  const std::vector<NodeIndex>&was = old->scene_.nodes.node, &now = scene_.nodes.node;
  for (std::size_t slot = 0, from = 0; slot < now.size(); ++slot) {  // both ascend
    while (from < was.size() && was[from] < now[slot]) ++from;
    if (from < was.size() && was[from] == now[slot]) side_[slot].direction = old->side_[from].direction;
  }
}

void SegmentRule::forget() { side_.assign(side_.size(), {}); }

}  // namespace gapcheck::solver
