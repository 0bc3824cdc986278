#include "solver/airbag/control_volume.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/quad.hpp"

namespace gapcheck::solver {
namespace {

std::size_t corners_of(const model::SegmentNodes& nodes) { return nodes[2] == nodes[3] ? 3 : 4; }

}  // namespace

ControlVolume::ControlVolume(std::vector<model::SegmentNodes> segments) : segments_(std::move(segments)) {
  for (const model::SegmentNodes& segment : segments_)
    for (const NodeIndex node : segment) nodes_.push_back(node.value);
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  for (const model::SegmentNodes& segment : segments_) {
    std::array<std::uint32_t, 4>& places = places_.emplace_back();
    for (std::size_t k = 0; k < 4; ++k)
      places[k] =
          static_cast<std::uint32_t>(std::lower_bound(nodes_.begin(), nodes_.end(), segment[k].value) - nodes_.begin());
  }
}

ControlVolume::OpenEdges ControlVolume::open_edges() const {
  // How often an edge is passed from its lower node up, and down.
  std::map<std::array<std::uint32_t, 2>, std::array<std::size_t, 2>> passes;
  for (const model::SegmentNodes& segment : segments_) {
    const std::size_t corners = corners_of(segment);
    for (std::size_t k = 0; k < corners; ++k) {
      const std::uint32_t a = segment[k].value, b = segment[(k + 1) % corners].value;
      if (a != b) ++passes[{std::min(a, b), std::max(a, b)}][a < b ? 0 : 1];
    }
  }
  OpenEdges open;
  for (const auto& [edge, count] : passes)
    if (count != std::array<std::size_t, 2>{1, 1} && open.count++ == 0) open.first = edge;
  return open;
}

double ControlVolume::volume(std::span<const Vector> x) const {
  if (segments_.empty()) return 0;
  // A near origin loses no digits.
  const Vector& origin = x[nodes_[0]];
  double sum = 0;
  for (const model::SegmentNodes& segment : segments_) {
    const std::size_t corners = corners_of(segment);
    Vector center = Vector::Zero();
    for (std::size_t k = 0; k < corners; ++k) center += x[segment[k].value] - origin;
    sum += center.dot(quad_normal(segment, x)) / (6 * static_cast<double>(corners));
  }
  return sum;
}

double ControlVolume::area(std::span<const Vector> x) const {
  double sum = 0;
  for (const model::SegmentNodes& segment : segments_) sum += quad_normal(segment, x).norm() / 2;
  return sum;
}

std::vector<Vector> ControlVolume::forces(std::span<const Vector> x) const {
  constexpr std::array<double, 4> s{-1, 1, 1, -1}, t{-1, -1, 1, 1};
  std::vector<Vector> forces(nodes_.size(), Vector::Zero());
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const model::SegmentNodes& n = segments_[i];
    const Vector normal = quad_normal(n, x) / 2;
    if (corners_of(n) == 3) {
      for (std::size_t k = 0; k < 3; ++k) forces[places_[i][k]] += normal / 3;
      continue;
    }
    // x = x0 + e s + f t + h s t: the normal is e x f + s e x h + t h x f, and a corner's weight (1 + s_k s)(1 + t_k
    // t)/4.
    const Vector &a = x[n[0].value], &b = x[n[1].value], &c = x[n[2].value], &d = x[n[3].value];
    const Vector e = (b + c - a - d) / 4, f = (c + d - a - b) / 4, h = (a + c - b - d) / 4;
    const Vector along = e.cross(h) / 3, across = h.cross(f) / 3;
    for (std::size_t k = 0; k < 4; ++k) forces[places_[i][k]] += normal / 4 + s[k] * along + t[k] * across;
  }
  return forces;
}

}  // namespace gapcheck::solver
