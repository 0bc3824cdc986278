#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "records/fix.hpp"
#include "records/repair.hpp"

namespace gapcheck {

/// A line of a deck that a repair changes, or a place where it puts new ones.
struct RepairLine {
  std::string file;
  std::uint32_t line = 0;
  std::string before, after;  ///< without the last line end; several lines where a repair adds some
};

/// What an audit of the repaired deck finds.
struct RepairOutcome {
  std::string refused;  ///< why the repair was not tried; empty: it was
  std::uint64_t left =
      0;  ///< penetrations of the pair that are still moved, pushed or released; of ties nodes still too far
  std::uint64_t forgiven = 0;   ///< that stay without force
  std::uint64_t added = 0;      ///< more penetrations elsewhere than before
  std::uint64_t lost_ties = 0;  ///< fewer tied nodes than before
  std::uint64_t untied = 0;     ///< penetrating nodes that a new tie does not hold
  std::uint64_t crossings = 0;  ///< more crossings of elements than before
  std::uint64_t moved = 0;      ///< nodes
  double largest_move = 0;      ///< of the two parts' nodes
  double changed_elements = 0;  ///< share of the model's elements that have a moved node
  [[nodiscard]] std::uint64_t remaining() const { return left + added + lost_ties + untied + crossings; }
  /// Nothing is left, and nothing is worse elsewhere.
  [[nodiscard]] bool solves() const { return refused.empty() && remaining() == 0; }
};

/// One way to repair a pair of parts.
struct Repair {
  std::string id;  ///< "2-optt": number of the pair, and the kind
  RepairKind kind = RepairKind::move;
  std::string text;  ///< what it does
  RepairSettings settings;
  double cost = 0;  ///< share of the contact distance that is moved, given away or forgiven; 1: the contact itself
  RepairOutcome outcome;
  std::vector<RepairLine> lines;  ///< of all kinds except move
};

/// The penetrations between two parts in one contact, or the nodes of a tied contact that are too far away to tie, and
/// what can be done about them.
struct RepairPair {
  std::size_t number = 0;  ///< from 1
  bool of_ties = false;    ///< then without parts, and the next lines are about nodes too far away
  RepairParts parts;
  std::uint64_t penetrations = 0, released = 0;
  double deepest = 0, contact_distance = 0;  ///< of the deepest one; of ties the farthest node and its tie distance
  bool tried = true;                         ///< false: there are too many pairs, so that nothing was tried
  std::vector<Repair> repairs;               ///< best first
};

/// All repairs of a deck, each tried and audited.
struct RepairPlan {
  std::string input;
  std::vector<RepairPair> pairs;  ///< by contact and parts; then ties, by contact
  std::uint64_t penetrating = 0;  ///< nodes, each counted once for each contact
  std::uint64_t too_far = 0;      ///< nodes that are too far away to tie
  std::uint64_t trials = 0;       ///< decks that were audited
  std::vector<std::string> notes;
  /// The first repair of each pair, if it solves the pair without changing the model (changes_the_model()).
  [[nodiscard]] std::vector<std::string> best() const;
};

/// A deck with repairs, audited again.
struct AppliedRepairs {
  std::string input;
  std::vector<std::string> ids;  ///< as applied
  struct Contact {
    std::int64_t id = 0;
    std::string keyword;
    std::uint64_t before = 0, after = 0;              ///< penetrations that are moved, pushed or released
    std::uint64_t forgiven_before = 0, forgiven = 0;  ///< that stay without force
  };
  std::vector<Contact> contacts;  ///< of the repaired deck
  std::uint64_t ties_before = 0, ties_after = 0;
  std::uint64_t too_far_before = 0, too_far_after = 0;  ///< nodes that are too far away to tie
  std::uint64_t moved = 0;                              ///< nodes
  double largest_move = 0;
  std::vector<RepairLine> lines;  ///< except those of moved nodes
  std::vector<FixedFile> files;
  std::vector<std::string> notes;
  bool dry_run = false;
  bool forgives = false;          ///< one of the repairs is IGNORE: what stays without force may stay
  std::optional<FixProof> proof;  ///< runs before and after, where they were asked for
  [[nodiscard]] std::uint64_t before() const;
  [[nodiscard]] std::uint64_t after() const;
  /// Nothing penetrates any more that the solver would move, push or release, and no node is too far away to tie.
  [[nodiscard]] bool complete() const { return after() + too_far_after == 0; }
};

}  // namespace gapcheck
