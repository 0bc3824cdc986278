#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace gapcheck::api {

/// Which finding a penetration is.
enum class PenetrationKind : std::uint8_t {
  initial,    ///< GC101: a node in a segment
  released,   ///< GC102: the same, so deep that the solver releases the node
  edge_zone,  ///< GC106: near an edge or a corner, outside every segment's band
  segment,    ///< GC107: a corner of a segment in another one, SOFT = 2
  mortar,     ///< GC108: the same, mortar contact
  edge,       ///< GC109: two edges or beams
};

/// What the solver does with a penetrating node at the start.
enum class Outcome : std::uint8_t { moved, kept, forced, released, reported };

/// The part of a segment that is closest to a node.
enum class Feature : std::uint8_t { face, edge, corner };

/// The input that gave a contact thickness.
enum class ThicknessRule : std::uint8_t {
  none,           ///< no thickness, or unknown
  element,        ///< section or *ELEMENT_SHELL_THICKNESS, scaled
  edge_limit,     ///< 0.4 of the shortest edge
  contact_card,   ///< SST, MST
  global,         ///< TH of *CONTROL_CONTACT
  part_contact,   ///< OPTT of *PART_CONTACT
  solid_coating,  ///< SLDTHK
  beam_section,   ///< radius of a beam's section
};

/// Why a node of a tied contact needs attention.
enum class TieReason : std::uint8_t {
  sep,        ///< moved onto the segment: GC204
  offset,     ///< tied with a distance: GC202
  too_far,    ///< from here on untied: GC201
  too_short,  ///< tying would shorten a connected beam
  not_found,  ///< on no segment
  rigslav,    ///< the node is rigid
  rigmast,    ///< a node of the segment is rigid
  conflict,   ///< another definition constrains the node already
};

/// Words as in the reports: "edge", "moved", "contact-card", "notfound".
[[nodiscard]] std::string_view name(Outcome outcome);
[[nodiscard]] std::string_view name(Feature feature);
[[nodiscard]] std::string_view name(ThicknessRule rule);
[[nodiscard]] std::string_view name(TieReason reason);
/// "GC101".
[[nodiscard]] std::string_view rule_id(PenetrationKind kind);
[[nodiscard]] std::string_view rule_id(TieReason reason);
/// True for the reasons that leave the node untied.
[[nodiscard]] bool untied(TieReason reason);

/// n penetrations as parallel arrays: entry i of each belongs to penetration i; arrays of n × k are row by row, one row
/// per penetration. Lengths in the deck's unit, positions in its coordinates. A record read from a solver's file has
/// zeros for what the file does not give, and NaN for `local`. The views live as long as the report.
struct Penetrations {
  [[nodiscard]] std::size_t size() const { return node.size(); }

  std::span<const PenetrationKind> kind;          ///< n
  std::span<const std::uint32_t> contact;         ///< n, positions in Report::contacts
  std::span<const std::int64_t> node;             ///< n ids; edges: of the end nearest to the other edge
  std::span<const std::int64_t> part;             ///< n ids, of the node; 0: unknown
  std::span<const std::int64_t> segment;          ///< n × 4 node ids; triangles and edges repeat the last one
  std::span<const std::uint32_t> segment_number;  ///< n, in the contact's reference surface, from 1
  std::span<const std::int64_t> element;          ///< n ids, of the segment's element; 0: unknown
  std::span<const std::int64_t> element_part;     ///< n ids; 0: unknown
  std::span<const double> depth;                  ///< n, the penetration, positive
  std::span<const double> contact_distance;       ///< n; contact_distance - depth is the remaining distance
  std::span<const double> local;                  ///< n × 2: s and t of the closest point on the segment, -1 to 1
  std::span<const double> position;               ///< n × 3: the node before the contact was initialised
  std::span<const double> closest;                ///< n × 3: the closest point of the segment or of the other edge
  std::span<const double> moved_to;  ///< n × 3: where the solver puts the node, or recommends to (outcome kept, IGNORE
                                     ///< = 2); else `position`
  std::span<const Outcome> outcome;  ///< n
  std::span<const Feature> feature;  ///< n
  std::span<const ThicknessRule> node_rule;     ///< n: where the node's share of the contact distance comes from
  std::span<const ThicknessRule> segment_rule;  ///< n: the same of the segment
  std::span<const std::uint32_t> file;          ///< n, positions in Report::files, of the node
  std::span<const std::uint32_t> line;          ///< n, from 1; 0: unknown
};

/// n nodes of tied contacts that did not tie, or tied with a distance, as parallel arrays like Penetrations.
struct Ties {
  [[nodiscard]] std::size_t size() const { return node.size(); }

  std::span<const TieReason> reason;              ///< n
  std::span<const std::uint32_t> contact;         ///< n, positions in Report::contacts
  std::span<const std::int64_t> node;             ///< n ids
  std::span<const std::int64_t> part;             ///< n ids; 0: unknown
  std::span<const std::uint32_t> segment_number;  ///< n, from 1; 0: unknown
  std::span<const double> distance;               ///< n, from the segment; negative: unknown
  std::span<const double> allowed;                ///< n, within which the node would tie; negative: unknown
  std::span<const double> position;               ///< n × 3, of the node in the deck; NaN: unknown
  std::span<const std::uint8_t> by_node_set;      ///< n, 1: a node set names the node, so it is surely meant to tie
  std::span<const std::uint32_t> file;            ///< n, positions in Report::files
  std::span<const std::uint32_t> line;            ///< n, from 1; 0: unknown
};

}  // namespace gapcheck::api
