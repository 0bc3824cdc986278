#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "contact/search/search.hpp"

namespace gapcheck::contact {

/// What a look at some hundred points and some ten boxes, evenly spaced in the lists, tells about a search. Costs a few
/// microseconds. Points and boxes with numbers that are infinite or none, and empty boxes, are left out.
class SearchSample {
 public:
  SearchSample(std::span<const Vector> points, std::span<const Bounds> boxes);

  /// Length that the middle 98 % of the points take along an axis; 0 without points.
  [[nodiscard]] double extent(int axis) const { return extents_[static_cast<std::size_t>(axis)]; }
  /// Mean share of the points that lie in a box's interval along an axis.
  [[nodiscard]] double slab(int axis) const { return slabs_[static_cast<std::size_t>(axis)]; }
  /// The axis with the thinnest slabs.
  [[nodiscard]] int sweep_axis() const;
  /// The longest side of the box in the middle, by that side; 0 without boxes.
  [[nodiscard]] double box_length() const { return box_length_; }

 private:
  std::array<double, 3> extents_{}, slabs_{};
  double box_length_ = 0;
};

}  // namespace gapcheck::contact
