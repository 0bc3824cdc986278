#include <fmt/format.h>

#include "solver/condition/condition_builder.hpp"

namespace gapcheck::solver {
namespace {

/// Holds those of the nodes that are in no rigid body; returns how many are in one.
std::size_t hold(Structure& structure, const std::vector<NodeIndex>& nodes, std::uint8_t freedoms) {
  std::size_t rigid = 0;
  for (const NodeIndex node : nodes) {
    if (structure.rigid.holds(node.value))
      ++rigid;
    else
      structure.constraints.hold(node, freedoms);
  }
  return rigid;
}

void warn_about_rigid(ConditionBuilder& builder, std::string_view keyword, model::Place place, std::size_t rigid) {
  if (rigid > 0)
    builder.warn(keyword, place,
                 fmt::format("{} of the nodes belong to rigid bodies, which it does not hold; hold the body by CMO, "
                             "CON1 and CON2 of its *MAT_RIGID",
                             rigid));
}

}  // namespace

void apply_boundary(ConditionBuilder& builder) {
  for (const model::SinglePointConstraint& spc : builder.model.spcs) {
    const std::string_view keyword = spc.nodes.set ? "BOUNDARY_SPC_SET" : "BOUNDARY_SPC_NODE";
    builder.refuse_system(spc.system, keyword, spc.place);
    if (!spc.lifetime.always())
      builder.fail(Failure::Kind::not_calculated, keyword, spc.place,
                   "constraints with a birth or death time are not calculated; remove the times");
    const std::vector<NodeIndex> nodes = builder.nodes(spc.nodes, keyword, spc.place);
    if (builder.failed()) return;
    warn_about_rigid(builder, keyword, spc.place, hold(builder.structure, nodes, spc.freedoms));
  }
  for (const model::NodeConstraint& constraint : builder.model.node_constraints)
    warn_about_rigid(builder, "NODE", constraint.place, hold(builder.structure, constraint.nodes, constraint.freedoms));
}

}  // namespace gapcheck::solver
