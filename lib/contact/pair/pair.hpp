#pragma once
#include <cstdint>
#include <vector>

#include "contact/definition/contact_type.hpp"
#include "contact/search/nearest_boxes.hpp"
#include "contact/surface/neighbours.hpp"
#include "contact/surface/surface.hpp"
#include "geometry/decide.hpp"

namespace gapcheck::contact {

/// What facets need to know about the solids behind them. Arrays parallel to Segments, or empty if no segment is solid.
struct SolidExtents {
  std::vector<double> depth;        ///< V / A: the thickness that release rules mean
  std::vector<double> extent;       ///< how far the facet's own element reaches behind its plane
  std::vector<std::uint32_t> body;  ///< number of the connected body that the facet bounds
  [[nodiscard]] bool empty() const { return depth.empty(); }
};
/// `bodies`: by node of the mesh, the connected body of solids that has it.
[[nodiscard]] SolidExtents solid_extents(const Segments& segments, const model::Mesh& mesh,
                                         const std::vector<std::uint32_t>& bodies, const std::vector<Vector>& x);

/// V / A of a segment of kind solid: the volume of its element over its own area; 0 where it has no area.
[[nodiscard]] double solid_depth(const Segments& segments, const model::Mesh& mesh, std::size_t segment,
                                 const std::vector<Vector>& x);

/// As a share of a face's shorter diagonal: a node that is so near to the face's plane slides along the face. Blocks
/// that slide with flush sides in a run stay that near.
inline constexpr double flush_in_runs = 0.01;

/// Everything needed to decide one tracked node against one segment; built once per contact and side. All references
/// must outlive it.
struct PairScene {
  const model::Model& model;
  const model::Contact& contact;
  const ContactType& type;
  const ContactSettings& settings;
  const std::vector<Vector>& x;  ///< current coordinates, by node
  const Segments& segments;
  const TrackedNodes& nodes;
  const Neighbours& neighbours;  ///< of the segments
  std::int64_t surface_type;     ///< SURFATYP or SURFBTYP that gave the segments
  SolidExtents solids;           ///< of the segments; empty: no solids
  std::vector<bool> flipped;     ///< by segment: oriented against its node order; empty: none
  double tolerance = -1;         ///< replaces the default tolerance; negative: default
  geometry::Mode mode = geometry::Mode::filtered;
  double flush = flush_in_runs;                ///< how near to a face's plane a node lies in it (InitialOptions)
  double most_pairs = crowd_pairs;             ///< of one search; beyond, only the nearest segments of each node
  const Segments* own = nullptr;               ///< of the tracked nodes' side; null: not known
  const Neighbours* own_neighbours = nullptr;  ///< of these
  /// By segment: how far segments near it look behind themselves (nearby_behind()); empty: reach() leaves that out.
  std::vector<double> nearby = {};

  /// Corners of the reference surface, mid-surface offsets included.
  [[nodiscard]] geometry::Facet facet(SegmentIndex segment) const;
  /// The position of a tracked node in contact: its coordinates, or its mid-surface if that is offset.
  [[nodiscard]] Vector position(SlotIndex slot) const {
    const Vector& at = x[nodes.node[slot.value].value];
    return nodes.shift.empty() ? at : Vector(at + nodes.shift[slot.value]);
  }
  [[nodiscard]] bool line(SegmentIndex s) const { return segments.kind[s.value] == SegmentKind::line; }
  /// Automatic types see both sides of a shell; solid facets and segments of old types have a front.
  [[nodiscard]] bool oriented(SegmentIndex s) const {
    const SegmentKind kind = segments.kind[s.value];
    if (kind == SegmentKind::solid) return true;
    if (type.by_segments()) return false;
    return kind == SegmentKind::shell && (type.family == Family::old || type.family == Family::forming);
  }
  /// A beam axis in a contact that does not search beams: present only for its neighbours.
  [[nodiscard]] bool passive(SegmentIndex s) const { return line(s) && !type.edges; }
  /// How far behind an oriented segment a node still counts: as far as the facet's own solid reaches; for shells half
  /// the segment's shorter diagonal. 0 for two-sided segments.
  [[nodiscard]] double behind(SegmentIndex segment) const;
  /// Largest distance at which a node can penetrate the segment, given the largest half thickness of the nodes; with
  /// `nearby` also the distance at which the segment may be nearer to a node than one that the node is behind.
  [[nodiscard]] double reach(SegmentIndex segment, double largest_node_half) const;
  /// True if the closest point lies on the border of a shell surface that ends there (SHLEDG, SRNDE): on a free edge,
  /// or on a corner of one.
  [[nodiscard]] bool beyond_square_edge(SegmentIndex segment, const geometry::ClosestPoint& closest) const;
  /// True if the segment has a free edge at the node.
  [[nodiscard]] bool ends_at(SegmentIndex segment, NodeIndex node) const;
  /// False if the query lies behind the segment, given its closest point; `slot`: the node there.
  [[nodiscard]] bool in_front(SlotIndex slot, SegmentIndex segment, const geometry::ClosestPoint& closest,
                              const Vector& query) const;
  /// True if a corner or edge of a solid slides along the segment instead of pressing on it: next to nothing lies
  /// between it and the segment (`distance`), or the segment's plane; all segments at the node are faces of solids, and
  /// none of them looks against the segment. At an edge of two flush blocks that tells the side faces, in whose plane
  /// the node lies, from the end face, which it meets.
  [[nodiscard]] bool slides(SlotIndex slot, SegmentIndex segment, double distance) const;
};

/// By segment, how far behind itself any oriented segment looks that is so near that a node behind that one may be
/// nearer to this one; empty: no segment is oriented. On the scene's present coordinates.
[[nodiscard]] std::vector<double> nearby_behind(const PairScene& scene);

/// The shorter diagonal of a facet; for a triangle the shorter of the sides at its third corner.
[[nodiscard]] double min_diagonal(const geometry::Facet& facet);

/// The distance below which a node at `query` penetrates a segment in front of it: contact distance less tolerance. May
/// be negative. `facet`: the segment's.
[[nodiscard]] double penetration_bound(const PairScene& scene, SlotIndex slot, SegmentIndex segment,
                                       const geometry::Facet& facet, const Vector& query);

/// The position of one tracked node relative to one segment.
struct PairResult {
  bool penetrates = false;  ///< p > tolerance; decided exactly
  bool in_band = false;     ///< the projection counts for this segment
  double distance = 0;      ///< from the reference surface, negative behind an oriented segment
  geometry::ClosestPoint closest;
  geometry::Stage stage = geometry::Stage::filter;  ///< which stage decided
};

/// The position of a tracked node relative to a segment, in double precision; `penetrates` is not set.
[[nodiscard]] PairResult measure_pair(const PairScene& scene, SlotIndex slot, SegmentIndex segment);

/// Whether the segment had the node in sight when they were here: in front of it, or at a shell on any side, with a gap
/// less than the segment looks behind itself (shells: less than the contact distance). `facet`, `query`: segment and
/// node in the cycle before the present one.
[[nodiscard]] bool was_followed(const PairScene& scene, SlotIndex slot, SegmentIndex segment,
                                const geometry::Facet& facet, const Vector& query);

/// Unit vector from the segment to its free side at the node, given their relative position.
[[nodiscard]] Vector free_direction(const PairScene& scene, SlotIndex slot, SegmentIndex segment,
                                    const PairResult& pair);

/// Decides tracked node number `slot` against a segment: penetration p = h - distance > tolerance.
/// Source: contact rules, sections 3 and 4.
[[nodiscard]] PairResult decide_pair(const PairScene& scene, SlotIndex slot, SegmentIndex segment);

/// The largest absolute coordinate of a facet and a point.
[[nodiscard]] double largest_coordinate(const geometry::Facet& facet, const Vector& query);

/// Default tolerance of a finding: 1e-9 of the contact distance plus 4 units in the last place of the largest
/// coordinate: decks are written in decimals, and plates that touch must not penetrate.
[[nodiscard]] double default_tolerance(double contact_distance, double largest_coordinate);

}  // namespace gapcheck::contact
