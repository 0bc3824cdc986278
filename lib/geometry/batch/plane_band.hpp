#pragma once
#include "geometry/closest_point.hpp"

namespace gapcheck::geometry {

/// A facet and its mean plane, for many points: how high they are over it, and whether their projection surely lies out
/// of the facet's band, without a closest point. Not usable for facets that are far from flat parallelograms, or thin.
/// Derivation: docs/theory/search.md, "Nodes beside a face".
class PlaneBand {
 public:
  /// `band`: as that of closest_point().
  PlaneBand(const Facet& facet, double band);

  /// Where false, nothing else may be asked.
  [[nodiscard]] bool usable() const { return usable_; }
  /// Height over the mean plane, positive where the facet's corners run counter-clockwise.
  [[nodiscard]] double height(const Vector& query) const { return normal_.dot(query - corner_ - middle_); }
  /// How far the corners lie off the mean plane, above or below.
  [[nodiscard]] double warp() const { return warp_; }
  /// More than rounding takes from heights and distances up to `distance`.
  [[nodiscard]] double error(const Vector& query, double distance) const {
    return margin * (size_ + (query - corner_).cwiseAbs().maxCoeff() + distance);
  }
  /// True if closest_point() says "not in the band". False if that is not clear.
  [[nodiscard]] bool outside(const Vector& query) const;

 private:
  /// Rounding is a thousand times less, relative to the sizes of facet and distance.
  static constexpr double margin = 1e-9;

  void take_quad(const Facet& facet, double end);
  void take_triangle(const Facet& facet, double end);

  bool usable_ = false, triangle_ = false;
  Vector corner_, middle_;  ///< the first corner, and from it to the middle (triangles: zero)
  Vector normal_;           ///< unit
  double warp_ = 0, size_ = 0;
  Vector dual_a_, dual_b_;            ///< products with a vector give its parameters in the mean plane
  double limit_s_ = 0, limit_t_ = 0;  ///< greatest parameters in the band (triangles: least barycentric coordinate) ...
  double slope_s_ = 0, slope_t_ = 0;  ///< ... and how much greater they are per height over a warped facet
};

}  // namespace gapcheck::geometry
