#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "audit/rules.hpp"
#include "audit/shared/tied_contacts.hpp"

namespace gapcheck::audit::rule::tie_conflict {
namespace {

using contact::JudgedNode;
using contact::RigidOwner;

/// Who else has a node: a tied contact (position in Model::contacts) or a rigid group (in Model::rigid_groups).
struct Holder {
  bool rigid = false;
  std::uint32_t index = 0;
  auto operator<=>(const Holder&) const = default;
};

std::optional<Holder> holder(const JudgedNode& node) {
  if (node.reason == TieReason::conflict) return Holder{false, node.holder.value};
  // Nodes of rigid parts belong to tie-rigid.
  if (node.reason == TieReason::rigslav && node.rigid.kind == RigidOwner::Kind::group)
    return Holder{true, node.rigid.index};
  return std::nullopt;
}

std::string describe(const model::Model& model, const Holder& holder) {
  if (!holder.rigid)
    return fmt::format("contact {}, which comes first in the deck,", model.contacts[holder.index].id.value);
  const model::RigidGroup& group = model.rigid_groups[holder.index];
  const bool extra = group.kind == model::RigidGroup::Kind::extra_nodes;
  return fmt::format("{} {}", extra ? "*CONSTRAINED_EXTRA_NODES of rigid part" : "nodal rigid body", group.id);
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  for_each_tied_contact(context, [&](ContactIndex c, std::span<const JudgedNode> nodes) {
    std::map<Holder, std::vector<std::int64_t>> held;
    for (const JudgedNode& node : nodes)
      if (const auto by = holder(node)) held[*by].push_back(model.mesh.nodes.id[node.node.value]);
    for (auto& [by, ids] : held) {
      std::sort(ids.begin(), ids.end());
      Finding f = finding_at(
          rule, context, model.contact(c),
          fmt::format("{} ({}) cannot be tied: {} constrains {} already; tie once only, or by "
                      "penalty (an OFFSET form, IPBACK = 1)",
                      node_count(ids.size()), first_few(ids), describe(model, by), ids.size() == 1 ? "it" : "them"));
      f.node = ids.front();
      f.count = ids.size();
      report.findings.push_back(std::move(f));
    }
  });
}

}  // namespace

const Rule definition{{"GC203", "tie-conflict", Severity::warning,
                       "two definitions constrain the same nodes; the later one does not get them", Need::ties,
                       "The later definition does not hold these nodes"},
                      run};

}  // namespace gapcheck::audit::rule::tie_conflict
