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
#include "audit/fix/wall_hits.hpp"
#include "audit/untangle/untangling.hpp"
#include "contact/initial.hpp"
#include "contact/mesh/mesh_index.hpp"
#include "contact/pair/record_pair.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "records/fix.hpp"

namespace gapcheck::audit {

/// What a node or an edge must keep its distance from.
enum class GapKind : std::uint8_t {
  facet,
  line,   ///< a beam axis: corners[0], corners[1]
  edges,  ///< the edge from `node` to `end` and the edge from corners[0] to corners[1]
  wall,   ///< a rigid wall: the plane through `foot` across `away`
};

/// A tracked node that must keep its contact distance from a segment, on the side on which it was found. A node next to
/// the segment of a two-sided surface is on the side of the nodes of its elements.
struct Gap {
  ContactIndex contact;                   ///< none<ContactIndex>: a rigid wall
  NodeIndex node, end = none<NodeIndex>;  ///< `end`: the other one of its edge
  model::SegmentNodes corners{};          ///< walls: the node itself
  GapKind kind = GapKind::facet;
  double side = 1;                ///< 1: in front of the facet's normal, -1: behind it; edges: of first x second
  double distance = 0;            ///< h
  double deepest = 0;             ///< largest penetration that was found
  double clearance = 0;           ///< beyond h
  int seen = 0;                   ///< how often it was found again
  Vector shift = Vector::Zero();  ///< from the node to its mid-surface
  double offset = 0;              ///< of the facet's mid-surface along its normal
  Vector foot = Vector::Zero(), away = Vector::Zero();  ///< of a wall, where the node was nearest to it
  double multiplier = 0;                                ///< of least_movement(), to start from
  HoldReason given_up = HoldReason::none;               ///< why no movement opens it
};

/// State of a gap at some coordinates.
struct GapState {
  bool counts = true;                 ///< the node's projection is in the segment's band
  double gap = 0;                     ///< distance from the segment, negative on the other side
  Vector direction = Vector::Zero();  ///< unit vector along which the gap grows
  std::array<double, 4> share{};      ///< how the corners move the closest point
  double own = 1;                     ///< share of the node; its edge's end has the rest
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
  /// Adds nodes in rigid walls.
  void add(std::span<const WallHit> hits);
  /// The gap of a record on the model's present coordinates; nullptr if there is none.
  [[nodiscard]] Gap* find(const model::Model& model, const Penetration& record);
  [[nodiscard]] Gap* find(const WallHit& hit);

 private:
  void take_side(Gap& gap, const model::Mesh& mesh, const contact::ContactSurfaces& surfaces,
                 const contact::RecordPair& pair, const Penetration& record, const std::vector<Vector>& x);
  void take_edges(Gap& gap, const model::Mesh& mesh, const Penetration& record, const std::vector<Vector>& x);
  [[nodiscard]] double neighbours_height(const model::Mesh& mesh, NodeIndex node, const Vector& point,
                                         const Vector& normal, const std::vector<Vector>& x);
  [[nodiscard]] NodeIndex other_end(const model::Mesh& mesh, NodeIndex node, const Penetration& record,
                                    const std::vector<Vector>& x);
  /// Found too small, perhaps again.
  static void deepen(Gap& gap, double depth);

  contact::MeshIndex& index_;
  /// Contact, node, end of its edge, and corners; the place of a wall in the model is its first corner.
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::array<std::int64_t, 4>>;
  [[nodiscard]] std::optional<Key> key_of(const model::Model& model, const Penetration& record);
  [[nodiscard]] static Key wall_key(const WallHit& hit) {
    return {none<ContactIndex>.value, hit.node.value, none<NodeIndex>.value, {hit.wall, 0, 0, 0}};
  }
  std::vector<Gap> gaps_;
  std::map<Key, std::size_t> position_;
};

/// Records of nodes that a correction has to free.
[[nodiscard]] constexpr bool to_be_fixed(PenetrationKind kind) { return kind != PenetrationKind::edge_zone; }

}  // namespace gapcheck::audit
