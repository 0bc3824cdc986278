#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "contact/search/search.hpp"

namespace gapcheck::contact {

/// Of how many pairs a search may consist, and how many each point may have on average, before it is crowded. Contacts
/// whose thickness suits their mesh have some tens. A deck is searched once, so it may have more than each search of a
/// run.
inline constexpr double crowd_pairs = 2e6, crowd_pairs_of_decks = 2e7, crowd_pairs_each = 400;

/// To how many of the boxes that contain it a point of a crowded search is compared: the nearest ones.
inline constexpr std::uint32_t most_candidates = 100;

/// True if the points lie in so many boxes that not all pairs can be decided: more than `most`, and more than
/// `crowd_pairs_each` for each point, as counted on a sample of both. A thickness in the wrong unit does that, or
/// thousands of nodes in one point.
[[nodiscard]] bool crowded(std::span<const Vector> points, std::span<const Bounds> boxes, double most = crowd_pairs);

/// The same for boxes that meet each other, more than `crowd_pairs`.
[[nodiscard]] bool crowded(std::span<const Bounds> boxes);

/// What a CandidateSearch finds, but for each point only `most_candidates` boxes: those whose `cores` are nearest to
/// it. Of equally near ones some; the same at each call. `cores`: beside the boxes and inside them.
void run_nearest(std::span<const Vector> points, std::span<const Bounds> boxes, std::span<const Bounds> cores,
                 const CandidateSink& sink);

/// Called with two positions in one list, once per pair, the lower one first; concurrently.
using NearPairVisit = std::function<void(std::uint32_t a, std::uint32_t b)>;

/// Pairs of boxes that meet, but for each box only those with the `each` others whose centres are nearest to its own.
void for_each_near_box_pair(std::span<const Bounds> boxes, std::uint32_t each, const NearPairVisit& visit);

}  // namespace gapcheck::contact
