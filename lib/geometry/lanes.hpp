#pragma once
#include <cstddef>
#include <cstdint>

#include "geometry/arithmetic.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

/// Vectors of doubles, one lane per pair. All operations are those of single doubles, lane by lane: the results do not
/// depend on the width. Internal linkage throughout, since the same source is compiled for several kinds of processors.
namespace gapcheck::geometry {
namespace {

template <std::size_t N>
struct LanesOf {
  typedef double type __attribute__((vector_size(8 * N)));  // NOLINT: the attribute needs the typedef
};
template <std::size_t N>
using Lanes = typename LanesOf<N>::type;

/// A mask has all bits of a lane set or none.
template <class V>
using Mask = decltype(V{} < V{});

template <class V>
inline constexpr std::size_t width = sizeof(V) / sizeof(double);

template <class V>
[[nodiscard]] inline V load(const double* from) {
  V value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}
template <class V>
inline void store(double* to, const V& value) {
  __builtin_memcpy(to, &value, sizeof value);
}
template <class V>
[[nodiscard]] inline V all(double value) {
  return V{} + value;
}
template <class V>
[[nodiscard]] inline V smaller(const V& a, const V& b) {
  return a < b ? a : b;
}
template <class V>
[[nodiscard]] inline V amount(const V& a) {
  return a < 0.0 ? -a : a;
}
/// Clamps to [low, high]; NaN becomes `low`.
template <class V>
[[nodiscard]] inline V clamped(const V& a, double low, double high) {
  const V raised = a > low ? a : all<V>(low);
  return raised < high ? raised : all<V>(high);
}

/// One bit per lane.
template <class V>
[[nodiscard]] inline std::uint64_t bits(const Mask<V>& mask) {
#if defined(__AVX512DQ__)
  if constexpr (width<V> == 8) return _mm512_movepi64_mask(reinterpret_cast<const __m512i&>(mask));
#endif
#if defined(__AVX__)
  if constexpr (width<V> == 4) {
    return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<const __m256d&>(mask)));
  }
#endif
#if defined(__SSE2__)
  if constexpr (width<V> == 2) return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<const __m128d&>(mask)));
#endif
  std::uint64_t out = 0;
  for (std::size_t i = 0; i < width<V>; ++i) out |= std::uint64_t{mask[i] != 0} << i;
  return out;
}

/// A vector in space, one per lane.
template <class V>
struct Vectors {
  V x, y, z;
};
template <class V>
[[nodiscard]] inline Vectors<V> operator+(const Vectors<V>& a, const Vectors<V>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
[[nodiscard]] inline Vectors<V> operator-(const Vectors<V>& a, const Vectors<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
[[nodiscard]] inline Vectors<V> operator*(const V& f, const Vectors<V>& a) {
  return {f * a.x, f * a.y, f * a.z};
}
template <class V>
[[nodiscard]] inline V dot(const Vectors<V>& a, const Vectors<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class V>
[[nodiscard]] inline Vectors<V> load(const double (&from)[3][64], std::size_t first) {
  return {load<V>(from[0] + first), load<V>(from[1] + first), load<V>(from[2] + first)};
}

}  // namespace
}  // namespace gapcheck::geometry
