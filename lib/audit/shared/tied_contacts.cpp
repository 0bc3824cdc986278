#include "audit/shared/tied_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audit/grouped.hpp"
#include "audit/shared/free_thickness.hpp"
#include "audit/shared_results.hpp"

namespace gapcheck::audit {

void for_each_tied_contact(Context& context,
                           const std::function<void(ContactIndex, std::span<const contact::JudgedNode>)>& visit) {
  const auto chosen = context.contacts();
  const bool any = std::any_of(chosen.begin(), chosen.end(), [&](ContactIndex i) {
    return contact::classify(context.model().contact(i)).family == contact::Family::tied;
  });
  if (!any) return;
  const std::vector<contact::JudgedNode>& all = context.results().initial().judged;
  std::vector<contact::JudgedNode> kept;
  for (auto first = all.begin(); first != all.end();) {
    const auto end = std::find_if(first, all.end(), [&](const auto& node) { return node.contact != first->contact; });
    if (context.options().parts.empty()) {
      visit(first->contact, {first, end});
    } else {
      kept.clear();
      std::copy_if(first, end, std::back_inserter(kept),
                   [&](const auto& node) { return context.part_chosen(node.part); });
      if (!kept.empty()) visit(first->contact, kept);
    }
    first = end;
  }
}

std::optional<FarNodes> far_nodes(const model::Model& model, std::span<const contact::JudgedNode> nodes) {
  FarNodes far;
  double thickness = 0;
  // Equally far but for rounding: the smallest id.
  const auto before = [&](const contact::JudgedNode& a, const contact::JudgedNode& b) {
    const double by = rough_weight(a.distance) - rough_weight(b.distance);
    return by != 0 ? by > 0 : model.mesh.nodes.id[a.node.value] < model.mesh.nodes.id[b.node.value];
  };
  for (const contact::JudgedNode& node : nodes) {
    if (!node.tied() && node.reason != TieReason::too_far) continue;
    // Nodes that tie now must still tie when only thickness counts.
    thickness = std::max(thickness, node.distance / contact::tie_thickness_share - node.segment_thickness);
    if (node.tied()) continue;
    ++far.count;
    if (far.farthest == nullptr || before(node, *far.farthest)) far.farthest = &node;
  }
  if (far.count == 0 || !(thickness > 0) || !std::isfinite(thickness)) return std::nullopt;
  far.reach = rounded_up(thickness);
  return far;
}

std::string first_few(const std::vector<std::int64_t>& numbers) {
  constexpr std::size_t few = 5;
  const auto end = numbers.begin() + static_cast<std::ptrdiff_t>(std::min(few, numbers.size()));
  return fmt::format("{}{}", fmt::join(numbers.begin(), end, ", "), numbers.size() > few ? ", ..." : "");
}

std::string node_count(std::uint64_t nodes) { return fmt::format("{} node{}", nodes, nodes == 1 ? "" : "s"); }

}  // namespace gapcheck::audit
