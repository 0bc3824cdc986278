#pragma once
#include <cstdint>
#include <optional>

#include "contact/surface/contact_surfaces.hpp"
#include "records/penetration.hpp"

namespace gapcheck::contact {

/// Where a record's node and segment stand in the surfaces of its contact.
struct RecordPair {
  bool node_on_b = false, segment_on_b = false;  ///< the sides that they are on; single-surface contacts: A both
  std::uint32_t slot = 0;                        ///< in TrackedNodes
  std::uint32_t segment = 0;                     ///< in Segments
};

/// Finds a record in surfaces of the same contact, whatever their thickness. Nothing if it is not of these surfaces.
[[nodiscard]] std::optional<RecordPair> find_pair(const ContactSurfaces& surfaces, const model::Mesh& mesh,
                                                  const Penetration& record);

}  // namespace gapcheck::contact
