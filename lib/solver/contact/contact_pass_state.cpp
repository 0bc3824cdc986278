// What a pass tells of its springs, and what it keeps of them when its surfaces change or the contact rests.
#include <algorithm>
#include <unordered_map>

#include "contact/pair/record_pair.hpp"
#include "contact/surface/segment_elements.hpp"
#include "solver/contact/contact_pass.hpp"

namespace gapcheck::solver {

using contact::NodeContact;

std::vector<ContactNode> ContactPass::nodes() const {
  std::vector<ContactNode> all;
  for (std::uint32_t slot = 0; slot < tracked_.size(); ++slot) {
    const Tracked& tracked = tracked_[slot];
    const bool released = tracked.memory.state == NodeContact::State::released;
    if (!tracked.active && !released) continue;
    ContactNode node;
    const double push = tracked.link.push + tracked.link.damping;
    node.kind = released ? ContactNode::Kind::released
                : push > 0 ? ContactNode::Kind::touching
                           : ContactNode::Kind::kept;
    node.node = scene_.nodes.node[slot];
    node.segment = scene_.segments.nodes[tracked.link.segment];
    node.force = tracked.link.force();
    node.penetration = tracked.penetration;
    node.forgiven = tracked.memory.forgiven;
    const double area = segment_area(tracked.link.segment);
    node.pressure = area > 0 ? push / area : 0;
    all.push_back(node);
  }
  return all;
}

void ContactPass::links(std::vector<ContactLink>& links) const {
  for (std::uint32_t slot = 0; slot < tracked_.size(); ++slot) {
    const Tracked& tracked = tracked_[slot];
    if (!tracked.active) continue;
    ContactLink& link = links.emplace_back();
    link.tracked = {{scene_.nodes.node[slot]}, {1}};
    link.reference = {scene_.segments.nodes[tracked.link.segment], tracked.link.weights};
    link.exchanged = exchanged_;
    link.force = tracked.link.force();
  }
}

void ContactPass::carry_over(InterfacePass& before, const State& state, ContactState& result) {
  auto* const old = dynamic_cast<ContactPass*>(&before);
  if (old == nullptr) return before.rest(state, result);
  std::unordered_map<contact::SegmentKey, std::uint32_t, contact::SegmentKeyHash> segments;
  for (std::uint32_t s = 0; s < scene_.segments.size(); ++s)
    segments.try_emplace(contact::segment_key(scene_.segments.nodes[s]), s);
  // Which side of a segment is its front does not change.
  std::vector<bool>& flipped = side_.scene().flipped;
  for (std::uint32_t s = 0; s < old->scene_.segments.size() && !(flipped.empty() && old->scene_.flipped.empty()); ++s) {
    const auto now = segments.find(contact::segment_key(old->scene_.segments.nodes[s]));
    flipped.resize(scene_.segments.size(), false);
    if (now != segments.end()) flipped[now->second] = !old->scene_.flipped.empty() && old->scene_.flipped[s];
  }
  const std::vector<NodeIndex>& nodes = scene_.nodes.node;
  for (std::uint32_t slot = 0; slot < old->tracked_.size(); ++slot) {
    const Tracked& was = old->tracked_[slot];
    const auto at = std::lower_bound(nodes.begin(), nodes.end(), old->scene_.nodes.node[slot],
                                     [](NodeIndex a, NodeIndex b) { return a.value < b.value; });
    const bool there = at != nodes.end() && *at == old->scene_.nodes.node[slot];
    const auto segment = was.active
                             ? segments.find(contact::segment_key(old->scene_.segments.nodes[was.link.segment]))
                             : segments.end();
    const bool goes_on = there && segment != segments.end();
    if (was.active && !goes_on) {
      Work work;
      old->add_work(was.link, old->velocities(slot, was.link.segment, state), state.dt, work);
      old->add_energies(work, result);
    }
    if (!there) continue;
    Tracked& tracked = tracked_[static_cast<std::size_t>(at - nodes.begin())];
    tracked = {};
    tracked.memory = was.memory;
    if (!goes_on) continue;
    tracked.active = true;
    tracked.penetration = was.penetration;
    tracked.link = was.link;
    tracked.link.segment = segment->second;
    // Following goes on where s and t mean the same.
    tracked.link.on_face =
        was.link.on_face && scene_.segments.nodes[segment->second] == old->scene_.segments.nodes[was.link.segment];
  }
}

void ContactPass::rest(const State& state, ContactState& result) {
  for (Tracked& tracked : tracked_) {
    if (tracked.active) {
      Work work;
      add_work(tracked.link, velocities(static_cast<std::uint32_t>(&tracked - tracked_.data()), tracked.link.segment, state),
               state.dt, work);
      add_energies(work, result);
    }
    tracked.active = false;
    tracked.memory = {};
    tracked.sleep = tracked.lead = 0;
  }
  blocks_.clear();
  pushes_.clear();
}

}  // namespace gapcheck::solver
