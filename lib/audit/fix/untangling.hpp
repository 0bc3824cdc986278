#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "audit/fix/gaps.hpp"
#include "audit/untangle/crossing_pairs.hpp"
#include "audit/untangle/facing.hpp"

namespace gapcheck::audit {

/// Two surfaces that cross and cannot be parted, or are not to be.
struct Hooked {
  ContactIndex contact;
  std::array<std::vector<ElementOfKind>, 2> elements;
  std::size_t pairs = 0;
  double too_deep = 0;  ///< how far the piece would have to come back; 0: no piece is on the wrong side
};

/// The crossings at some coordinates: pieces of surfaces that belong on the other side, as gaps that are to open.
class Untangling {
 public:
  /// A piece that reaches farther beyond the other surface is left where it is: three segments (mean diagonal `size`)
  /// or ten contact distances, whichever is more.
  [[nodiscard]] static double reach(double size, double distance) { return std::max(3 * size, 10 * distance); }

  /// `surfaces`: of the model, on the coordinates `x`. `left_alone`: pairs whose contours are not touched. `work`:
  /// steps that may still be done.
  Untangling(const model::Model& model, contact::SurfaceStore& surfaces, const std::vector<Vector>& x,
             std::span<const ContactCrossing> crossings, const std::set<ElementPair>& left_alone, std::uint64_t& work);
  [[nodiscard]] const std::vector<Hooked>& hooked() const { return hooked_; }
  /// Gaps of nodes that are on the wrong side, and of their neighbours that are not: their sides.
  void add_to(Gaps& gaps, const model::Mesh& mesh, const std::vector<Vector>& x) const;
  /// at_crossing() as a function; this must outlive it.
  [[nodiscard]] Gaps::Skip skip() const {
    return [this](NodeIndex n, const model::SegmentNodes& s) { return at_crossing(n, s); };
  }
  [[nodiscard]] bool any() const { return !gaps_.empty(); }
  /// True if a node and a segment are both at one of these crossings: as long as they cross, their distance says
  /// nothing.
  [[nodiscard]] bool at_crossing(NodeIndex node, const model::SegmentNodes& segment) const;

 private:
  struct Found {
    Gap gap;
    double depth = 0;
  };
  /// The nodes of the two surfaces at one crossing.
  struct Place {
    std::set<NodeIndex> piece, other;
  };
  void take_contact(const model::Model& model, const contact::ContactSurfaces& surfaces, ContactIndex contact,
                    const std::vector<Vector>& x, std::span<const ElementPair> pairs,
                    const std::set<ElementPair>& left_alone, std::uint64_t& work);
  [[nodiscard]] double take_piece(const WrongPiece& piece, const CutSurface& own, const CutSurface& other,
                                  ContactIndex contact, std::uint64_t& work);

  std::vector<Found> gaps_;
  std::vector<Place> places_;
  std::vector<Hooked> hooked_;
};

}  // namespace gapcheck::audit
