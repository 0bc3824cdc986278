#include "contact/search/float_box.hpp"

#include <cmath>

namespace gapcheck::contact {
namespace {

void add_sample(std::span<const Bounds> boxes, int axis, std::vector<double>& sample) {
  constexpr std::size_t samples = 128;
  for (std::size_t i = 0; i < boxes.size(); i += std::max<std::size_t>(1, boxes.size() / samples)) {
    const double middle = 0.5 * boxes[i].low[axis] + 0.5 * boxes[i].high[axis];
    if (!boxes[i].empty() && std::isfinite(middle)) sample.push_back(middle);
  }
}

void add_sample(std::span<const Vector> points, int axis, std::vector<double>& sample) {
  constexpr std::size_t samples = 128;
  for (std::size_t i = 0; i < points.size(); i += std::max<std::size_t>(1, points.size() / samples))
    if (std::isfinite(points[i][axis])) sample.push_back(points[i][axis]);
}

template <class Items>
Vector middle_of(const Items& a, std::span<const Bounds> b) {
  Vector middle = Vector::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> sample;
    add_sample(a, axis, sample);
    add_sample(b, axis, sample);
    if (sample.empty()) continue;
    const auto at = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
    std::nth_element(sample.begin(), at, sample.end());
    middle[axis] = *at;
  }
  return middle;
}

}  // namespace

FloatMap::FloatMap(std::span<const Bounds> a, std::span<const Bounds> b) : origin_(middle_of(a, b)) {}
FloatMap::FloatMap(std::span<const Vector> points, std::span<const Bounds> boxes) : origin_(middle_of(points, boxes)) {}

}  // namespace gapcheck::contact
