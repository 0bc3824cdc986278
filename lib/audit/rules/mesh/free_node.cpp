#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/mesh_finding.hpp"
#include "contact/definition/contact_type.hpp"
#include "contact/mesh/element_nodes.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "model/read/node_references.hpp"

namespace gapcheck::audit::rule::free_node {
namespace {

constexpr std::array thresholds{
    Threshold{"share", 0.01, 0, 1, "share of all nodes that nothing uses, from which on they are listed"}};

/// Nodes that sides of contacts name one by one.
void report_tracked(const RuleIdentity& rule, Context& context, Report& report, const std::vector<std::uint8_t>& used) {
  const model::Model& model = context.model();
  const std::vector<std::int64_t>& ids = model.mesh.nodes.id;
  std::vector<Found> found;
  for (const ContactIndex c : context.contacts()) {
    const model::Contact& contact = model.contact(c);
    if (!contact.known || contact.own_layout || contact::classify(contact).treatment == contact::Treatment::none)
      continue;
    const contact::ContactSurfaces& surfaces = context.surfaces(c);
    for (const NodeIndex n : surfaces.a.selection.nodes)
      if (used[n.value] == 0) found.push_back({c.value, 0, n.value, {ids[n.value]}});
    if (!surfaces.two_sided()) continue;
    for (const NodeIndex n : surfaces.b.selection.nodes)
      if (used[n.value] == 0) found.push_back({c.value, 0, n.value, {ids[n.value]}});
  }
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        const NodeIndex node{static_cast<std::uint32_t>(f.item)};
        const std::int64_t contact = model.contacts[static_cast<std::size_t>(f.group)].id.value;
        Finding at =
            node_finding(rule, context, node,
                         fmt::format("node {} is tracked by contact {} but belongs to no element: it has no mass, and "
                                     "contact cannot act on it; take it out of the node set",
                                     model.mesh.nodes.id[node.value], contact));
        at.contact = contact;
        at.severity = Severity::warning;
        return at;
      },
      [&](const Found& f, std::uint64_t count) {
        const model::Contact& contact = model.contacts[static_cast<std::size_t>(f.group)];
        Finding at = finding_at(
            rule, context, contact,
            fmt::format("{} more tracked nodes of contact {} belong to no element", count, contact.id.value));
        at.severity = Severity::warning;
        return at;
      },
      collect_nodes(context, [](const Found& f) { return NodeIndex{static_cast<std::uint32_t>(f.item)}; }));
}

/// One line for all nodes that nothing uses.
void report_unused(const RuleIdentity& rule, Context& context, Report& report, std::vector<std::uint8_t> used) {
  const model::Model& model = context.model();
  const auto mark = [&](NodeIndex n) { used[n.value] = 1; };
  for (const auto& [id, set] : model.sets.nodes) std::for_each(set.members.begin(), set.members.end(), mark);
  for (const auto& [id, set] : model.sets.segments)
    for (const model::SegmentNodes& nodes : set.members) std::for_each(nodes.begin(), nodes.end(), mark);
  for (const model::RigidGroup& group : model.rigid_groups) std::for_each(group.nodes.begin(), group.nodes.end(), mark);
  if (std::find(used.begin(), used.end(), 0) == used.end()) return;
  const std::vector<std::uint8_t> referenced = model::referenced_nodes(context.deck(), model, "");
  const std::vector<std::int64_t>& ids = model.mesh.nodes.id;
  std::vector<std::uint32_t> unused;
  for (const NodeIndex n : positions<NodeIndex>(used.size()))
    if (used[n.value] == 0 && referenced[n.value] == 0) unused.push_back(n.value);
  if (unused.empty()) return;
  // Less is waste that costs nothing: what remains of a mesh that was cut or meshed again.
  if (static_cast<double>(unused.size()) < context.threshold(rule, thresholds[0]) * static_cast<double>(ids.size()))
    return context.skipped(rule,
                           fmt::format("{} nodes belong to no element and no set: too few to matter", unused.size()));
  const std::uint32_t first =
      *std::min_element(unused.begin(), unused.end(), [&](auto a, auto b) { return ids[a] < ids[b]; });
  const std::int64_t id = ids[first];
  const std::size_t count = unused.size();
  Finding at = node_finding(
      rule, context, NodeIndex{first},
      count == 1 ? fmt::format("node {} belongs to no element and no set; delete it", id)
                 : fmt::format("{} nodes belong to no element and no set, the first is {}; delete them", count, id));
  at.count = count;
  if (context.options().members)
    for (const std::uint32_t n : unused) at.members.nodes.push_back(ids[n]);
  report.findings.push_back(std::move(at));
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  if (context.contacts().empty()) return context.skipped(rule, "there is no contact");
  const keyword::DeckCounters& read = context.deck().counters();
  if (read.missing_includes > 0 || read.encrypted_blocks > 0)
    return context.skipped(rule, "the deck is not complete, so elements may be missing");
  const std::vector<std::uint8_t> used = contact::element_nodes(context.model().mesh);
  report_tracked(rule, context, report, used);
  if (context.options().parts.empty()) report_unused(rule, context, report, used);
}

}  // namespace

const Rule definition{.identity = {"GC508", "free-node", Severity::note, "a node belongs to no element", Need::surfaces,
                                   "The node does nothing"},
                      .run = run,
                      .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::free_node
