#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "contact/crossings.hpp"

namespace gapcheck::contact {

/// Two lines that cross each other between their ends: shell edges or beam axes.
struct EdgeCrossing {
  CrossingSegment a, b;         ///< the elements that they belong to
  std::array<NodeIndex, 2> edge_a, edge_b;
  Vector point = Vector::Zero();
};

/// True for contacts that hold edges against edges: types 26, and SOFT = 2 with a DEPTH that ends in 5.
/// Source: LS-DYNA Keyword User's Manual, Vol. I, *CONTACT card A, as commonly quoted.
[[nodiscard]] bool looks_at_edges(const model::Contact& contact, const ContactType& type);

/// All pairs of lines of one contact that cross, to within crossing_tolerance of the mean of their lengths: free shell
/// edges (type i26: all), in types 26 beam axes. Lines around one element, and pairs that CrossingPairs leaves out, do
/// not count. In the order of the surface. `contact`: position in Model::contacts.
[[nodiscard]] std::vector<EdgeCrossing> find_crossed_edges(const model::Model& model, std::uint32_t contact,
                                                           const ContactSurfaces& surfaces,
                                                           const CrossingOptions& options, CrossingCounters& counters);

}  // namespace gapcheck::contact
