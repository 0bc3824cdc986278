// Boxes are sorted along a Z-order curve and packed eight to a leaf; eight leaves make a node, eight nodes the next one,
// up to a root. Every leaf then asks a tree for the leaves that it meets, and two leaves compare their boxes.
//
// The tree holds single-precision numbers. They come from one monotone map (less the origin, rounded to double, rounded
// to float), so boxes that meet still meet after it: no pair is lost. Pairs that meet only there are told apart at the end
// by the boxes themselves.
#include "contact/box_pairs.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "base/parallel.hpp"

namespace gapcheck::contact {
namespace {

constexpr std::uint32_t width = 8;  ///< boxes in a leaf, children of a node
constexpr std::uint32_t no_box = std::numeric_limits<std::uint32_t>::max();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// A box after the map.
struct Box {
  std::array<float, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
};

/// Eight boxes beside one another, so that one comparison can take several.
struct Pack {
  std::array<std::array<float, width>, 3> low, high;

  Pack() {
    for (auto& row : low) row.fill(infinity);
    for (auto& row : high) row.fill(-infinity);
  }
  void set(std::uint32_t i, const Box& box) {
    for (std::size_t k = 0; k < 3; ++k) low[k][i] = box.low[k], high[k][i] = box.high[k];
  }
  [[nodiscard]] Box at(std::uint32_t i) const {
    Box box;
    for (std::size_t k = 0; k < 3; ++k) box.low[k] = low[k][i], box.high[k] = high[k][i];
    return box;
  }
  [[nodiscard]] Box hull() const {
    Box box;
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = *std::min_element(low[k].begin(), low[k].end());
      box.high[k] = *std::max_element(high[k].begin(), high[k].end());
    }
    return box;
  }
  /// Bit i: box i meets `box`.
  [[nodiscard]] std::uint32_t meeting(const Box& box) const {
    std::array<std::int32_t, width> hit;
    for (std::uint32_t i = 0; i < width; ++i)
      hit[i] = static_cast<std::int32_t>(low[0][i] <= box.high[0]) & static_cast<std::int32_t>(high[0][i] >= box.low[0]) &
               static_cast<std::int32_t>(low[1][i] <= box.high[1]) & static_cast<std::int32_t>(high[1][i] >= box.low[1]) &
               static_cast<std::int32_t>(low[2][i] <= box.high[2]) & static_cast<std::int32_t>(high[2][i] >= box.low[2]);
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < width; ++i) bits |= static_cast<std::uint32_t>(hit[i]) << i;
    return bits;
  }
};

/// The common map of both lists: an origin amid the boxes, and the size of a cell of the curve.
class Map {
 public:
  Map(std::span<const Bounds> a, std::span<const Bounds> b) {
    // The middle 96 % of a sample and room around them: one stray box must not make all cells huge.
    constexpr std::size_t samples = 1024;
    double extent = 0;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> sample;
      for (const auto boxes : {a, b})
        for (std::size_t i = 0; i < boxes.size(); i += std::max<std::size_t>(1, boxes.size() / samples)) {
          const double middle = 0.5 * boxes[i].low[axis] + 0.5 * boxes[i].high[axis];
          if (!boxes[i].empty() && std::isfinite(middle)) sample.push_back(middle);
        }
      if (sample.empty()) continue;
      std::sort(sample.begin(), sample.end());
      const std::size_t margin = sample.size() / 50;
      const double low = sample[margin], high = sample[sample.size() - 1 - margin];
      origin_[axis] = low;
      extent = std::max(extent, high - low);
    }
    cells_per_length_ = extent > 0 && std::isfinite(extent) ? cells / 2 / extent : 0;
  }
  [[nodiscard]] Box box(const Bounds& bounds) const {
    Box out;
    for (int k = 0; k < 3; ++k) {
      out.low[k] = to_float(bounds.low[k] - origin_[k]);
      out.high[k] = to_float(bounds.high[k] - origin_[k]);
    }
    return out;
  }
  /// Place along the Z-order curve, in 30 bits.
  [[nodiscard]] std::uint32_t key(const Bounds& bounds) const {
    std::uint32_t key = 0;
    for (int k = 0; k < 3; ++k) {
      const double at = (0.5 * bounds.low[k] + 0.5 * bounds.high[k] - origin_[k]) * cells_per_length_ + cells / 4;
      key |= spread(at > 0 ? static_cast<std::uint32_t>(std::min(at, cells - 1)) : 0) << k;
    }
    return key;
  }

 private:
  static constexpr double cells = 1024;  ///< per axis
  static float to_float(double x) {
    constexpr double largest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(x, -largest, largest));
  }
  static std::uint32_t spread(std::uint32_t v) {
    v = (v | v << 16) & 0x030000ffU;
    v = (v | v << 8) & 0x0300f00fU;
    v = (v | v << 4) & 0x030c30c3U;
    return (v | v << 2) & 0x09249249U;
  }
  Vector origin_ = Vector::Zero();
  double cells_per_length_ = 0;
};

/// Positions of the boxes that are not empty, along the curve.
std::vector<std::uint32_t> sorted(std::span<const Bounds> boxes, const Map& map) {
  struct Item {
    std::uint32_t key, box;
  };
  std::vector<Item> items(boxes.size());
  parallel_for(boxes.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      items[i] = boxes[i].empty() ? Item{0, no_box} : Item{map.key(boxes[i]), static_cast<std::uint32_t>(i)};
  });
  std::erase_if(items, [](const Item& item) { return item.box == no_box; });
  constexpr int digit = 10;
  constexpr std::uint32_t radix = 1U << digit;
  std::vector<Item> spare(items.size());
  for (int shift = 0; shift < 3 * digit; shift += digit) {
    std::array<std::uint32_t, radix + 1> start{};
    for (const Item& item : items) ++start[(item.key >> shift & (radix - 1)) + 1];
    for (std::size_t d = 1; d <= radix; ++d) start[d] += start[d - 1];
    for (const Item& item : items) spare[start[item.key >> shift & (radix - 1)]++] = item;
    items.swap(spare);
  }
  std::vector<std::uint32_t> order(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].box;
  return order;
}

class Tree {
 public:
  Tree(std::span<const Bounds> boxes, const Map& map) : order_(sorted(boxes, map)) {
    const auto packs = [](std::size_t n) { return (n + width - 1) / width; };
    levels_.emplace_back(packs(order_.size()));
    parallel_for(leaves(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin * width; i < std::min(end * width, order_.size()); ++i)
        levels_[0][i / width].set(i % width, map.box(boxes[order_[i]]));
    });
    while (levels_.back().size() > 1) {
      std::vector<Pack> above(packs(levels_.back().size()));
      for (std::size_t i = 0; i < levels_.back().size(); ++i) above[i / width].set(i % width, levels_.back()[i].hull());
      levels_.push_back(std::move(above));
    }
  }
  [[nodiscard]] std::size_t leaves() const { return levels_[0].size(); }
  [[nodiscard]] const Pack& leaf(std::uint32_t i) const { return levels_[0][i]; }
  /// Position in the input of box i of a leaf.
  [[nodiscard]] std::uint32_t box(std::uint32_t leaf, std::uint32_t i) const { return order_[leaf * width + i]; }

  /// Calls visit(leaf) for all leaves from number `first` on whose hull meets the box.
  template <class Visit>
  void leaves_meeting(const Box& box, std::uint32_t first, const Visit& visit) const {
    if (leaves() == 1) visit(0U);
    if (leaves() > 1) descend(levels_.size() - 1, 0, box, first, visit);
  }

 private:
  template <class Visit>
  void descend(std::size_t level, std::uint32_t node, const Box& box, std::uint32_t first, const Visit& visit) const {
    const std::size_t leaves_per_child = std::size_t{1} << 3 * (level - 1);
    for (std::uint32_t bits = levels_[level][node].meeting(box); bits != 0; bits &= bits - 1) {
      const std::uint32_t child = node * width + static_cast<std::uint32_t>(std::countr_zero(bits));
      if ((child + 1) * leaves_per_child <= first) continue;
      if (level == 1)
        visit(child);
      else
        descend(level - 1, child, box, first, visit);
    }
  }

  std::vector<std::uint32_t> order_;
  std::vector<std::vector<Pack>> levels_;  ///< leaves first, the root last
};

constexpr std::size_t leaf_grain = 256;

/// Calls pair(a, b) for the boxes of leaf `l` of one tree and leaf `m` of the other that meet after the map.
template <class Pair>
void compare_leaves(const Tree& a, std::uint32_t l, const Box& hull_l, const Tree& b, std::uint32_t m, const Pair& pair) {
  const Pack& others = a.leaf(l);
  for (std::uint32_t rows = b.leaf(m).meeting(hull_l); rows != 0; rows &= rows - 1) {
    const auto j = static_cast<std::uint32_t>(std::countr_zero(rows));
    for (std::uint32_t bits = others.meeting(b.leaf(m).at(j)); bits != 0; bits &= bits - 1)
      pair(static_cast<std::uint32_t>(std::countr_zero(bits)), j);
  }
}

void brute_force(std::span<const Bounds> a, std::span<const Bounds> b, bool self, const BoxPairVisit& visit) {
  parallel_for(a.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = self ? i + 1 : 0; j < b.size(); ++j)
        if (!a[i].empty() && !b[j].empty() && a[i].meets(b[j]))
          visit(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
  });
}

}  // namespace

void for_each_box_pair(std::span<const Bounds> a, std::span<const Bounds> b, const BoxPairVisit& visit, BoxSearch search) {
  if (a.empty() || b.empty()) return;
  if (search == BoxSearch::brute_force) return brute_force(a, b, false, visit);
  const Map map(a, b);
  const Tree first(a, map), second(b, map);
  parallel_for(first.leaves(), leaf_grain, [&](std::size_t begin, std::size_t end) {
    for (auto l = static_cast<std::uint32_t>(begin); l < end; ++l) {
      const Box hull = first.leaf(l).hull();
      second.leaves_meeting(hull, 0, [&](std::uint32_t m) {
        compare_leaves(first, l, hull, second, m, [&](std::uint32_t i, std::uint32_t j) {
          const std::uint32_t p = first.box(l, i), q = second.box(m, j);
          if (a[p].meets(b[q])) visit(p, q);
        });
      });
    }
  });
}

void for_each_box_pair(std::span<const Bounds> boxes, const BoxPairVisit& visit, BoxSearch search) {
  if (boxes.empty()) return;
  if (search == BoxSearch::brute_force) return brute_force(boxes, boxes, true, visit);
  const Tree tree(boxes, Map(boxes, {}));
  parallel_for(tree.leaves(), leaf_grain, [&](std::size_t begin, std::size_t end) {
    for (auto l = static_cast<std::uint32_t>(begin); l < end; ++l) {
      const Box hull = tree.leaf(l).hull();
      tree.leaves_meeting(hull, l, [&](std::uint32_t m) {
        compare_leaves(tree, l, hull, tree, m, [&](std::uint32_t i, std::uint32_t j) {
          if (l == m && i >= j) return;
          const std::uint32_t p = tree.box(l, i), q = tree.box(m, j);
          if (boxes[p].meets(boxes[q])) visit(std::min(p, q), std::max(p, q));
        });
      });
    }
  });
}

}  // namespace gapcheck::contact
