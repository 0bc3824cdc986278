#include "solver/interface/contact_spring.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "contact/stiffness/node_masses.hpp"
#include "contact/stiffness/stiffness.hpp"

namespace gapcheck::solver {

using contact::corner_count;

ContactMasses::ContactMasses(const model::Model& model, SpringFormula which)
    : sizes(contact::element_sizes(model)),
      springs(model, sizes),
      mass(contact::node_masses(model, sizes)),
      formula(which) {}

contact::SegmentSpring ContactMasses::spring(const contact::Segments& segments, std::size_t segment, double scale,
                                             double solid_modulus) const {
  const bool printed = formula == SpringFormula::printed && segments.kind[segment] != contact::SegmentKind::line;
  return springs(segments, segment, scale, printed, solid_modulus);
}

namespace {

std::unique_ptr<const SideStiffness> segment_table(const ContactMasses& masses, const contact::Segments& segments,
                                                   double scale, double solid_modulus) {
  auto table = std::make_unique<SideStiffness>();
  table->segments.reserve(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s)
    table->segments.push_back(masses.spring(segments, s, scale, solid_modulus).stiffness);
  return table;
}

std::unique_ptr<const SideStiffness> node_table(const ContactMasses& masses, const contact::ContactSide& side,
                                                double scale, double solid_modulus, bool lines) {
  const contact::Segments& own = side.selection.segments;
  // Thousands of small contacts must not each visit all nodes of the model.
  std::vector<NodeIndex> touched;
  for (const auto& corners : own.nodes) touched.insert(touched.end(), corners.begin(), corners.end());
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  const auto place = [&](NodeIndex node) {
    return static_cast<std::size_t>(std::lower_bound(touched.begin(), touched.end(), node) - touched.begin());
  };
  constexpr double none_yet = std::numeric_limits<double>::infinity();
  std::vector<double> least(touched.size(), none_yet);
  std::vector<contact::NodeStiffness> sums(touched.size());
  const bool printed = masses.formula == SpringFormula::printed;
  for (std::size_t s = 0; s < own.size(); ++s) {
    // If beams are not a reference, the segment that their nodes contact decides.
    if (own.kind[s] == contact::SegmentKind::line && !lines) continue;
    const contact::SegmentSpring spring = masses.spring(own, s, scale, solid_modulus);
    // A triangle lists its third node twice, and printed weights count it so.
    if (!(spring.weight > 0)) continue;
    const bool listed = printed && own.kind[s] != contact::SegmentKind::line;
    for (std::size_t c = 0; c < (listed ? own.nodes[s].size() : corner_count(own.nodes[s])); ++c) {
      const std::size_t node = place(own.nodes[s][c]);
      least[node] = std::min(least[node], spring.stiffness);
      sums[node] += {spring.weight, spring.weight * spring.stiffness};
    }
  }
  auto table = std::make_unique<SideStiffness>();
  table->nodes.resize(side.nodes.size());
  for (std::size_t slot = 0; slot < side.nodes.size(); ++slot) {
    const std::size_t node = place(side.nodes.node[slot]);
    if (node == touched.size() || touched[node] != side.nodes.node[slot] || least[node] == none_yet) continue;
    table->nodes[slot] = {printed ? sums[node].value() : least[node], sums[node].value(), 2 * side.nodes.half[slot]};
  }
  return table;
}

}  // namespace

std::shared_ptr<const SideStiffness> StiffnessCache::nodes(const ContactMasses& masses,
                                                           const contact::ContactSide& side, double scale,
                                                           double solid_modulus, bool lines) {
  const Key key{&side, std::bit_cast<std::uint64_t>(scale), std::bit_cast<std::uint64_t>(solid_modulus), true, lines};
  return tables_.at(key, [&] { return node_table(masses, side, scale, solid_modulus, lines); });
}

std::shared_ptr<const SideStiffness> StiffnessCache::segments(const ContactMasses& masses,
                                                              const contact::ContactSide& side, double scale,
                                                              double solid_modulus) {
  const Key key{&side, std::bit_cast<std::uint64_t>(scale), std::bit_cast<std::uint64_t>(solid_modulus), false, false};
  return tables_.at(key, [&] { return segment_table(masses, side.selection.segments, scale, solid_modulus); });
}

ContactSprings::ContactSprings(const model::Model& model, const contact::SideScene& side, const ContactMasses& masses,
                               double node_scale, double segment_scale, StiffnessCache& shared)
    : scene_(side.scene()),
      mass_(masses.mass),
      penopt_(model.controls.penopt),
      // The solver uses SOFT = 1 if a type has no segment-based contact.
      soft_(scene_.contact.soft == 2 && !contact::has_soft_2(scene_.type) ? 1 : scene_.contact.soft),
      sofscl_(scene_.contact.sofscl) {
  const double slsfac = model.controls.slsfac;
  const double solid_modulus = scene_.contact.sldthk > 0 ? scene_.contact.sldstf : 0;
  nodes_ = shared.nodes(masses, side.tracked(), slsfac * node_scale, solid_modulus, scene_.type.edges);
  segments_ = shared.segments(masses, side.reference(), slsfac * segment_scale, solid_modulus);
}

ContactSprings::Spring ContactSprings::operator()(SlotIndex slot, SegmentIndex segment) const {
  const SideStiffness::Node& node = nodes_->nodes[slot.value];
  const double of_segment = segments_->segments[segment.value];
  // Nodes of a set have no segment of their own: the segment that they contact decides.
  const contact::PairStiffness pair{node.least > 0 ? node.least : of_segment, of_segment > 0 ? of_segment : node.least,
                                    node.weighted > 0 ? node.weighted : of_segment, node.thickness};
  const model::SegmentNodes& corners = scene_.segments.nodes[segment.value];
  Spring spring;
  spring.stiffness = contact::spring_stiffness(penopt_, pair);
  spring.node_mass = mass_[scene_.nodes.node[slot.value].value];
  for (std::size_t c = 0; c < corner_count(corners); ++c) spring.segment_mass += mass_[corners[c].value];
  if (soft_ == 1) {
    const double soft = contact::soft_1_stiffness(spring.node_mass, spring.segment_mass, timestep_);
    spring.stiffness = contact::soft_1_spring(spring.stiffness, sofscl_, soft);
  }
  return spring;
}

double ContactSprings::damping(const Spring& spring, double percent) {
  const double m1 = spring.node_mass, m2 = spring.segment_mass;
  if (!(m1 > 0) || !(m2 > 0) || !(percent > 0)) return 0;
  const double frequency = std::sqrt(spring.stiffness * (m1 + m2) / (m1 * m2));
  return percent / 100 * 2 * std::min(m1, m2) * frequency;
}

}  // namespace gapcheck::solver
