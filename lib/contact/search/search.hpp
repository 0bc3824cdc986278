#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string_view>

#include "base/vector.hpp"

namespace gapcheck::contact {

/// Axis-aligned box.
struct Bounds {
  Vector low = Vector::Constant(1e300), high = Vector::Constant(-1e300);
  void add(const Vector& x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  [[nodiscard]] bool empty() const { return !(low.array() <= high.array()).all(); }
  [[nodiscard]] bool contains(const Vector& x) const {
    return (x.array() >= low.array()).all() && (x.array() <= high.array()).all();
  }
  [[nodiscard]] bool meets(const Bounds& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// As std::nextafter(x, infinity), but inlined: boxes are grown by the million.
[[nodiscard]] inline double next_above(double x) {
  if (!(x < std::numeric_limits<double>::infinity())) return x;
  if (x == 0) return std::numeric_limits<double>::denorm_min();
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(x) + (x > 0 ? 1 : -1));
}

/// Grows by `reach` and one more rounding step on either side, so no rounding can lose a pair.
[[nodiscard]] inline Bounds grown(Bounds box, double reach) {
  for (int i = 0; i < 3; ++i) {
    box.low[i] = -next_above(reach - box.low[i]);
    box.high[i] = next_above(box.high[i] + reach);
  }
  return box;
}

/// Called with a segment's position and the positions of nodes that may be near it; concurrently for different
/// segments; possibly several times for one segment, but never twice with the same node. The span dies with the call.
using CandidateSink = std::function<void(std::uint32_t segment, std::span<const std::uint32_t> nodes)>;

/// Finds, for every segment box, all points inside it (closed box, no rounding inward). Boxes are already grown by the
/// contact distance and rounded outward; an empty box or one with NaN gets nothing, and points with NaN are in no box;
/// infinite coordinates are taken as such. Extra candidates are allowed, a missing one is a bug. At most 2³² - 1 points
/// and boxes.
class CandidateSearch {
 public:
  virtual ~CandidateSearch() = default;
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// True for the slow twin, which leaves nothing out whatever it costs.
  [[nodiscard]] virtual bool exhaustive() const { return false; }
  virtual void run(std::span<const Vector> points, std::span<const Bounds> boxes, const CandidateSink& sink) const = 0;
};

/// The ways to search. All find the same pairs; which is fastest depends on the scene (docs/theory/search.md).
enum class SearchKind : std::uint8_t {
  bucket_grid,   ///< hierarchical: surfaces of any size, mixed element sizes, stray parts
  sorted_sweep,  ///< along one axis: few nodes or segments
  box_tree,      ///< of bounding boxes: dense corners of a model too wide for the cells of a grid, large boxes
  brute_force,   ///< every point against every box; the slow, obvious twin
};
inline constexpr std::array all_searches{SearchKind::bucket_grid, SearchKind::sorted_sweep, SearchKind::box_tree,
                                         SearchKind::brute_force};

[[nodiscard]] std::unique_ptr<CandidateSearch> make_bucket_grid();
[[nodiscard]] std::unique_ptr<CandidateSearch> make_sorted_sweep();
[[nodiscard]] std::unique_ptr<CandidateSearch> make_box_tree();
[[nodiscard]] std::unique_ptr<CandidateSearch> make_brute_force();
[[nodiscard]] std::unique_ptr<CandidateSearch> make_search(SearchKind kind);

}  // namespace gapcheck::contact
