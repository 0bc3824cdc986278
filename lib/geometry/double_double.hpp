#pragma once

/// Numbers of about 106 bits as sums of two doubles, one lane of V each: V is double or one of lanes.hpp. Correct
/// without fused products and in rounding to nearest only. Error bounds: docs/theory/decisions.md.
namespace gapcheck::geometry {
namespace {

/// high + low with |low| <= half a unit in the last place of high.
template <class V>
struct DoubleDouble {
  V high, low;
};

/// a + b without rounding.
template <class V>
[[nodiscard]] inline DoubleDouble<V> two_sum(const V& a, const V& b) {
  const V sum = a + b, of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// a + b without rounding where |a| >= |b| or a = 0.
template <class V>
[[nodiscard]] inline DoubleDouble<V> ordered_sum(const V& a, const V& b) {
  const V sum = a + b;
  return {sum, b - (sum - a)};
}

/// a b without rounding, by halves of 26 bits (Dekker, 1971). Products above 1e300 or below 1e-280 may be off.
template <class V>
[[nodiscard]] inline DoubleDouble<V> two_product(const V& a, const V& b) {
  const V wide_a = 134217729.0 * a, wide_b = 134217729.0 * b;
  const V high_a = wide_a - (wide_a - a), low_a = a - high_a, high_b = wide_b - (wide_b - b), low_b = b - high_b;
  const V product = a * b;
  return {product, ((high_a * high_b - product) + high_a * low_b + low_a * high_b) + low_a * low_b};
}

/// Off by at most 4 u² (|a| + |b|).
template <class V>
[[nodiscard]] inline DoubleDouble<V> operator+(const DoubleDouble<V>& a, const DoubleDouble<V>& b) {
  const DoubleDouble<V> sum = two_sum<V>(a.high, b.high);
  return two_sum<V>(sum.high, sum.low + (a.low + b.low));
}
template <class V>
[[nodiscard]] inline DoubleDouble<V> operator-(const DoubleDouble<V>& a) {
  return {-a.high, -a.low};
}
template <class V>
[[nodiscard]] inline DoubleDouble<V> operator-(const DoubleDouble<V>& a, const DoubleDouble<V>& b) {
  return a + -b;
}
/// Off by at most 9 u² |a b|.
template <class V>
[[nodiscard]] inline DoubleDouble<V> operator*(const DoubleDouble<V>& a, const DoubleDouble<V>& b) {
  const DoubleDouble<V> product = two_product<V>(a.high, b.high);
  return ordered_sum<V>(product.high, product.low + (a.high * b.low + a.low * b.high));
}

}  // namespace
}  // namespace gapcheck::geometry
