#pragma once
#include <cmath>
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
  [[nodiscard]] bool meets(const Bounds& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// Grows by `reach` and one more rounding step on either side, so that no rounding can lose a pair.
[[nodiscard]] inline Bounds grown(Bounds box, double reach) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    box.low[i] = std::nextafter(box.low[i] - reach, -inf);
    box.high[i] = std::nextafter(box.high[i] + reach, inf);
  }
  return box;
}

/// Called with a segment's position and the positions of nodes that may be near it; concurrently for different
/// segments; possibly several times for one segment, but never twice with the same node. The span dies with the call.
using CandidateSink = std::function<void(std::uint32_t segment, std::span<const std::uint32_t> nodes)>;

/// Finds, for every segment box, all points inside it (closed box, no rounding inward). Boxes come already grown by the
/// contact distance and rounded outward; an empty box gets nothing. More candidates than the true ones are allowed, a missing one is a bug.
class CandidateSearch {
 public:
  virtual ~CandidateSearch() = default;
  [[nodiscard]] virtual std::string_view name() const = 0;
  virtual void run(std::span<const Vector> points, std::span<const Bounds> boxes, const CandidateSink& sink) const = 0;
};

/// Hierarchical bucket grid: good for mixed element sizes and stray parts.
[[nodiscard]] std::unique_ptr<CandidateSearch> make_bucket_grid();
/// Every point against every box; the slow, obvious twin.
[[nodiscard]] std::unique_ptr<CandidateSearch> make_brute_force();

}  // namespace gapcheck::contact
