#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

// For loops over many elements or pairs that are compiled several times, for the baseline processor and for wider
// vectors. Each operation is rounded as IEEE 754 says, so all give the same bits. GAPCHECK_INLINE: code outside of the
// functions that are compiled for a processor would be compiled for the baseline.
#if defined(__x86_64__) && defined(__GNUC__)
#define GAPCHECK_WIDE_VECTORS 1
#define GAPCHECK_FOUR_LANES __attribute__((target("avx2")))
#if defined(__clang__)  // does not know how to ask for vectors of eight
#define GAPCHECK_EIGHT_LANES GAPCHECK_FOUR_LANES
#else
#define GAPCHECK_EIGHT_LANES __attribute__((target("avx512f,avx512dq,prefer-vector-width=512")))
#endif
#else
#define GAPCHECK_WIDE_VECTORS 0
#endif
#define GAPCHECK_INLINE inline __attribute__((always_inline))

namespace gapcheck {

/// How many doubles the vectors of a processor hold.
enum class Lanes : std::uint8_t { two, four, eight };

inline Lanes lanes_of_processor() {
#if GAPCHECK_WIDE_VECTORS
  static const Lanes lanes = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") ? Lanes::eight
                             : __builtin_cpu_supports("avx2")                                        ? Lanes::four
                                                                                                     : Lanes::two;
  return lanes;
#else
  return Lanes::two;
#endif
}

/// A vector of one of many elements. Sums go from the left, as Eigen's do.
struct Triple {
  double x, y, z;
};
GAPCHECK_INLINE Triple operator+(Triple p, Triple q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
GAPCHECK_INLINE Triple operator-(Triple p, Triple q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
GAPCHECK_INLINE Triple operator-(Triple p) { return {-p.x, -p.y, -p.z}; }
GAPCHECK_INLINE Triple operator*(double f, Triple p) { return {f * p.x, f * p.y, f * p.z}; }
GAPCHECK_INLINE Triple operator/(Triple p, double f) { return {p.x / f, p.y / f, p.z / f}; }
GAPCHECK_INLINE Triple cross(Triple p, Triple q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
GAPCHECK_INLINE double dot(Triple p, Triple q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
GAPCHECK_INLINE double larger(double a, double b) { return a < b ? b : a; }
GAPCHECK_INLINE double smaller(double a, double b) { return b < a ? b : a; }

/// Vectors of many elements, by axis.
template <std::size_t N>
GAPCHECK_INLINE Triple load(const std::array<std::array<double, N>, 3>& rows, std::size_t i) {
  return {rows[0][i], rows[1][i], rows[2][i]};
}
template <std::size_t N>
GAPCHECK_INLINE void store(std::array<std::array<double, N>, 3>& rows, std::size_t i, Triple p) {
  rows[0][i] = p.x;
  rows[1][i] = p.y;
  rows[2][i] = p.z;
}

}  // namespace gapcheck
