#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <unordered_map>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "audit/shared/contact_thickness.hpp"
#include "audit/shared/records_of.hpp"
#include "audit/shared_results.hpp"
#include "records/thickness_source.hpp"

namespace gapcheck::audit::rule::thickness_conflict {
namespace {

constexpr std::array thresholds{
    Threshold{"ratio", 2, 1, 1e6, "ratio of two contact thicknesses at one node, above which they are listed"}};
constexpr std::uint32_t no_slot = std::numeric_limits<std::uint32_t>::max();

/// The tracked nodes of one side by node.
class Slots {
 public:
  explicit Slots(const contact::TrackedNodes& nodes) {
    if (nodes.size() == 0) return;
    first_ = nodes.node.front().value;
    slot_.assign(nodes.node.back().value - first_ + 1, no_slot);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) slot_[nodes.node[i].value - first_] = i;
  }
  [[nodiscard]] std::uint32_t at(NodeIndex node) const {
    const std::uint32_t i = node.value - first_;  // wraps round below the first
    return i < slot_.size() ? slot_[i] : no_slot;
  }

 private:
  std::uint32_t first_ = 0;
  std::vector<std::uint32_t> slot_;
};

/// Thickness of the drawing, not of a setting of contact.
bool own(ThicknessRule rule) { return rule == ThicknessRule::element || rule == ThicknessRule::edge_limit; }

/// Depths of the nodes that penetrate in one contact, by id.
using Depths = std::unordered_map<std::int64_t, double>;

Depths depths_of(const contact::InitialState& state, ContactIndex contact) {
  Depths depths;
  for (const Penetration& p : records_of(state, contact)) {
    double& depth = depths[p.node];
    depth = std::max(depth, p.depth);
  }
  return depths;
}

/// The corner of a segment whose node has the most different thickness.
struct Corner {
  double ratio = 0;
  std::uint32_t slot = no_slot;
};

Corner worst_corner(const contact::Segments& s, const contact::TrackedNodes& nodes, const Slots& slots, std::size_t i) {
  Corner worst;
  const double half = s.half[i];
  if (!(half > 0) || s.kind[i] != contact::SegmentKind::shell) return worst;
  for (const NodeIndex n : s.nodes[i]) {
    const std::uint32_t slot = slots.at(n);
    if (slot == no_slot || !(nodes.half[slot] > 0)) continue;
    const double ratio = std::max(nodes.half[slot] / half, half / nodes.half[slot]);
    if (ratio > worst.ratio) worst = {ratio, slot};
  }
  return worst;
}

/// Segments of one part with nodes that count the thickness of another part, in one contact.
struct Conflict {
  ContactIndex contact;
  std::uint32_t segment = 0, slot = 0;
  const contact::Segments* segments = nullptr;
  const contact::TrackedNodes* nodes = nullptr;
  double ratio = 0;
  std::uint64_t count = 0;
  double depth = 0;  ///< of the node, which would not penetrate with the segment's thickness; 0: not so
};

/// By part of the segment and part that gave the node its thickness.
using Conflicts = std::map<std::uint64_t, Conflict>;

bool all_alike(const contact::Segments& s, const contact::TrackedNodes& nodes, double most_ratio) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const auto* halves : {&s.half, &nodes.half})
    for (const double half : *halves)
      if (half > 0) least = std::min(least, half), most = std::max(most, half);
  return !(most > most_ratio * least);
}

void compare(Conflicts& conflicts, Context& context, ContactIndex contact, const contact::TrackedNodes& nodes,
             const contact::Segments& s, double most_ratio) {
  if (nodes.size() == 0 || s.size() == 0 || all_alike(s, nodes, most_ratio)) return;
  const Slots slots(nodes);
  const Depths depths = depths_of(context.results().initial(), contact);
  // A node that counts the thicker of two sheets, and penetrates only by that.
  const auto depth_by_thickness = [&](std::size_t i, std::uint32_t slot) {
    const auto found = depths.find(context.model().mesh.nodes.id[nodes.node[slot].value]);
    return found != depths.end() && found->second <= nodes.half[slot] - s.half[i] ? found->second : 0;
  };
  const auto found = worst_by_key(s.size(), [&](std::size_t i) {
    const Corner corner = worst_corner(s, nodes, slots, i);
    if (!(corner.ratio > most_ratio)) return Weighed{};
    const PartIndex part = part_of(context.model().mesh, s, i), giver = nodes.part[corner.slot];
    if (part == none<PartIndex> || giver == none<PartIndex>) return Weighed{};
    if (!context.part_chosen(part) && !context.part_chosen(giver)) return Weighed{};
    // Two sheets of different thickness that share nodes are meant.
    if (part != giver && own(s.rule[i]) && own(nodes.rule[corner.slot]) && !(depth_by_thickness(i, corner.slot) > 0))
      return Weighed{};
    return Weighed{std::uint64_t{part.value} << 32 | giver.value, rough_weight(corner.ratio),
                   element_id(context.model().mesh, s, i)};
  });
  for (const Worst& w : found) {
    Conflict& c = conflicts[w.key];
    const std::uint64_t count = c.count + w.count;
    if (w.weight > c.ratio) {
      const std::uint32_t slot = worst_corner(s, nodes, slots, w.item).slot;
      c = {contact, w.item, slot, &s, &nodes, w.weight, 0, depth_by_thickness(w.item, slot)};
    }
    c.count = count;
  }
}

Finding words(const RuleIdentity& rule, const Context& context, const Conflict& c) {
  const model::Model& model = context.model();
  const PartIndex part = part_of(model.mesh, *c.segments, c.segment), giver = c.nodes->part[c.slot];
  const std::int64_t node = model.mesh.nodes.id[c.nodes->node[c.slot].value];
  const std::string with =
      part == giver ? "differ in thickness from their neighbours" : "share nodes with " + part_name(model, giver);
  Finding f = finding_at_segment(
      rule, context, model.contact(c.contact), *c.segments, c.segment,
      fmt::format(
          "{}: {} {}, and a node counts its largest thickness: {} has {:.4g} ({}), its node {} counts {:.4g} ({}){}; "
          "even them out with OPTT, SST or MST where that matters",
          part_name(model, part), count_elements(c.count), with, element_name(model.mesh, *c.segments, c.segment),
          2 * c.segments->half[c.segment], thickness_source(c.segments->rule[c.segment]), node,
          2 * c.nodes->half[c.slot], thickness_source(c.nodes->rule[c.slot]),
          c.depth > 0 ? fmt::format(", by which alone it penetrates ({:.4g} deep)", c.depth) : ""));
  f.node = node;
  f.count = c.count;
  return f;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  const double most_ratio = context.threshold(rule, thresholds[0]);
  std::vector<Conflict> all;
  for (const ContactIndex i : contacts_with_thickness(rule, context)) {
    const contact::ContactSurfaces& surfaces = context.surfaces(i);
    Conflicts conflicts;
    for (const contact::ContactSide* nodes : {&surfaces.a, &surfaces.b})
      for (const contact::ContactSide* segments : {&surfaces.a, &surfaces.b})
        compare(conflicts, context, i, nodes->nodes, segments->selection.segments, most_ratio);
    for (const auto& [key, conflict] : conflicts) all.push_back(conflict);
  }
  std::vector<Found> found;
  for (std::size_t i = 0; i < all.size(); ++i)
    found.push_back(
        {all[i].contact.value, all[i].ratio, i, {element_id(model.mesh, *all[i].segments, all[i].segment)}});
  add_grouped(
      report, std::move(found), [&](const Found& f) { return words(rule, context, all[f.item]); },
      [&](const Found& f, std::uint64_t count) {
        return finding_at(rule, context, model.contact(all[f.item].contact),
                          fmt::format("{} more pairs of parts with different thickness at shared nodes", count));
      });
}

}  // namespace

const Rule definition{.identity = {"GC307", "thickness-conflict", Severity::note,
                                   "elements that share nodes have very different thickness in one contact",
                                   Need::surfaces | Need::node_penetrations,
                                   "Contact thickness jumps from element to element, so forces do too"},
                      .run = run,
                      .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::thickness_conflict
