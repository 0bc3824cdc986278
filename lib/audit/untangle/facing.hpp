#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "audit/untangle/wrong_pieces.hpp"

namespace gapcheck::audit {

/// The segment of the other surface that a node has to be in front of or behind.
struct Facing {
  NodeIndex node;
  FaceSide face;
  double depth = 0;    ///< distance from the segment's mid-surface
  bool wrong = false;  ///< it is beyond: one of WrongPiece::nodes
};

/// For each node of a piece, and of its rim, the nearest segment of the other surface, as far as this continues over
/// edges with two segments from where it is cut through. Nodes that have none (the surface ends before) are left out.
/// `work`: steps that may still be done; nothing if they are exceeded, or the piece is too large.
[[nodiscard]] std::optional<std::vector<Facing>> face_piece(const WrongPiece& piece, const CutSurface& other,
                                                            std::uint64_t& work);

}  // namespace gapcheck::audit
