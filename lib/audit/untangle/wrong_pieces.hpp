#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "audit/untangle/contours.hpp"
#include "audit/untangle/face_region.hpp"

namespace gapcheck::audit {

/// Nodes that are on the wrong side of another surface, which cuts them off from the rest of theirs.
struct WrongPiece {
  std::vector<NodeIndex>
      nodes;                   ///< beyond the other surface, ascending; none: segments graze each other between corners
  std::vector<NodeIndex> rim;  ///< the ends of cut edges that are on the right side, ascending
  std::vector<FaceSide> faces;  ///< where the other surface is cut through
  bool other_is_second = true;  ///< the other surface is the second of find_wrong_pieces()
};

/// Which side each piece of two surfaces belongs to that cross along a contour. The contour cuts edges of a surface; if
/// that divides the surface, the part behind a solid is wrong, or, where both are shells, the smaller one. Where the
/// contour ends at the edge of the other surface and divides neither, only nodes above and below that surface count, no
/// farther from it than `reach`. Of two shells that are both divided, the one with fewer wrong nodes gives way. Nothing
/// if neither is divided (the surfaces are hooked into each other), or if the work is exceeded. `work`: steps that may
/// still be done; what is done is taken off.
[[nodiscard]] std::vector<WrongPiece> find_wrong_pieces(const Contour& contour, const model::Mesh& mesh,
                                                        const CutSurface& first, const CutSurface& second, double reach,
                                                        std::uint64_t& work);

}  // namespace gapcheck::audit
