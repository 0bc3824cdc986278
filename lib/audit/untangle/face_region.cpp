#include "audit/untangle/face_region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "audit/untangle/flood.hpp"

namespace gapcheck::audit {
namespace {

/// True if the segment has the edge from a to b, in this order.
bool runs_along(const model::SegmentNodes& n, NodeIndex a, NodeIndex b) {
  for (std::size_t i = 0; i < 4; ++i)
    if (n[i] == a && n[(i + 1) % 4] == b) return true;
  return false;
}

}  // namespace

bool FaceRegion::grow(std::span<const FaceSide> from, const contact::Bounds& box, std::uint64_t& work) {
  for (const FaceSide& face : from) add(face);
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const FaceSide face = faces_[i];
    if (work == 0) return false;
    --work;
    for_each_edge(surface_.segments(), face.segment, [&](NodeIndex a, NodeIndex b) { pass(face, a, b, box); });
  }
  return true;
}

/// Over the edge from a to b.
void FaceRegion::pass(const FaceSide& face, NodeIndex a, NodeIndex b, const contact::Bounds& box) {
  const contact::Segments& segments = surface_.segments();
  std::size_t count = 0;
  SegmentIndex next = face.segment;
  for (const SegmentIndex s : surface_.neighbours().at(a)) {
    const auto& n = segments.nodes[s.value];
    if (!runs_along(n, a, b) && !runs_along(n, b, a)) continue;
    ++count;
    if (s != face.segment) next = s;
  }
  if (count != 2 || side_.contains(next.value) || !bounds(next).meets(box)) return;
  add({next, runs_along(segments.nodes[next.value], b, a) ? face.side : -face.side});
}

void FaceRegion::add(const FaceSide& face) {
  if (!side_.emplace(face.segment.value, face.side).second) return;
  faces_.push_back(face);
  boxes_.push_back(bounds(face.segment));
}

contact::Bounds FaceRegion::bounds(SegmentIndex segment) const {
  contact::Bounds bounds;
  for (const NodeIndex n : surface_.segments().nodes[segment.value]) bounds.add(surface_.x()[n.value]);
  return bounds;
}

NearestFace FaceRegion::nearest(NodeIndex node) const {
  const std::vector<Vector>& x = surface_.x();
  double least = std::numeric_limits<double>::infinity();
  NearestFace found{{}, least, false, false};
  const Vector& q = x[node.value];
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const Vector beside = (boxes_[i].low - q).cwiseMax(q - boxes_[i].high).cwiseMax(0.0);
    if (beside.squaredNorm() > least) continue;
    const FaceSide& face = faces_[i];
    const auto& n = surface_.segments().nodes[face.segment.value];
    if (std::find(n.begin(), n.end(), node) != n.end()) continue;
    const geometry::Facet facet{{x[n[0].value], x[n[1].value], x[n[2].value], x[n[3].value]}, n[2] == n[3]};
    const auto c = geometry::closest_point(facet, q);
    if (!(c.squared_distance < least)) continue;
    least = c.squared_distance;
    found = {face, std::sqrt(least), c.in_band, false};
    found.above = !at_end(face.segment, c);
  }
  return found;
}

/// True if the closest point is on an edge of a segment that no other segment has.
bool FaceRegion::at_end(SegmentIndex segment, const geometry::ClosestPoint& closest) const {
  if (closest.feature == Feature::face) return false;
  const auto& n = surface_.segments().nodes[segment.value];
  const std::size_t i = closest.feature_index;
  const auto free = [&](std::size_t k) {
    const NodeIndex a = n[k % 4], b = n[(k + 1) % 4];
    return a != b && surface_.neighbours().free_edge(segment, a, b);
  };
  return free(i) || (closest.feature == Feature::corner && free(i + 3));
}

}  // namespace gapcheck::audit
