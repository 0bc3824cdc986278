#pragma once
#include <cstdint>
#include <vector>

#include "contact/pair/closest_segment.hpp"
#include "contact/pair/pair.hpp"
#include "contact/search/search.hpp"

namespace gapcheck::contact {

/// Distance within which a node ties to a segment (contact rules, section 9.1): shells max(0.6 (ts + tm), 0.05 of
/// the shorter diagonal), solids the latter; with negative SST or MST only 0.6 (|SST| + |MST|).
[[nodiscard]] double tie_distance(double node_thickness, double segment_thickness, double min_diagonal,
                                  bool solid_segment, bool negative_thickness);

/// Share of the thickness sum within which a node ties (contact rules, section 9.1).
inline constexpr double tie_thickness_share = 0.6;

/// The segment that a tracked node ties to, or comes nearest to tying to.
struct TieCandidate {
  SegmentIndex segment = none<SegmentIndex>;  ///< none: none is near
  bool on_segment = false;                    ///< the projection falls in the segment, PARMAX included
  bool ties = false;                          ///< and the distance is within the tie distance; decided exactly
  double distance = 0;                        ///< from the closest point of the segment
  double diagonal = 0;                        ///< the segment's shorter one
};

/// How the nodes of one tied contact search for their segments.
struct TieSearch {
  double parmax = 1.035;  ///< how far the projection may lie beyond the segment's edges, in parameters; at least 1
  bool negative = false;  ///< SST or MST is negative: thickness alone counts
  bool node_set = false;  ///< all nodes are meant to tie: search up to a segment's diagonal away
  bool single = false;    ///< one surface against itself: elements next to the node's own are left out
};

/// For every tracked node its candidate: first segments that tie, then those that hold the projection, then the rest,
/// each time the nearest; of segments equally near (to 1e-9 of the tie distance) the first. Nodes that no node set
/// names are searched within twice the tie distance. Segments do not tie their own corners. d <= tie distance is
/// decided exactly, with the default tolerance of penetrations on top of the tie distance: decks are written in
/// decimals, and a node exactly at the distance ties.
[[nodiscard]] std::vector<TieCandidate> tie_candidates(const PairScene& scene, const CandidateSearch& search,
                                                       const TieSearch& how, SweepCounters& counters,
                                                       geometry::DecisionCounters& decisions);

}  // namespace gapcheck::contact
