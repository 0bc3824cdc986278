#include "contact/rigid_wall.hpp"

#include <algorithm>
#include <cmath>

#include "contact/mesh/element_nodes.hpp"
#include "contact/mesh/rigid_nodes.hpp"

namespace gapcheck::contact {
namespace {

using Shape = model::RigidWall::Shape;

/// A face of a wall: the point's depth below it, and the face's outward normal.
struct WallFace {
  double depth;
  Vector normal;
};

/// The face with the smallest depth of the point; a depth that is not positive means that it is outside.
std::optional<WallPenetration> nearest_face(std::initializer_list<WallFace> faces, const Vector& x, double tolerance) {
  const WallFace face = *std::min_element(faces.begin(), faces.end(),
                                          [](const WallFace& a, const WallFace& b) { return a.depth < b.depth; });
  if (!(face.depth > tolerance) || !std::isfinite(face.depth)) return std::nullopt;
  return WallPenetration{face.depth, x + face.depth * face.normal, face.normal};
}

/// Rounding of the deck's numbers is not a penetration.
double touching(const model::RigidWall& wall, const Vector& x) {
  return 1e-9 * (x - wall.tail).norm() + 1e-15 * (x.norm() + wall.tail.norm()) + 1e-9 * wall.radius;
}

std::optional<WallPenetration> in_plane_wall(const model::RigidWall& wall, const Vector& x, double tolerance) {
  const Vector from_tail = x - wall.tail;
  const double depth = -from_tail.dot(wall.normal), l = from_tail.dot(wall.edge_l), m = from_tail.dot(wall.edge_m);
  const auto inside = [&](double along, double length) {
    return !std::isfinite(length) || (along >= -tolerance && along <= length + tolerance);
  };
  if (!inside(l, wall.length_l) || !inside(m, wall.length_m)) return std::nullopt;
  return nearest_face({{depth, wall.normal}}, x, tolerance);
}

std::optional<WallPenetration> in_prism(const model::RigidWall& wall, const Vector& x, double tolerance) {
  const Vector from_tail = x - wall.tail;
  const double depth = -from_tail.dot(wall.normal);
  const double l = from_tail.dot(wall.edge_l), m = from_tail.dot(wall.edge_m);
  const auto before = [](double along, double length) { return std::isfinite(length) ? along : INFINITY; };
  return nearest_face({{depth, wall.normal},
                       {wall.length_p - depth, -wall.normal},
                       {before(l, wall.length_l), -wall.edge_l},
                       {wall.length_l - l, wall.edge_l},
                       {before(m, wall.length_m), -wall.edge_m},
                       {wall.length_m - m, wall.edge_m}},
                      x, tolerance);
}

/// `out`: from the axis or centre to the point.
std::optional<WallPenetration> in_round(const model::RigidWall& wall, const Vector& x, const Vector& out, double low,
                                        double high, double tolerance) {
  const double distance = out.norm();
  Vector radial = distance > 0 ? Vector(out / distance) : Vector(wall.normal.unitOrthogonal());
  if (!wall.interior)
    return nearest_face({{wall.radius - distance, radial}, {low, -wall.normal}, {high, wall.normal}}, x, tolerance);
  // Kept inside: only leaving through the mantle counts, the ends are open.
  if (low < 0 || high < 0) return std::nullopt;
  return nearest_face({{distance - wall.radius, -radial}}, x, tolerance);
}

}  // namespace

std::optional<WallPenetration> wall_penetration(const model::RigidWall& wall, const Vector& x) {
  return wall_penetration(wall, x, touching(wall, x));
}

std::optional<WallPenetration> wall_penetration(const model::RigidWall& wall, const Vector& x, double tolerance) {
  if (!x.allFinite()) return std::nullopt;
  const Vector from_tail = x - wall.tail;
  switch (wall.shape) {
    case Shape::plane:
      return in_plane_wall(wall, x, tolerance);
    case Shape::prism:
      return in_prism(wall, x, tolerance);
    case Shape::cylinder: {
      const double along = from_tail.dot(wall.normal);
      const bool finite = std::isfinite(wall.length_l);
      return in_round(wall, x, from_tail - along * wall.normal, finite ? along : INFINITY,
                      finite ? wall.length_l - along : INFINITY, tolerance);
    }
    case Shape::sphere:
      return in_round(wall, x, from_tail, INFINITY, INFINITY, tolerance);
  }
  return std::nullopt;
}

WallNodes::WallNodes(const model::Model& model) : model_(model) {
  if (model.controls.rwpnal == 0) rigid_.emplace(model);
}

std::vector<NodeIndex> WallNodes::of(const model::RigidWall& wall) {
  const model::Mesh& mesh = model_.mesh;
  std::vector<NodeIndex> nodes, exempted;
  if (wall.node_set == 0) {
    if (all_.empty()) {
      const std::vector<std::uint8_t> used = element_nodes(mesh);
      for (std::uint32_t n = 0; n < used.size(); ++n)
        if (used[n] != 0) all_.emplace_back(n);
    }
    nodes = all_;
  } else if (const auto set = model_.sets.nodes.find(wall.node_set); set != model_.sets.nodes.end()) {
    nodes = set->second.members;
    std::sort(nodes.begin(), nodes.end());
  }
  if (const auto set = model_.sets.nodes.find(wall.exempted_set); set != model_.sets.nodes.end()) {
    exempted = set->second.members;
    std::sort(exempted.begin(), exempted.end());
  }
  const auto box = model_.boxes.find(wall.box);
  std::erase_if(nodes, [&](NodeIndex n) {
    const Vector& x = mesh.nodes.x[n.value];
    if (rigid_ && rigid_->owner(n)) return true;
    if (box != model_.boxes.end() && !box->second.contains(x)) return true;
    if (wall.offset > 0 && !(std::abs((x - wall.tail).dot(wall.normal)) <= wall.offset)) return true;
    return std::binary_search(exempted.begin(), exempted.end(), n);
  });
  return nodes;
}

}  // namespace gapcheck::contact
