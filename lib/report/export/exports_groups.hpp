#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/export/exports.hpp"

namespace gapcheck::report {

/// The records of one contact and one warning type: pen, below (released), edge, or the word of a tie's reason. Lives
/// as long as the report.
struct ExportGroup {
  std::string name;                              ///< "id3 pen"
  std::string title;                             ///< "id3 pen: Global contact", at most 70 bytes, no control characters
  std::vector<const Penetration*> penetrations;  ///< in the report's order
  std::vector<std::int64_t> nodes;               ///< tracked ones, ascending, each once
};

/// Groups that have records, in the order of the report's contacts, then by type.
[[nodiscard]] std::vector<ExportGroup> export_groups(const Report& report);

/// A line from the tracked node to the contact surface, as long as the penetration.
struct PenetrationLine {
  Vector node, surface;
};

/// Position of the tracked node: from the record, or from `position`.
[[nodiscard]] std::optional<Vector> node_of(const Report& report, const Penetration& record,
                                            const NodePosition& position);

/// Nothing if the position, the direction or the depth is not known. The direction is that in which the solver moved
/// the node; otherwise away from the closest point (towards it if the node is behind the segment); otherwise, where the
/// node is on the segment, the segment's normal.
[[nodiscard]] std::optional<PenetrationLine> penetration_line(const Report& report, const Penetration& record,
                                                              const NodePosition& position);

/// Ids on one card of *SET_NODE_LIST.
inline constexpr std::size_t ids_per_card = 8;

/// Above every id of nodes, elements, segments, parts and contacts in the report; ids of more than 18 digits, which no
/// deck has, are ignored.
[[nodiscard]] std::int64_t first_free_id(const Report& report);

}  // namespace gapcheck::report
