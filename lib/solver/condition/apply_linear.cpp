#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "solver/condition/condition_builder.hpp"
#include "solver/condition/linear_constraints.hpp"

namespace gapcheck::solver {
namespace {

using LinearFreedom = LinearConstraints::Freedom;

constexpr std::string_view joined_keyword = "CONSTRAINED_NODE_SET";

std::string_view linear_keyword(const model::LinearConstraint& equation) {
  return equation.local ? "CONSTRAINED_LINEAR_LOCAL" : "CONSTRAINED_LINEAR_GLOBAL";
}

/// Components of a local direction below this are rounding.
constexpr double no_share = 1e-12;
/// Equations that share degrees of freedom are solved by a full matrix.
constexpr std::size_t most_equations = 500;

/// False after a failure: the node is rigid, held or moved, or has nothing to move.
bool check_freedom(ConditionBuilder& builder, const LinearFreedom& at, std::string_view keyword, model::Place place) {
  const Structure& structure = builder.structure;
  const std::int64_t id = structure.node_id[at.node];
  const auto fail = [&](Failure::Kind kind, const std::string& why) {
    builder.fail(kind, keyword, place, why);
    return false;
  };
  if (structure.rigid.holds(at.node))
    return fail(Failure::Kind::not_calculated,
                fmt::format("node {} belongs to a rigid body; name nodes outside it", id));
  if (structure.constraints.axes(at.node) != nullptr)
    return fail(Failure::Kind::not_calculated,
                fmt::format("node {} has conditions in local axes; give them in the global axes", id));
  if ((structure.constraints.mask(at.node) >> at.freedom & 1u) != 0)
    return fail(Failure::Kind::not_calculated,
                fmt::format("node {} is held or moved in degree of freedom {}, which the constraint moves too; remove "
                            "one of both",
                            id, at.freedom + 1));
  const double mass = (at.freedom < 3 ? structure.state.mass : structure.state.inertia)[at.node];
  if (mass > 0) return true;
  return fail(Failure::Kind::zero_mass, fmt::format("node {} has no {}; give it one or leave it out", id,
                                                    at.freedom < 3 ? "mass" : "rotational inertia"));
}

void add_joined(ConditionBuilder& builder, const model::JoinedSet& set, std::set<LinearFreedom>& joined,
                LinearConstraints& constraints) {
  const auto fail = [&](Failure::Kind kind, std::string_view why) {
    builder.fail(kind, joined_keyword, set.place, why);
  };
  constexpr std::array<unsigned, 8> codes{0, 1, 2, 4, 3, 6, 5, 7};
  if (set.code < 1 || set.code > 7)
    return fail(Failure::Kind::not_calculated, fmt::format("DOF = {} is not calculated; 1 to 7 are", set.code));
  if (!(set.failure_time >= 0))
    return fail(Failure::Kind::contradiction, fmt::format("TF = {:g} is no time; set 0 or more", set.failure_time));
  const std::vector<NodeIndex> nodes = builder.nodes({set.node_set, true}, joined_keyword, set.place);
  const std::set<NodeIndex> each(nodes.begin(), nodes.end());
  if (!builder.failed() && each.size() < 2)
    fail(Failure::Kind::contradiction,
         fmt::format("node set {} has {} nodes; give it two or more", set.node_set, each.size()));
  const double end = set.failure_time > 0 ? set.failure_time : std::numeric_limits<double>::infinity();
  for (std::uint8_t axis = 0; axis < 3 && !builder.failed(); ++axis) {
    if ((codes[static_cast<std::size_t>(set.code)] >> axis & 1u) == 0) continue;
    std::vector<LinearFreedom> freedoms;
    for (const NodeIndex node : each) {
      const LinearFreedom at{node.value, axis};
      if (!check_freedom(builder, at, joined_keyword, set.place)) return;
      if (!joined.insert(at).second)
        return fail(Failure::Kind::not_calculated,
                    fmt::format("node {} shares its degree of freedom {} with two sets; join them to one",
                                builder.structure.node_id[node.value], axis + 1));
      freedoms.push_back(at);
    }
    constraints.join(freedoms, end);
  }
}

void add_linear_equation(ConditionBuilder& builder, const model::LinearConstraint& equation,
                         LinearConstraints& constraints) {
  std::vector<LinearConstraints::Term> terms;
  const auto fail = [&](Failure::Kind kind, model::Place place, std::string_view why) {
    builder.fail(kind, linear_keyword(equation), place, fmt::format("constraint {}: {}", equation.id, why));
  };
  if (equation.terms.empty())
    return fail(Failure::Kind::contradiction, equation.place, "it has no degrees of freedom; name them");
  for (const model::LinearConstraint::Term& term : equation.terms) {
    const auto node = builder.model.mesh.nodes.lookup.find(term.node);
    if (!node)
      return fail(Failure::Kind::unknown_reference, term.place,
                  fmt::format("node {} is not defined; define it", term.node));
    if (term.freedom < 1 || term.freedom > 6)
      return fail(Failure::Kind::not_calculated, term.place,
                  fmt::format("DOF = {} is not calculated; 1 to 6 are", term.freedom));
    if (term.factor == 0 || !std::isfinite(term.factor))
      return fail(Failure::Kind::contradiction, term.place,
                  fmt::format("COEF = {:g} of node {}; give a number other than 0", term.factor, term.node));
    const auto first = static_cast<std::uint8_t>(term.freedom < 4 ? 0 : 3);
    Vector direction = Vector::Unit(term.freedom - 1 - first);
    if (term.system != 0) {
      const auto axes = builder.system(term.system, linear_keyword(equation), term.place);
      if (!axes) return;
      direction = axes->col(term.freedom - 1 - first);
    }
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
      if (!(std::abs(direction[axis]) > no_share)) continue;
      const LinearFreedom at{*node, static_cast<std::uint8_t>(first + axis)};
      if (!check_freedom(builder, at, linear_keyword(equation), term.place)) return;
      terms.push_back({at, term.factor * direction[axis]});
    }
  }
  constraints.add_equation(terms);
}

}  // namespace

void apply_linear_constraints(ConditionBuilder& builder) {
  const model::Model& model = builder.model;
  const bool equations = !model.linear_constraints.empty();
  if (!equations && model.joined_sets.empty()) return;
  const model::Place place = equations ? model.linear_constraints[0].place : model.joined_sets[0].place;
  const std::string_view keyword = equations ? linear_keyword(model.linear_constraints[0]) : joined_keyword;
  const auto refuse = [&](std::string_view other) {
    builder.fail(Failure::Kind::not_calculated, keyword, place,
                 fmt::format("linear constraints and {} are not calculated in one run; leave one of both out", other));
  };
  if (!model.rigid_walls.empty()) refuse("rigid walls");
  if (!model.interpolations.empty()) refuse("*CONSTRAINED_INTERPOLATION");
  auto constraints = std::make_unique<LinearConstraints>();
  std::set<LinearFreedom> joined;
  for (const model::JoinedSet& set : model.joined_sets)
    if (!builder.failed()) add_joined(builder, set, joined, *constraints);
  for (const model::LinearConstraint& equation : model.linear_constraints)
    if (!builder.failed()) add_linear_equation(builder, equation, *constraints);
  if (builder.failed()) return;
  constraints->finish();
  if (constraints->largest_group() > most_equations)
    return builder.fail(Failure::Kind::not_calculated, keyword, place,
                        fmt::format("{} equations share degrees of freedom, which are too many to solve together; let "
                                    "at most {} share them",
                                    constraints->largest_group(), most_equations));
  builder.forces.push_back(std::move(constraints));
}

}  // namespace gapcheck::solver
