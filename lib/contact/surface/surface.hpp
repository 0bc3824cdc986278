#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "contact/definition/contact_type.hpp"
#include "contact/mesh/mesh_index.hpp"
#include "contact/mesh/node_slots.hpp"
#include "contact/search/search.hpp"
#include "contact/surface/thickness.hpp"
#include "model/model.hpp"

namespace gapcheck::contact {

enum class SegmentKind : std::uint8_t {
  shell,  ///< two-sided in automatic types, oriented in old ones
  solid,  ///< facet of a solid without coating: oriented, material behind it
  line,   ///< beam axis: nodes[0], nodes[1]
};

/// The reference side of a contact: segments with their contact thickness. Arrays of equal length, in the order of the
/// deck (shells, solids, thick shells, beams part by part; sets as written).
struct Segments {
  std::vector<model::SegmentNodes> nodes;
  std::vector<std::uint32_t> element;  ///< position in the array of its kind, or no_position
  std::vector<model::ElementKind> element_kind;
  std::vector<SegmentKind> kind;
  std::vector<double> half;  ///< half the contact thickness
  std::vector<ThicknessRule> rule;
  std::vector<double> offset;  ///< offset of the mid-surface along the normal; empty: none is offset
  [[nodiscard]] std::size_t size() const { return nodes.size(); }
};

/// The tracked side: nodes with their contact thickness. Arrays of equal length, ascending by node.
struct TrackedNodes {
  std::vector<NodeIndex> node;
  std::vector<double> half;
  std::vector<ThicknessRule> rule;
  std::vector<PartIndex> part;  ///< of the element that gave the thickness; none: no element
  std::vector<Vector> shift;    ///< from the node to its mid-surface; empty: none is shifted
  [[nodiscard]] std::size_t size() const { return node.size(); }
};

/// What a side's input names, before thickness: segments in deck order, or only nodes.
struct Selection {
  Segments segments;             ///< half and rule not filled
  std::vector<NodeIndex> nodes;  ///< node sets and particles: nodes without segments; those inside a box, of `cut`
  Segments cut;                  ///< reach out of the box: no reference segments, but their nodes inside have thickness
  std::string empty_reason;      ///< why nothing was found; empty otherwise
  bool unknown_id = false;       ///< it names a set or part that does not exist
  bool later = false;            ///< it is empty at first: particles that failing solids become
  std::string note;              ///< input that is not supported; empty: none
};

/// Resolves one side of a contact. `single_surface`: id 0 means all parts; beams join if the type has them. `index`: of
/// this model, to find small surfaces fast.
[[nodiscard]] Selection select(const model::Model& model, const model::SurfaceInput& input, const ContactType& type,
                               const std::vector<Vector>& x, MeshIndex& index);

/// Contact thickness of every segment of a selection.
void fill_thickness(Segments& segments, const model::Model& model, const ThicknessSide& side,
                    const std::vector<Vector>& x);

/// Mid-surface offsets of the shells (NLOC, *ELEMENT_SHELL_OFFSET): fills `offset` if any shell has one.
void fill_offsets(Segments& segments, const model::Model& model);

/// The nodes of a selection whose segments have their thickness; each takes the largest thickness of its segments,
/// nodes without segments take that of all elements at them.
[[nodiscard]] TrackedNodes tracked_nodes(const Selection& selection, const model::Model& model,
                                         const ThicknessSide& side, const std::vector<Vector>& x, MeshIndex& index);

/// True if the node is a corner of the segment.
[[nodiscard]] inline bool is_corner(const model::SegmentNodes& nodes, NodeIndex node) {
  return nodes[0] == node || nodes[1] == node || nodes[2] == node || nodes[3] == node;
}

/// Numbers the corners of segments.
[[nodiscard]] NodeSlots slots_of(const Segments& segments, std::size_t mesh_nodes);

/// Shortest edge of a segment; infinity if all its corners are one node.
[[nodiscard]] double shortest_edge(const model::SegmentNodes& nodes, const std::vector<Vector>& x);

/// Part of the element of a segment; none if unknown.
[[nodiscard]] PartIndex part_of(const model::Mesh& mesh, const Segments& segments, std::size_t segment);
/// Id of the element of a segment; 0 if unknown.
[[nodiscard]] std::int64_t element_id(const model::Mesh& mesh, const Segments& segments, std::size_t segment);

}  // namespace gapcheck::contact
