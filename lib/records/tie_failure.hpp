#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/vector.hpp"

namespace gapcheck {

/// Why a node of a tied contact needs a look; the words are those of check-c -sel.
enum class TieReason : std::uint8_t {
  sep,       ///< separated and moved onto the segment
  offset,    ///< separated and not moved, tied all the same
  too_far,   ///< "far": untied
  too_short, ///< "short": would shorten a connected beam; untied
  not_found, ///< "notfound": on no segment; untied
  rigslav,   ///< rigid tracked node; untied
  rigmast,   ///< on a segment with a rigid node; untied
  conflict,  ///< already constrained by another definition; untied
};

[[nodiscard]] std::string_view name(TieReason reason);
/// The rule that such a node is a finding of: "GC201".
[[nodiscard]] std::string_view rule_id(TieReason reason);
/// True for the reasons that leave the node untied.
[[nodiscard]] bool untied(TieReason reason);

/// One node of a tied contact that did not tie, or tied with a separation.
struct TieFailure {
  std::uint32_t contact = 0;         ///< position in Report::contacts
  std::int64_t node = 0;
  std::int64_t part = 0;             ///< 0: unknown
  std::uint32_t segment_number = 0;  ///< running number in the interface, from 1; 0: unknown
  double distance = -1;              ///< separation; negative: unknown
  double allowed = -1;               ///< distance within which it would tie; negative: unknown
  double segment_size = -1;          ///< the shorter diagonal of the segment; negative: unknown
  TieReason reason = TieReason::not_found;
  bool by_node_set = false;          ///< the node was named by a node set, so it was surely meant to tie
  std::optional<Vector> position = std::nullopt;  ///< of the node in the deck; none: unknown
  std::uint32_t file = 0, line = 0;  ///< file is a position in Report::files; line 0: unknown
};

}  // namespace gapcheck
