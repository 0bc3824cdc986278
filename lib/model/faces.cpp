#include "model/faces.hpp"

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

/// The same for a face however its nodes are turned.
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
  const bool is_tetrahedron =
      std::all_of(nodes.begin() + 4, nodes.end(), [&](NodeIndex node) { return node == nodes[3]; });
  if (is_tetrahedron) {
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

std::vector<SegmentNodes> exterior_faces(const Elements<8>& elements, const std::vector<std::uint32_t>& members) {
  struct Entry {
    SegmentNodes key;
    std::uint32_t place;
  };
  std::vector<SegmentNodes> faces;
  std::vector<Entry> entries;
  for (const std::uint32_t member : members)
    for (const SegmentNodes& face : SolidFaces(elements.nodes[member])) {
      entries.push_back({face_key(face), static_cast<std::uint32_t>(faces.size())});
      faces.push_back(face);
    }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
  std::vector<std::uint32_t> single;
  for (std::size_t i = 0; i < entries.size();) {
    std::size_t end = i + 1;
    while (end < entries.size() && entries[end].key == entries[i].key) ++end;
    if (end == i + 1) single.push_back(entries[i].place);
    i = end;
  }
  std::sort(single.begin(), single.end());
  std::vector<SegmentNodes> result;
  result.reserve(single.size());
  for (const std::uint32_t place : single) result.push_back(faces[place]);
  return result;
}

}  // namespace gapcheck::model
