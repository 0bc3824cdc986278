#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "records/report.hpp"

namespace gapcheck::report {

/// A number that identifies a finding from one version of a deck to the next: FNV-1a (64 bits) of the contact id, the
/// rule and the node's position. Ids and line numbers are not included, so renumbering and edits elsewhere keep it. The
/// position is rounded on a decimal grid, common to the three coordinates, that leaves the largest of them six
/// significant digits. Limit: coincident nodes in one contact share it. The same on every machine.
[[nodiscard]] std::uint64_t fingerprint(const Penetration& record, std::int64_t contact_id);

/// A message without the location of something else: "defined again (first in line 40 of a.k)" becomes "defined again
/// (first)", since lines move and the same file has another path from another folder. The file's name is arbitrary; it
/// ends where the message does. "line of", as in earlier baselines, is treated the same.
[[nodiscard]] std::string without_place(std::string_view message);

/// The same for findings without a position: the message of without_place() replaces it, without numbers after "line ".
[[nodiscard]] std::uint64_t fingerprint(const Finding& finding);

/// The same for a node of a tied contact; if its position is unknown, its number is included with the message.
[[nodiscard]] std::uint64_t fingerprint(const TieFailure& failure, std::int64_t contact_id);

/// For a finding as a baseline has it: penetrations and ties as above; others with a position likewise from that, since
/// a baseline does not keep their text.
[[nodiscard]] std::uint64_t fingerprint(const KnownFinding& known);

}  // namespace gapcheck::report
