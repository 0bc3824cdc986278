#include "audit/untangle/facing.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::audit {

std::optional<std::vector<Facing>> face_piece(const WrongPiece& piece, const CutSurface& other, std::uint64_t& work) {
  FaceRegion cut(other);
  if (!cut.grow(piece.faces, contact::Bounds{}, work)) return std::nullopt;
  // No node is nearer to a face outside this box than to one of those that are cut through.
  contact::Bounds box;
  double farthest = 0;
  for (const auto* list : {&piece.nodes, &piece.rim})
    for (const NodeIndex n : *list) {
      box.add(other.x()[n.value]);
      if (work < cut.faces().size()) return std::nullopt;
      work -= cut.faces().size();
      const double distance = cut.nearest(n).distance;
      if (std::isfinite(distance)) farthest = std::max(farthest, distance);
    }
  FaceRegion region(other);
  if (!region.grow(piece.faces, contact::grown(box, farthest), work)) return std::nullopt;
  std::vector<Facing> list;
  for (const auto* nodes : {&piece.nodes, &piece.rim})
    for (const NodeIndex n : *nodes) {
      if (work < region.faces().size()) return std::nullopt;
      work -= region.faces().size();
      const NearestFace nearest = region.nearest(n);
      if (nearest.in_band) list.push_back({n, nearest.face, nearest.distance, nodes == &piece.nodes});
    }
  return list;
}

}  // namespace gapcheck::audit
