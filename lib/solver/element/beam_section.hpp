#pragma once
#include <vector>

#include "model/entity/part.hpp"

namespace gapcheck::solver {

/// An integration point of a beam's cross-section: its place along the axes s and t, and the area that it stands for.
struct Fiber {
  double s = 0, t = 0, area = 0;
};

/// The integration points of an integrated beam (ELFORM 1 and 9); of beams that taper those of the middle, with the
/// mean of both ends' lengths. Empty for a rule of *INTEGRATION_BEAM, an arbitrary section or an unknown rule.
///
/// Rectangles: QR 1, one point; 2, 3 and 5: 2 x 2, 3 x 3, 4 x 4 Gauss; 4: 3 x 3 Lobatto. Solid circles and tubes: QR 1,
/// one point; 2: four points on one circle; 3 and 4: four on each of two circles, the inner ones on the axes s and t,
/// the outer ones between; 5: eight on each of two circles. The circles are at Gauss points of the squared radius, so
/// that area and moments of area are exact.
[[nodiscard]] std::vector<Fiber> section_fibers(const model::BeamProfile& profile);

/// Sums over the points: area, ISS = Σ A t², ITT = Σ A s², torsion Σ A (s² + t²) (0 with ITOFF = 1), shear area
/// SHRF Σ A.
[[nodiscard]] model::BeamSection section_constants(const model::BeamProfile& profile, const std::vector<Fiber>& fibers);

}  // namespace gapcheck::solver
