#include "contact/faces.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"

namespace gapcheck::contact {
namespace {

using FaceCorners = std::array<std::uint8_t, 4>;
// Outward for the manual's numbering: 1–4 below, 5–8 above.
constexpr std::array<FaceCorners, 6> brick{
    FaceCorners{0, 3, 2, 1}, FaceCorners{4, 5, 6, 7}, FaceCorners{0, 1, 5, 4},
    FaceCorners{1, 2, 6, 5}, FaceCorners{2, 3, 7, 6}, FaceCorners{3, 0, 4, 7}};
constexpr std::array<FaceCorners, 4> tetrahedron{FaceCorners{0, 2, 1, 1}, FaceCorners{0, 1, 3, 3},
                                                 FaceCorners{1, 2, 3, 3}, FaceCorners{2, 0, 3, 3}};

/// Takes out repeated neighbours; false if fewer than three corners stay.
bool tidy(model::SegmentNodes& nodes) {
  model::SegmentNodes kept{};
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (std::find(kept.begin(), kept.begin() + n, nodes[i]) == kept.begin() + n) kept[n++] = nodes[i];
  if (n < 3) return false;
  if (n == 3) kept[3] = kept[2];
  nodes = kept;
  return true;
}

Vector mean(std::span<const NodeIndex> nodes, const std::vector<Vector>& x) {
  Vector sum = Vector::Zero();
  for (const NodeIndex n : nodes) sum += x[n.value];
  return sum / static_cast<double>(nodes.size());
}

Vector area_vector(const model::SegmentNodes& n, const std::vector<Vector>& x) {
  return 0.5 * (x[n[2].value] - x[n[0].value]).cross(x[n[3].value] - x[n[1].value]);
}

void turn_outward(Face& face, const Vector& inside, const std::vector<Vector>& x) {
  const Vector centre = mean(face.nodes, x);
  const bool triangle = face.nodes[2] == face.nodes[3];
  if (area_vector(face.nodes, x).dot(centre - inside) >= 0) return;
  if (triangle)
    std::swap(face.nodes[0], face.nodes[1]);
  else
    std::swap(face.nodes[1], face.nodes[3]);
}

template <class Visit>
void for_each_face(const std::array<NodeIndex, 8>& nodes, const Visit& visit) {
  const auto one = [&](const FaceCorners& c) {
    model::SegmentNodes face{nodes[c[0]], nodes[c[1]], nodes[c[2]], nodes[c[3]]};
    if (tidy(face)) visit(face);
  };
  if (is_tetrahedron(nodes)) {
    for (const auto& c : tetrahedron) one(c);
  } else {
    for (const auto& c : brick) one(c);
  }
}

model::SegmentNodes key(model::SegmentNodes nodes) {
  if (nodes[2] == nodes[3]) nodes[3] = none<NodeIndex>;
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace

bool is_tetrahedron(const std::array<NodeIndex, 8>& n) {
  return n[3] == n[4] && n[3] == n[5] && n[3] == n[6] && n[3] == n[7];
}

void turn_outward(Face& face, const std::array<NodeIndex, 8>& element_nodes, const std::vector<Vector>& x) {
  turn_outward(face, mean(element_nodes, x), x);
}

std::vector<Face> faces_of(const std::array<NodeIndex, 8>& nodes, std::uint32_t element, const std::vector<Vector>& x) {
  std::vector<Face> faces;
  const Vector inside = mean(nodes, x);
  for_each_face(nodes, [&](const model::SegmentNodes& face) {
    faces.push_back({face, element});
    turn_outward(faces.back(), inside, x);
  });
  return faces;
}

std::vector<Face> free_faces(const model::Elements<8>& elements, std::span<const std::uint32_t> chosen,
                             const std::vector<Vector>& x) {
  // Faces in buckets by their lowest node: two elements that share a face meet in one small bucket.
  struct Entry {
    model::SegmentNodes key;
    std::uint32_t element;
    std::uint32_t face;
  };
  std::vector<std::uint32_t> start(x.size() + 1, 0);
  const auto each = [&](auto&& visit) {
    for (const std::uint32_t e : chosen) {
      std::uint32_t number = 0;
      for_each_face(elements.nodes[e], [&](const model::SegmentNodes& face) { visit(key(face), e, number++); });
    }
  };
  each([&](const model::SegmentNodes& k, std::uint32_t, std::uint32_t) { ++start[k[0].value + 1]; });
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<Entry> entries(start.back());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  each([&](const model::SegmentNodes& k, std::uint32_t e, std::uint32_t number) {
    entries[next[k[0].value]++] = {k, e, number};
  });
  std::vector<std::uint8_t> shared_faces(elements.size(), 0);  // bit per face number
  for (std::size_t n = 0; n + 1 < start.size(); ++n) {
    const auto first = entries.begin() + start[n], last = entries.begin() + start[n + 1];
    std::sort(first, last, [](const Entry& a, const Entry& b) { return a.key < b.key; });
    for (auto i = first; i != last;) {
      auto j = i;
      while (j != last && j->key == i->key) ++j;
      if (j - i > 1)
        for (auto k = i; k != j; ++k) shared_faces[k->element] |= static_cast<std::uint8_t>(1U << k->face);
      i = j;
    }
  }
  std::vector<Face> free;
  for (const std::uint32_t e : chosen) {
    const auto faces = faces_of(elements.nodes[e], e, x);
    for (std::size_t f = 0; f < faces.size(); ++f)
      if ((shared_faces[e] >> f & 1U) == 0) free.push_back(faces[f]);
  }
  return free;
}

double volume(const std::array<NodeIndex, 8>& nodes, const std::vector<Vector>& x) {
  // Divergence theorem about the mean point: pyramids over the faces, each split in two.
  const Vector inside = mean(nodes, x);
  double sum = 0;
  for (const Face& face : faces_of(nodes, 0, x)) {
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
