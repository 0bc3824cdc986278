#pragma once
#include <optional>
#include <string>

#include "records/penetration.hpp"
#include "records/solver_run.hpp"
#include "records/tie_failure.hpp"
#include "results/log/message_kinds.hpp"

namespace gapcheck::results {

/// What was wrong with a block: the first thing only.
struct BlockFault {
  std::uint32_t line = 0;
  std::string what;
};

/// A record that a block was turned into; `contact` is the interface's id, the record's own contact is not set.
template <class Record>
struct FromBlock {
  std::int64_t contact = 0;
  Record record;
  bool complete = false;  ///< the fields without which it is no record are there
  BlockFault fault;       ///< empty: none
};

/// The node's record of a penetration block: layout of 40565, any order of its fields. Depth and remaining distance 0:
/// not said. `awaits_more`: the block's last line promises more.
struct PenetrationBlock : FromBlock<Penetration> {
  bool awaits_more = false;
};
[[nodiscard]] PenetrationBlock penetration_of(const MessageBlock& block, const MessageKind& kind);

[[nodiscard]] FromBlock<TieFailure> tie_failure_of(const MessageBlock& block, const MessageKind& kind);

/// "node N (rigidwall W) init. penetration= p". `contact` stays 0.
[[nodiscard]] FromBlock<RigidwallPenetration> rigidwall_of(const MessageBlock& block);

}  // namespace gapcheck::results
