#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/ids.hpp"
#include "base/parallel.hpp"

namespace gapcheck::contact {
namespace node_sums {

/// Items are cut into pieces of this many.
inline constexpr std::size_t piece = 16384;

[[nodiscard]] inline std::size_t pieces(std::size_t items) { return (items + piece - 1) / piece; }

/// By piece: the first node above all nodes of the pieces before it.
template <std::size_t N>
std::vector<std::uint64_t> nodes_before(const std::vector<std::array<NodeIndex, N>>& nodes) {
  std::vector<std::uint64_t> above(pieces(nodes.size()) + 1, 0);
  parallel_for(above.size() - 1, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      for (std::size_t i = p * piece; i < std::min(nodes.size(), (p + 1) * piece); ++i)
        for (const NodeIndex n : nodes[i])
          if (n != none<NodeIndex>) above[p + 1] = std::max(above[p + 1], std::uint64_t{n.value} + 1);
  });
  for (std::size_t p = 1; p < above.size(); ++p) above[p] = std::max(above[p], above[p - 1]);
  return above;
}

/// Whether most pieces lie below earlier ones, as in a mesh without order: one item of each is looked at.
template <std::size_t N>
bool disordered(const std::vector<std::array<NodeIndex, N>>& nodes, const std::vector<std::uint64_t>& before) {
  const std::size_t count = pieces(nodes.size());
  std::size_t below = 0;
  for (std::size_t p = 0; p < count; ++p) {
    const auto& item = nodes[(p * piece + std::min(nodes.size(), (p + 1) * piece)) / 2];
    below += std::all_of(item.begin(), item.end(), [&](NodeIndex n) { return n.value < before[p]; });
  }
  return 2 * below > count;
}

}  // namespace node_sums

/// Adds the values that `each(item, add)` passes to add(node, value), for all items, to sums[node]; each node must be
/// one of nodes[item]. Every sum is formed in the order of the items, for any number of threads: pieces of the items
/// are visited at once, and what a piece adds to the nodes of an earlier one waits until the end. In most
/// meshes few values wait. If most of them would, one thread visits all items.
template <class Sum, std::size_t N, class Each>
void sum_at_nodes(std::vector<Sum>& sums, const std::vector<std::array<NodeIndex, N>>& nodes, const Each& each) {
  using node_sums::piece;
  const auto one_by_one = [&] {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      each(i, [&](NodeIndex node, const Sum& value) { sums[node.value] += value; });
  };
  const std::size_t pieces = node_sums::pieces(nodes.size());
  if (pieces <= 2 || one_thread()) return one_by_one();
  const std::vector<std::uint64_t> before = node_sums::nodes_before(nodes);
  if (node_sums::disordered(nodes, before)) return one_by_one();
  std::vector<std::vector<std::pair<NodeIndex, Sum>>> waiting(pieces);
  parallel_for(pieces, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      for (std::size_t i = p * piece; i < std::min(nodes.size(), (p + 1) * piece); ++i)
        each(i, [&](NodeIndex node, const Sum& value) {
          if (node.value >= before[p])
            sums[node.value] += value;
          else
            waiting[p].emplace_back(node, value);
        });
  });
  for (const auto& of_piece : waiting)
    for (const auto& [node, value] : of_piece) sums[node.value] += value;
}

}  // namespace gapcheck::contact
