#include "model/entity/faces.hpp"

#include <algorithm>

namespace gapcheck::model {
namespace {

constexpr std::size_t hexahedron[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                          {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
constexpr std::size_t tetrahedron[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

/// Neighbouring equal nodes become one; a triangle then repeats its last node. False for less than a triangle.
bool tidy(SegmentNodes& face) {
  SegmentNodes kept{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    bool seen = false;
    for (std::size_t j = 0; j < count; ++j) seen = seen || kept[j] == face[i];
    if (!seen) kept[count++] = face[i];
  }
  if (count < 3) return false;
  if (count == 3) kept[3] = kept[2];
  face = kept;
  return true;
}

/// The same key for a face in any rotation of its nodes.
SegmentNodes key(SegmentNodes face) {
  std::sort(face.begin(), face.end());
  return face;
}

/// Repeated nodes of triangles differ between two neighbours, so the key repeats the largest.
SegmentNodes face_key(const SegmentNodes& face) {
  if (face[3] != face[2]) return key(face);
  return key({face[0], face[1], face[2], std::max({face[0], face[1], face[2]})});
}

}  // namespace

SolidFaces::SolidFaces(const std::array<NodeIndex, 8>& nodes) {
  if (is_tetrahedron(nodes)) {
    for (const auto& corners : tetrahedron) {
      SegmentNodes face{nodes[corners[0]], nodes[corners[1]], nodes[corners[2]], nodes[corners[2]]};
      if (tidy(face)) faces_[count_++] = face;
    }
    return;
  }
  for (const auto& corners : hexahedron) {
    SegmentNodes face{nodes[corners[0]], nodes[corners[1]], nodes[corners[2]], nodes[corners[3]]};
    if (tidy(face)) faces_[count_++] = face;
  }
}

bool is_tetrahedron(const std::array<NodeIndex, 8>& nodes) {
  return std::all_of(nodes.begin() + 4, nodes.end(), [&](NodeIndex node) { return node == nodes[3]; });
}

std::vector<Face> exterior_faces(const Elements<8>& elements, const std::vector<std::uint32_t>& members) {
  // Faces in buckets by their lowest node: two elements that share a face meet in one small bucket.
  struct Entry {
    SegmentNodes key;
    std::uint32_t face;
  };
  std::vector<Face> faces;
  std::uint32_t lowest = no_position, highest = 0;
  for (const std::uint32_t member : members) {
    for (const SegmentNodes& nodes : SolidFaces(elements.nodes[member])) {
      faces.push_back({nodes, member});
      lowest = std::min(lowest, face_key(nodes)[0].value);
      highest = std::max(highest, face_key(nodes)[0].value);
    }
  }
  if (faces.empty()) return {};
  std::vector<std::uint32_t> start(std::size_t{highest - lowest} + 2, 0);
  for (const Face& face : faces) ++start[face_key(face.nodes)[0].value - lowest + 1];
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<Entry> entries(faces.size());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const SegmentNodes k = face_key(faces[f].nodes);
    entries[next[k[0].value - lowest]++] = {k, f};
  }
  std::vector<bool> shared(faces.size(), false);
  for (std::size_t n = 0; n + 1 < start.size(); ++n) {
    const auto first = entries.begin() + start[n], last = entries.begin() + start[n + 1];
    std::sort(first, last, [](const Entry& a, const Entry& b) { return a.key < b.key; });
    for (auto i = first; i != last; ++i)
      if (i + 1 != last && (i + 1)->key == i->key) shared[i->face] = shared[(i + 1)->face] = true;
  }
  std::vector<Face> single;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (!shared[f]) single.push_back(faces[f]);
  return single;
}

}  // namespace gapcheck::model
