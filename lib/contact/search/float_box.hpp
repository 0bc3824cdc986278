#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "base/large_array.hpp"
#include "contact/search/search.hpp"

namespace gapcheck::contact {

/// A box in single precision, after the map of a FloatMap. Empty unless given.
struct FloatBox {
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  std::array<float, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
};

/// Boxes are compared eight at a time.
inline constexpr std::uint32_t float_width = 8;

/// Bit k: the k-th of eight boxes meets `box`. `low`, `high`: the eight lowest and highest coordinates for each axis;
/// of points they are the same. A NaN meets nothing.
[[nodiscard]] inline std::uint32_t meeting(const std::array<const float*, 3>& low,
                                           const std::array<const float*, 3>& high, const FloatBox& box) {
#ifdef __SSE2__
  const auto four = [&](std::size_t at) {
    __m128 meet = _mm_castsi128_ps(_mm_set1_epi32(-1));
    for (std::size_t k = 0; k < 3; ++k) {
      meet = _mm_and_ps(meet, _mm_cmple_ps(_mm_loadu_ps(low[k] + at), _mm_set1_ps(box.high[k])));
      meet = _mm_and_ps(meet, _mm_cmpge_ps(_mm_loadu_ps(high[k] + at), _mm_set1_ps(box.low[k])));
    }
    return static_cast<std::uint32_t>(_mm_movemask_ps(meet));
  };
  return four(0) | four(4) << 4;
#else
  std::uint32_t bits = 0;
  for (std::uint32_t i = 0; i < float_width; ++i) {
    bool meet = true;
    for (std::size_t k = 0; k < 3; ++k) meet = meet && low[k][i] <= box.high[k] && high[k][i] >= box.low[k];
    bits |= static_cast<std::uint32_t>(meet) << i;
  }
  return bits;
#endif
}

/// A monotone map of coordinates to single precision: minus an origin in the middle of the scene, rounded to double,
/// rounded to float. Points inside a box and boxes that meet stay so after it; false hits are removed in double
/// precision.
class FloatMap {
 public:
  /// The origin is the middle of a sample of both lists.
  FloatMap(std::span<const Bounds> a, std::span<const Bounds> b);
  FloatMap(std::span<const Vector> points, std::span<const Bounds> boxes);
  /// NaN stays NaN.
  [[nodiscard]] float operator()(const Vector& x, int axis) const {
    constexpr double largest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(x[axis] - origin_[axis], -largest, largest));
  }
  [[nodiscard]] FloatBox box(const Bounds& bounds) const {
    FloatBox out;
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      out.low[axis] = (*this)(bounds.low, k);
      out.high[axis] = (*this)(bounds.high, k);
    }
    return out;
  }

 private:
  Vector origin_ = Vector::Zero();
};

/// Points after a FloatMap, one array for each axis, so that one comparison handles several.
class FloatPoints {
 public:
  /// Places for `count` points, to be set one by one, from any thread.
  explicit FloatPoints(std::size_t count = 0) : count_(count) {
    for (auto& row : rows_) resize_in_parallel(row, count + float_width);
  }
  void set(std::size_t i, const Vector& x, const FloatMap& map) {
    for (int k = 0; k < 3; ++k) rows_[static_cast<std::size_t>(k)][i] = map(x, k);
  }
  [[nodiscard]] std::span<const float> along(int axis) const {
    return std::span(rows_[static_cast<std::size_t>(axis)]).first(count_);
  }

  /// Calls visit(i) for the points of [begin, end) inside the closed box.
  template <class Visit>
  void inside(std::size_t begin, std::size_t end, const FloatBox& box, const Visit& visit) const {
    // The rows are longer than the points by as much as the last step may reach beyond them.
    for (std::size_t i = begin; i < end; i += float_width) {
      const std::array rows{rows_[0].data() + i, rows_[1].data() + i, rows_[2].data() + i};
      std::uint32_t bits = meeting(rows, rows, box);
      if (end - i < float_width) bits &= (1U << (end - i)) - 1;
      for (; bits != 0; bits &= bits - 1) visit(i + static_cast<std::size_t>(std::countr_zero(bits)));
    }
  }

 private:
  std::size_t count_;
  std::array<std::vector<float>, 3> rows_;
};

}  // namespace gapcheck::contact
