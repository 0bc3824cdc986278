#pragma once
#include "contact/definition/contact_type.hpp"
#include "contact/pair/pair.hpp"
#include "model/model.hpp"

namespace gapcheck::contact {

/// What the release rule needs to know about one pair.
struct ReleasePair {
  bool solid_segment = false;
  double node_thickness = 0;     ///< t of the node
  double segment_thickness = 0;  ///< t of a shell segment in the contact
  double element_thickness = 0;  ///< t of the shell element itself, whether or not the contact counts it
  double solid_depth = 0;        ///< V / A of a solid segment
  double min_diagonal = 0;       ///< shorter diagonal of the segment
};

/// Penetration beyond which the solver releases a node; infinity if it never does. Source: contact rules, section 5.
[[nodiscard]] double release_depth(const model::Contact& contact, const ContactType& type,
                                   const ContactSettings& settings, const model::Controls& controls,
                                   const ReleasePair& pair);

/// What it needs to know about a tracked node and a segment of a scene.
[[nodiscard]] ReleasePair release_pair(const PairScene& scene, SlotIndex slot, SegmentIndex segment);

/// The same for a tracked node and a segment of a scene.
[[nodiscard]] double release_depth(const PairScene& scene, SlotIndex slot, SegmentIndex segment);

}  // namespace gapcheck::contact
