#pragma once
#include <string>
#include <vector>

#include "geometry/closest_point.hpp"

namespace gapcheck::bench {

/// "Is the facet nearer to the query than the bound?"
struct DecisionPair {
  geometry::Facet facet;
  Vector query = Vector::Zero();
  double bound = 0;
};

struct PairSet {
  std::string name;
  std::vector<DecisionPair> pairs;
};

/// All pairs that the search for initial penetrations hands to its decisions, in the order of the segments, with their
/// bounds: contact distance less tolerance, or its amount for facets of solids. Without beam axes. Empty if the deck
/// cannot be read. `margin` widens the search by that many shorter diagonals of each segment, as a search does whose
/// result is to serve for more than one time step.
[[nodiscard]] PairSet pairs_of_deck(const std::string& path, double margin);

/// The families of the tests, `count` pairs each, with bounds from half to twice the distance, and the families of the
/// cases that are hard: bounds next to the distance to the last bit, nodes on the facet, slivers, large offsets.
[[nodiscard]] std::vector<PairSet> pairs_of_families(std::size_t count);

}  // namespace gapcheck::bench
