#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "audit/fix/joined_nodes.hpp"
#include "audit/fix/least_movement.hpp"
#include "audit/untangle/untangling.hpp"
#include "contact/initial.hpp"
#include "contact/mesh/mesh_index.hpp"
#include "contact/pair/record_pair.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "records/fix.hpp"

namespace gapcheck::audit {

/// A tracked node that must keep its contact distance from a segment, on the side on which it was found. A node next to
/// the segment of a two-sided surface is on the side of the nodes of its elements.
struct Gap {
  ContactIndex contact;
  NodeIndex node;
  model::SegmentNodes corners{};
  bool line = false;                       ///< a beam axis: corners[0], corners[1]
  double side = 1;                         ///< 1: in front of the facet's normal, -1: behind it
  double distance = 0;                     ///< h
  double deepest = 0;                      ///< largest penetration that was found
  double clearance = 0;                    ///< beyond h
  int seen = 0;                            ///< how often it was found again
  Vector shift = Vector::Zero();           ///< from the node to its mid-surface
  double offset = 0;                       ///< of the facet's mid-surface along its normal
  double multiplier = 0;                   ///< of least_movement(), to start from
  HoldReason given_up = HoldReason::none;  ///< why no movement opens it
};

/// State of a gap at some coordinates.
struct GapState {
  bool counts = true;                 ///< the node's projection is in the segment's band
  double gap = 0;                     ///< distance from the segment, negative on the other side
  Vector direction = Vector::Zero();  ///< unit vector along which the gap grows
  std::array<double, 4> share{};      ///< how the corners move the closest point
};
[[nodiscard]] GapState measure_gap(const Gap& gap, const std::vector<Vector>& x);

/// All gaps found too small so far. Only grows.
class Gaps {
 public:
  /// `index`: of the model whose records it will take; must outlive it.
  explicit Gaps(contact::MeshIndex& index) : index_(index) {}
  /// Adds the nodes that penetrate (even too deep ones) in a state of the contacts. `surfaces`: of the same model on
  /// the same coordinates `x`. Gaps found too small repeatedly get more clearance, because of rounding.
  /// `skip`: nodes and segments whose side is decided elsewhere; empty: none.
  using Skip = std::function<bool(NodeIndex node, const model::SegmentNodes& segment)>;
  void add(const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& state,
           const std::vector<Vector>& x, const Skip& skip = {});
  /// Adds nodes whose side is known, or gives their gaps this side. A gap that is open at `x` and still named gets more
  /// clearance: surfaces of warped segments cross before nodes do.
  void add(const model::Mesh& mesh, std::span<const KnownSide> sides, const std::vector<Vector>& x);
  /// Gives every gap at least this clearance, but no more than a twentieth of its distance: nodes that slide from
  /// segment to segment as gaps open find the next one open.
  void widen(double clearance);
  void clear() {
    gaps_.clear();
    position_.clear();
  }
  /// Drops gaps to segments that the node is joined to: around a weld the sheets cannot separate.
  void give_up(const JoinedNodes& joined);
  [[nodiscard]] std::vector<Gap>& list() { return gaps_; }
  [[nodiscard]] const std::vector<Gap>& list() const { return gaps_; }
  /// The gap of a record; nullptr if there is none.
  [[nodiscard]] Gap* find(const model::Model& model, const Penetration& record);

 private:
  void take_side(Gap& gap, const model::Mesh& mesh, const contact::ContactSurfaces& surfaces,
                 const contact::RecordPair& pair, const Penetration& record, const std::vector<Vector>& x);
  [[nodiscard]] double neighbours_height(const model::Mesh& mesh, NodeIndex node, const Vector& point,
                                         const Vector& normal, const std::vector<Vector>& x);

  contact::MeshIndex& index_;
  /// Contact, node and corners.
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::array<std::int64_t, 4>>;
  std::vector<Gap> gaps_;
  std::map<Key, std::size_t> position_;
};

/// Records of nodes that a correction has to free.
[[nodiscard]] constexpr bool to_be_fixed(PenetrationKind kind) {
  return kind == PenetrationKind::initial || kind == PenetrationKind::released;
}

}  // namespace gapcheck::audit
