#pragma once
#include <cstdint>
#include <vector>

#include "contact/definition/exclusions.hpp"
#include "contact/pair/pair.hpp"
#include "contact/pair/tied_pairs.hpp"
#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::contact {

/// Why a tracked node and a segment of one contact are never in contact.
enum class PairRule : std::uint8_t {
  counts,     ///< they may
  neighbour,  ///< single surface: a beam or solid of the node touches the shell, or any of its elements another segment
  no_corner,  ///< segment-based: the node is not a corner of a facet
  own_part,   ///< mortar with a negative IGNORE: both belong to one part
  excluded,   ///< *CONTACT_EXCLUDE_INTERACTION
  tied,       ///< the node is tied to the segment's part
};

/// Answers for the pairs of one side's nodes and the other side's segments. All references must outlive it. May be
/// called from any thread while nothing is added to the ties.
class PairRules {
 public:
  PairRules(const PairScene& scene, const ContactSide& tracked, const Exclusions& exclusions, const TiedPairs& ties);
  [[nodiscard]] PairRule operator()(SlotIndex slot, SegmentIndex segment) const;
  /// True for a pair that counts only if the node is in the segment's band: single surface, and shells of both share a
  /// node. Where the sheet is folded they may meet; elsewhere the segment lies beside the node, however thick both are.
  [[nodiscard]] bool only_in_band(SlotIndex slot, SegmentIndex segment) const {
    return single_ && counts_beside_own(segment) && scene_.neighbours.in_ring(node_of(slot), segment);
  }

 private:
  /// Node against shell: a node meets every segment that it does not belong to (contact rules, section 1).
  [[nodiscard]] bool counts_beside_own(SegmentIndex segment) const {
    return scene_.type.pairing == Pairing::nodes && scene_.segments.kind[segment.value] == SegmentKind::shell &&
           !scene_.oriented(segment);
  }
  [[nodiscard]] NodeIndex node_of(SlotIndex slot) const { return scene_.nodes.node[slot.value]; }

  const PairScene& scene_;
  const Exclusions& exclusions_;
  const TiedPairs& ties_;
  bool single_, own_part_;
  std::vector<bool> corners_;  ///< by slot; empty: all count
};

}  // namespace gapcheck::contact
