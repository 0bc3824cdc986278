#include "audit/fix/element_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/quad.hpp"
#include "contact/surface/segment_quality.hpp"

namespace gapcheck::audit {
namespace {

constexpr double slack = 1e-9;  ///< rounding does not make a shape worse
constexpr double visible_warp = 1, visible_share = 0.01;

/// Compared with the limits; larger is better, except for the warp.
struct Shape {
  double warp = 0;     ///< degrees
  double measure = 1;  ///< slenderness of shells, worst corner of solids
  bool sound = true;   ///< has an area, does not cross itself; right side out
};

Shape shell_shape(std::span<const NodeIndex> n, const std::vector<Vector>& x) {
  const contact::SegmentQuality q = contact::segment_quality({n[0], n[1], n[2], n[3]}, x);
  Shape shape;
  shape.warp = contact::warp_degrees(q);
  shape.measure = q.slenderness;
  shape.sound = q.fault == contact::SegmentFault::none || q.fault == contact::SegmentFault::repeated_node;
  return shape;
}

Shape solid_shape(std::span<const NodeIndex> n, const std::vector<Vector>& x) {
  std::array<NodeIndex, 8> nodes{};
  std::copy(n.begin(), n.end(), nodes.begin());
  const contact::SolidQuality q = contact::solid_quality(nodes, x);
  Shape shape;
  shape.measure = q.worst_corner;
  shape.sound = q.centre > 0 && q.worst_corner > 0;
  if (q.corner != none<NodeIndex>) return shape;
  // All corners are collapsed: a tetrahedron with its last node repeated.
  const Vector a = x[n[1].value] - x[n[0].value], b = x[n[2].value] - x[n[0].value], c = x[n[3].value] - x[n[0].value];
  const double lengths = a.norm() * b.norm() * c.norm();
  shape.measure = lengths > 0 ? a.cross(b).dot(c) / lengths : 0;
  shape.sound = shape.measure > 0;
  return shape;
}

Shape shape_of(std::span<const NodeIndex> n, const std::vector<Vector>& x) {
  return n.size() == 4 ? shell_shape(n, x) : n.size() == 8 ? solid_shape(n, x) : Shape{};
}

bool edges_kept(std::span<const NodeIndex> n, const std::vector<Vector>& before, const std::vector<Vector>& after,
                const ShapeLimits& limits) {
  constexpr std::array<std::array<std::size_t, 2>, 12> edges{
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  const std::size_t count = n.size() == 2 ? 1 : n.size() == 4 ? 4 : 12;
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = n[edges[i][0]].value, b = n[edges[i][1]].value;
    const double from = (before[a] - before[b]).norm(), to = (after[a] - after[b]).norm();
    if (!(to >= limits.edge_from * from * (1 - slack) && to <= limits.edge_to * from * (1 + slack))) return false;
  }
  return true;
}

bool keeps_shape(std::span<const NodeIndex> n, const std::vector<Vector>& before, const std::vector<Vector>& after,
                 const ShapeLimits& limits) {
  if (!edges_kept(n, before, after, limits)) return false;
  if (n.size() == 2) return true;
  const Shape old = shape_of(n, before), now = shape_of(n, after);
  if (old.sound && !now.sound) return false;
  if (n.size() == 4) {
    if (!(quad_normal(n.first<4>(), before).dot(quad_normal(n.first<4>(), after)) > 0) && old.sound) return false;
    return now.warp <= std::max(limits.warp, old.warp) + slack &&
           now.measure >= std::min(limits.slenderness, old.measure) - slack;
  }
  return now.measure >= std::min(limits.corner, old.measure) - slack;
}

bool worse(std::span<const NodeIndex> n, const std::vector<Vector>& before, const std::vector<Vector>& after) {
  const Shape old = shape_of(n, before), now = shape_of(n, after);
  return now.warp > old.warp + visible_warp || now.measure < old.measure - visible_share;
}

}  // namespace

/// Each element at a moved node once, with its nodes; those with missing nodes are left out.
template <class Visit>
void ElementBounds::for_each_element(std::span<const NodeIndex> moved, const Visit& visit) {
  const auto visit_kind = [&](model::ElementKind kind, const auto& elements, contact::ElementIndex& index) {
    std::vector<std::uint32_t> list;
    for (const NodeIndex node : moved) {
      const auto at = index.at(node);
      list.insert(list.end(), at.begin(), at.end());
    }
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    for (const std::uint32_t e : list) {
      const auto& n = elements.nodes[e];
      if (std::find(n.begin(), n.end(), none<NodeIndex>) == n.end())
        visit(ElementOfKind{kind, e}, std::span<const NodeIndex>(n));
    }
  };
  visit_kind(model::ElementKind::shell, model_.mesh.shells, index_.shells);
  visit_kind(model::ElementKind::solid, model_.mesh.solids, index_.solids);
  visit_kind(model::ElementKind::thick_shell, model_.mesh.thick_shells, index_.thick_shells);
  visit_kind(model::ElementKind::beam, model_.mesh.beams, index_.beams);
}

double ElementBounds::least_step() {
  if (least_step_) return *least_step_;
  const double smallest = steps_.smallest(deck_);
  return least_step_.emplace(std::isfinite(smallest) ? limits_.step * smallest : 0);
}

bool ElementBounds::keeps_step(const ElementOfKind& element, const std::vector<Vector>& x) {
  const double least = least_step() * (1 - slack), now = steps_(element.first, element.second, x);
  return now >= least || now >= steps_(element.first, element.second, deck_) * (1 - slack);
}

ShapeLimits ElementBounds::limits_of(const ElementOfKind& element) {
  ShapeLimits limits = limits_;
  const double step = steps_(element.first, element.second, deck_);
  if (step > 0) limits.edge_from = std::min(1.0, std::max(limits.edge_from, least_step() / step));
  return limits;
}

std::vector<ElementOfKind> ElementBounds::broken(const std::vector<Vector>& x, std::span<const NodeIndex> moved) {
  std::vector<ElementOfKind> list;
  for_each_element(moved, [&](const ElementOfKind& element, std::span<const NodeIndex> nodes) {
    if (!keeps_shape(nodes, deck_, x, limits_) || !keeps_step(element, x)) list.push_back(element);
  });
  return list;
}

std::vector<NodeIndex> ElementBounds::offenders(const std::vector<Vector>& x,
                                                std::span<const ElementOfKind> elements) const {
  std::vector<NodeIndex> held;
  for (const ElementOfKind& element : elements) {
    const std::span<const NodeIndex> nodes = nodes_of(model_.mesh, element);
    double most = 0;
    for (const NodeIndex n : nodes) most = std::max(most, (x[n.value] - deck_[n.value]).norm());
    for (const NodeIndex n : nodes)
      if (const double move = (x[n.value] - deck_[n.value]).norm(); move > 0 && !(move < most / 2)) held.push_back(n);
  }
  std::sort(held.begin(), held.end());
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
}

ElementBounds::Change ElementBounds::change(const std::vector<Vector>& x, std::span<const NodeIndex> moved) {
  Change change;
  for_each_element(moved, [&](const ElementOfKind&, std::span<const NodeIndex> nodes) {
    ++change.touched;
    change.worsened += worse(nodes, deck_, x) ? 1 : 0;
  });
  return change;
}

}  // namespace gapcheck::audit
