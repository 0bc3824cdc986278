#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/closest_point.hpp"
#include "methods.hpp"

namespace gapcheck::bench {

/// What is true of a pair.
struct Truth {
  long double distance = 0;  ///< to 64 bits
  double size = 0;           ///< longest side of the facet
  bool closer = false;       ///< distance < bound, decided in exact numbers
};

/// Pairs of one kind and what is true of them.
struct PairFamily {
  std::string name, group;
  Pairs pairs;
  std::vector<Truth> truth;
  std::uint64_t triangulated = 0;   ///< of the exact decisions: those on a triangulation
  std::uint64_t disagreements = 0;  ///< pairs on which exact decision and reference differ: must be none
  double exact_seconds = 0;         ///< what the exact decisions took
};

/// Groups of families, as they are shown together.
inline constexpr const char* groups[] = {"warp", "border", "shape", "scale", "decks"};

/// Families made by fixed seeds, `count` pairs each.
[[nodiscard]] std::vector<PairFamily> made_families(std::size_t count);

/// Adds a pair with a given contact distance; computes what is true of it.
void add_pair(PairFamily& family, const geometry::Facet& facet, const Vector& query, double bound);

/// The pairs of nodes and segments that the contacts of the decks in a folder may look at: the node lies in the box of
/// the segment, grown by twice the contact distance. Decks that cannot be read are left out; `decks` counts the others.
[[nodiscard]] PairFamily deck_family(const std::string& folder, int& decks);

}  // namespace gapcheck::bench
