#include "contact/crossing/enclosed_bodies.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>

#include "base/union_find.hpp"
#include "geometry/intersect.hpp"
#include "model/entity/faces.hpp"

namespace gapcheck::contact {
namespace {

using geometry::Triangle;

struct Body {
  PartIndex part;
  std::vector<std::uint32_t> solids;  ///< ascending
  std::vector<NodeIndex> nodes;       ///< ascending, each once
  Bounds box;
};

bool fluid(const model::Model& model, PartIndex index) {
  const auto& section = model.part(index).section;
  if (!section) return false;
  constexpr std::array<std::int64_t, 5> formulations{5, 6, 7, 11, 12};
  return std::find(formulations.begin(), formulations.end(), model.sections[*section].elform) != formulations.end();
}

/// Parts of solids with the box of each; the box of any other part is empty.
std::vector<Bounds> part_boxes(const model::Model& model) {
  const model::Mesh& mesh = model.mesh;
  std::vector<Bounds> boxes(model.parts.size());
  for (std::size_t e = 0; e < mesh.solids.size(); ++e)
    if (mesh.solids.part[e] != none<PartIndex>)
      for (const NodeIndex n : mesh.solids.nodes[e]) boxes[mesh.solids.part[e].value].add(mesh.nodes.x[n.value]);
  for (std::uint32_t p = 0; p < boxes.size(); ++p)
    if (fluid(model, PartIndex{p})) boxes[p] = {};
  return boxes;
}

/// The bodies of one part. `connected`: of all nodes, used by part after part.
void append_bodies(const model::Mesh& mesh, PartIndex part, const std::vector<std::uint32_t>& solids,
                   UnionFind& connected, std::vector<bool>& listed, std::vector<Body>& bodies) {
  const auto& nodes = mesh.solids.nodes;
  // Parts that share nodes are not one body.
  for (const std::uint32_t e : solids)
    for (const NodeIndex n : nodes[e]) {
      connected.separate(n.value);
      listed[n.value] = false;
    }
  for (const std::uint32_t e : solids)
    for (const NodeIndex n : nodes[e]) connected.unite(n.value, nodes[e][0].value);
  std::map<std::uint32_t, std::size_t> body_of_root;
  for (const std::uint32_t e : solids) {
    const auto [entry, is_new] = body_of_root.emplace(connected.root(nodes[e][0].value), bodies.size());
    if (is_new) bodies.push_back({part, {}, {}, {}});
    Body& body = bodies[entry->second];
    body.solids.push_back(e);
    for (const NodeIndex n : nodes[e]) {
      if (listed[n.value]) continue;
      listed[n.value] = true;
      body.nodes.push_back(n);
      body.box.add(mesh.nodes.x[n.value]);
    }
  }
  for (const auto& [r, i] : body_of_root) std::sort(bodies[i].nodes.begin(), bodies[i].nodes.end());
}

/// Bodies of the parts whose boxes meet another part's.
std::vector<Body> candidate_bodies(const model::Model& model) {
  const std::vector<Bounds> boxes = part_boxes(model);
  std::vector<std::atomic<bool>> meets(boxes.size());
  for_each_box_pair(boxes, [&](std::uint32_t p, std::uint32_t q) { meets[p] = meets[q] = true; });
  std::vector<std::vector<std::uint32_t>> solids(boxes.size());
  const model::Elements<8>& all = model.mesh.solids;
  for (std::uint32_t e = 0; e < all.size(); ++e)
    if (all.part[e] != none<PartIndex> && meets[all.part[e].value]) solids[all.part[e].value].push_back(e);
  std::vector<Body> bodies;
  UnionFind connected(model.mesh.nodes.size());
  std::vector<bool> listed(model.mesh.nodes.size(), false);  // nodes of the part at hand that a body has
  for (std::uint32_t p = 0; p < solids.size(); ++p)
    if (!solids[p].empty()) append_bodies(model.mesh, PartIndex{p}, solids[p], connected, listed, bodies);
  return bodies;
}

/// The outer faces of a body as triangles.
std::vector<Triangle> skin(const model::Mesh& mesh, const Body& body) {
  std::vector<Triangle> triangles;
  const auto& x = mesh.nodes.x;
  for (const model::Face& face : model::exterior_faces(mesh.solids, body.solids)) {
    const auto& n = face.nodes;
    triangles.push_back({x[n[0].value], x[n[1].value], x[n[2].value]});
    if (n[2] != n[3]) triangles.push_back({x[n[0].value], x[n[2].value], x[n[3].value]});
  }
  return triangles;
}

/// Whether a point is inside a closed skin; nothing if it lies on it, or every line tried touches an edge.
std::optional<bool> inside(const Vector& point, const std::vector<Triangle>& skin, const Bounds& box,
                           const CrossingOptions& options, CrossingCounters& counters) {
  // Directions without any relation to the axes of a mesh.
  constexpr std::array<std::array<double, 3>, 4> directions{
      {{0.8137, 0.4271, 0.3943}, {-0.3319, 0.7853, 0.5227}, {0.2741, -0.5119, 0.8141}, {-0.6173, -0.4409, -0.6517}}};
  const double far = 4 * (box.high - box.low).norm();
  for (const auto& d : directions) {
    const Vector end = point + far * Vector(d[0], d[1], d[2]);
    bool odd = false, touching = false;
    for (const Triangle& t : skin) {
      const geometry::Passage way = geometry::passage(point, end, t, options.mode, counters.decisions);
      if (way == geometry::Passage::through) odd = !odd;
      touching = way == geometry::Passage::touching;
      if (touching) break;
    }
    if (!touching) return odd;
  }
  return std::nullopt;
}

bool cross(const std::vector<Triangle>& a, const std::vector<Triangle>& b, const CrossingOptions& options,
           CrossingCounters& counters) {
  const auto boxes = [](const std::vector<Triangle>& triangles) {
    std::vector<Bounds> list(triangles.size());
    for (std::size_t i = 0; i < list.size(); ++i)
      for (const Vector& x : triangles[i]) list[i].add(x);
    return list;
  };
  std::atomic<bool> any{false};
  for_each_box_pair(
      boxes(a), boxes(b),
      [&](std::uint32_t i, std::uint32_t j) {
        if (!any && geometry::triangles_cross(a[i], b[j], options.mode, counters.decisions)) any = true;
      },
      options.search);
  return any;
}

/// A node of the inner body that is inside the outer one, if all of the body is.
std::optional<Vector> enclosed(const model::Mesh& mesh, const Body& inner, const Body& outer,
                               const CrossingOptions& options, CrossingCounters& counters) {
  std::vector<NodeIndex> shared;
  std::set_intersection(inner.nodes.begin(), inner.nodes.end(), outer.nodes.begin(), outer.nodes.end(),
                        std::back_inserter(shared));
  if (!shared.empty()) return std::nullopt;
  const std::vector<Triangle> outer_skin = skin(mesh, outer);
  // A node on the other's skin decides nothing: the next one is tried, up to a limit.
  constexpr std::size_t enough = 64;
  for (std::size_t i = 0; i < std::min(enough, inner.nodes.size()); ++i) {
    const Vector& x = mesh.nodes.x[inner.nodes[i].value];
    const std::optional<bool> is_inside = inside(x, outer_skin, outer.box, options, counters);
    if (!is_inside) continue;
    if (!*is_inside || cross(skin(mesh, inner), outer_skin, options, counters)) return std::nullopt;
    return x;
  }
  return std::nullopt;
}

}  // namespace

std::vector<EnclosedBody> find_enclosed_bodies(const model::Model& model, const PairContact& acts_on,
                                               const CrossingOptions& options, CrossingCounters& counters) {
  std::vector<EnclosedBody> found;
  if (model.mesh.solids.size() == 0) return found;
  const std::vector<Body> bodies = candidate_bodies(model);
  std::vector<Bounds> boxes;
  boxes.reserve(bodies.size());
  for (const Body& body : bodies) boxes.push_back(body.box);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> nested;  // inner, outer
  std::mutex mutex;
  const auto contains = [&](std::uint32_t outer, std::uint32_t inner) {
    return (boxes[outer].low.array() <= boxes[inner].low.array()).all() &&
           (boxes[inner].high.array() <= boxes[outer].high.array()).all();
  };
  for_each_box_pair(
      boxes,
      [&](std::uint32_t i, std::uint32_t j) {
        if (bodies[i].part == bodies[j].part) return;
        const std::lock_guard lock(mutex);
        if (contains(j, i)) nested.emplace_back(i, j);
        if (contains(i, j)) nested.emplace_back(j, i);
      },
      options.search);
  std::sort(nested.begin(), nested.end());
  for (const auto& [i, j] : nested) {
    const Body &inner = bodies[i], &outer = bodies[j];
    const ContactIndex contact = acts_on(inner.part, outer.part);
    if (contact == none<ContactIndex>) continue;
    const std::optional<Vector> point = enclosed(model.mesh, inner, outer, options, counters);
    if (!point) continue;
    found.push_back(
        {inner.part, outer.part, inner.solids[0], static_cast<std::uint32_t>(inner.solids.size()), contact, *point});
  }
  std::sort(found.begin(), found.end(), [](const EnclosedBody& l, const EnclosedBody& r) {
    return std::tie(l.first_solid, l.outer) < std::tie(r.first_solid, r.outer);
  });
  return found;
}

}  // namespace gapcheck::contact
