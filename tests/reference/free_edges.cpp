#include "reference/free_edges.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace gapcheck::reference {
namespace {

std::size_t corner_count(const Facet& facet) { return facet.triangle ? 3 : 4; }

}  // namespace

FreeEdges::FreeEdges(const Side& side) {
  for (const Facet& facet : side.facets) {
    if (facet.line) continue;
    const std::size_t count = corner_count(facet);
    for (std::size_t i = 0; i < count; ++i) {
      const Edge edge = std::minmax(facet.nodes[i], facet.nodes[(i + 1) % count]);
      ++uses_[edge];
    }
  }
}

bool FreeEdges::beside(const Facet& facet, const Closest& c) const {
  if (facet.solid || facet.line || c.feature == Feature::face) return false;
  const std::size_t count = corner_count(facet);
  const auto edge_of = [&](std::size_t i) -> Edge { return std::minmax(facet.nodes[i], facet.nodes[(i + 1) % count]); };
  if (c.feature == Feature::edge) return uses_.at(edge_of(c.place)) == 1;
  return ends_at(facet.nodes[c.place]);
}

bool FreeEdges::ends_at(std::int64_t node) const {
  return std::any_of(uses_.begin(), uses_.end(), [&](const auto& entry) {
    return entry.second == 1 && (entry.first.first == node || entry.first.second == node);
  });
}

bool FreeEdges::level_with_end(const Facet& facet, const Closest& c, const Corners& x, const Vector& query) const {
  if (facet.solid || facet.line || c.feature == Feature::face) return false;
  constexpr double digits = 1e-9;
  // Straight above the border: how far outside the band a projection on the border lies.
  if (std::abs(c.beyond_band + (facet.triangle ? 0.25 : 0.5)) < digits) return beside(facet, c);
  const std::size_t count = corner_count(facet);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    if (uses_.at(std::minmax(facet.nodes[i], facet.nodes[next])) == 1) continue;
    const Vector along = x[next] - x[i];
    for (const std::size_t end : {i, next})
      if (std::abs((query - x[end]).dot(along)) < digits * along.squaredNorm() &&
          (c.point - x[end]).norm() < digits * along.norm() && ends_at(facet.nodes[end]))
        return true;
  }
  return false;
}

}  // namespace gapcheck::reference
