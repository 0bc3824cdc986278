#include "contact/surface/element_fate.hpp"

#include <algorithm>
#include <cmath>

#include "contact/surface/segment_quality.hpp"
#include "model/entity/faces.hpp"

namespace gapcheck::contact {
namespace {

/// Twice the vector area of a shell.
Vector double_area(const std::array<NodeIndex, 4>& n, const std::vector<Vector>& x) {
  return (x[n[2].value] - x[n[0].value]).cross(x[n[3].value] - x[n[1].value]);
}

/// Volume within the faces, each cut into triangles around its middle.
double volume_within(const std::array<NodeIndex, 8>& nodes, const std::vector<Vector>& x) {
  double sum = 0;
  const Vector& origin = x[nodes[0].value];
  for (const model::SegmentNodes& face : model::SolidFaces(nodes)) {
    Vector middle = Vector::Zero();
    for (const NodeIndex n : face) middle += (x[n.value] - origin) / 4;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector a = x[face[k].value] - origin, b = x[face[(k + 1) % 4].value] - origin;
      sum += middle.dot(a.cross(b)) / 6;
    }
  }
  return std::abs(sum);
}

}  // namespace

ElementFate element_fate(const std::array<NodeIndex, 4>& nodes, const std::vector<Vector>& before,
                         const std::vector<Vector>& after) {
  const Vector normal = double_area(nodes, before);
  const double length = normal.norm(), area = length / 2;
  const double now = length > 0 ? double_area(nodes, after).dot(normal) / (2 * length) : 0;
  ElementFate fate{area, now};
  if (!(area > 0)) return fate;
  fate.inverted = now < 0;
  fate.flat = now >= 0 && now < flattened_element * area;
  return fate;
}

ElementFate element_fate(const std::array<NodeIndex, 8>& nodes, const std::vector<Vector>& before,
                         const std::vector<Vector>& after) {
  const SolidQuality was = solid_quality(nodes, before), is = solid_quality(nodes, after);
  const double least_was = std::min(was.centre, was.worst_corner), least = std::min(is.centre, is.worst_corner);
  const double size = volume_within(nodes, after);
  ElementFate fate{volume_within(nodes, before), is.centre < 0 ? -size : size};
  if (least_was < flattened_element || least >= flattened_element) return fate;
  fate.inverted = least < 0;
  fate.flat = least >= 0;
  return fate;
}

}  // namespace gapcheck::contact
