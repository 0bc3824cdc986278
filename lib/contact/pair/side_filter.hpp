#pragma once
#include "contact/pair/pair.hpp"
#include "geometry/batch/plane_band.hpp"

namespace gapcheck::contact {

/// Cheap proofs that nodes do not penetrate one oriented segment: most nodes near a solid's face are in front of it, or
/// behind it but beside it, and need no closest point. Built once per segment for many nodes.
/// Derivation: docs/theory/search.md, "Nodes beside a face".
class SideFilter {
 public:
  /// `facet`: that of segment `s`.
  SideFilter(const PairScene& scene, SegmentIndex s, const geometry::Facet& facet)
      : band_(facet, contact_band),
        front_(!scene.flipped.empty() && scene.flipped[s.value] ? -1 : 1),
        behind_(scene.behind(s)) {}
  /// True if decide_pair() says "does not penetrate" of a node at `query`, whose penetration_bound() is `bound`. False
  /// if that is not clear.
  [[nodiscard]] bool apart(const Vector& query, double bound) const;

 private:
  static constexpr double contact_band = 0.5;  ///< the solver's

  geometry::PlaneBand band_;
  double front_;  ///< the sign of heights in front
  double behind_;
};

}  // namespace gapcheck::contact
