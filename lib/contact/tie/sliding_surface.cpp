#include "contact/tie/sliding_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/quad.hpp"
#include "geometry/closest_point.hpp"

namespace gapcheck::contact {

SlidingSurface::SlidingSurface(const Segments& segments) : segments_(segments) {
  std::vector<std::pair<NodeIndex, std::uint32_t>> pairs;
  for (std::uint32_t s = 0; s < segments.size(); ++s)
    for (const NodeIndex node : segments.nodes[s]) pairs.emplace_back(node, s);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const auto& [node, segment] : pairs) {
    if (nodes_.empty() || nodes_.back() != node) {
      nodes_.push_back(node);
      first_.push_back(static_cast<std::uint32_t>(segments_at_.size()));
    }
    segments_at_.push_back(segment);
  }
  first_.push_back(static_cast<std::uint32_t>(segments_at_.size()));
}

std::span<const std::uint32_t> SlidingSurface::segments_at(NodeIndex node) const {
  const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), node);
  if (found == nodes_.end() || *found != node) return {};
  const auto at = static_cast<std::size_t>(found - nodes_.begin());
  return std::span(segments_at_).subspan(first_[at], first_[at + 1] - first_[at]);
}

SlidingSurface::Foot SlidingSurface::nearest(SegmentIndex from, const Vector& node,
                                             const std::vector<Vector>& x) const {
  Foot best;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](std::uint32_t s) {
    const model::SegmentNodes& n = segments_.nodes[s];
    const geometry::Facet facet{{x[n[0].value], x[n[1].value], x[n[2].value], x[n[3].value]}, n[2] == n[3]};
    const geometry::ClosestPoint closest = geometry::closest_point(facet, node);
    const bool first = best.segment.value > s && closest.squared_distance == least;
    if (!(closest.squared_distance < least) && !first) return;
    least = closest.squared_distance;
    best = {SegmentIndex{s}, closest.s, closest.t, closest.point, closest.normal, false};
  };
  look(from.value);
  for (const NodeIndex corner : segments_.nodes[from.value])
    for (const std::uint32_t s : segments_at(corner)) look(s);
  const Vector way = node - best.point;
  const double size = std::sqrt(quad_normal(segments_.nodes[best.segment.value], x).norm() / 2);
  constexpr double beside = 0.1;
  best.off = !((way - way.dot(best.normal) * best.normal).norm() <= beside * size);
  return best;
}

}  // namespace gapcheck::contact
