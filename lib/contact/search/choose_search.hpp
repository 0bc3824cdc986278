#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "contact/search/search.hpp"

namespace gapcheck::contact {

/// The search that is probably fastest for a scene, from a sample of it; the same on every machine. Reasons and
/// measurements: docs/theory/search.md.
[[nodiscard]] SearchKind choose_search(std::span<const Vector> points, std::span<const Bounds> boxes);

/// The same for a search that is repeated on surfaces that move: the grid, unless its cells are too coarse for them.
[[nodiscard]] SearchKind choose_repeated_search(std::span<const Vector> points, std::span<const Bounds> boxes);
/// Chooses so for every run.
[[nodiscard]] std::unique_ptr<CandidateSearch> make_repeated_search();

/// How often each kind of search has run.
struct SearchTally {
  std::array<std::uint64_t, all_searches.size()> runs{};
  [[nodiscard]] std::uint64_t& of(SearchKind kind) { return runs[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] std::uint64_t of(SearchKind kind) const { return runs[static_cast<std::size_t>(kind)]; }
};

/// A search that chooses again for every run. The tally must outlive it; runs must not overlap.
[[nodiscard]] std::unique_ptr<CandidateSearch> make_chosen_search(SearchTally& tally);

/// A search that always takes the same one, and counts its runs.
[[nodiscard]] std::unique_ptr<CandidateSearch> make_counted_search(SearchKind kind, SearchTally& tally);

}  // namespace gapcheck::contact
