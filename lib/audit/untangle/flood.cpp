#include "audit/untangle/flood.hpp"

#include <algorithm>
#include <map>

namespace gapcheck::audit {

std::optional<Flood> Flood::over(const contact::Segments& segments, const contact::Neighbours& neighbours,
                                 std::span<const NodeIndex> from,
                                 const std::set<std::pair<NodeIndex, NodeIndex>>& closed, const Allowed& allowed,
                                 Until until, std::uint64_t& work) {
  Flood flood(from.size());
  std::vector<NodeIndex> front(from.begin(), from.end()), next;
  for (std::uint32_t i = 0; i < from.size(); ++i) flood.label_.emplace(from[i].value, i);
  while (!front.empty()) {
    std::set<std::uint32_t> growing;
    for (const NodeIndex n : front) growing.insert(flood.labels_.root(flood.label_.at(n.value)));
    if (growing.size() == 1 && until == Until::one_left) {
      flood.open_ = *growing.begin();
      break;
    }
    next.clear();
    for (const NodeIndex n : front)
      for (const SegmentIndex s : neighbours.at(n)) {
        if (work == 0) return std::nullopt;
        --work;
        for_each_edge(segments, s, [&](NodeIndex a, NodeIndex b) {
          if ((a != n && b != n) || closed.contains({std::min(a, b), std::max(a, b)})) return;
          const NodeIndex other = a == n ? b : a;
          if (allowed && !flood.label_.contains(other.value) && !allowed(other)) return;
          const std::uint32_t own = flood.label_.at(n.value);
          const auto [place, fresh] = flood.label_.emplace(other.value, own);
          if (fresh)
            next.push_back(other);
          else
            flood.labels_.unite(place->second, own);
        });
      }
    front.swap(next);
  }
  flood.settle();
  return flood;
}

/// Gives every node the final number of its region.
void Flood::settle() {
  for (auto& [node, label] : label_) label = labels_.root(label);
  if (open_ != no_position) open_ = labels_.root(open_);
}

std::uint32_t Flood::region(NodeIndex node) const {
  const auto found = label_.find(node.value);
  return found == label_.end() ? no_position : found->second;
}

std::uint32_t Flood::largest() const {
  if (open_ != no_position) return open_;
  std::map<std::uint32_t, std::size_t> sizes;
  for (const auto& [node, label] : label_) ++sizes[label];
  std::uint32_t best = no_position;
  std::size_t most = 0;
  for (const auto& [region, size] : sizes) {
    if (size <= most) continue;
    best = region;
    most = size;
  }
  return best;
}

std::vector<NodeIndex> Flood::nodes(std::uint32_t region) const {
  std::vector<NodeIndex> list;
  for (const auto& [node, label] : label_)
    if (label == region) list.push_back(NodeIndex{node});
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace gapcheck::audit
