#include "contact/mesh/faces.hpp"

#include <algorithm>
#include <cmath>

#include "base/quad.hpp"

namespace gapcheck::contact {
namespace {

Vector mean(std::span<const NodeIndex> nodes, const std::vector<Vector>& x) {
  Vector sum = Vector::Zero();
  for (const NodeIndex n : nodes) sum += x[n.value];
  return sum / static_cast<double>(nodes.size());
}

Vector area_vector(const model::SegmentNodes& n, const std::vector<Vector>& x) { return 0.5 * quad_normal(n, x); }

void turn_away(Face& face, const Vector& inside, const std::vector<Vector>& x) {
  const Vector centre = mean(face.nodes, x);
  const bool triangle = face.nodes[2] == face.nodes[3];
  if (area_vector(face.nodes, x).dot(centre - inside) >= 0) return;
  if (triangle)
    std::swap(face.nodes[0], face.nodes[1]);
  else
    std::swap(face.nodes[1], face.nodes[3]);
}

}  // namespace

void turn_outward(Face& face, const std::array<NodeIndex, 8>& element_nodes, const std::vector<Vector>& x) {
  turn_away(face, mean(element_nodes, x), x);
}

std::vector<Face> faces_of(const std::array<NodeIndex, 8>& nodes, std::uint32_t element, const std::vector<Vector>& x) {
  std::vector<Face> faces;
  const Vector inside = mean(nodes, x);
  for (const model::SegmentNodes& face : model::SolidFaces(nodes)) {
    faces.push_back({face, element});
    turn_away(faces.back(), inside, x);
  }
  return faces;
}

std::vector<Face> free_faces(const model::Elements<8>& elements, const std::vector<std::uint32_t>& chosen,
                             const std::vector<Vector>& x) {
  std::vector<Face> faces = model::exterior_faces(elements, chosen);
  for (Face& face : faces) turn_outward(face, elements.nodes[face.element], x);
  return faces;
}

double volume(const std::array<NodeIndex, 8>& nodes, const std::vector<Vector>& x) {
  // Divergence theorem about the mean point: pyramids over the faces, each split in two.
  const Vector inside = mean(nodes, x);
  double sum = 0;
  for (const model::SegmentNodes& corners : model::SolidFaces(nodes)) {
    Face face{corners, 0};
    turn_away(face, inside, x);
    const auto& n = face.nodes;
    const Vector a = x[n[0].value] - inside, b = x[n[1].value] - inside, c = x[n[2].value] - inside,
                 d = x[n[3].value] - inside;
    sum += a.dot(b.cross(c)) + a.dot(c.cross(d));
  }
  return std::abs(sum) / 6;
}

double area(const model::SegmentNodes& n, const std::vector<Vector>& x) {
  const Vector a = x[n[1].value] - x[n[0].value], b = x[n[2].value] - x[n[0].value], c = x[n[3].value] - x[n[0].value];
  return 0.5 * (a.cross(b).norm() + b.cross(c).norm());
}

}  // namespace gapcheck::contact
