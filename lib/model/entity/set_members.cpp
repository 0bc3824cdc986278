#include "model/entity/set_members.hpp"

#include <algorithm>
#include <functional>
#include <unordered_set>

namespace gapcheck::model {
namespace {

struct SegmentHash {
  std::size_t operator()(const SegmentNodes& nodes) const noexcept {
    std::uint64_t hash = 0;
    for (const NodeIndex node : nodes) {
      hash = (hash ^ node.value) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

using Positions = std::unordered_set<std::uint32_t>;
using Segments = std::unordered_set<SegmentNodes, SegmentHash>;

template <class Set, class Value>
void keep_first(std::vector<Value>& values, const std::vector<Value>& removed) {
  Set seen(removed.begin(), removed.end());
  std::erase_if(values, [&](const Value& value) { return !seen.insert(value).second; });
}

template <class Set, class Value>
void keep_common(std::vector<Value>& values, const std::vector<Value>& others) {
  const Set common(others.begin(), others.end());
  std::erase_if(values, [&](const Value& value) { return !common.contains(value); });
}

}  // namespace

void Members::append(const Members& other) {
  positions.insert(positions.end(), other.positions.begin(), other.positions.end());
  segments.insert(segments.end(), other.segments.begin(), other.segments.end());
}

void Members::intersect(const Members& other) {
  keep_common<Positions>(positions, other.positions);
  keep_common<Segments>(segments, other.segments);
}

void Members::keep_unique(const Members& removed) {
  // Strictly ascending positions, the usual case, have no duplicates.
  const bool rising = std::adjacent_find(positions.begin(), positions.end(), std::greater_equal<>()) == positions.end();
  if (!rising || !removed.positions.empty()) keep_first<Positions>(positions, removed.positions);
  if (!segments.empty()) keep_first<Segments>(segments, removed.segments);
}

}  // namespace gapcheck::model
