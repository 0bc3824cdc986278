#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "contact/contact_surfaces.hpp"
#include "contact/contact_type.hpp"
#include "contact/search.hpp"
#include "contact/surface.hpp"
#include "records/tie_failure.hpp"

namespace gapcheck::contact {

/// Distance within which a node ties to a segment (contact rules, section 9): shells max(0.6 (ts + tm), 0.05 of the
/// shorter diagonal), solids the latter; with negative SST or MST 0.6 (|SST| + |MST|) alone.
[[nodiscard]] double tie_distance(double node_thickness, double segment_thickness, double min_diagonal,
                                  bool solid_segment, bool negative_thickness);

/// Types that tie by constraint equations: 2, 6, 7 and their c forms. They take no rigid bodies and no node that is
/// constrained already.
[[nodiscard]] bool ties_by_constraint(const ContactType& type);

/// Nodes that a rigid body moves: those of rigid parts, nodal rigid bodies and extra nodes. By node of the mesh.
[[nodiscard]] std::vector<bool> rigid_nodes(const model::Model& model);

/// Which nodes are tied to which parts by the tied contacts seen so far.
class Ties {
 public:
  void add(NodeIndex node, PartIndex part, bool constraint);
  [[nodiscard]] bool tied(NodeIndex node, PartIndex part) const;
  /// Tied by a constraint: no other constraint can take the node.
  [[nodiscard]] bool constrained(NodeIndex node) const;
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }

 private:
  struct Tied {
    std::vector<PartIndex> parts;
    bool constraint = false;
  };
  std::unordered_map<std::uint32_t, Tied> nodes_;
};

/// What one tied contact did.
struct TieResult {
  std::uint64_t nodes = 0, segments = 0;
  std::uint64_t tied = 0, moved = 0;
  std::uint64_t judged = 0;  ///< nodes meant to tie: all of a node set; of other surfaces those within twice the distance
  std::vector<TieFailure> untied;  ///< judged nodes that did not tie, by node; `contact`, `file` and `line` not filled
  double largest_separation = 0;   ///< of the tied ones
};

/// Ties the nodes of one tied contact that lie within the tie distance of a segment, to the closest one (a node keeps
/// what earlier contacts did to it), and says why the others that were meant to tie did not. Types 2, 6 and 7 also move
/// the node onto the segment in `x`.
TieResult apply_ties(const model::Model& model, const model::Contact& contact, const ContactSurfaces& surfaces,
                     const CandidateSearch& search, std::vector<Vector>& x, Ties& ties);

}  // namespace gapcheck::contact
