#include "contact/pair/pair.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/quad.hpp"
#include "contact/pair/node_contact.hpp"

namespace gapcheck::contact {
namespace {

constexpr double relative_tolerance = 1e-9;
constexpr double tolerance_in_ulps = 4;
/// Parametric band of a beam axis, as of a segment.
constexpr double band_end = 1.5 * (1 + relative_tolerance);
/// Share of the shorter diagonal up to which an oriented shell segment sees nodes behind it.
constexpr double shell_behind = 0.5;
/// Faces look against each other if the cosine of their normals is below this: 84 degrees from opposite at most.
constexpr double against = -0.1;

PairResult measure_line(const geometry::Facet& f, const Vector& q) {
  PairResult result;
  const auto c = geometry::closest_point_on_line(f.x[0], f.x[1], q);
  result.in_band = std::abs(c.free_s) <= band_end;
  result.distance = std::sqrt(c.squared_distance);
  result.closest.point = c.point;
  result.closest.squared_distance = c.squared_distance;
  result.closest.s = c.s;
  result.closest.free_s = c.free_s;
  result.closest.feature = std::abs(c.s) < 1 ? Feature::edge : Feature::corner;
  // A beam has no side; a node on its axis is moved across it.
  const Vector axis = f.x[1] - f.x[0];
  result.closest.normal = axis.squaredNorm() > 0 ? Vector(axis.unitOrthogonal()) : Vector(Vector::UnitZ());
  return result;
}

PairResult measure(const PairScene& scene, SlotIndex slot, SegmentIndex s, const geometry::Facet& facet,
                   const Vector& q) {
  if (scene.line(s)) return measure_line(facet, q);
  PairResult result;
  result.closest = geometry::closest_point(facet, q);
  result.in_band = result.closest.in_band;
  result.distance = std::sqrt(result.closest.squared_distance);
  if (scene.oriented(s) && !scene.in_front(slot, s, result.closest, q)) result.distance = -result.distance;
  return result;
}

}  // namespace

double min_diagonal(const geometry::Facet& f) {
  return std::sqrt(std::min((f.x[2] - f.x[0]).squaredNorm(), (f.x[3] - f.x[1]).squaredNorm()));
}

double largest_coordinate(const geometry::Facet& facet, const Vector& query) {
  double largest = query.cwiseAbs().maxCoeff();
  for (const Vector& x : facet.x) largest = std::max(largest, x.cwiseAbs().maxCoeff());
  return largest;
}

double default_tolerance(double contact_distance, double largest) {
  // std::nextafter() upwards: the bits of numbers that are not negative rise with them.
  const double ulp = std::bit_cast<double>(std::bit_cast<std::uint64_t>(largest) + 1) - largest;
  return relative_tolerance * contact_distance + tolerance_in_ulps * ulp;
}

geometry::Facet PairScene::facet(SegmentIndex s) const {
  const auto& n = segments.nodes[s.value];
  geometry::Facet f{{x[n[0].value], x[n[1].value], x[n[2].value], x[n[3].value]}, n[2] == n[3]};
  if (segments.offset.empty() || segments.offset[s.value] == 0) return f;
  const Vector shift = segments.offset[s.value] * quad_normal(f.x).stableNormalized();
  for (Vector& corner : f.x) corner += shift;
  return f;
}

double PairScene::behind(SegmentIndex s) const {
  if (!oriented(s)) return 0;
  if (segments.kind[s.value] == SegmentKind::solid) return solids.empty() ? 0 : solids.extent[s.value];
  return shell_behind * min_diagonal(facet(s));
}

double PairScene::reach(SegmentIndex s, double largest_node_half) const {
  const double of_itself = std::max(largest_node_half + segments.half[s.value], behind(s));
  return nearby.empty() ? of_itself : std::max(of_itself, nearby[s.value]);
}

bool PairScene::beyond_square_edge(SegmentIndex s, const geometry::ClosestPoint& closest) const {
  if (!settings.square_edges || segments.kind[s.value] != SegmentKind::shell) return false;
  if (closest.feature == Feature::face) return false;
  // Exactly on the edge is still on the surface.
  if (closest.free_s == closest.s && closest.free_t == closest.t) return false;
  const auto& n = segments.nodes[s.value];
  const std::size_t i = closest.feature_index;
  const std::size_t next = (i + 1) % 4;
  if (closest.feature == Feature::edge) return n[i] != n[next] && neighbours.free_edge(s, n[i], n[next]);
  // A corner on the border, though this segment may have no free edge there.
  const std::span<const SegmentIndex> around = neighbours.at(n[i]);
  return std::any_of(around.begin(), around.end(), [&](SegmentIndex other) { return ends_at(other, n[i]); });
}

bool PairScene::ends_at(SegmentIndex s, NodeIndex node) const {
  if (segments.kind[s.value] != SegmentKind::shell) return false;
  const auto& n = segments.nodes[s.value];
  const std::size_t count = n[2] == n[3] ? 3 : 4;
  for (std::size_t i = 0; i < count; ++i) {
    const NodeIndex a = n[i], b = n[(i + 1) % count];
    if ((a == node || b == node) && a != b && neighbours.free_edge(s, a, b)) return true;
  }
  return false;
}

bool PairScene::slides(SlotIndex slot, SegmentIndex segment, double distance) const {
  if (own_neighbours == nullptr || segments.kind[segment.value] != SegmentKind::solid) return false;
  const geometry::Facet plane = facet(segment);
  const Vector normal = quad_normal(plane.x);
  const double near = flush * min_diagonal(plane);
  // Of a warped face the distance tells; of one beside the node, the next along a flush side, its plane.
  if (!(std::abs(distance) <= near)) {
    const Vector middle = (plane.x[0] + plane.x[1] + plane.x[2] + plane.x[3]) / 4;
    const double height = normal.dot(position(slot) - middle);
    if (!(height * height < near * near * normal.squaredNorm())) return false;
  }
  const std::span<const SegmentIndex> around = own_neighbours->at(nodes.node[slot.value]);
  for (const SegmentIndex each : around) {
    if (own->kind[each.value] != SegmentKind::solid) return false;
    const auto& n = own->nodes[each.value];
    const Vector own_normal = quad_normal(std::array{x[n[0].value], x[n[1].value], x[n[2].value], x[n[3].value]});
    const double cosine = own_normal.dot(normal);  // times both lengths
    if (cosine < 0 && cosine * cosine > against * against * own_normal.squaredNorm() * normal.squaredNorm())
      return false;
  }
  return !around.empty();
}

bool PairScene::in_front(SlotIndex slot, SegmentIndex s, const geometry::ClosestPoint& closest,
                         const Vector& query) const {
  const auto sign = [&](SegmentIndex i) { return !flipped.empty() && flipped[i.value] ? -1.0 : 1.0; };
  if (closest.feature == Feature::face) return sign(s) * closest.gap >= 0;
  // On an edge or corner one facet's normal misleads: beside a convex edge a node is behind one facet and in front of
  // the other. It is inside only where it is behind all that meet there (a concave edge).
  const auto& corners = segments.nodes[s.value];
  const std::size_t i = closest.feature_index;
  const NodeIndex a = corners[i], b = corners[(i + 1) % 4];
  for (const SegmentIndex other : neighbours.at(a)) {
    const auto& n = segments.nodes[other.value];
    if (!oriented(other)) continue;
    if (closest.feature == Feature::edge && std::find(n.begin(), n.end(), b) == n.end()) continue;
    const Vector normal = sign(other) * quad_normal(facet(other).x), from_closest = query - closest.point;
    if (!(normal.dot(from_closest) >= 0)) continue;
    if (other == s || !slides(slot, other, normal.stableNormalized().dot(from_closest))) return true;
  }
  return false;
}

namespace {

double tolerance_of(const PairScene& scene, double contact_distance, const geometry::Facet& facet,
                    const Vector& query) {
  if (scene.tolerance >= 0) return scene.tolerance;
  return default_tolerance(contact_distance, largest_coordinate(facet, query));
}

}  // namespace

double penetration_bound(const PairScene& scene, SlotIndex slot, SegmentIndex s, const geometry::Facet& facet,
                         const Vector& query) {
  const double h = scene.nodes.half[slot.value] + scene.segments.half[s.value];
  return h - tolerance_of(scene, h, facet, query);
}

PairResult measure_pair(const PairScene& scene, SlotIndex slot, SegmentIndex s) {
  return measure(scene, slot, s, scene.facet(s), scene.position(slot));
}

bool was_followed(const PairScene& scene, SlotIndex slot, SegmentIndex segment, const geometry::Facet& facet,
                  const Vector& query) {
  const double h = scene.nodes.half[slot.value] + scene.segments.half[segment.value];
  return was_followed(measure(scene, slot, segment, facet, query).distance, h, std::max(h, scene.behind(segment)),
                      tolerance_of(scene, h, facet, query));
}

Vector free_direction(const PairScene& scene, SlotIndex slot, SegmentIndex segment, const PairResult& pair) {
  // The distance is negative behind the segment.
  if (pair.distance != 0) return (scene.position(slot) - pair.closest.point) / pair.distance;
  const bool flipped = !scene.flipped.empty() && scene.flipped[segment.value];
  return flipped ? Vector(-pair.closest.normal) : pair.closest.normal;
}

PairResult decide_pair(const PairScene& scene, SlotIndex slot, SegmentIndex s) {
  const geometry::Facet facet = scene.facet(s);
  const Vector q = scene.position(slot);
  const double h = scene.nodes.half[slot.value] + scene.segments.half[s.value];
  const double tolerance = tolerance_of(scene, h, facet, q);
  PairResult result = measure(scene, slot, s, facet, q);
  if (scene.line(s)) {
    geometry::DecisionCounters once;
    result.penetrates = geometry::closer_than(facet.x[0], facet.x[1], q, h - tolerance, scene.mode, once);
    if (once.exact > 0) result.stage = geometry::Stage::exact;
    return result;
  }
  if (scene.beyond_square_edge(s, result.closest)) return result;
  const auto closer = [&](double bound) {
    const geometry::Decision decision = geometry::decide(facet, q, bound, scene.mode, &result.closest);
    result.stage = decision.stage;
    return decision.closer;
  };
  const bool behind = std::signbit(result.distance);
  if (!behind)
    result.penetrates = closer(h - tolerance);
  else if (result.in_band && -result.distance <= scene.behind(s))  // p = h + distance, as deep as the material goes
    result.penetrates = h > tolerance || !closer(tolerance - h);
  return result;
}

}  // namespace gapcheck::contact
