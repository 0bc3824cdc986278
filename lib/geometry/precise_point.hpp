#pragma once
#include <array>
#include <cmath>

#include "geometry/double_double.hpp"
#include "geometry/lanes.hpp"
#include "geometry/patch.hpp"

/// Points and parameters of about 106 bits, for the proofs of precise.hpp, precise_edge.hpp and pieces.hpp.
namespace gapcheck::geometry::precise {
namespace {

using Number = DoubleDouble<double>;
using Two = Lanes<2>;

/// x and y side by side, and z alone.
struct Point {
  DoubleDouble<Two> xy, z;
};

[[nodiscard]] inline Point operator+(const Point& a, const Point& b) { return {a.xy + b.xy, a.z + b.z}; }
[[nodiscard]] inline Point operator-(const Point& a, const Point& b) { return {a.xy - b.xy, a.z - b.z}; }
[[nodiscard]] inline Point operator*(const Number& f, const Point& a) {
  const DoubleDouble<Two> both{all<Two>(f.high), all<Two>(f.low)};
  return {both * a.xy, both * a.z};
}
[[nodiscard]] inline Point quarter(const Point& a) {
  return {{0.25 * a.xy.high, 0.25 * a.xy.low}, {0.25 * a.z.high, 0.25 * a.z.low}};
}
[[nodiscard]] inline Number dot(const Point& a, const Point& b) {
  const DoubleDouble<Two> xy = a.xy * b.xy, z = a.z * b.z;
  return (Number{xy.high[0], xy.low[0]} + Number{xy.high[1], xy.low[1]}) + Number{z.high[0], z.low[0]};
}
[[nodiscard]] inline Number square(const Point& a) { return dot(a, a); }
[[nodiscard]] inline Vector rounded(const Point& a) { return {a.xy.high[0], a.xy.high[1], a.z.high[0]}; }

/// to - from, without rounding.
[[nodiscard]] inline Point difference(const Vector& to, const Vector& from) {
  return {two_sum<Two>(Two{to.x(), to.y()}, Two{-from.x(), -from.y()}),
          two_sum<Two>(Two{to.z(), 0}, Two{-from.z(), 0})};
}

/// A parameter between `least` and `greatest`.
struct Parameter {
  Number value;
  double least, greatest;

  [[nodiscard]] bool at_least() const { return value.high == least && value.low == 0; }
  [[nodiscard]] bool at_greatest() const { return value.high == greatest && value.low == 0; }
  /// The slope leads out of the range.
  [[nodiscard]] bool held(double slope) const { return (at_greatest() && slope <= 0) || (at_least() && slope >= 0); }
  void move(double step) {
    value = value + Number{step, 0};
    const auto beyond = [](const Number& a, double end) { return a.high > end || (a.high == end && a.low > 0); };
    if (beyond(value, greatest)) value = {greatest, 0};
    if (beyond(-value, -least)) value = {least, 0};
  }
  /// In double precision, at 1 or -1 only if the value itself is there.
  [[nodiscard]] double nearly() const { return value.low == 0 ? value.high : value.high * (1 - roundoff); }
};

/// A point w of a facet relative to the bound: the squared distance less the squared bound, and its error.
struct Beside {
  double excess = 0, error = 0;
  Beside() = default;
  Beside(const Point& w, double size, const Number& squared_bound) {
    constexpr double squared_roundoff = roundoff * roundoff;
    const Number ww = square(w);
    excess = (ww - squared_bound).high;
    error = squared_roundoff * (128 * (ww.high + squared_bound.high) + 2048 * size * rounded(w).lpNorm<1>() +
                                0x1p20 * squared_roundoff * size * size);
  }
  [[nodiscard]] bool closer() const { return excess < -error; }
  /// The facet is nowhere nearer to the origin than at the bound if nothing lies deeper below w than `drop`.
  [[nodiscard]] bool apart(double drop) const { return 0.999 * (excess - error) >= drop && excess > error; }
};

}  // namespace
}  // namespace gapcheck::geometry::precise
