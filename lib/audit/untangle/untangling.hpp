#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "audit/untangle/crossing_pairs.hpp"
#include "audit/untangle/facing.hpp"
#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::audit {

/// A node, a segment, and the side of it on which the node belongs.
struct KnownSide {
  ContactIndex contact;
  NodeIndex node;
  model::SegmentNodes corners{};
  double side = 1;                ///< 1: in front of the segment's normal, -1: behind it
  double distance = 0;            ///< contact distance
  Vector shift = Vector::Zero();  ///< from the node to its mid-surface
  double offset = 0;              ///< of the segment's mid-surface along its normal
  double depth = 0;               ///< how far the node is from where it should be
  double step = 0;  ///< more distance for the next attempt, if the node is there and the surfaces still cross
};

/// Two surfaces that cross along one contour.
struct CrossingPlace {
  ContactIndex contact;
  std::array<std::vector<ElementOfKind>, 2> elements;
  std::size_t pairs = 0;
  bool divided = false;          ///< it is known which piece is on the wrong side
  double too_deep = 0;           ///< how far that would have to come back, if it is too far; else 0
  std::vector<NodeIndex> nodes;  ///< that have to change sides, or to move away from it
};

/// The crossings at some coordinates, and the sides on which pieces of surfaces belong.
class Untangling {
 public:
  /// A piece that reaches farther beyond the other surface is left where it is: three segments (mean diagonal `size`)
  /// or ten contact distances, whichever is more.
  [[nodiscard]] static double reach(double size, double distance) { return std::max(3 * size, 10 * distance); }

  /// `surfaces`: of the model, on the coordinates `x`. `left_alone`: pairs whose contours are not touched. `work`:
  /// steps that may still be done.
  Untangling(const model::Model& model, contact::SurfaceStore& surfaces, const std::vector<Vector>& x,
             std::span<const ContactCrossing> crossings, const std::set<ElementPair>& left_alone, std::uint64_t& work);
  [[nodiscard]] const std::vector<CrossingPlace>& places() const { return places_; }
  /// Of nodes that are on the wrong side, and of their neighbours that are not.
  [[nodiscard]] const std::vector<KnownSide>& sides() const { return sides_; }
  /// True if a node and a segment are both at one of these crossings: as long as they cross, their distance says
  /// nothing.
  [[nodiscard]] bool at_crossing(NodeIndex node, const model::SegmentNodes& segment) const;

 private:
  /// The nodes of the two surfaces at one crossing.
  struct Nodes {
    std::set<NodeIndex> piece, other;
  };
  void take_contact(const model::Model& model, const contact::ContactSurfaces& surfaces, ContactIndex contact,
                    const std::vector<Vector>& x, std::span<const ElementPair> pairs,
                    const std::set<ElementPair>& left_alone, std::uint64_t& work);
  void take_piece(const WrongPiece& piece, const CutSurface& own, const CutSurface& other, CrossingPlace& place,
                  std::uint64_t& work);

  std::vector<KnownSide> sides_;
  std::vector<Nodes> nodes_;
  std::vector<CrossingPlace> places_;
};

}  // namespace gapcheck::audit
