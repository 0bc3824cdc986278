#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/union_find.hpp"
#include "contact/surface/neighbours.hpp"

namespace gapcheck::audit {

/// Calls visit(a, b) for the edges of a segment; a beam axis has one.
template <class Visit>
void for_each_edge(const contact::Segments& segments, SegmentIndex segment, const Visit& visit) {
  const auto& n = segments.nodes[segment.value];
  if (segments.kind[segment.value] == contact::SegmentKind::line) {
    visit(n[0], n[1]);
    return;
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (n[i] != n[(i + 1) % 4]) visit(n[i], n[(i + 1) % 4]);
}

/// Regions of a surface that grow from nodes along its edges, all at the same pace, until at most one of them can grow
/// any further: the others are then known completely, in steps proportional to the second largest.
class Flood {
 public:
  /// Whether a node may be reached; empty: all may.
  using Allowed = std::function<bool(NodeIndex)>;

  enum class Until : std::uint8_t { one_left, all_known };

  /// `until`: with all_known, no region stays open. `closed`: edges (lower node first) that are not crossed. Nothing if
  /// that takes more than `work` steps, which are taken off it.
  [[nodiscard]] static std::optional<Flood> over(const contact::Segments& segments,
                                                 const contact::Neighbours& neighbours, std::span<const NodeIndex> from,
                                                 const std::set<std::pair<NodeIndex, NodeIndex>>& closed,
                                                 const Allowed& allowed, Until until, std::uint64_t& work);
  /// The region of a node that was reached, or no_position.
  [[nodiscard]] std::uint32_t region(NodeIndex node) const;
  /// True for the one region, if any, that was not grown to its end.
  [[nodiscard]] bool open(std::uint32_t region) const { return open_ == region; }
  /// The open region; if all are known, the one with the most nodes.
  [[nodiscard]] std::uint32_t largest() const;
  /// Of a region, ascending.
  [[nodiscard]] std::vector<NodeIndex> nodes(std::uint32_t region) const;

 private:
  explicit Flood(std::size_t seeds) : labels_(seeds) {}
  void settle();

  UnionFind labels_;
  std::unordered_map<std::uint32_t, std::uint32_t> label_;  ///< by node; while it grows, any of its region
  std::uint32_t open_ = no_position;
};

}  // namespace gapcheck::audit
