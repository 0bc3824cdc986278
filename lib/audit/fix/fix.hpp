#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "audit/fix/element_bounds.hpp"
#include "audit/fix/freedoms.hpp"
#include "audit/fix/node_lines.hpp"
#include "base/diagnostic.hpp"
#include "base/result.hpp"
#include "keyword/deck.hpp"
#include "records/fix.hpp"

namespace gapcheck::audit {

struct FixOptions {
  std::vector<Lock> locks;                                  ///< --lock
  std::vector<std::pair<std::int64_t, double>> priorities;  ///< --priority: part id and factor, positive
  /// --recommended: nodes of contacts with IGNORE = 2 go where the solver recommends, and nothing else moves.
  bool recommended = false;
  bool proposals = true;    ///< what could be done instead of moving nodes is searched, too
  bool untangle = true;     ///< elements that cross are separated where it is clear which of them is on the wrong side
  bool free_welds = false;  ///< --free-welds: nodes of spot welds, rivets and weld elements may move against each other
  ShapeLimits limits;
  std::uint32_t rounds = 40;  ///< searches of the contacts at most
  /// Most pairs to decide and conditions to solve, a few minutes: a search that reaches it ends with its result so far.
  /// Corrections of crossings may take as much again.
  std::uint64_t work = 10'000'000'000;
};

/// A corrected deck: what was done, and the lines that change.
struct Fix {
  FixReport report;
  using File = ChangedLines;
  std::vector<File> files;  ///< only those that change, in the order of the deck
};

/// Moves nodes so that nothing penetrates initially any more (GC101, GC102, GC107 to GC110) and tied nodes that the
/// solver would move lie on their segments (GC204), with the least movement: Σ wᵢ |uᵢ|², weights of find_freedoms().
/// Each node keeps to
/// the side of the segment on which the deck has it, and is cleared by 1.002 times its penetration, as the solver does.
/// Ties stay together; nodes that must not move stay; elements keep their shape (ShapeLimits). The coordinates are
/// judged as rounded in the deck's lines. Never more nodes penetrate afterwards than before. Overlaps that mortar
/// contacts press out over time (IGNORE = 3, 4) and those of INTERFERENCE are left alone. With FixOptions::recommended
/// no least movement is sought, elements may lose their shape, and what the moves make penetrate is reported as
/// unfixed. Errors: the deck cannot be read as a model, has unread keywords that move or create nodes, or lacks
/// something that the options name; the work is stopped.
[[nodiscard]] Result<Fix> fix_penetrations(const keyword::Deck& deck, const FixOptions& options,
                                           Diagnostics& diagnostics);

}  // namespace gapcheck::audit
