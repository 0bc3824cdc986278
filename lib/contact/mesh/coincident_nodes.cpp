#include "contact/mesh/coincident_nodes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <tuple>

#include "base/parallel.hpp"

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

/// The entries in buckets by the upper bits of their keys. `start`: first entry of each bucket, and the end.
std::vector<CellEntry> distribute(const std::vector<CellEntry>& entries, std::vector<std::uint32_t>& start) {
  const int bits = std::clamp(static_cast<int>(std::bit_width(entries.size())) - 2, 1, 24);
  const auto bucket = [&](const CellEntry& e) {
    return static_cast<std::size_t>(e.key * 0xD6E8FEB86659FD93ULL >> (64 - bits));
  };
  start.assign((std::size_t{1} << bits) + 2, 0);
  for (const CellEntry& e : entries)
    if (e.node != none<NodeIndex>) ++start[bucket(e) + 2];
  for (std::size_t b = 2; b < start.size(); ++b) start[b] += start[b - 1];
  std::vector<CellEntry> sorted(start.back());
  for (const CellEntry& e : entries)
    if (e.node != none<NodeIndex>) sorted[start[bucket(e) + 1]++] = e;
  start.pop_back();
  return sorted;
}

}  // namespace

std::vector<CoincidentNodes> coincident_nodes(std::span<const NodeIndex> nodes, const std::vector<Vector>& x,
                                              double tolerance) {
  if (!(tolerance >= 0) || !std::isfinite(tolerance)) tolerance = 0;
  const double cell = tolerance > 0 ? cell_tolerances * tolerance : 1;
  std::vector<std::uint32_t> start;
  std::vector<CellEntry> entries = distribute(enter(nodes, x, cell, tolerance), start);
  std::vector<CoincidentNodes> found;
  std::mutex mutex;
  parallel_for(start.size() - 1, nodes_per_task, [&](std::size_t begin, std::size_t end) {
    std::vector<CoincidentNodes> here;
    for (std::size_t b = begin; b < end; ++b) {
      const auto first = entries.begin() + start[b], last = entries.begin() + start[b + 1];
      if (last - first < 2) continue;
      std::sort(first, last, [](const CellEntry& p, const CellEntry& q) {
        return std::tie(p.key, p.node) < std::tie(q.key, q.node);
      });
      for (auto from = first; from != last;) {
        const auto to = std::find_if(from, last, [&](const CellEntry& e) { return e.key != from->key; });
        if (to - from > 1) compare({from, to}, x, tolerance, here);
        from = to;
      }
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
