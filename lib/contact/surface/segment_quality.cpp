#include "contact/surface/segment_quality.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapcheck::contact {
namespace {

/// Areas below this fraction of the squared longest edge are zero up to rounding.
constexpr double no_area = 1e-10;
/// How far a corner must turn the other way, as a fraction of the whole, to count as turned.
constexpr double turned_fraction = 1e-6;

/// Different nodes among the four, and whether they are written as a proper triangle or quad.
SegmentFault numbering(const model::SegmentNodes& n) {
  int different = 1;
  for (std::size_t i = 1; i < 4; ++i)
    if (std::find(n.begin(), n.begin() + static_cast<std::ptrdiff_t>(i), n[i]) ==
        n.begin() + static_cast<std::ptrdiff_t>(i))
      ++different;
  if (different < 3) return SegmentFault::few_nodes;
  return different == 3 && n[2] != n[3] ? SegmentFault::repeated_node : SegmentFault::none;
}

/// `corner`: at each corner the cross product of the edges that come in and go out. For a flat quad these are twice the
/// areas of the four triangles that the diagonals cut off, with a sign; opposite ones add up to the whole.
SegmentFault shape(const std::array<Vector, 4>& corner, double largest) {
  const Vector whole = corner[1] + corner[3];
  if (whole.norm() <= no_area * largest) return SegmentFault::crossed;
  const double limit = -turned_fraction * whole.squaredNorm();
  const auto inward =
      std::count_if(corner.begin(), corner.end(), [&](const Vector& c) { return c.dot(whole) < limit; });
  return inward >= 2 ? SegmentFault::crossed : inward == 1 ? SegmentFault::folded : SegmentFault::none;
}

double cosine(const Vector& a, double norm_a, const Vector& b, double norm_b) {
  const double product = norm_a * norm_b;
  return product > 0 ? a.dot(b) / product : 1;
}

}  // namespace

SegmentQuality segment_quality(const model::SegmentNodes& n, const std::vector<Vector>& x) {
  SegmentQuality quality;
  const bool triangle = n[2] == n[3];
  const Vector &a = x[n[0].value], &b = x[n[1].value], &c = x[n[2].value], &d = x[n[3].value];
  const std::array<Vector, 4> edge{b - a, c - b, d - c, a - d};
  const std::array<Vector, 4> corner{edge[3].cross(edge[0]), edge[0].cross(edge[1]), edge[1].cross(edge[2]),
                                     edge[2].cross(edge[3])};
  double squared_longest = 0, largest = 0;
  std::array<double, 4> norm{};
  for (std::size_t i = 0; i < 4; ++i) {
    squared_longest = std::max(squared_longest, edge[i].squaredNorm());
    norm[i] = corner[i].norm();
    largest = std::max(largest, norm[i]);
  }
  const double doubled_area = norm[1] + norm[3];
  if (!std::isfinite(doubled_area) || !std::isfinite(squared_longest)) {
    quality.fault = SegmentFault::not_finite;
    return quality;
  }
  // A triangle's last corner does not count.
  const double twice = triangle ? doubled_area : doubled_area / 2;
  quality.size = static_cast<float>(std::sqrt(twice));
  quality.slenderness = squared_longest > 0 ? static_cast<float>(twice / squared_longest) : 0;
  if (n[0] == n[1] || n[1] == n[2] || n[0] == n[2] || n[0] == n[3] || n[1] == n[3] || triangle)
    quality.fault = numbering(n);
  if (quality.fault == SegmentFault::few_nodes) return quality;
  if (!(largest > no_area * squared_longest)) {
    quality.fault = SegmentFault::zero_area;
  } else if (!triangle && quality.fault == SegmentFault::none) {
    quality.fault = shape(corner, largest);
    quality.warp_cosine = static_cast<float>(
        std::min(cosine(corner[1], norm[1], corner[3], norm[3]), cosine(corner[0], norm[0], corner[2], norm[2])));
  }
  return quality;
}

double warp_degrees(const SegmentQuality& quality) {
  return std::acos(std::clamp(static_cast<double>(quality.warp_cosine), -1.0, 1.0)) * 180 / std::numbers::pi;
}

EdgeRange edge_range(const model::SegmentNodes& n, const std::vector<Vector>& x) {
  EdgeRange range{INFINITY, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    if (n[i] == n[(i + 1) % 4]) continue;
    const double length = (x[n[(i + 1) % 4].value] - x[n[i].value]).norm();
    range.shortest = std::min(range.shortest, length);
    range.longest = std::max(range.longest, length);
  }
  if (!(range.shortest <= range.longest)) range.shortest = range.longest;
  return range;
}

SolidQuality solid_quality(const std::array<NodeIndex, 8>& n, const std::vector<Vector>& x) {
  /// Neighbours of each corner along the edges, so that the three edges of a brick are right-handed.
  constexpr std::array<std::array<std::size_t, 3>, 8> along{
      {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
  const auto at = [&](std::size_t i) -> const Vector& { return x[n[i].value]; };
  const auto spanned = [](const Vector& a, const Vector& b, const Vector& c) {
    const double lengths = a.norm() * b.norm() * c.norm();
    const double volume = a.cross(b).dot(c);
    return lengths > 0 ? volume / lengths : 0 * volume;
  };
  SolidQuality quality;
  quality.centre = spanned(at(1) + at(2) + at(5) + at(6) - at(0) - at(3) - at(4) - at(7),
                           at(2) + at(3) + at(6) + at(7) - at(0) - at(1) - at(4) - at(5),
                           at(4) + at(5) + at(6) + at(7) - at(0) - at(1) - at(2) - at(3));
  for (std::size_t i = 0; i < 8; ++i) {
    const auto& to = along[i];
    const NodeIndex p = n[to[0]], q = n[to[1]], r = n[to[2]];
    if (p == n[i] || q == n[i] || r == n[i] || p == q || q == r || p == r) continue;
    const double corner = spanned(at(to[0]) - at(i), at(to[1]) - at(i), at(to[2]) - at(i));
    if (quality.corner != none<NodeIndex> && !(corner < quality.worst_corner)) continue;
    quality.worst_corner = corner;
    quality.corner = n[i];
  }
  return quality;
}

}  // namespace gapcheck::contact
