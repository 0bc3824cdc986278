#include "model/entity/faces.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace gapcheck::model {
namespace {

constexpr std::size_t hexahedron[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                          {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
constexpr std::size_t tetrahedron[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

/// Neighbouring equal nodes become one; a triangle then repeats its last node. False for less than a triangle.
bool tidy(SegmentNodes& face) {
  const auto [a, b, c, d] = face;
  if (a != b && a != c && a != d && b != c && b != d && c != d) return true;
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

/// The nodes of a face, ascending: the same for any rotation. Repeated nodes of triangles differ between two
/// neighbours, so the largest one is repeated.
SegmentNodes face_key(const SegmentNodes& face) {
  NodeIndex a = face[0], b = face[1], c = face[2], d = face[3] == face[2] ? std::max({a, b, c}) : face[3];
  const auto order = [](NodeIndex& low, NodeIndex& high) {
    const NodeIndex less = std::min(low, high);
    high = std::max(low, high);
    low = less;
  };
  order(a, b);
  order(c, d);
  order(a, c);
  order(b, d);
  order(b, c);
  return {a, b, c, d};
}

/// A face among those with the same lowest node.
struct Entry {
  std::array<NodeIndex, 3> others;  ///< ascending
  std::uint32_t face;
};

/// Marks the faces of one bucket that are there twice.
void mark_shared(std::span<Entry> bucket, std::vector<bool>& shared) {
  std::sort(bucket.begin(), bucket.end(), [](const Entry& a, const Entry& b) { return a.others < b.others; });
  for (std::size_t i = 1; i < bucket.size(); ++i)
    if (bucket[i].others == bucket[i - 1].others) shared[bucket[i].face] = shared[bucket[i - 1].face] = true;
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
  std::vector<Face> faces;
  std::vector<SegmentNodes> keys;
  faces.reserve(6 * members.size());
  keys.reserve(6 * members.size());
  std::uint32_t lowest = no_position, highest = 0;
  for (const std::uint32_t member : members) {
    for (const SegmentNodes& nodes : SolidFaces(elements.nodes[member])) {
      faces.push_back({nodes, member});
      keys.push_back(face_key(nodes));
      lowest = std::min(lowest, keys.back()[0].value);
      highest = std::max(highest, keys.back()[0].value);
    }
  }
  if (faces.empty()) return {};
  // In buckets by their lowest node: two elements that share a face meet in one small bucket.
  std::vector<std::uint32_t> start(std::size_t{highest - lowest} + 2, 0);
  for (const SegmentNodes& key : keys) ++start[key[0].value - lowest + 1];
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<Entry> entries(faces.size());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const SegmentNodes& key = keys[f];
    entries[next[key[0].value - lowest]++] = {{key[1], key[2], key[3]}, f};
  }
  std::vector<bool> shared(faces.size(), false);
  for (std::size_t n = 0; n + 1 < start.size(); ++n)
    mark_shared(std::span(entries).subspan(start[n], start[n + 1] - start[n]), shared);
  std::vector<Face> single;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (!shared[f]) single.push_back(faces[f]);
  return single;
}

}  // namespace gapcheck::model
