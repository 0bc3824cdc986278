#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/search/float_box.hpp"
#include "contact/search/search.hpp"

namespace gapcheck::contact {

/// Eight boxes side by side, so that one comparison handles several.
struct BoxPack {
  static constexpr std::uint32_t width = float_width;
  std::array<std::array<float, width>, 3> low, high;

  BoxPack() {
    for (auto& row : low) row.fill(FloatBox::infinity);
    for (auto& row : high) row.fill(-FloatBox::infinity);
  }
  void set(std::uint32_t i, const FloatBox& box) {
    for (std::size_t k = 0; k < 3; ++k) low[k][i] = box.low[k], high[k][i] = box.high[k];
  }
  [[nodiscard]] FloatBox at(std::uint32_t i) const {
    FloatBox box;
    for (std::size_t k = 0; k < 3; ++k) box.low[k] = low[k][i], box.high[k] = high[k][i];
    return box;
  }
  /// From box i to a point.
  [[nodiscard]] float squared_distance(std::uint32_t i, const std::array<float, 3>& point) const {
    float sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const float away = std::max({low[k][i] - point[k], point[k] - high[k][i], 0.0F});
      sum += away * away;
    }
    return sum;
  }
  [[nodiscard]] FloatBox hull() const {
    FloatBox box;
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = *std::min_element(low[k].begin(), low[k].end());
      box.high[k] = *std::max_element(high[k].begin(), high[k].end());
    }
    return box;
  }
  /// Bit i: box i meets `box`.
  [[nodiscard]] std::uint32_t meeting(const FloatBox& box) const {
    return contact::meeting({low[0].data(), low[1].data(), low[2].data()},
                            {high[0].data(), high[1].data(), high[2].data()}, box);
  }
};

/// Boxes (or points) sorted along a Z-order curve and packed eight to a leaf; eight leaves make a node, eight nodes the
/// next one, up to a root. Cells of the curve that hold many boxes have curves of their own, so a dense corner of a
/// wide model is resolved as well as the rest. Empty boxes and those with NaN are left out. Memory: about 33 bytes for
/// each box. Build time is O(n) except for nested dense corners.
class BoxTree {
 public:
  BoxTree(std::span<const Bounds> boxes, const FloatMap& map);
  BoxTree(std::span<const Vector> points, const FloatMap& map);

  [[nodiscard]] std::size_t leaves() const { return levels_[0].size(); }
  [[nodiscard]] const BoxPack& leaf(std::uint32_t i) const { return levels_[0][i]; }
  /// Position in the input of box i of a leaf.
  [[nodiscard]] std::uint32_t box(std::uint32_t leaf, std::uint32_t i) const {
    return order_[leaf * BoxPack::width + i];
  }

  /// How many boxes a leaf has.
  [[nodiscard]] std::uint32_t filled(std::uint32_t leaf) const {
    return static_cast<std::uint32_t>(
        std::min<std::size_t>(BoxPack::width, order_.size() - std::size_t{leaf} * BoxPack::width));
  }

  /// Calls visit(leaf) for all leaves from number `first` on whose hull meets the box.
  template <class Visit>
  void leaves_meeting(const FloatBox& box, std::uint32_t first, const Visit& visit) const {
    if (leaves() == 1) visit(0U);
    if (leaves() > 1) descend(levels_.size() - 1, 0, box, first, visit);
  }

  /// Calls visit(leaf, squared distance of its hull) for the leaves, the nearest to the point first, until it returns
  /// false. `point`: after the map.
  template <class Visit>
  void leaves_by_distance(const std::array<float, 3>& point, const Visit& visit) const {
    struct Place {
      float squared = 0;
      std::uint32_t level = 0, node = 0;
      bool operator<(const Place& other) const { return squared > other.squared; }  // the nearest on top
    };
    static thread_local std::vector<Place> waiting;
    waiting.clear();
    if (leaves() > 0) waiting.push_back({0, static_cast<std::uint32_t>(levels_.size() - 1), 0});
    while (!waiting.empty()) {
      std::pop_heap(waiting.begin(), waiting.end());
      const Place place = waiting.back();
      waiting.pop_back();
      if (place.level == 0) {
        if (!visit(place.node, place.squared)) return;
        continue;
      }
      const BoxPack& children = levels_[place.level][place.node];
      for (std::uint32_t i = 0; i < BoxPack::width; ++i) {
        const std::uint32_t child = place.node * BoxPack::width + i;
        if (child >= levels_[place.level - 1].size()) break;
        waiting.push_back({children.squared_distance(i, point), place.level - 1, child});
        std::push_heap(waiting.begin(), waiting.end());
      }
    }
  }

 private:
  template <class Items>
  void build(const Items& items, const FloatMap& map);

  template <class Visit>
  void descend(std::size_t level, std::uint32_t node, const FloatBox& box, std::uint32_t first,
               const Visit& visit) const {
    const std::size_t leaves_per_child = std::size_t{1} << 3 * (level - 1);
    for (std::uint32_t bits = levels_[level][node].meeting(box); bits != 0; bits &= bits - 1) {
      const std::uint32_t child = node * BoxPack::width + static_cast<std::uint32_t>(std::countr_zero(bits));
      if ((child + 1) * leaves_per_child <= first) continue;
      if (level == 1)
        visit(child);
      else
        descend(level - 1, child, box, first, visit);
    }
  }

  std::vector<std::uint32_t> order_;
  std::vector<std::vector<BoxPack>> levels_;  ///< leaves first, the root last
};

/// Calls pair(i, j) for box i of leaf `l` of tree `a` and box j of leaf `m` of tree `b` that meet after the map.
/// `hull_l`: of leaf l.
template <class Pair>
void compare_leaves(const BoxTree& a, std::uint32_t l, const FloatBox& hull_l, const BoxTree& b, std::uint32_t m,
                    const Pair& pair) {
  const BoxPack& others = a.leaf(l);
  for (std::uint32_t rows = b.leaf(m).meeting(hull_l); rows != 0; rows &= rows - 1) {
    const auto j = static_cast<std::uint32_t>(std::countr_zero(rows));
    for (std::uint32_t bits = others.meeting(b.leaf(m).at(j)); bits != 0; bits &= bits - 1)
      pair(static_cast<std::uint32_t>(std::countr_zero(bits)), j);
  }
}

}  // namespace gapcheck::contact
