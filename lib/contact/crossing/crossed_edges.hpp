#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "contact/crossing/crossings.hpp"
#include "contact/edge/edge_scene.hpp"

namespace gapcheck::contact {

/// Two lines that cross each other between their ends: shell edges or beam axes.
struct EdgeCrossing {
  CrossingSegment a, b;  ///< the elements that they belong to
  std::array<NodeIndex, 2> edge_a, edge_b;
  Vector point = Vector::Zero();
};

/// Lines nearer to each other than this fraction of their mean length cross: decks are written in decimals.
inline constexpr double crossed_edge_tolerance = 1e-5;

/// All pairs of lines of one contact that cross, to within crossed_edge_tolerance: free shell edges (type i26: all), in
/// types 26 beam axes. Lines around one element, and pairs that CrossingPairs leaves out, do not count. In the order of
/// the surface.
[[nodiscard]] std::vector<EdgeCrossing> find_crossed_edges(const model::Model& model, ContactIndex contact,
                                                           const ContactSurfaces& surfaces,
                                                           const CrossingOptions& options, CrossingCounters& counters);

/// The same as penetrations of edges at their contact distance: what they lack until they are clear of each other. One
/// for each node that is the nearest end of a crossed edge.
[[nodiscard]] std::vector<Penetration> crossed_edge_records(const model::Model& model, ContactIndex contact,
                                                            const ContactSurfaces& surfaces,
                                                            const CrossingOptions& options, CrossingCounters& counters);

}  // namespace gapcheck::contact
