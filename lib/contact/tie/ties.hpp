#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/definition/contact_type.hpp"
#include "contact/mesh/rigid_nodes.hpp"
#include "contact/pair/tied_pairs.hpp"
#include "contact/search/search.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "contact/surface/surface.hpp"
#include "contact/tie/tie_candidates.hpp"
#include "records/tie_failure.hpp"

namespace gapcheck::contact {

/// Distance from which a tied node counts as separated, in shorter diagonals of its segment. Smaller distances come
/// from mesh generators and rounding.
inline constexpr double visible_separation = 0.01;

/// A tied node is not moved where a beam that ends there would keep less than this share of its length. The solver's
/// limit is not published: half is where a beam between two sheets starts to belong to one of them.
inline constexpr double shortest_beam = 0.5;

/// What happened to one node that was meant to tie.
struct JudgedNode {
  ContactIndex contact;
  NodeIndex node;
  PartIndex part = none<PartIndex>;           ///< of the element that gave the node's thickness; none: no element
  SegmentIndex segment = none<SegmentIndex>;  ///< of the reference side; none: its projection is on none
  PartIndex segment_part = none<PartIndex>;
  std::optional<TieReason> reason;  ///< none: tied without a visible separation
  bool by_node_set = false;         ///< a node set names it: surely meant to tie
  bool penalty = false;             ///< IPBACK ties it by penalty, since a constraint cannot
  RigidOwner rigid;                 ///< rigslav, rigmast: who moves the node or the segment
  ContactIndex holder;              ///< conflict: the contact that has the node
  double distance = -1;             ///< from the segment; negative: on none
  double allowed = 0;               ///< tie distance
  double node_thickness = 0, segment_thickness = 0;
  double diagonal = 0;  ///< the segment's shorter one
  [[nodiscard]] bool tied() const { return !reason || !untied(*reason); }
};

/// What one tied contact did.
struct TieResult {
  std::uint64_t nodes = 0, segments = 0;
  std::uint64_t tied = 0, moved = 0;
  std::vector<NodeIndex> out_of_reach;  ///< nodes that no node set names, beyond twice the tie distance: not judged
  std::vector<JudgedNode> judged;       ///< ascending by node; of single surfaces only the tied ones
};

/// What the ties of one model need besides the contact itself.
struct TieScene {
  const model::Model& model;
  const CandidateSearch& search;
  geometry::Mode mode = geometry::Mode::filtered;
  SweepCounters& sweep;
  geometry::DecisionCounters& decisions;
};

/// Ties the nodes of one tied contact that lie within the tie distance of a segment, to
/// the closest one (a node keeps what earlier contacts did to it), and says why the others that were meant to tie did
/// not. Types 2, 6 and 7 also move the node onto the segment in `x`. Nodes of the reference surface itself are not
/// judged: the mesh joins them already. Source: contact rules, section 9.
[[nodiscard]] TieResult apply_ties(const TieScene& scene, ContactIndex contact, const ContactSurfaces& surfaces,
                                   std::vector<Vector>& x, TiedPairs& ties);

}  // namespace gapcheck::contact
