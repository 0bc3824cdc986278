#include "audit/fix/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/quad.hpp"
#include "contact/definition/outcome.hpp"
#include "geometry/closest_point.hpp"
#include "geometry/edge_distance.hpp"

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

/// Of two edges, along their common perpendicular. Where an end is nearest, nodes and segments have to see to it.
GapState measure_edges(const Gap& gap, const std::vector<Vector>& x) {
  const geometry::Edge first{x[gap.node.value] + gap.shift, x[gap.end.value] + gap.shift};
  const geometry::Edge second{x[gap.corners[0].value], x[gap.corners[1].value]};
  const geometry::EdgesClosest c = geometry::closest_points(first, second);
  GapState state;
  state.counts = std::abs(c.s) < 1 && std::abs(c.t) < 1;
  state.own = (1 - c.s) / 2;
  state.share = {(1 - c.t) / 2, (1 + c.t) / 2, 0, 0};
  state.direction = gap.side * (first[1] - first[0]).cross(second[1] - second[0]).stableNormalized();
  state.gap = state.direction.dot(c.first - c.second);
  return state;
}

GapState measure_wall(const Gap& gap, const std::vector<Vector>& x) {
  GapState state;
  state.direction = gap.away;
  state.gap = gap.away.dot(x[gap.node.value] - gap.foot);
  return state;
}

/// The side of surfaces that lie in each other: parts with higher ids go towards the positive end of the axis to which
/// the normal is nearest, so that all pairs of two parts agree.
double side_of_equals(const Vector& normal, const Penetration& record) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const double up = normal[axis] < 0 ? -1 : 1;
  return record.part < record.element_part ? -up : up;
}

/// Heights below this share of the contact distance are rounding.
constexpr double level = 1e-6;

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
  if (gap.kind == GapKind::edges) return measure_edges(gap, x);
  if (gap.kind == GapKind::wall) return measure_wall(gap, x);
  const geometry::Facet facet = facet_of(gap, x);
  const Vector q = x[gap.node.value] + gap.shift;
  if (gap.kind == GapKind::line) return measure_line(gap, facet, q);
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
  if (segments.kind[pair.segment.value] == contact::SegmentKind::line) gap.kind = GapKind::line;
  gap.distance = record.contact_distance;
  if (!nodes.shift.empty()) gap.shift = nodes.shift[pair.slot.value];
  if (!segments.offset.empty()) gap.offset = segments.offset[pair.segment.value];
  if (gap.kind == GapKind::line) return;
  const Vector q = x[gap.node.value] + gap.shift;
  const auto closest = geometry::closest_point(facet_of(gap, x), q);
  // The record's distance is negative behind a segment that has a front: then the way out is the opposite one.
  const double distance = record.remaining();
  double height = closest.normal.dot(q - closest.point);
  const bool two_sided = segments.kind[pair.segment.value] == contact::SegmentKind::shell &&
                         (surfaces.type.by_segments() || (surfaces.type.family != contact::Family::old &&
                                                          surfaces.type.family != contact::Family::forming));
  if (two_sided && distance < ambiguous * gap.distance)
    height = neighbours_height(mesh, gap.node, closest.point - gap.shift, closest.normal, x);
  gap.side = (distance < 0 ? -height : height) < 0 ? -1 : 1;
  if (two_sided && std::abs(height) <= level * gap.distance) gap.side = side_of_equals(closest.normal, record);
}

void Gaps::add(const model::Mesh& mesh, std::span<const KnownSide> sides, const std::vector<Vector>& x) {
  for (const KnownSide& known : sides) {
    std::array<std::int64_t, 4> segment{};
    for (std::size_t i = 0; i < 4; ++i) segment[i] = mesh.nodes.id[known.corners[i].value];
    const Key key{known.contact.value, known.node.value, none<NodeIndex>.value, segment};
    const auto [place, fresh] = position_.emplace(key, gaps_.size());
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
    const auto key = key_of(model, record);
    if (!key) continue;
    if (const auto known = position_.find(*key); known != position_.end()) {
      deepen(gaps_[known->second], record.depth);
      continue;
    }
    Gap gap;
    gap.contact = ContactIndex{record.contact};
    gap.node = NodeIndex{std::get<1>(*key)};
    gap.distance = record.contact_distance;
    if (record.kind == PenetrationKind::edge) {
      gap.end = NodeIndex{std::get<2>(*key)};
      take_edges(gap, model.mesh, record, x);
    } else {
      const contact::ContactSurfaces& sides = surfaces.at(gap.contact);
      const auto pair = contact::find_pair(sides, model.mesh, record);
      if (!pair) continue;
      gap.corners = (pair->segment_on_b ? sides.b : sides.a).selection.segments.nodes[pair->segment.value];
      take_side(gap, model.mesh, sides, *pair, record, x);
    }
    gap.deepest = record.depth;
    gap.clearance = (contact::shooting_move - 1) * record.depth;
    position_.emplace(*key, gaps_.size());
    gaps_.push_back(gap);
  }
}

void Gaps::deepen(Gap& gap, double depth) {
  if (++gap.seen > patience) gap.clearance += 2 * depth;
  gap.deepest = std::max(gap.deepest, depth);
  gap.clearance = std::max(gap.clearance, (contact::shooting_move - 1) * gap.deepest);
}

/// The side is the one on which the edges are, and of edges next to each other that of the nodes around them.
void Gaps::take_edges(Gap& gap, const model::Mesh& mesh, const Penetration& record, const std::vector<Vector>& x) {
  gap.kind = GapKind::edges;
  for (std::size_t i = 0; i < 4; ++i) gap.corners[i] = NodeIndex{*mesh.nodes.lookup.find(record.segment[i])};
  const Vector normal = (x[gap.end.value] - x[gap.node.value])
                            .cross(x[gap.corners[1].value] - x[gap.corners[0].value])
                            .stableNormalized();
  double height = normal.dot(record.original - record.point);
  if (record.remaining() < ambiguous * gap.distance) {
    height = 0;
    for (const NodeIndex n : {gap.node, gap.end}) height += neighbours_height(mesh, n, record.point, normal, x);
    for (const NodeIndex n : {gap.corners[0], gap.corners[1]})
      height -= neighbours_height(mesh, n, record.original, normal, x);
  }
  gap.side = std::abs(height) <= level * gap.distance ? side_of_equals(normal, record) : height < 0 ? -1 : 1;
}

/// The other end of the tracked edge of a record, which names only the end that is nearest to the other edge.
NodeIndex Gaps::other_end(const model::Mesh& mesh, NodeIndex node, const Penetration& record,
                          const std::vector<Vector>& x) {
  NodeIndex best = none<NodeIndex>;
  double least = std::numeric_limits<double>::infinity();
  const double along = (1 - std::abs(record.t)) / 2;
  const auto look = [&](NodeIndex end) {
    if (end == node || end == none<NodeIndex>) return;
    const double off = (x[node.value] + along * (x[end.value] - x[node.value]) - record.original).squaredNorm();
    if (!(off < least)) return;
    least = off;
    best = end;
  };
  for (const std::uint32_t e : index_.shells.at(node)) {
    const auto& n = mesh.shells.nodes[e];
    for (std::size_t i = 0; i < 4; ++i)
      if (n[i] == node) {
        look(n[(i + 1) % 4]);
        look(n[(i + 3) % 4]);
        if (n[2] == n[3]) look(n[0]);
      }
  }
  for (const std::uint32_t e : index_.beams.at(node))
    for (const NodeIndex end : {mesh.beams.nodes[e][0], mesh.beams.nodes[e][1]}) look(end);
  return best;
}

void Gaps::add(std::span<const WallHit> hits) {
  for (const WallHit& hit : hits) {
    Gap* gap = find(hit);
    if (gap == nullptr) {
      position_.emplace(wall_key(hit), gaps_.size());
      gap = &gaps_.emplace_back();
      gap->kind = GapKind::wall;
      gap->contact = none<ContactIndex>;
      gap->node = hit.node;
      gap->corners.fill(hit.node);
    }
    gap->foot = hit.surface;
    gap->away = hit.normal;
    deepen(*gap, hit.depth);
  }
}

void Gaps::widen(double clearance) {
  for (Gap& gap : gaps_) gap.clearance = std::max(gap.clearance, std::min(clearance, largest_clearance * gap.distance));
}

void Gaps::give_up(const JoinedNodes& joined) {
  if (joined.leaders().empty()) return;
  for (Gap& gap : gaps_) {
    if (gap.kind == GapKind::wall) continue;
    const auto meets = [&](NodeIndex own) {
      return std::any_of(gap.corners.begin(), gap.corners.end(),
                         [&](NodeIndex n) { return joined.leader(n) == joined.leader(own); });
    };
    const bool one = meets(gap.node) || (gap.kind == GapKind::edges && meets(gap.end));
    if (one && gap.given_up == HoldReason::none) gap.given_up = HoldReason::constrained;
  }
}

std::optional<Gaps::Key> Gaps::key_of(const model::Model& model, const Penetration& record) {
  const auto found = model.mesh.nodes.lookup.find(record.node);
  if (!found) return std::nullopt;
  NodeIndex end = none<NodeIndex>;
  if (record.kind == PenetrationKind::edge) {
    end = other_end(model.mesh, NodeIndex{*found}, record, model.mesh.nodes.x);
    if (end == none<NodeIndex>) return std::nullopt;
  }
  return Key{record.contact, *found, end.value, record.segment};
}

Gap* Gaps::find(const model::Model& model, const Penetration& record) {
  const auto key = key_of(model, record);
  const auto found = key ? position_.find(*key) : position_.end();
  return found == position_.end() ? nullptr : &gaps_[found->second];
}

Gap* Gaps::find(const WallHit& hit) {
  const auto found = position_.find(wall_key(hit));
  return found == position_.end() ? nullptr : &gaps_[found->second];
}

}  // namespace gapcheck::audit
