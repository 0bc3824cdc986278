#pragma once
#include <cstdint>
#include <vector>

#include "geometry/batch/pair_arrays.hpp"
#include "geometry/certificate.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry {

/// Number of pairs that the processor handles at once.
enum class BatchWidth : std::uint8_t { two = 2, four = 4, eight = 8 };

/// The widths this processor has, ascending; never empty.
[[nodiscard]] std::vector<BatchWidth> batch_widths();

/// "Nearer than the bound?" for up to 64 pairs of a facet and a point at once: one facet with many points, or each pair
/// with a facet of its own. Proves what doubles can prove cheaply; the rest is `open` and needs decide(). Facets of one
/// batch are all quads or all triangles. The answers are the same for every width. Coordinates and bounds may be
/// anything; non-finite, far too large or far too small values stay open. Derivation: docs/theory/decisions.md.
class PairBatch {
 public:
  static constexpr std::size_t capacity = PairArrays::capacity;
  explicit PairBatch(bool triangles) : triangles_(triangles) {}

  [[nodiscard]] bool full() const { return arrays_.size == capacity; }
  [[nodiscard]] std::size_t size() const { return arrays_.size; }
  void clear() { arrays_.size = 0; }
  /// The corners of a facet less the point (seen_from). The batch must not be full.
  void add(const Corners& e, double bound) {
    const std::size_t i = arrays_.size++;
    for (std::size_t corner = 0; corner < 4; ++corner)
      for (int axis = 0; axis < 3; ++axis) arrays_.corner[corner][axis][i] = e[corner][axis];
    arrays_.bound[i] = bound;
  }

  /// Decides all pairs, with the greatest width that the processor has.
  void decide();
  /// The same with a width out of batch_widths().
  void decide(BatchWidth width);

  /// One bit per pair: proven nearer than the bound, proven not, and neither.
  [[nodiscard]] std::uint64_t closer() const { return arrays_.closer; }
  [[nodiscard]] std::uint64_t apart() const { return arrays_.apart; }
  [[nodiscard]] std::uint64_t open() const { return ~(arrays_.closer | arrays_.apart) & filled(arrays_.size); }
  /// Of pair i: closer, apart or open.
  [[nodiscard]] Verdict verdict(std::size_t i) const {
    return arrays_.closer >> i & 1 ? Verdict::closer : arrays_.apart >> i & 1 ? Verdict::apart : Verdict::open;
  }
  /// True if s(i), t(i) and squared_distance(i) belong to the closest point, up to rounding, and it lies on the face
  /// well off the border. Only for closer pairs.
  [[nodiscard]] bool located(std::size_t i) const { return arrays_.located >> i & 1; }
  [[nodiscard]] double s(std::size_t i) const { return arrays_.s[i]; }
  [[nodiscard]] double t(std::size_t i) const { return arrays_.t[i]; }
  [[nodiscard]] double squared_distance(std::size_t i) const { return arrays_.squared_distance[i]; }

 private:
  PairArrays arrays_;
  bool triangles_;
};

}  // namespace gapcheck::geometry
