#pragma once
#include <cstdint>

#include "geometry/patch.hpp"

namespace gapcheck::geometry {

/// What is known about "the facet is nearer to the origin than the bound".
enum class Verdict : std::uint8_t {
  closer,  ///< proven
  apart,   ///< proven not
  open,    ///< a smaller piece of the facet may tell more
  tied,    ///< a point of the facet lies at the bound up to rounding: only exact numbers can tell
};

/// Is some coordinate of all corners beyond the bound? Exact for corners rounded once.
[[nodiscard]] inline bool separated_by_axis(const Corners& e, double bound) {
  const Vector low = e[0].cwiseMin(e[1]).cwiseMin(e[2].cwiseMin(e[3]));
  const Vector high = e[0].cwiseMax(e[1]).cwiseMax(e[2].cwiseMax(e[3]));
  return low.maxCoeff() > bound || high.minCoeff() < -bound;
}

/// Floating-point proofs about one facet or piece of a facet with the origin as the query. All of them hold for corners
/// known to within 16 roundoffs of `size`, which bounds every coordinate and must be usable() (view.hpp). Derivation:
/// docs/theory/decisions.md.
class Certificate {
 public:
  Certificate(double size, double bound) : size_(size), bound_(bound), slack_(64 * roundoff * size) {}

  /// A cheap proof that the corners' hull is apart: the mean plane separates it.
  [[nodiscard]] bool separated_by_mean_plane(const Corners& e) const;
  /// What the point at (s, t) proves: the point itself, the plane through it, and on quads largest_drop().
  [[nodiscard]] Verdict at(const Corners& e, double s, double t, bool triangle) const;

  [[nodiscard]] double size() const { return size_; }

 private:
  [[nodiscard]] bool separated_by(const Corners& e, const Vector& direction) const;
  double size_, bound_, slack_;
};

/// Upper bound of how much smaller the squared distance gets anywhere on the patch than at (s, t), where the patch's
/// point is w. Infinity if there is no such bound. Rounding is accounted for; `slope_error` bounds that of the products
/// of w with the patch's derivatives.
[[nodiscard]] double largest_drop(const Patch& patch, double s, double t, const Vector& w, double size,
                                  double slope_error);
[[nodiscard]] inline double largest_drop(const Patch& patch, double s, double t, const Vector& w, double size) {
  return largest_drop(patch, s, t, w, size, 512 * roundoff * size * size);
}

/// True if (s, t) is the nearest point of the patch up to rounding; false if that is not clear.
[[nodiscard]] bool is_nearest(const Corners& e, const Patch& patch, double s, double t);

}  // namespace gapcheck::geometry
