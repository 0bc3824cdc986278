#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "records/report.hpp"

namespace gapcheck::report {

/// A number that names a finding from one version of a deck to the next: FNV-1a (64 bits) of the contact id, the rule
/// and the node's position. Ids and line numbers do not enter, so renumbering and edits elsewhere keep it. The position
/// is rounded on a decimal grid, common to the three coordinates, that leaves the largest of them six significant
/// digits. Limit: coincident nodes in one contact share it. The same on every machine.
[[nodiscard]] std::uint64_t fingerprint(const Penetration& record, std::int64_t contact_id);

/// A message without the place of something else: "defined again (first in line 40 of a.k)" becomes "defined again
/// (first)", since lines move and the same file has another path from another folder. The file's name may be any; it
/// ends where the message does. "line of", as earlier baselines have it, is the same.
[[nodiscard]] std::string without_place(std::string_view message);

/// The same for findings without a position: the message without_place() takes its place, numbers after "line " left
/// out.
[[nodiscard]] std::uint64_t fingerprint(const Finding& finding);

/// The same for a node of a tied contact; where nothing says where it is, its number enters with the message.
[[nodiscard]] std::uint64_t fingerprint(const TieFailure& failure, std::int64_t contact_id);

/// Of a finding as a baseline has it: penetrations and ties as above; of others with a position the same of that, since a
/// baseline does not keep their words.
[[nodiscard]] std::uint64_t fingerprint(const KnownFinding& known);

}  // namespace gapcheck::report
