#include "contact/pair/hidden_faces.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_set>

#include "base/quad.hpp"
#include "base/union_find.hpp"
#include "contact/mesh/faces.hpp"
#include "contact/surface/segment_elements.hpp"

namespace gapcheck::contact {
namespace {

bool behind_solid(const PairScene& scene, const Hit& hit) {
  return std::signbit(hit.distance) && scene.segments.kind[hit.segment.value] == SegmentKind::solid;
}

/// Outer faces of the solids in a contact that meet a box and are not among its segments, with the body that each
/// bounds.
class HiddenFaces {
 public:
  HiddenFaces(const PairScene& scene, const Bounds& box) : scene_(scene), box_(box), connected_(scene.x.size()) {
    const model::Mesh& mesh = scene.model.mesh;
    std::vector<bool> parts(scene.model.parts.size(), false);
    std::unordered_set<SegmentKey, SegmentKeyHash> segments;
    for (std::size_t s = 0; s < scene.segments.size(); ++s) {
      if (scene.segments.kind[s] != SegmentKind::solid) continue;
      if (meets_box(scene.segments.nodes[s])) segments.insert(segment_key(scene.segments.nodes[s]));
      if (const PartIndex part = part_of(mesh, scene.segments, s); part != none<PartIndex>) parts[part.value] = true;
    }
    add(mesh.solids, parts, segments);
    add(mesh.thick_shells, parts, segments);
  }

  [[nodiscard]] const std::vector<model::SegmentNodes>& list() const { return faces_; }
  /// The connected body of a node's elements.
  [[nodiscard]] std::uint32_t body(NodeIndex node) { return connected_.root(node.value); }

 private:
  [[nodiscard]] bool meets_box(std::span<const NodeIndex> nodes) const {
    Bounds bounds;
    for (const NodeIndex n : nodes) bounds.add(scene_.x[n.value]);
    return bounds.meets(box_);
  }

  void add(const model::Elements<8>& elements, const std::vector<bool>& parts,
           const std::unordered_set<SegmentKey, SegmentKeyHash>& segments) {
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t e = 0; e < elements.size(); ++e) {
      if (elements.part[e] == none<PartIndex> || !parts[elements.part[e].value]) continue;
      if (meets_box(elements.nodes[e])) chosen.push_back(e);
      for (const NodeIndex n : elements.nodes[e]) connected_.unite(n.value, elements.nodes[e][0].value);
    }
    if (chosen.empty()) return;
    // Both elements at a face that meets the box do.
    for (const Face& face : free_faces(elements, chosen, scene_.x))
      if (meets_box(face.nodes) && !segments.contains(segment_key(face.nodes))) faces_.push_back(face.nodes);
  }

  const PairScene& scene_;
  const Bounds box_;
  UnionFind connected_;
  std::vector<model::SegmentNodes> faces_;
};

/// Position of a node relative to a hidden face.
struct Seen {
  std::uint32_t point = 0, body = 0;
  double distance = 0;
  bool in_front = false;  ///< or on it
  bool own = false;       ///< the node is a corner of the face
};

Seen look(const PairScene& scene, const model::SegmentNodes& n, const Vector& q) {
  const geometry::Facet facet{{scene.x[n[0].value], scene.x[n[1].value], scene.x[n[2].value], scene.x[n[3].value]},
                              n[2] == n[3]};
  const auto closest = geometry::closest_point(facet, q);
  Seen seen;
  seen.distance = std::sqrt(closest.squared_distance);
  seen.in_front = closest.normal.dot(q - closest.point) >= -default_tolerance(0, largest_coordinate(facet, q));
  return seen;
}

/// The nodes of hits behind solid facets, and where they are.
struct Points {
  std::vector<Vector> x;
  std::vector<NodeIndex> node;
};

/// Everything near them, by node.
std::vector<Seen> look_around(const PairScene& scene, const CandidateSearch& search, HiddenFaces& faces,
                              const Points& points, double reach) {
  std::vector<Bounds> boxes;
  std::vector<std::uint32_t> bodies;
  for (const model::SegmentNodes& n : faces.list()) {
    Bounds box;
    for (const NodeIndex node : n) box.add(scene.x[node.value]);
    boxes.push_back(grown(box, reach));
    bodies.push_back(faces.body(n[0]));
  }
  tbb::enumerable_thread_specific<std::vector<Seen>> found;
  search.run(points.x, boxes, [&](std::uint32_t face, std::span<const std::uint32_t> inside) {
    const model::SegmentNodes& nodes = faces.list()[face];
    for (const std::uint32_t p : inside) {
      Seen seen = look(scene, nodes, points.x[p]);
      seen.own = std::find(nodes.begin(), nodes.end(), points.node[p]) != nodes.end();
      if (seen.own) seen.distance = 0;
      seen.point = p;
      seen.body = bodies[face];
      if (seen.distance <= reach) found.local().push_back(seen);
    }
  });
  std::vector<Seen> all;
  for (const std::vector<Seen>& some : found) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end(), [](const Seen& l, const Seen& r) {
    return std::tuple(l.point, l.distance, !l.own) < std::tuple(r.point, r.distance, !r.own);
  });
  return all;
}

/// True if a node is behind all faces of the solid that has a segment, and not one of its corners: these lie in the
/// planes of three faces but for rounding.
bool in_element(const PairScene& scene, SegmentIndex segment, SlotIndex slot) {
  const model::Mesh& mesh = scene.model.mesh;
  const bool solid = scene.segments.element_kind[segment.value] == model::ElementKind::solid;
  const std::uint32_t element = scene.segments.element[segment.value];
  const std::vector<Vector>& x = scene.x;
  const std::array<NodeIndex, 8>& corners = (solid ? mesh.solids : mesh.thick_shells).nodes[element];
  if (std::find(corners.begin(), corners.end(), scene.nodes.node[slot.value]) != corners.end()) return false;
  const Vector q = scene.position(slot);
  const std::vector<Face> faces = faces_of(corners, element, x);
  return std::all_of(faces.begin(), faces.end(), [&](const Face& face) {
    const auto& n = face.nodes;
    const Vector centre = (x[n[0].value] + x[n[1].value] + x[n[2].value] + x[n[3].value]) / 4;
    return quad_normal(n, x).dot(q - centre) < 0;
  });
}

/// True if the nearest of a body's faces is nearer than the hit's and the node is in front of it. A node of the body
/// itself is always on its surface: it is inside only where another element of the body has it. `around`: the node's.
bool outside(const PairScene& scene, std::span<const Seen> around, std::uint32_t body, const Hit& hit) {
  const Seen* nearest = nullptr;
  for (const Seen& seen : around) {
    if (seen.body != body) continue;
    if (nearest == nullptr) {
      if (!(seen.distance * (1 + equally_near) < -hit.distance)) return false;
      if (seen.own) return !in_element(scene, hit.segment, hit.slot);
      nearest = &seen;
    }
    if (seen.distance > nearest->distance * (1 + equally_near)) return false;
    if (seen.in_front) return true;
  }
  return false;
}

}  // namespace

void drop_outside(const PairScene& scene, const CandidateSearch& search, std::vector<Hit>& hits) {
  Points points;
  std::vector<std::uint32_t> point_of(scene.nodes.size(), no_position);
  double reach = 0;
  Bounds box;
  for (const Hit& hit : hits) {
    if (!behind_solid(scene, hit)) continue;
    reach = std::max(reach, -hit.distance);
    if (point_of[hit.slot.value] != no_position) continue;
    point_of[hit.slot.value] = static_cast<std::uint32_t>(points.x.size());
    points.x.push_back(scene.position(hit.slot));
    points.node.push_back(scene.nodes.node[hit.slot.value]);
    box.add(points.x.back());
  }
  if (points.x.empty()) return;
  HiddenFaces faces(scene, grown(box, reach));
  const bool single = scene.type.treatment == Treatment::single_surface;
  const std::vector<Seen> seen = look_around(scene, search, faces, points, reach);
  const auto around = [&](std::uint32_t point) {
    const auto [first, last] = std::equal_range(seen.begin(), seen.end(), Seen{point, 0, 0, false, false},
                                                [](const Seen& l, const Seen& r) { return l.point < r.point; });
    return std::span<const Seen>(first, last);
  };
  std::erase_if(hits, [&](const Hit& hit) {
    if (!behind_solid(scene, hit)) return false;
    const std::uint32_t body = faces.body(scene.segments.nodes[hit.segment.value][0]);
    // A node of the body, as of shells that coat it, is on its surface; single surfaces leave its neighbours out.
    if (!single && faces.body(scene.nodes.node[hit.slot.value]) == body)
      return !in_element(scene, hit.segment, hit.slot);
    return outside(scene, around(point_of[hit.slot.value]), body, hit);
  });
}

}  // namespace gapcheck::contact
