#include "audit/untangle/facing.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::audit {
namespace {

/// Pairs of a node and a segment for one piece, at most: about a second.
constexpr std::uint64_t most_pairs = 100'000'000;

}  // namespace

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
  const std::size_t count = piece.nodes.size() + piece.rim.size();
  if (!region.grow(piece.faces, contact::grown(box, farthest), work)) return std::nullopt;
  if (region.faces().empty()) return std::vector<Facing>{};
  if (count > most_pairs / region.faces().size()) return std::nullopt;
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
