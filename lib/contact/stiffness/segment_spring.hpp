#pragma once
#include <cstdint>
#include <vector>

#include "contact/stiffness/element_sizes.hpp"
#include "contact/surface/surface.hpp"
#include "model/model.hpp"

namespace gapcheck::contact {

/// Stiffness that a segment gives a contact spring (SOFT = 0), and the weight with which it counts at each of its
/// corners.
struct SegmentSpring {
  double stiffness = 0;
  /// Area / number of corners; 0: the segment gives no stiffness. Of the printed step: area / 4, at the four listed
  /// corners, so that a triangle counts twice at its third node.
  double weight = 0;
};

/// The input for the stiffness of all segments of a model. Model and sizes must outlive it.
class SegmentSprings {
 public:
  SegmentSprings(const model::Model& model, const ElementSizes& sizes);
  /// `scale`: SLSFAC · SFS (or SFM); SSF of *PART_CONTACT goes on top. `printed`: K A / max(t, shorter diagonal) for
  /// shells, as in the solver's printed time step, instead of K A / longest diagonal. `solid_modulus`: SLDSTF, replaces
  /// the modulus of solids where it is positive. A beam counts as a shell strip as wide as its section is thick, which
  /// the printed estimate leaves out. Source: contact rules, sections 6.1 and 12.3; for beams our own choice.
  [[nodiscard]] SegmentSpring operator()(const Segments& segments, std::size_t segment, double scale,
                                         bool printed = false, double solid_modulus = 0) const;

 private:
  [[nodiscard]] SegmentSpring beam(const model::SegmentNodes& nodes, PartIndex part, double scale) const;
  const model::Model& model_;
  const ElementSizes& sizes_;
  std::vector<double> moduli_;  // by part, SSF included
};

/// Number of different nodes of a segment: 4, of a triangle 3, of a line 2.
[[nodiscard]] inline std::size_t corner_count(const model::SegmentNodes& n) {
  return n[2] != n[3] ? 4 : n[1] != n[2] ? 3 : 2;
}

}  // namespace gapcheck::contact
