#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "audit/shared/tied_contacts.hpp"

namespace gapcheck::audit::rule::tie_reach {
namespace {

using contact::JudgedNode;

/// Rounded up to four digits, so that the printed number reaches as far; not for mere rounding.
double rounded_up(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 3);
  return std::ceil(value / unit * (1 - 1e-10)) * unit;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  for_each_tied_contact(context, [&](ContactIndex c, std::span<const JudgedNode> nodes) {
    const JudgedNode* farthest = nullptr;
    std::uint64_t far = 0;
    double thickness = 0;
    // Equally far but for rounding: the smallest id.
    const auto before = [&](const JudgedNode& a, const JudgedNode& b) {
      const double by = rough_weight(a.distance) - rough_weight(b.distance);
      return by != 0 ? by > 0 : model.mesh.nodes.id[a.node.value] < model.mesh.nodes.id[b.node.value];
    };
    for (const JudgedNode& node : nodes) {
      if (!node.tied() && node.reason != TieReason::too_far) continue;
      // Nodes that tie now must still tie when only thickness counts.
      thickness = std::max(thickness, node.distance / contact::tie_thickness_share - node.segment_thickness);
      if (node.tied()) continue;
      ++far;
      if (farthest == nullptr || before(node, *farthest)) farthest = &node;
    }
    if (far == 0 || !(thickness > 0) || !std::isfinite(thickness)) return;
    const std::int64_t id = model.mesh.nodes.id[farthest->node.value];
    Finding f = finding_at(
        rule, context, model.contact(c),
        fmt::format(
            "{} too far to tie, node {} by most: {:.6g} from its segment, tie distance {:.6g}; SST = {:.6g} would "
            "tie {} and all that tie now",
            far == 1 ? "1 node is" : fmt::format("{} nodes are", far), id, farthest->distance, farthest->allowed,
            -rounded_up(thickness), far == 1 ? "it" : "them"));
    f.node = id;
    f.count = far;
    report.findings.push_back(std::move(f));
  });
}

}  // namespace

const Rule definition{
    {"GC208", "tie-reach", Severity::note, "the negative SST that would tie the nodes that are too far", Need::ties,
     "The nodes stay untied as long as the reach is too short"},
    run};

}  // namespace gapcheck::audit::rule::tie_reach
