#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "contact/search/search.hpp"

namespace gapcheck::contact {

/// What a few hundred points and a few tens of boxes, evenly spaced in the lists, tell about a search. Costs a few
/// microseconds. Points and boxes with infinite or NaN coordinates, and empty boxes, are left out.
class SearchSample {
 public:
  SearchSample(std::span<const Vector> points, std::span<const Bounds> boxes);

  /// Extent of the middle 98 % of the points along an axis; 0 without points.
  [[nodiscard]] double extent(int axis) const { return extents_[static_cast<std::size_t>(axis)]; }
  /// The axis with the thinnest slabs.
  [[nodiscard]] int sweep_axis() const;
  /// The longest side of the median box, by that side; 0 without boxes.
  [[nodiscard]] double box_length() const { return box_length_; }

 private:
  std::array<double, 3> extents_{};
  std::array<double, 3> slabs_{};  ///< mean share of the points that lie in a box's interval along an axis
  double box_length_ = 0;
};

}  // namespace gapcheck::contact
