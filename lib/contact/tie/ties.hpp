#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"
#include "contact/definition/contact_type.hpp"
#include "contact/mesh/rigid_nodes.hpp"
#include "contact/search/search.hpp"
#include "contact/surface/surface.hpp"
#include "contact/tie/tie_candidates.hpp"
#include "contact/pair/tied_pairs.hpp"
#include "records/tie_failure.hpp"

namespace gapcheck::contact {

/// Types that tie by constraint equations: 2, 6, 7 and their c forms. They take no rigid bodies and no node that is
/// constrained already.
[[nodiscard]] bool ties_by_constraint(const ContactType& type);

/// Types that move a tied node onto its segment: 2, 6 and 7 without any offset form.
[[nodiscard]] bool moves_tied_nodes(const ContactType& type);

/// Types that tie translations alone and ignore the moments of an offset: 2, 6 and their o forms. The b and c forms
/// carry moments over the offset; 7 and its forms tie rotations.
[[nodiscard]] bool leaves_rotations_free(const ContactType& type);

/// A tied node is said to be separated from here on, in shorter diagonals of its segment. Below lies what mesh
/// generators and decimals leave.
inline constexpr double visible_separation = 0.01;

/// A tied node is not moved where a beam that ends there would keep less than this share of its length. What the solver
/// takes is not published: half is where a beam between two sheets starts to belong to one of them.
inline constexpr double shortest_beam = 0.5;

/// What became of one node that was meant to tie.
struct JudgedNode {
  std::uint32_t contact = 0;  ///< position in Model::contacts
  NodeIndex node;
  PartIndex part = none<PartIndex>;  ///< of the element that gave the node's thickness; none: no element
  std::uint32_t segment = TieCandidate::no_segment;  ///< of the reference side; no_segment: its projection is on none
  PartIndex segment_part = none<PartIndex>;
  std::optional<TieReason> reason;  ///< none: tied without a visible separation
  bool by_node_set = false;         ///< a node set names it: surely meant to tie
  bool penalty = false;             ///< IPBACK ties it by penalty, since a constraint cannot
  RigidOwner rigid;                 ///< rigslav, rigmast: who moves the node or the segment
  std::uint32_t holder = 0;         ///< conflict: position of the contact that has the node
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
  std::uint64_t out_of_reach = 0;  ///< nodes that no node set names, beyond twice the tie distance: not judged
  std::vector<JudgedNode> judged;  ///< ascending by node; of single surfaces the tied ones alone
};

/// What ties of one model need beside the contact itself.
struct TieScene {
  const model::Model& model;
  const CandidateSearch& search;
  geometry::Mode mode = geometry::Mode::filtered;
  SweepCounters& sweep;
  geometry::DecisionCounters& decisions;
};

/// Ties the nodes of one tied contact (position in Model::contacts) that lie within the tie distance of a segment, to
/// the closest one (a node keeps what earlier contacts did to it), and says why the others that were meant to tie did
/// not. Types 2, 6 and 7 also move the node onto the segment in `x`. Nodes of the reference surface itself are not
/// judged: the mesh joins them already. Source: contact rules, section 9.
[[nodiscard]] TieResult apply_ties(const TieScene& scene, std::uint32_t contact, const ContactSurfaces& surfaces,
                                   std::vector<Vector>& x, TiedPairs& ties);

}  // namespace gapcheck::contact
