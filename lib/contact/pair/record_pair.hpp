#pragma once
#include <cstdint>
#include <optional>

#include "contact/surface/contact_surfaces.hpp"
#include "records/penetration.hpp"

namespace gapcheck::contact {

/// The positions of a record's node and segment in the surfaces of its contact.
struct RecordPair {
  bool node_on_b = false, segment_on_b = false;  ///< the sides that they are on; single-surface contacts: A both
  SlotIndex slot;
  SegmentIndex segment;
};

/// Finds a record in surfaces of the same contact, whatever their thickness. Nothing if it does not belong to these
/// surfaces.
[[nodiscard]] std::optional<RecordPair> find_pair(const ContactSurfaces& surfaces, const model::Mesh& mesh,
                                                  const Penetration& record);

}  // namespace gapcheck::contact
