#pragma once
#include <optional>
#include <string>

#include "records/penetration.hpp"
#include "records/solver_run.hpp"
#include "records/tie_failure.hpp"
#include "results/log/message_kinds.hpp"

namespace gapcheck::results {

/// The first fault of a block.
struct BlockFault {
  std::uint32_t line = 0;
  std::string what;
};

/// A record made from a block; `contact` is the interface's id, the record's own contact is not set.
template <class Record>
struct FromBlock {
  std::int64_t contact = 0;
  Record record;
  bool complete = false;  ///< the fields required for a record are present
  BlockFault fault;       ///< empty: none
};

/// The node's record of a penetration block: layout of 40565, any order of its fields. Depth and remaining distance 0:
/// not given. `awaits_more`: the block's last line announces more.
struct PenetrationBlock : FromBlock<Penetration> {
  bool awaits_more = false;
};
[[nodiscard]] PenetrationBlock penetration_of(const MessageBlock& block, const MessageKind& kind);

[[nodiscard]] FromBlock<TieFailure> tie_failure_of(const MessageBlock& block, const MessageKind& kind);

/// "node N (rigidwall W) init. penetration= p". `contact` stays 0.
[[nodiscard]] FromBlock<RigidwallPenetration> rigidwall_of(const MessageBlock& block);

}  // namespace gapcheck::results
