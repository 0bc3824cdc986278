#include "solver/constraint/constraint_solve.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

/// Below this share of the response of free node and corners, a constraint counts as held.
constexpr double least_compliance_share = 1e-9;
constexpr double largest_open_share = 1e-12;

/// Relative displacement of node and segment per unit force: along the normal, and the maximum in any direction.
struct Compliance {
  double normal = 0, any = 0;
};

Compliance compliance(const SurfaceConstraint& c, const NodeResponse& response) {
  Compliance sum;
  const auto add = [&](NodeIndex node, double weight) {
    const Vector& give = response.give[node.value];
    sum.normal += weight * weight * give.dot(c.normal.cwiseAbs2());
    sum.any += weight * weight * give.maxCoeff();
  };
  add(c.node, 1);
  for (std::size_t i = 0; i < 4; ++i)
    if (c.segment.weights[i] != 0) add(c.segment.nodes[i], c.segment.weights[i]);
  return sum;
}

Vector relative(const SurfaceConstraint& c, const std::vector<Vector>& moved) {
  return moved[c.node.value] - c.segment.of(moved);
}

void push(const SurfaceConstraint& c, const Vector& force, NodeResponse& response) {
  const auto give = [&](NodeIndex node, double weight) {
    response.moved[node.value] += weight * response.give[node.value].cwiseProduct(force);
  };
  give(c.node, 1);
  for (std::size_t i = 0; i < 4; ++i)
    if (c.segment.weights[i] != 0) give(c.segment.nodes[i], -c.segment.weights[i]);
}

/// Updates one constraint's reactions with all others fixed; returns the displacement.
double relax(SurfaceConstraint& c, const Compliance& k, NodeResponse& response) {
  if (!(k.normal > least_compliance_share * k.any)) return 0;
  const double gap = c.depth - c.normal.dot(relative(c, response.moved));
  const double before = c.push;
  c.push = std::max(0.0, c.push + gap / k.normal);
  double change = std::abs(c.push - before) * k.normal;
  push(c, (c.push - before) * c.normal, response);
  const double limit = std::min(c.friction * c.push, c.greatest_shear);
  if (!(c.friction > 0) && c.shear.isZero(0)) return change;
  const Vector slip = c.slip + relative(c, response.moved);
  Vector shear = c.shear - (slip - slip.dot(c.normal) * c.normal) / k.any;
  const double size = shear.norm();
  if (size > limit) shear *= limit / size;
  push(c, shear - c.shear, response);
  change = std::max(change, (shear - c.shear).norm() * k.any);
  c.shear = shear;
  return change;
}

}  // namespace

ConstraintSolution solve_constraints(std::span<SurfaceConstraint> constraints, NodeResponse& response,
                                     std::size_t most_sweeps) {
  std::vector<Compliance> compliances;
  compliances.reserve(constraints.size());
  double scale = 0;
  for (const SurfaceConstraint& c : constraints) {
    compliances.push_back(compliance(c, response));
    scale = std::max({scale, std::abs(c.depth), c.friction > 0 ? c.slip.norm() : 0});
  }
  ConstraintSolution solution;
  while (solution.sweeps < most_sweeps) {
    ++solution.sweeps;
    solution.open = 0;
    for (std::size_t i = 0; i < constraints.size(); ++i)
      solution.open = std::max(solution.open, relax(constraints[i], compliances[i], response));
    if (!(solution.open > largest_open_share * scale)) break;
  }
  return solution;
}

}  // namespace gapcheck::solver
