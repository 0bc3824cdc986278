#include "contact/search/box_tree.hpp"

#include <cmath>
#include <tuple>

#include "base/large_array.hpp"
#include "base/parallel.hpp"
#include "base/radix_sort.hpp"

namespace gapcheck::contact {
namespace {

constexpr std::uint32_t width = BoxPack::width;
/// Cells of the curve with more boxes get a curve of their own.
constexpr std::size_t crowded_cell = std::size_t{8} * width;
/// Curves within curves: each is at least 500 times finer, so that these reach from 10^300 to the last bit.
constexpr int deepest_curve = 128;

/// Boxes and points as the tree takes them.
struct BoxItems {
  std::span<const Bounds> boxes;
  [[nodiscard]] std::size_t size() const { return boxes.size(); }
  [[nodiscard]] bool empty(std::size_t i) const { return boxes[i].empty(); }
  [[nodiscard]] double middle(std::size_t i, int axis) const {
    return 0.5 * boxes[i].low[axis] + 0.5 * boxes[i].high[axis];
  }
  [[nodiscard]] Bounds bounds(std::size_t i) const { return boxes[i]; }
};
struct PointItems {
  std::span<const Vector> points;
  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] bool empty(std::size_t i) const { return !(points[i].array() == points[i].array()).all(); }
  [[nodiscard]] double middle(std::size_t i, int axis) const { return points[i][axis]; }
  [[nodiscard]] Bounds bounds(std::size_t i) const { return {points[i], points[i]}; }
};

/// Up to about 1024 middles of the items along one axis, unsorted, without NaN.
template <class Items>
void sample_middles(const Items& items, int axis, std::vector<double>& sample) {
  constexpr std::size_t samples = 1024;
  for (std::size_t i = 0; i < items.size(); i += std::max<std::size_t>(1, items.size() / samples))
    if (!items.empty(i) && std::isfinite(items.middle(i, axis))) sample.push_back(items.middle(i, axis));
}

/// A Z-order curve over a grid of cells.
class Curve {
 public:
  static constexpr int bits = 30;

  /// Over the middle 96 % of a sample and room around them: one stray box must not make all cells huge.
  template <class Items>
  static Curve over_most(const Items& items) {
    Curve curve;
    double extent = 0;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> sample;
      sample_middles(items, axis, sample);
      if (sample.empty()) continue;
      std::sort(sample.begin(), sample.end());
      const std::size_t margin = sample.size() / 50;
      const double low = sample[margin], high = sample[sample.size() - 1 - margin];
      curve.origin_[axis] = low;
      extent = std::max(extent, high - low);
    }
    curve.cells_per_length_ = extent > 0 && std::isfinite(extent) ? cells / 2 / extent : 0;
    curve.shift_ = cells / 4;
    return curve;
  }

  /// Over all items given. Nothing to distinguish: no cells.
  template <class Items, class Positions>
  static Curve over_all(const Items& items, const Positions& positions) {
    constexpr double limit = 1e300;
    Curve curve;
    double extent = 0;
    for (int axis = 0; axis < 3; ++axis) {
      double low = limit, high = -limit;
      for (const auto& position : positions) {
        const double middle = std::clamp(items.middle(position.item, axis), -limit, limit);
        low = std::min(low, middle), high = std::max(high, middle);
      }
      curve.origin_[axis] = low;
      extent = std::max(extent, high - low);
    }
    const double cells_per_length = extent > 0 ? cells / extent : 0;
    curve.cells_per_length_ = std::isfinite(cells_per_length) ? cells_per_length : 0;
    return curve;
  }

  [[nodiscard]] bool flat() const { return cells_per_length_ == 0; }
  template <class Items>
  [[nodiscard]] std::uint32_t key(const Items& items, std::size_t i) const {
    std::uint32_t key = 0;
    for (int k = 0; k < 3; ++k) {
      const double at = (items.middle(i, k) - origin_[k]) * cells_per_length_ + shift_;
      key |= spread(at > 0 ? static_cast<std::uint32_t>(std::min(at, cells - 1)) : 0) << k;
    }
    return key;
  }

 private:
  static constexpr double cells = 1024;  ///< per axis
  static std::uint32_t spread(std::uint32_t v) {
    v = (v | v << 16) & 0x030000ffU;
    v = (v | v << 8) & 0x0300f00fU;
    v = (v | v << 4) & 0x030c30c3U;
    return (v | v << 2) & 0x09249249U;
  }
  Vector origin_ = Vector::Zero();
  double cells_per_length_ = 0, shift_ = 0;
};

struct Place {
  std::uint32_t key, item;
};

/// Sorts the places along the curve, and those of crowded cells along curves of their own.
template <class Items>
void sort_along(const Items& items, const Curve& curve, std::span<Place> places, std::span<Place> spare, int depth) {
  parallel_for(places.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) places[i].key = curve.key(items, places[i].item);
  });
  constexpr std::size_t few = 1024;
  if (places.size() < few)
    std::sort(places.begin(), places.end(),
              [](const Place& a, const Place& b) { return std::tie(a.key, a.item) < std::tie(b.key, b.item); });
  else
    radix_sort(places, spare, Curve::bits, [](const Place& place) { return place.key; });
  if (depth == deepest_curve) return;
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    end = begin + 1;
    while (end < places.size() && places[end].key == places[begin].key) ++end;
    if (end - begin <= crowded_cell) continue;
    const auto run = places.subspan(begin, end - begin);
    const Curve finer = Curve::over_all(items, run);
    if (!finer.flat()) sort_along(items, finer, run, spare.subspan(begin, end - begin), depth + 1);
  }
}

/// Positions of the items that are not empty, along the curve.
template <class Items>
std::vector<std::uint32_t> sorted(const Items& items) {
  std::vector<Place> places = large_array<Place>(items.size());
  parallel_for(items.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) places[i] = {items.empty(i) ? 1U : 0U, static_cast<std::uint32_t>(i)};
  });
  std::erase_if(places, [](const Place& place) { return place.key == 1; });
  std::vector<Place> spare = large_array<Place>(places.size());
  sort_along(items, Curve::over_most(items), std::span(places), std::span(spare), 0);
  std::vector<std::uint32_t> order(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) order[i] = places[i].item;
  return order;
}

}  // namespace

BoxTree::BoxTree(std::span<const Bounds> boxes, const FloatMap& map) { build(BoxItems{boxes}, map); }
BoxTree::BoxTree(std::span<const Vector> points, const FloatMap& map) { build(PointItems{points}, map); }

template <class Items>
void BoxTree::build(const Items& items, const FloatMap& map) {
  order_ = sorted(items);
  const auto packs = [](std::size_t n) { return (n + width - 1) / width; };
  levels_.push_back(large_array<BoxPack>(packs(order_.size())));
  parallel_for(leaves(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin * width; i < std::min(end * width, order_.size()); ++i)
      levels_[0][i / width].set(i % width, map.box(items.bounds(order_[i])));
  });
  while (levels_.back().size() > 1) {
    const std::vector<BoxPack>& below = levels_.back();
    std::vector<BoxPack> above(packs(below.size()));
    parallel_for(above.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin * width; i < std::min(end * width, below.size()); ++i)
        above[i / width].set(i % width, below[i].hull());
    });
    levels_.push_back(std::move(above));
  }
}

}  // namespace gapcheck::contact
