#include <fmt/format.h>

#include <cmath>

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

/// Whole translations and rotations are the same in all axes.
bool needs_axes(unsigned freedoms) {
  const auto partly = [](unsigned three) { return three != 0 && three != 7; };
  return partly(freedoms & 7u) || partly(freedoms >> 3);
}

void choose_axes(ConditionBuilder& builder, const model::SinglePointConstraint& spc,
                 const std::vector<NodeIndex>& nodes, std::string_view keyword) {
  if (spc.system == 0) return builder.refuse_axes(nodes, keyword, spc.place);
  const auto axes = builder.system(spc.system, keyword, spc.place);
  if (axes && needs_axes(spc.freedoms)) builder.use_axes(nodes, *axes, keyword, spc.place);
}

void check_lifetime(ConditionBuilder& builder, const model::SinglePointConstraint& spc, std::string_view keyword) {
  if (!std::isfinite(spc.lifetime.birth) || !(spc.lifetime.birth < spc.lifetime.death))
    builder.fail(Failure::Kind::contradiction, keyword, spc.place,
                 fmt::format("its birth {:g} is not before its death {:g}; correct the times", spc.lifetime.birth,
                             spc.lifetime.death));
}

/// Holds the nodes between birth and death: a motion without velocity.
std::size_t hold_for_a_while(Structure& structure, const std::vector<NodeIndex>& nodes,
                             const model::SinglePointConstraint& spc) {
  Motion rest;
  rest.phases = {true, true};
  rest.support = true;
  rest.birth = spc.lifetime.birth;
  if (spc.lifetime.death < model::Lifetime::forever) rest.death = spc.lifetime.death;
  const std::uint32_t position = structure.constraints.add(rest);
  std::size_t rigid = 0;
  for (const NodeIndex node : nodes) {
    if (structure.rigid.holds(node.value)) {
      ++rigid;
      continue;
    }
    for (std::size_t freedom = 0; freedom < 6; ++freedom)
      if ((spc.freedoms >> freedom & 1u) != 0) structure.constraints.move(node, freedom, position);
  }
  return rigid;
}

}  // namespace

void apply_boundary(ConditionBuilder& builder) {
  for (const model::SinglePointConstraint& spc : builder.model.spcs) {
    const std::string_view keyword = spc.nodes.set ? "BOUNDARY_SPC_SET" : "BOUNDARY_SPC_NODE";
    const std::vector<NodeIndex> nodes = builder.nodes(spc.nodes, keyword, spc.place);
    if (!builder.failed()) choose_axes(builder, spc, nodes, keyword);
    if (!builder.failed() && !spc.lifetime.always()) check_lifetime(builder, spc, keyword);
    if (builder.failed()) return;
    const std::size_t rigid = spc.lifetime.always() ? hold(builder.structure, nodes, spc.freedoms)
                                                    : hold_for_a_while(builder.structure, nodes, spc);
    warn_about_rigid(builder, keyword, spc.place, rigid);
  }
  for (const model::NodeConstraint& constraint : builder.model.node_constraints) {
    builder.refuse_axes(constraint.nodes, "NODE", constraint.place);
    if (builder.failed()) return;
    warn_about_rigid(builder, "NODE", constraint.place, hold(builder.structure, constraint.nodes, constraint.freedoms));
  }
}

}  // namespace gapcheck::solver
