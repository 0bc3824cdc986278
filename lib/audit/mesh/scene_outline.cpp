// The outline of a scene: its edges, and their simplification by merging points on a grid.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "audit/mesh/scene_mesh.hpp"
#include "base/quad.hpp"

namespace gapcheck::audit {
namespace {

constexpr double squared_cosine_sharp = 0.75;  // of 30 degrees

/// Two nodes, the lower one first.
using Edge = std::array<std::uint32_t, 2>;

Vector normal(const SceneFace& face, std::span<const Vector> x) {
  const auto& n = face.nodes;
  return quad_normal(x[n[0]], x[n[1]], x[n[2]], x[n[3]]);
}

/// Shells may be numbered in either direction, so the sign of the normals is meaningless.
bool sharp(const SceneFace& a, const SceneFace& b, std::span<const Vector> x) {
  const Vector first = normal(a, x), second = normal(b, x);
  const double dot = first.dot(second);
  return dot * dot < squared_cosine_sharp * first.squaredNorm() * second.squaredNorm();
}

/// The edges of all faces, sorted by their nodes, with the faces that have them.
class EdgeTable {
 public:
  struct Entry {
    std::uint32_t high, face;
  };
  EdgeTable(const std::vector<SceneFace>& faces, std::size_t nodes) : start_(nodes + 1, 0) {
    for_each_edge(faces, [&](const Edge& edge, std::uint32_t) { ++start_[edge[0] + 1]; });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    entries_.resize(start_.back());
    for_each_edge(faces, [&](const Edge& edge, std::uint32_t face) { entries_[next[edge[0]]++] = {edge[1], face}; });
    for (std::size_t n = 0; n < nodes; ++n)
      std::sort(entries_.begin() + static_cast<std::ptrdiff_t>(start_[n]),
                entries_.begin() + static_cast<std::ptrdiff_t>(start_[n + 1]),
                [](const Entry& a, const Entry& b) { return a.high != b.high ? a.high < b.high : a.face < b.face; });
  }
  /// Calls visit(edge, entries of it) for every edge.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::uint32_t low = 0; low + 1 < start_.size(); ++low) {
      for (std::size_t i = start_[low], end = 0; i < start_[low + 1]; i = end) {
        for (end = i + 1; end < start_[low + 1] && entries_[end].high == entries_[i].high;) ++end;
        visit(Edge{low, entries_[i].high}, std::span(entries_).subspan(i, end - i));
      }
    }
  }

 private:
  template <class Visit>
  static void for_each_edge(const std::vector<SceneFace>& faces, const Visit& visit) {
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      const auto& n = faces[f].nodes;
      const std::size_t edges = n[1] == n[2] ? 1 : 4;  // a beam has one
      for (std::size_t i = 0; i < edges; ++i)
        if (const std::uint32_t a = n[i], b = n[(i + 1) % 4]; a != b) visit(Edge{std::min(a, b), std::max(a, b)}, f);
    }
  }
  std::vector<std::size_t> start_;
  std::vector<Entry> entries_;
};

std::vector<Edge> outline_edges(const std::vector<SceneFace>& faces, std::span<const Vector> x) {
  std::vector<Edge> list;
  EdgeTable(faces, x.size()).for_each([&](const Edge& edge, std::span<const EdgeTable::Entry> entries) {
    const SceneFace& first = faces[entries[0].face];
    const bool inner =
        entries.size() == 2 && first.part == faces[entries[1].face].part && !sharp(first, faces[entries[1].face], x);
    if (!inner) list.push_back(edge);
  });
  return list;
}

/// Points of the outline; with a cell length above zero all points in one cell of a grid become the first of them.
class Merged {
 public:
  Merged(const std::vector<Edge>& edges, std::span<const Vector> x, const Vector& low, double cell) {
    for (const Edge& edge : edges) {
      const std::uint32_t a = point(edge[0], x, low, cell), b = point(edge[1], x, low, cell);
      if (a != b) list.push_back({std::min(a, b), std::max(a, b)});
    }
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  std::vector<std::uint32_t> nodes;  ///< of each point
  std::vector<Edge> list;            ///< positions in `nodes`

 private:
  std::uint32_t point(std::uint32_t node, std::span<const Vector> x, const Vector& low, double cell) {
    std::uint64_t key = node;
    if (cell > 0) {
      key = 0;
      for (int axis = 0; axis < 3; ++axis)
        key = key << 21 |
              std::min<std::uint64_t>(static_cast<std::uint64_t>((x[node][axis] - low[axis]) / cell), 0x1fffff);
    }
    const auto [entry, is_new] = points_.try_emplace(key, static_cast<std::uint32_t>(nodes.size()));
    if (is_new) nodes.push_back(node);
    return entry->second;
  }
  std::unordered_map<std::uint64_t, std::uint32_t> points_;
};

}  // namespace

void add_outline(const std::vector<SceneFace>& faces, std::span<const Vector> x, const SceneFrame& frame,
                 std::size_t limit, SceneMesh& scene) {
  std::vector<Edge> edges = outline_edges(faces, x);
  scene.outline_left_out +=
      std::erase_if(edges, [&](const Edge& edge) { return !frame.holds(x[edge[0]]) || !frame.holds(x[edge[1]]); });
  const double length = (frame.high - frame.low).maxCoeff();
  double cell = edges.size() > limit && length > 0 ? length / 4096 : 0;
  Merged merged(edges, x, frame.low, cell);
  // Cells of twice the length hold whole cells, so merged points can be merged further. At the latest the whole frame
  // is one cell.
  while (merged.list.size() > limit && cell > 0 && cell <= length) {
    cell *= 2;
    edges.clear();
    for (const auto& [a, b] : merged.list) edges.push_back({merged.nodes[a], merged.nodes[b]});
    merged = Merged(edges, x, frame.low, cell);
  }
  if (merged.list.size() > limit) merged.list.resize(limit);
  for (const std::uint32_t node : merged.nodes) {
    const Vector local = x[node] - frame.origin;
    scene.outline_points.push_back(
        {static_cast<float>(local[0]), static_cast<float>(local[1]), static_cast<float>(local[2])});
  }
  scene.outline = std::move(merged.list);
}

}  // namespace gapcheck::audit
