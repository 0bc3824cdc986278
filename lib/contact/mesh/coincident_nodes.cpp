#include "contact/mesh/coincident_nodes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <span>
#include <tuple>

#include "base/parallel.hpp"
#include "base/pieces.hpp"
#include "base/radix_sort.hpp"

namespace gapcheck::contact {
namespace {

constexpr std::size_t nodes_per_task = 16384;
/// Cells this many tolerances wide: small against the mesh, so that few share one; large against the tolerance, so that
/// few nodes are near a wall.
constexpr double cell_tolerances = 64;
/// Moves the walls away from the round coordinates of generated meshes.
constexpr double wall_shift = 0.371;
constexpr std::size_t crowd = 32;

struct CellEntry {
  std::uint64_t key;
  NodeIndex node;
};

std::uint64_t mix(std::uint64_t hash, double cell) {
  hash = (hash ^ std::bit_cast<std::uint64_t>(cell)) * 0x9E3779B97F4A7C15ULL;
  return hash ^ (hash >> 32);
}

/// The cells that contain a node or are within the tolerance: one, two, four or eight.
template <class Visit>
void for_each_cell(const Vector& x, double cell, double tolerance, const Visit& visit) {
  std::array<std::array<double, 2>, 3> range{};
  std::array<std::size_t, 3> count{};
  for (std::size_t k = 0; k < 3; ++k) {
    // Adding zero makes the negative zero positive, so that equal cells have equal bits.
    range[k] = {std::floor((x[static_cast<int>(k)] - tolerance) / cell + wall_shift) + 0.0,
                std::floor((x[static_cast<int>(k)] + tolerance) / cell + wall_shift) + 0.0};
    count[k] = range[k][0] == range[k][1] ? 1 : 2;
  }
  for (std::size_t i = 0; i < count[0]; ++i)
    for (std::size_t j = 0; j < count[1]; ++j)
      for (std::size_t k = 0; k < count[2]; ++k) visit(mix(mix(mix(0, range[0][i]), range[1][j]), range[2][k]));
}

/// Entries of all nodes, those of further cells after the first ones.
std::vector<CellEntry> enter(std::span<const NodeIndex> nodes, const std::vector<Vector>& x, double cell,
                             double tolerance) {
  std::vector<CellEntry> entries(nodes.size(), {0, none<NodeIndex>}), all_further;
  std::mutex mutex;
  parallel_for(nodes.size(), nodes_per_task, [&](std::size_t begin, std::size_t end) {
    std::vector<CellEntry> further;
    for (std::size_t i = begin; i < end; ++i) {
      if (!x[nodes[i].value].allFinite()) continue;
      for_each_cell(x[nodes[i].value], cell, tolerance, [&](std::uint64_t key) {
        if (entries[i].node == none<NodeIndex>)
          entries[i] = {key, nodes[i]};
        else
          further.push_back({key, nodes[i]});
      });
    }
    const std::scoped_lock lock(mutex);
    all_further.insert(all_further.end(), further.begin(), further.end());
  });
  entries.insert(entries.end(), all_further.begin(), all_further.end());
  return entries;
}

/// Compares all nodes of one cell.
void compare(std::span<CellEntry> cell, const std::vector<Vector>& x, double tolerance,
             std::vector<CoincidentNodes>& found) {
  const double squared_tolerance = tolerance * tolerance;
  const auto near = [&](NodeIndex a, NodeIndex b) {
    return (x[a.value] - x[b.value]).squaredNorm() <= squared_tolerance || x[a.value] == x[b.value];
  };
  if (cell.size() <= crowd) {
    for (std::size_t i = 1; i < cell.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (near(cell[i].node, cell[j].node)) {
          found.push_back({cell[j].node, cell[i].node});
          break;
        }
    return;
  }
  std::sort(cell.begin(), cell.end(), [&](const CellEntry& a, const CellEntry& b) {
    const Vector &p = x[a.node.value], &q = x[b.node.value];
    return std::tie(p[0], p[1], p[2], a.node) < std::tie(q[0], q[1], q[2], b.node);
  });
  for (std::size_t i = 1; i < cell.size(); ++i)
    if (near(cell[i - 1].node, cell[i].node))
      found.push_back({std::min(cell[i - 1].node, cell[i].node), std::max(cell[i - 1].node, cell[i].node)});
}

/// Compares the nodes of the cells that share a hash.
void compare_cells(std::span<CellEntry> entries, const std::vector<Vector>& x, double tolerance,
                   std::vector<CoincidentNodes>& found) {
  if (entries.size() < 2) return;
  std::sort(entries.begin(), entries.end(),
            [](const CellEntry& p, const CellEntry& q) { return std::tie(p.key, p.node) < std::tie(q.key, q.node); });
  for (auto from = entries.begin(); from != entries.end();) {
    const auto to = std::find_if(from, entries.end(), [&](const CellEntry& e) { return e.key != from->key; });
    if (to - from > 1) compare({from, to}, x, tolerance, found);
    from = to;
  }
}

/// Of a cell: so many bits that few cells share one.
struct CellHash {
  int bits;
  explicit CellHash(std::size_t entries) : bits(std::clamp(static_cast<int>(std::bit_width(entries)) - 2, 1, 22)) {}
  std::uint64_t operator()(const CellEntry& e) const { return e.key * 0xD6E8FEB86659FD93ULL >> (64 - bits); }
};

/// Sorts the entries by their hashes. Returns where pieces of them begin, and their end; no hash is in two pieces.
std::vector<std::size_t> distribute(std::vector<CellEntry>& entries, const CellHash& hash) {
  std::vector<CellEntry> spare(entries.size());
  radix_sort(std::span(entries), std::span(spare), hash.bits, hash);
  return pieces_of_runs(entries.size(), nodes_per_task,
                        [&](std::size_t i) { return hash(entries[i]) == hash(entries[i - 1]); });
}

}  // namespace

std::vector<CoincidentNodes> coincident_nodes(std::span<const NodeIndex> nodes, const std::vector<Vector>& x,
                                              double tolerance) {
  if (!(tolerance >= 0) || !std::isfinite(tolerance)) tolerance = 0;
  const double cell = tolerance > 0 ? cell_tolerances * tolerance : 1;
  std::vector<CellEntry> entries = enter(nodes, x, cell, tolerance);
  std::erase_if(entries, [](const CellEntry& e) { return e.node == none<NodeIndex>; });
  const CellHash hash(entries.size());
  const std::vector<std::size_t> pieces = distribute(entries, hash);
  std::vector<CoincidentNodes> found;
  std::mutex mutex;
  parallel_for(pieces.size() - 1, 1, [&](std::size_t begin, std::size_t end) {
    std::vector<CoincidentNodes> here;
    for (std::size_t first = pieces[begin], last = first; first < pieces[end]; first = last) {
      last = first + 1;
      while (last < pieces[end] && hash(entries[last]) == hash(entries[first])) ++last;
      compare_cells(std::span(entries).subspan(first, last - first), x, tolerance, here);
    }
    const std::scoped_lock lock(mutex);
    found.insert(found.end(), here.begin(), here.end());
  });
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return std::tie(a.second, a.first) < std::tie(b.second, b.first); });
  const auto same = [](const auto& a, const auto& b) { return a.second == b.second; };
  found.erase(std::unique(found.begin(), found.end(), same), found.end());
  return found;
}

}  // namespace gapcheck::contact
