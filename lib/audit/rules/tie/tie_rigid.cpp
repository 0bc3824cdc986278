#include <fmt/format.h>

#include <set>

#include "audit/rules.hpp"
#include "audit/shared/tied_contacts.hpp"

namespace gapcheck::audit::rule::tie_rigid {
namespace {

using contact::JudgedNode;
using contact::RigidOwner;

/// Nodes that one kind of rigid partner keeps untied.
struct Affected {
  std::uint64_t nodes = 0;
  std::int64_t first = 0;  ///< id of the first one
  std::set<std::int64_t> parts, bodies;

  void add(const model::Model& model, const JudgedNode& node) {
    if (nodes++ == 0) first = model.mesh.nodes.id[node.node.value];
    if (node.rigid.kind == RigidOwner::Kind::part) {
      parts.insert(model.part(PartIndex{node.rigid.index}).id.value);
    } else {
      const model::RigidGroup& group = model.rigid_groups[node.rigid.index];
      (group.kind == model::RigidGroup::Kind::extra_nodes ? parts : bodies).insert(group.id);
    }
  }
  /// "rigid part 4, 5, nodal rigid body 7"
  [[nodiscard]] std::string owners() const {
    std::string text;
    const auto list = [&](const char* what, const std::set<std::int64_t>& ids) {
      if (!ids.empty())
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", what, first_few({ids.begin(), ids.end()}));
    };
    list("rigid part", parts);
    list("nodal rigid body", bodies);
    return text;
  }
};

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  for_each_tied_contact(context, [&](ContactIndex c, std::span<const JudgedNode> nodes) {
    Affected tracked, reference;
    for (const JudgedNode& node : nodes) {
      // Nodes of nodal rigid bodies and extra nodes belong to tie-conflict.
      if (node.reason == TieReason::rigslav && node.rigid.kind == RigidOwner::Kind::part) tracked.add(model, node);
      if (node.reason == TieReason::rigmast) reference.add(model, node);
    }
    if (tracked.nodes + reference.nodes == 0) return;
    std::string what;
    if (tracked.nodes > 0) what = fmt::format("{} of {}", node_count(tracked.nodes), tracked.owners());
    if (reference.nodes > 0)
      what += fmt::format("{}{} on segments of {}", what.empty() ? "" : " and ", node_count(reference.nodes),
                          reference.owners());
    const model::Contact& contact = model.contact(c);
    Finding f = finding_at(rule, context, contact,
                           fmt::format("*{} ties by constraint, which rigid bodies do not take; untied are {}; use "
                                       "the OFFSET form or *CONSTRAINED_EXTRA_NODES",
                                       contact.written, what));
    f.node = tracked.nodes > 0 ? tracked.first : reference.first;
    f.count = tracked.nodes + reference.nodes;
    report.findings.push_back(std::move(f));
  });
}

}  // namespace

const Rule definition{
    {"GC206", "tie-rigid", Severity::error, "a constraint tie meets rigid bodies, which it cannot tie", Need::ties,
     "The tie does not hold rigid bodies: the parts separate"},
    run};

}  // namespace gapcheck::audit::rule::tie_rigid
