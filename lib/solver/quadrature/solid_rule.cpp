#include "solver/quadrature/solid_rule.hpp"

#include <algorithm>

#include "model/entity/faces.hpp"

namespace gapcheck::solver {
namespace {

/// The edges of a brick that have one direction, in order round it: two that follow each other are opposite in a side.
constexpr std::size_t parallel_edges[3][4][2] = {
    {{0, 1}, {3, 2}, {7, 6}, {4, 5}}, {{0, 3}, {1, 2}, {5, 6}, {4, 7}}, {{0, 4}, {1, 5}, {2, 6}, {3, 7}}};

std::size_t different(std::array<NodeIndex, 8> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return static_cast<std::size_t>(std::unique(nodes.begin(), nodes.end()) - nodes.begin());
}

bool is_wedge(const std::array<NodeIndex, 8>& nodes) {
  if (different(nodes) != 6) return false;
  for (const auto& edges : parallel_edges)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& one = edges[k];
      const auto& next = edges[(k + 1) % 4];
      if (nodes[one[0]] == nodes[one[1]] && nodes[next[0]] == nodes[next[1]]) return true;
    }
  return false;
}

}  // namespace

SolidShape solid_shape(const std::array<NodeIndex, 8>& nodes) {
  if (model::is_tetrahedron(nodes)) return SolidShape::tetrahedron;
  if (different(nodes) == 8) return SolidShape::brick;
  return is_wedge(nodes) ? SolidShape::wedge : SolidShape::other;
}

SolidRules solid_rules(std::int64_t elform, std::int64_t esort) {
  const std::int64_t sorted = esort > 10 ? esort - 10 : esort;
  const bool all = sorted == 1 || sorted == 3, full = all || sorted == 2 || sorted == 4;
  SolidRules rules;
  if (elform == 13 || stands_in_nodal_pressure(elform) || (esort > 10 && elform != 10))
    rules.tetrahedron = SolidRule::nodal_pressure;
  switch (elform) {
    case 2:
    case 3:
    case 18:
      rules.brick = SolidRule::eight_points;
      break;
    case -1:
      rules.brick = SolidRule::efficient;
      break;
    case -2:
      rules.brick = SolidRule::accurate;
      break;
    case 15:
      rules.brick = rules.wedge = rules.other = SolidRule::wedge;
      return rules;
    default:
      if (all) rules.wedge = SolidRule::wedge;
      return rules;
  }
  rules.wedge = full ? SolidRule::wedge : SolidRule::eight_points;
  rules.other = SolidRule::eight_points;
  return rules;
}

std::array<double, 8> corner_shares(SolidRule rule, const std::array<NodeIndex, 8>& nodes) {
  std::array<double, 8> shares;
  shares.fill(1.0 / 8);
  if (rule != SolidRule::wedge) return shares;
  for (std::size_t k = 0; k < 8; ++k)
    shares[k] = 1.0 / 6 / static_cast<double>(std::count(nodes.begin(), nodes.end(), nodes[k]));
  return shares;
}

}  // namespace gapcheck::solver
