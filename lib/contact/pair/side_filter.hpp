#pragma once
#include "contact/pair/pair.hpp"

namespace gapcheck::contact {

/// Cheap proofs that nodes do not penetrate one oriented segment: most nodes near a solid's face are in front of it, or
/// behind it but beside it, and need no closest point. Built once per segment for many nodes. Proves nothing for facets
/// that are far from flat parallelograms, or thin. Derivation: docs/theory/search.md, "Nodes beside a face".
class SideFilter {
 public:
  /// `facet`: that of segment `s`.
  SideFilter(const PairScene& scene, SegmentIndex s, const geometry::Facet& facet);
  /// True if decide_pair() says "does not penetrate" of a node at `query`, whose penetration_bound() is `bound`. False
  /// if that is not clear.
  [[nodiscard]] bool apart(const Vector& query, double bound) const;

 private:
  void take_quad(const geometry::Facet& facet);
  void take_triangle(const geometry::Facet& facet);
  [[nodiscard]] bool beside(const Vector& from_corner) const;

  bool usable_ = false, triangle_ = false;
  double behind_ = 0;
  Vector corner_, middle_;            ///< the first corner, and from it to the middle (triangles: zero)
  Vector normal_;                     ///< unit, to the front
  double warp_ = 0;                   ///< how far the corners lie off the mean plane
  Vector dual_a_, dual_b_;            ///< products with a vector give its parameters in the mean plane
  double limit_s_ = 0, limit_t_ = 0;  ///< greatest parameters of nodes in the band ...
  double slope_s_ = 0, slope_t_ = 0;  ///< ... and how much greater they are per height over a warped facet
  double size_ = 0;                   ///< of the facet
};

}  // namespace gapcheck::contact
