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
  neighbour,  ///< single surface: an element of the node touches the segment
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

 private:
  const PairScene& scene_;
  const Exclusions& exclusions_;
  const TiedPairs& ties_;
  bool single_, own_part_;
  std::vector<bool> corners_;  ///< by slot; empty: all count
};

}  // namespace gapcheck::contact
