#include "solver/contact/segment_pass.hpp"

#include <limits>

#include "contact/stiffness/segment_mass.hpp"
#include "contact/stiffness/stiffness.hpp"

namespace gapcheck::solver {

using contact::corner_count;

namespace {

/// How two segments hang together, and whether their node orders give them the same front.
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

}  // namespace

SegmentPass::SegmentPass(const ContactSetting& setting, std::uint32_t contact, const contact::ContactSurfaces& surfaces,
                         bool exchanged, const std::vector<Vector>& x)
    : ContactPass(setting, contact, surfaces, exchanged, x),
      model_(setting.model),
      node_mass_(setting.masses.mass),
      side_(side().scene().nodes.size()) {
  const contact::PairScene& scene = side().scene();
  const model::Contact& card = scene.contact;
  const double scale = model_.controls.slsfac * (exchanged ? card.sfm : card.sfs);
  const auto mass = [&](const contact::Segments& segments, std::size_t i) {
    return contact::segment_mass(model_, setting.masses.sizes, node_mass_, segments, i);
  };
  const contact::Segments& own = side().tracked().selection.segments;
  const contact::Neighbours around(own, model_.mesh);
  for (const NodeIndex node : scene.nodes.node) {
    start_.push_back(static_cast<std::uint32_t>(own_.size()));
    for (const std::uint32_t i : around.at(node)) {
      if (own.kind[i] == contact::SegmentKind::line) continue;
      const PartIndex part = contact::part_of(model_.mesh, own, i);
      const auto* options =
          part != none<PartIndex> && model_.part(part).contact ? &*model_.part(part).contact : nullptr;
      const double factor = options != nullptr && options->ssf > 0 ? options->ssf : 1;
      own_.push_back({mass(own, i), scale * factor / static_cast<double>(corner_count(own.nodes[i]))});
    }
    if (own_.size() == start_.back()) own_.push_back({node_mass_[node.value], scale});
  }
  start_.push_back(static_cast<std::uint32_t>(own_.size()));
  for (std::size_t s = 0; s < scene.segments.size(); ++s) mass_.push_back(mass(scene.segments, s));
}

void SegmentPass::set_timestep(double timestep) {
  timestep_ = timestep;
  forget_partners();
}

ContactSprings::Spring SegmentPass::spring(std::uint32_t slot, std::uint32_t segment) const {
  ContactSprings::Spring spring;
  for (std::uint32_t i = start_[slot]; i < start_[slot + 1]; ++i)
    spring.stiffness += contact::soft_2_stiffness(own_[i].share, own_[i].mass, mass_[segment], timestep_);
  const contact::PairScene& scene = side().scene();
  spring.node_mass = node_mass_[scene.nodes.node[slot].value];
  const model::SegmentNodes& corners = scene.segments.nodes[segment];
  for (std::size_t c = 0; c < corner_count(corners); ++c) spring.segment_mass += node_mass_[corners[c].value];
  return spring;
}

double SegmentPass::release_depth(std::uint32_t /*slot*/, std::uint32_t /*segment*/) const {
  return std::numeric_limits<double>::infinity();
}

bool SegmentPass::passed(const Side& before, std::uint32_t segment, const Vector& direction) const {
  if (before.segment == Side::unknown || before.segment == segment) return before.direction.dot(direction) < 0;
  // The surface goes on over a common edge. A segment without one is another surface.
  const contact::PairScene& scene = ContactPass::side().scene();
  const auto normal = [&](std::uint32_t s) -> Vector {
    const geometry::Facet facet = scene.facet(s);
    return (facet.x[2] - facet.x[0]).cross(facet.x[3] - facet.x[1]);
  };
  const Vector was = normal(before.segment), is = normal(segment);
  bool same_front = false;
  switch (joint(scene.segments.nodes[before.segment], scene.segments.nodes[segment])) {
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

void SegmentPass::orient(std::uint32_t slot, Contact* contact) {
  Side& side = side_[slot];
  if (contact == nullptr) {
    side = {};
    return;
  }
  // Oriented segments know their front. Of a node on the surface nothing new can be said.
  if (contact->distance < 0 || !(contact->way.squaredNorm() > 0)) return;
  const Vector direction = contact->way.stableNormalized();
  const bool behind = passed(side, contact->segment, direction);
  if (behind) contact->distance = -contact->distance;
  side = {behind ? Vector(-direction) : direction, contact->segment};
}

contact::NodeAction SegmentPass::advance(contact::NodeContact& memory, const contact::NodeEncounter& encounter) const {
  return contact::advance_from_baseline(memory, encounter, first_, reduction_);
}

double SegmentPass::update(State& state, double used, ContactCounters& counters) {
  reduction_ = contact::baseline_reduction(model_, side().scene().contact, state.time);
  const double moved = ContactPass::update(state, used, counters);
  first_ = false;
  return moved;
}

void SegmentPass::carry_over(InterfacePass& before, const State& state, ContactState& result) {
  ContactPass::carry_over(before, state, result);
  const auto* old = dynamic_cast<const SegmentPass*>(&before);
  if (old == nullptr) return;
  first_ = old->first_;
  const std::vector<NodeIndex>&was = old->side().scene().nodes.node, &now = side().scene().nodes.node;
  for (std::size_t slot = 0, from = 0; slot < now.size(); ++slot) {  // both ascend
    while (from < was.size() && was[from] < now[slot]) ++from;
    if (from < was.size() && was[from] == now[slot]) side_[slot].direction = old->side_[from].direction;
  }
}

void SegmentPass::rest(const State& state, ContactState& result) {
  ContactPass::rest(state, result);
  side_.assign(side_.size(), {});
  first_ = true;
}

}  // namespace gapcheck::solver
