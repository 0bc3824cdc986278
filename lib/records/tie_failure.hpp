#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/vector.hpp"

namespace gapcheck {

/// Why a node of a tied contact needs a look; the words are those of check-c -sel.
enum class TieReason : std::uint8_t {
  sep,        ///< separated and moved onto the segment
  offset,     ///< separated and not moved, but tied
  too_far,    ///< "far": untied
  too_short,  ///< "short": would shorten a connected beam; untied
  not_found,  ///< "notfound": on no segment; untied
  rigslav,    ///< rigid tracked node; untied
  rigmast,    ///< on a segment with a rigid node; untied
  conflict,   ///< already constrained by another definition; untied
};

/// All reasons, in the order of the views.
inline constexpr std::array tie_reasons{TieReason::sep,       TieReason::offset,    TieReason::too_far,
                                        TieReason::too_short, TieReason::not_found, TieReason::rigslav,
                                        TieReason::rigmast,   TieReason::conflict};

[[nodiscard]] std::string_view name(TieReason reason);
/// True for the reasons that leave the node untied.
[[nodiscard]] bool untied(TieReason reason);

/// One node of a tied contact that did not tie, or tied with a separation.
struct TieFailure {
  std::uint32_t contact = 0;  ///< position in Report::contacts, as in Penetration
  std::int64_t node = 0;
  std::int64_t part = 0;             ///< 0: unknown
  std::uint32_t segment_number = 0;  ///< running number in the interface, from 1; 0: unknown
  double distance = -1;              ///< separation; negative: unknown
  double allowed = -1;               ///< distance within which it would tie; negative: unknown
  double segment_size = -1;          ///< the shorter diagonal of the segment; negative: unknown
  double thickness = -1;             ///< of node and segment together; negative: unknown, or one of them has none
  TieReason reason = TieReason::not_found;
  bool by_node_set = false;                       ///< a node set names the node, so it is surely meant to tie
  std::optional<Vector> position = std::nullopt;  ///< of the node in the deck; none: unknown
  std::uint32_t file = 0, line = 0;               ///< file is a position in Report::files; line 0: unknown

  /// True if the tie moves the node by more than both parts are thick.
  [[nodiscard]] bool moved_far() const { return reason == TieReason::sep && thickness > 0 && distance > thickness; }
};

}  // namespace gapcheck
