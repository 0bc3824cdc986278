#include "reference/orientation.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace gapcheck::reference {
namespace {

/// Nearby: in the box around the segment, grown by its longer diagonal.
bool nearby(const Corners& c, const Vector& query) {
  Vector low = c[0], high = c[0];
  for (const Vector& corner : c) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  const double diagonal = std::max((c[2] - c[0]).norm(), (c[3] - c[1]).norm());
  return (query.array() >= low.array() - diagonal).all() && (query.array() <= high.array() + diagonal).all();
}

/// Four units in the last place of the largest coordinate: nearer to a segment, a node is on neither side of it.
double rounding(const Corners& c, const Vector& query) {
  double largest = query.cwiseAbs().maxCoeff();
  for (const Vector& corner : c) largest = std::max(largest, corner.cwiseAbs().maxCoeff());
  return 4 * (std::nextafter(largest, 1e308) - largest);
}

}  // namespace

bool turns(const Rules& rules, const Side& reference) {
  return rules.oriented && (reference.turned_by_default || rules.controls.orien == 2);
}

Turns turned_parts(const Rules& rules, const Side& tracked, const Side& reference, const Positions& x) {
  Turns votes;
  for (const Facet& facet : reference.facets) {
    if (facet.solid || facet.line || facet.coated) continue;
    int& vote = votes[facet.part];
    if (!turns(rules, reference)) continue;
    const Corners around = corners(facet.nodes, x);
    for (const auto& [node, half] : tracked.nodes) {
      const Vector& query = x[static_cast<std::size_t>(node)];
      if (facet.has(node) || !nearby(around, query)) continue;
      const Closest c = closest(around, facet.triangle, query);
      const bool on_segment = c.beyond_band <= (facet.triangle ? -0.25 : -0.5) + 1e-9;
      if (on_segment && c.distance > rounding(around, query)) vote += c.normal.dot(query - c.point) > 0 ? 1 : -1;
    }
  }
  Turns result;
  for (const auto& [part, vote] : votes) result[part] = vote < 0 ? -1 : 1;
  return result;
}

}  // namespace gapcheck::reference
