#include "reference/free_edges.hpp"

#include <algorithm>

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
  if (facet.solid || facet.coated || facet.line || c.feature == Feature::face) return false;
  const std::size_t count = corner_count(facet);
  const auto edge_of = [&](std::size_t i) -> Edge { return std::minmax(facet.nodes[i], facet.nodes[(i + 1) % count]); };
  if (c.feature == Feature::edge) return uses_.at(edge_of(c.place)) == 1;
  const std::int64_t corner = facet.nodes[c.place];
  const bool border = std::any_of(uses_.begin(), uses_.end(), [&](const auto& entry) {
    return entry.second == 1 && (entry.first.first == corner || entry.first.second == corner);
  });
  return border;
}

}  // namespace gapcheck::reference
