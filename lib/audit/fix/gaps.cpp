#include "audit/fix/gaps.hpp"

#include <algorithm>
#include <cmath>

#include "base/quad.hpp"
#include "contact/definition/outcome.hpp"
#include "geometry/closest_point.hpp"

namespace gapcheck::audit {
namespace {

/// A gap still too small after this many corrections is too small because of the deck's digits.
constexpr int patience = 4;
/// Parametric band of a beam axis, as of a segment.
constexpr double band_end = 1.5;
/// A node nearer to the mid-surface than this share of the contact distance does not determine its side alone.
constexpr double ambiguous = 0.2;

geometry::Facet facet_of(const Gap& gap, const std::vector<Vector>& x) {
  const auto& n = gap.corners;
  geometry::Facet f{{x[n[0].value], x[n[1].value], x[n[2].value], x[n[3].value]}, n[2] == n[3]};
  if (gap.offset == 0) return f;
  const Vector shift = gap.offset * quad_normal(f.x).stableNormalized();
  for (Vector& corner : f.x) corner += shift;
  return f;
}

/// Of the contact distance, what slow progress may add to it.
constexpr double largest_clearance = 0.05;
/// A node beside an edge is on the wrong side if it is more behind the segment than beside it.
constexpr double behind_edge = -0.7;

/// Away from the closest point on an edge, but never to the side on which the node must not be.
void point_away(GapState& state, const Vector& away, const Vector& free) {
  const double distance = away.norm();
  const bool aside = distance > 0 && away.dot(free) >= behind_edge * distance;
  state.direction = aside ? Vector(away / distance) : free;
  state.gap = aside ? distance : away.dot(free);
}

GapState measure_line(const Gap& gap, const geometry::Facet& facet, const Vector& q) {
  const auto c = geometry::closest_point_on_line(facet.x[0], facet.x[1], q);
  GapState state;
  state.counts = std::abs(c.free_s) <= band_end;
  state.share = {(1 - c.s) / 2, (1 + c.s) / 2, 0, 0};
  const Vector axis = facet.x[1] - facet.x[0], away = q - c.point;
  const Vector free = axis.squaredNorm() > 0 ? Vector(axis.unitOrthogonal()) : Vector(Vector::UnitZ());
  point_away(state, away, away.squaredNorm() > 0 ? Vector(away.normalized()) : Vector(gap.side * free));
  return state;
}

/// Asks `skip` about the node and the segment of a record.
bool skips(const model::Mesh& mesh, const Penetration& record, const Gaps::Skip& skip) {
  const auto node = mesh.nodes.lookup.find(record.node);
  if (!node) return false;
  model::SegmentNodes corners{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto corner = mesh.nodes.lookup.find(record.segment[i]);
    if (!corner) return false;
    corners[i] = NodeIndex{*corner};
  }
  return skip(NodeIndex{*node}, corners);
}

}  // namespace

GapState measure_gap(const Gap& gap, const std::vector<Vector>& x) {
  const geometry::Facet facet = facet_of(gap, x);
  const Vector q = x[gap.node.value] + gap.shift;
  if (gap.line) return measure_line(gap, facet, q);
  const auto c = geometry::closest_point(facet, q);
  GapState state;
  state.counts = c.in_band;
  state.share = quad_weights(c.s, c.t);
  const Vector free = gap.side * c.normal;
  if (c.feature == Feature::face) {
    state.direction = free;
    state.gap = gap.side * c.gap;
  } else {
    point_away(state, q - c.point, free);
  }
  return state;
}

/// Sum of the heights of the nodes around a node above a plane: the side on which its elements are. Where middles are
/// beside their nodes, the plane is shifted instead of each of them.
double Gaps::neighbours_height(const model::Mesh& mesh, NodeIndex node, const Vector& point, const Vector& normal,
                               const std::vector<Vector>& x) {
  double height = 0;
  const auto add = [&](const auto& elements, contact::ElementIndex& index) {
    for (const std::uint32_t e : index.at(node))
      for (const NodeIndex n : elements.nodes[e])
        if (n != none<NodeIndex>) height += normal.dot(x[n.value] - point);
  };
  add(mesh.shells, index_.shells);
  add(mesh.solids, index_.solids);
  add(mesh.thick_shells, index_.thick_shells);
  add(mesh.beams, index_.beams);
  return height;
}

void Gaps::take_side(Gap& gap, const model::Mesh& mesh, const contact::ContactSurfaces& surfaces,
                     const contact::RecordPair& pair, const Penetration& record, const std::vector<Vector>& x) {
  const auto& nodes = (pair.node_on_b ? surfaces.b : surfaces.a).nodes;
  const auto& segments = (pair.segment_on_b ? surfaces.b : surfaces.a).selection.segments;
  gap.line = segments.kind[pair.segment.value] == contact::SegmentKind::line;
  gap.distance = record.contact_distance;
  if (!nodes.shift.empty()) gap.shift = nodes.shift[pair.slot.value];
  if (!segments.offset.empty()) gap.offset = segments.offset[pair.segment.value];
  if (gap.line) return;
  const Vector q = x[gap.node.value] + gap.shift;
  const auto closest = geometry::closest_point(facet_of(gap, x), q);
  // The record's distance is negative behind a segment that has a front: then the way out is the opposite one.
  const double distance = record.remaining();
  double height = closest.normal.dot(q - closest.point);
  const bool two_sided = segments.kind[pair.segment.value] == contact::SegmentKind::shell &&
                         surfaces.type.family != contact::Family::old &&
                         surfaces.type.family != contact::Family::forming;
  if (two_sided && distance < ambiguous * gap.distance)
    height = neighbours_height(mesh, gap.node, closest.point - gap.shift, closest.normal, x);
  gap.side = (distance < 0 ? -height : height) < 0 ? -1 : 1;
}

void Gaps::add(const model::Mesh& mesh, std::span<const KnownSide> sides, const std::vector<Vector>& x) {
  for (const KnownSide& known : sides) {
    std::array<std::int64_t, 4> segment{};
    for (std::size_t i = 0; i < 4; ++i) segment[i] = mesh.nodes.id[known.corners[i].value];
    const auto [place, fresh] = position_.emplace(Key{known.contact.value, known.node.value, segment}, gaps_.size());
    if (fresh) {
      Gap gap;
      gap.contact = known.contact;
      gap.node = known.node;
      gap.corners = known.corners;
      gap.side = known.side;
      gap.distance = known.distance;
      gap.shift = known.shift;
      gap.offset = known.offset;
      gaps_.push_back(gap);
    }
    Gap& gap = gaps_[place->second];
    if (!fresh && gap.side == known.side && measure_gap(gap, x).gap >= gap.distance) gap.clearance += known.step;
    gap.side = known.side;
    gap.deepest = std::max(gap.deepest, known.depth);
    gap.clearance = std::max(gap.clearance, (contact::shooting_move - 1) * gap.deepest);
  }
}

void Gaps::add(const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& state,
               const std::vector<Vector>& x, const Skip& skip) {
  for (const Penetration& record : state.penetrations) {
    if (!to_be_fixed(record.kind)) continue;
    if (skip && skips(model.mesh, record, skip)) continue;
    if (Gap* known = find(model, record); known != nullptr) {
      if (++known->seen > patience) known->clearance += 2 * record.depth;
      known->deepest = std::max(known->deepest, record.depth);
      known->clearance = std::max(known->clearance, (contact::shooting_move - 1) * known->deepest);
      continue;
    }
    const ContactIndex of{record.contact};
    const contact::ContactSurfaces& sides = surfaces.at(of);
    const auto pair = contact::find_pair(sides, model.mesh, record);
    if (!pair) continue;
    Gap gap;
    gap.contact = of;
    gap.node = NodeIndex{*model.mesh.nodes.lookup.find(record.node)};
    gap.corners = (pair->segment_on_b ? sides.b : sides.a).selection.segments.nodes[pair->segment.value];
    take_side(gap, model.mesh, sides, *pair, record, x);
    gap.deepest = record.depth;
    gap.clearance = (contact::shooting_move - 1) * record.depth;
    position_.emplace(Key{record.contact, gap.node.value, record.segment}, gaps_.size());
    gaps_.push_back(gap);
  }
}

void Gaps::widen(double clearance) {
  for (Gap& gap : gaps_) gap.clearance = std::max(gap.clearance, std::min(clearance, largest_clearance * gap.distance));
}

void Gaps::give_up(const JoinedNodes& joined) {
  if (joined.leaders().empty()) return;
  for (Gap& gap : gaps_) {
    const NodeIndex own = joined.leader(gap.node);
    const bool one =
        std::any_of(gap.corners.begin(), gap.corners.end(), [&](NodeIndex n) { return joined.leader(n) == own; });
    if (one && gap.given_up == HoldReason::none) gap.given_up = HoldReason::constrained;
  }
}

Gap* Gaps::find(const model::Model& model, const Penetration& record) {
  const auto node = model.mesh.nodes.lookup.find(record.node);
  if (!node) return nullptr;
  const auto found = position_.find(Key{record.contact, *node, record.segment});
  return found == position_.end() ? nullptr : &gaps_[found->second];
}

}  // namespace gapcheck::audit
