#pragma once
#include <cstddef>
#include <cstdint>

/// Plain numbers only: this header is compiled for several kinds of processors, and nothing that other code includes
/// may be compiled for more than one.
namespace gapcheck::geometry {

/// Pairs of a facet and a point side by side, and what is known about them. Bit i of a word belongs to pair i.
struct PairArrays {
  static constexpr std::size_t capacity = 64;
  alignas(
      64) double corner[4][3][capacity] = {};  ///< [corner][axis][pair], less the query; triangles leave the last out
  alignas(64) double bound[capacity] = {};
  std::size_t size = 0;

  std::uint64_t closer = 0;   ///< proven nearer than the bound
  std::uint64_t apart = 0;    ///< proven not
  std::uint64_t located = 0;  ///< s, t and squared_distance are the closest point's, on the face
  alignas(64) double s[capacity] = {}, t[capacity] = {};
  alignas(64) double squared_distance[capacity] = {};
};

/// One bit for each of `size` pairs.
[[nodiscard, gnu::always_inline]] constexpr std::uint64_t filled(std::size_t size) {
  return size >= PairArrays::capacity ? ~std::uint64_t{0} : (std::uint64_t{1} << size) - 1;
}

}  // namespace gapcheck::geometry
