#include "audit/untangle/contours.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

namespace gapcheck::audit {
namespace {

/// Finds pairs next to a pair by the nodes of its first element.
class PairNeighbours {
 public:
  PairNeighbours(const model::Mesh& mesh, std::span<const ElementPair> pairs) : mesh_(mesh), pairs_(pairs) {
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
      for (const NodeIndex n : nodes_of(mesh, pairs[i].first)) list_[n].push_back({i, false});
      for (const NodeIndex n : nodes_of(mesh, pairs[i].second)) list_[n].push_back({i, true});
    }
  }
  /// Calls visit(pair, turned) for the pairs next to pair `i`, some of them several times: `turned` if their elements
  /// are in the other order.
  template <class Visit>
  void visit(std::uint32_t i, const Visit& visit) const {
    for (const NodeIndex n : nodes_of(mesh_, pairs_[i].first))
      for (const auto& [other, turned] : list_.at(n)) {
        if (other == i) continue;
        const ElementOfKind& partner = turned ? pairs_[other].first : pairs_[other].second;
        if (touch(pairs_[i].second, partner)) visit(other, turned);
      }
  }

 private:
  [[nodiscard]] bool touch(const ElementOfKind& a, const ElementOfKind& b) const {
    if (a == b) return true;
    const auto of_b = nodes_of(mesh_, b);
    for (const NodeIndex n : nodes_of(mesh_, a))
      if (std::find(of_b.begin(), of_b.end(), n) != of_b.end()) return true;
    return false;
  }

  struct Place {
    std::uint32_t pair;
    bool second;  ///< the node belongs to its second element
  };
  const model::Mesh& mesh_;
  std::span<const ElementPair> pairs_;
  std::map<NodeIndex, std::vector<Place>> list_;
};

void sort_once(std::vector<ElementOfKind>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

std::vector<Contour> find_contours(const model::Mesh& mesh, std::span<const ElementPair> pairs) {
  const PairNeighbours neighbours(mesh, pairs);
  std::vector<Contour> contours;
  std::vector<std::uint8_t> seen(pairs.size()), turned(pairs.size());
  for (std::uint32_t first = 0; first < pairs.size(); ++first) {
    if (seen[first] != 0) continue;
    seen[first] = 1;
    Contour contour;
    std::vector<std::uint32_t> open{first};
    while (!open.empty()) {
      const std::uint32_t i = open.back();
      open.pop_back();
      ++contour.pairs;
      contour.elements[turned[i]].push_back(pairs[i].first);
      contour.elements[1 - turned[i]].push_back(pairs[i].second);
      neighbours.visit(i, [&](std::uint32_t other, bool other_way) {
        if (seen[other] != 0) return;
        seen[other] = 1;
        turned[other] = static_cast<std::uint8_t>(other_way ? 1 - turned[i] : turned[i]);
        open.push_back(other);
      });
    }
    for (std::vector<ElementOfKind>& list : contour.elements) sort_once(list);
    contours.push_back(std::move(contour));
  }
  return contours;
}

}  // namespace gapcheck::audit
