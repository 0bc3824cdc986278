#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "contact/search/search.hpp"

namespace gapcheck::contact {

/// Called with a position in the first list and one in the second; concurrently, in no order, once per pair.
using BoxPairVisit = std::function<void(std::uint32_t a, std::uint32_t b)>;

/// How pairs of boxes are found; both give the same pairs.
enum class BoxSearch : std::uint8_t {
  tree,         ///< boxes in leaves along a space-filling curve, a tree of bounds above them
  brute_force,  ///< every box against every other; the slow, obvious twin
};

/// Visits every pair of a box of `a` and a box of `b` that have a point in common: closed boxes, decided exactly. Empty
/// boxes and those with NaN meet nothing. Sorting is O(n log n); the rest is proportional to the pairs of boxes that
/// nearly meet. Callers that grow boxes by a distance must round them outward first.
void for_each_box_pair(std::span<const Bounds> a, std::span<const Bounds> b, const BoxPairVisit& visit,
                       BoxSearch search = BoxSearch::tree);

/// The same for the boxes of one list against each other: every pair once, with a < b, and none with itself.
void for_each_box_pair(std::span<const Bounds> boxes, const BoxPairVisit& visit, BoxSearch search = BoxSearch::tree);

}  // namespace gapcheck::contact
