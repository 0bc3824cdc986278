#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "audit/repair/repair_trial.hpp"
#include "base/diagnostic.hpp"
#include "base/result.hpp"
#include "keyword/deck.hpp"
#include "records/repair_plan.hpp"

namespace gapcheck::audit {

/// Most pairs of parts whose repairs are tried: for each of them up to seven decks are read and audited.
inline constexpr std::size_t most_repaired_pairs = 20;

/// Most pairs of parts whose repairs are listed without being tried.
inline constexpr std::size_t most_listed_pairs = 500;

/// Which repairs are tried.
enum class Tried : std::uint8_t { all, cards };  ///< `cards`: those that move nodes are left out

/// For each pair of parts with penetrations (GC101, GC102, GC107 to GC109) what can be done: moving nodes, OPTT, SST,
/// sections, IGNORE, a tie, no contact, or the sides of a one-way contact exchanged. Each is written into the deck,
/// read again and audited. Repairs that solve their pair come first, then by cost. Errors: as fix_penetrations().
[[nodiscard]] Result<RepairPlan> plan_repairs(const keyword::Deck& deck, const FixOptions& options,
                                              const Reread& reread, Diagnostics& diagnostics, Tried tried = Tried::all);

/// The same pairs and repairs with the lines that apply_repairs() would write for each, or why it would not; none is
/// tried, and those that move nodes are left out. Takes as long as one audit. Errors: as plan_repairs().
[[nodiscard]] Result<RepairPlan> list_written_repairs(const keyword::Deck& deck, Diagnostics& diagnostics);

/// A deck with repairs, and the texts of its files.
struct Repaired {
  AppliedRepairs report;
  std::map<std::string, std::string> texts;  ///< of the files that change, by path as read
};

/// Applies repairs by their ids ("2-optt") together, and audits the result. `move` of any pair moves nodes wherever
/// something penetrates once the others are done. Errors: an unknown id, a card that cannot be changed.
[[nodiscard]] Result<Repaired> apply_repairs(const keyword::Deck& deck, std::span<const std::string> ids,
                                             const FixOptions& options, const Reread& reread, Diagnostics& diagnostics);

}  // namespace gapcheck::audit
