// Points are sorted along one axis; a box finds its interval there by bisection and scans it. The axis is the one along
// which the boxes' intervals hold the fewest points, on a sample.
//
// Coordinates are compared in single precision after a monotone map, so no pair is lost; the boxes themselves decide
// the survivors.
#include <algorithm>
#include <bit>
#include <vector>

#include "base/parallel.hpp"
#include "base/radix_sort.hpp"
#include "contact/search/float_box.hpp"
#include "contact/search/search.hpp"
#include "contact/search/search_sample.hpp"

namespace gapcheck::contact {
namespace {

/// A number that rises with the float. No NaN.
std::uint32_t rising(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value + 0.0F);  // zero has one sign here, else two numbers
  return bits >> 31 != 0 ? ~bits : bits | 1U << 31;
}

class Sweep {
 public:
  Sweep(std::span<const Vector> points, std::span<const Bounds> boxes)
      : input_(points), map_(points, boxes), axis_(SearchSample(points, boxes).sweep_axis()) {
    struct Item {
      std::uint32_t key, point;
    };
    std::vector<Item> items;
    items.reserve(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if ((points[i].array() == points[i].array()).all()) items.push_back({rising(map_(points[i], axis_)), i});
    std::vector<Item> spare(items.size());
    radix_sort(std::span(items), std::span(spare), 32, [](const Item& item) { return item.key; });
    order_.resize(items.size());
    sorted_ = FloatPoints(items.size());
    parallel_for(items.size(), 8192, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        order_[i] = items[i].point;
        sorted_.set(i, points[items[i].point], map_);
      }
    });
  }

  void collect(const Bounds& box, std::vector<std::uint32_t>& inside) const {
    const FloatBox mapped = map_.box(box);
    const auto axis = static_cast<std::size_t>(axis_);
    const auto along = sorted_.along(axis_);
    const auto first = std::lower_bound(along.begin(), along.end(), mapped.low[axis]);
    const auto last = std::upper_bound(first, along.end(), mapped.high[axis]);
    sorted_.inside(static_cast<std::size_t>(first - along.begin()), static_cast<std::size_t>(last - along.begin()),
                   mapped, [&](std::size_t i) {
                     if (box.contains(input_[order_[i]])) inside.push_back(order_[i]);
                   });
  }

 private:
  std::span<const Vector> input_;
  FloatMap map_;
  int axis_;
  std::vector<std::uint32_t> order_;  // positions of the points along the axis
  FloatPoints sorted_;                // beside order_
};

class SortedSweep final : public CandidateSearch {
 public:
  [[nodiscard]] std::string_view name() const override { return "sorted sweep"; }

  void run(std::span<const Vector> points, std::span<const Bounds> boxes, const CandidateSink& sink) const override {
    if (points.empty() || boxes.empty()) return;
    const Sweep sweep(points, boxes);
    parallel_for(boxes.size(), 256, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> inside;
      for (std::size_t b = begin; b < end; ++b) {
        if (boxes[b].empty()) continue;
        inside.clear();
        sweep.collect(boxes[b], inside);
        if (!inside.empty()) sink(static_cast<std::uint32_t>(b), inside);
      }
    });
  }
};

}  // namespace

std::unique_ptr<CandidateSearch> make_sorted_sweep() { return std::make_unique<SortedSweep>(); }

}  // namespace gapcheck::contact
