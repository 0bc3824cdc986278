#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/ids.hpp"
#include "base/vector.hpp"

namespace gapcheck {

/// The part of a segment that is closest to a node.
enum class Feature : std::uint8_t { face, edge, corner };

/// What the solver does with a penetrating node (contact rules, section 7).
enum class Outcome : std::uint8_t { moved, kept, forced, released, reported };

/// Which finding a record is; rule_of() in records/record_rules.hpp is the rule.
enum class PenetrationKind : std::uint8_t {
  initial,    ///< GC101: a node in a segment
  released,   ///< GC102: the same, too deep
  edge_zone,  ///< GC106: outside every segment's band
  segment,    ///< GC107: a corner of a segment in another one, SOFT = 2
  mortar,     ///< GC108: the same, mortar contact
  edge,       ///< GC109: two edges or beams
};
inline constexpr std::size_t penetration_kinds = 6;

/// Kinds that LS-DYNA lists, node by node, when it initialises a contact.
[[nodiscard]] constexpr bool listed_by_solver(PenetrationKind kind) {
  return kind == PenetrationKind::initial || kind == PenetrationKind::released;
}

/// The rule that gave a contact thickness (contact rules, section 4).
enum class ThicknessRule : std::uint8_t {
  none,           ///< no thickness: solid facet, SPH node, old type with SHLTHK = 0
  element,        ///< section or *ELEMENT_SHELL_THICKNESS, scaled
  edge_limit,     ///< SSTHK = 0: 0.4 of the shortest edge
  contact_card,   ///< SST, MST (SAST, SBST)
  global,         ///< TH of *CONTROL_CONTACT
  part_contact,   ///< OPTT of *PART_CONTACT
  solid_coating,  ///< SLDTHK
  beam_section,   ///< radius of a beam's section
};

[[nodiscard]] std::string_view name(Feature feature);
[[nodiscard]] std::string_view name(Outcome outcome);
[[nodiscard]] std::string_view name(ThicknessRule rule);

/// One tracked node that is nearer to its closest segment than the contact distance, in one contact; or one tracked
/// edge that is nearer to another edge. Lengths in deck units. The same record whether predicted, computed or read from
/// the solver's files.
struct Penetration {
  /// Position in Report::contacts. Reports on a deck list all contacts of its model: there it is the ContactIndex.
  std::uint32_t contact = 0;
  std::uint32_t segment_number = 0;       ///< position in the contact's reference surface, from 1
  std::int64_t node = 0;                  ///< id of the tracked node; edges: of the end nearest to the other edge
  std::int64_t part = 0;                  ///< id of the node's part; 0: unknown
  std::array<std::int64_t, 4> segment{};  ///< node ids; triangles and edges repeat the last one
  std::int64_t element = 0;               ///< id of the element that the segment belongs to; 0: unknown
  std::int64_t element_part = 0;          ///< id of that element's part; 0: unknown
  double depth = 0;                       ///< penetration, positive
  double contact_distance = 0;            ///< h; the remaining distance is h - depth
  double s = 0, t = 0;  ///< on the segment, -1 to 1; edges: on the other and the tracked one; NaN: unknown
  /// The node before the contact was initialised; edges: the point of the tracked edge that is nearest to the other
  /// one.
  Vector original = Vector::Zero();
  Vector point = Vector::Zero();  ///< closest point of the segment or of the other edge
  /// Where the solver puts the node; outcome `kept`: where it recommends to put it (IGNORE = 2). Otherwise as
  /// `original`.
  Vector moved_to = Vector::Zero();
  std::uint32_t file = 0, line = 0;  ///< of the node; file is a position in Report::files, line 0 = unknown
  PenetrationKind kind = PenetrationKind::initial;
  Outcome outcome = Outcome::reported;
  Feature feature = Feature::face;
  ThicknessRule node_rule = ThicknessRule::none, segment_rule = ThicknessRule::none;
  [[nodiscard]] double remaining() const { return contact_distance - depth; }
  /// `moved_to` is a recommendation.
  [[nodiscard]] bool recommended() const { return outcome == Outcome::kept && moved_to != original; }
};

/// The depth is less than the written coordinates and the mesh can mean: at most 1e-6 of the contact distance, or the
/// rounding of the node's largest coordinate to single precision, which most pre-processors write. It has no effect
/// that a run could show, so it is a note whatever its rule.
[[nodiscard]] bool within_rounding(const Penetration& record);

}  // namespace gapcheck
