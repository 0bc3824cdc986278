// Sides of a contact: contact rules, sections 1.3, 4.1, 4.5 and 4.6.
#include "reference/surfaces.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

namespace gapcheck::reference {
namespace {

using Quad = std::array<std::int64_t, 4>;
constexpr std::size_t brick_faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                           {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

Quad sorted(Quad nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

Vector middle(const Element& brick, const Positions& x) {
  Vector sum = Vector::Zero();
  for (const std::int64_t n : brick.nodes) sum += at(x, n);
  return sum / 8;
}

double area(const Corners& c) {
  return 0.5 * ((c[1] - c[0]).cross(c[2] - c[0]).norm() + (c[2] - c[0]).cross(c[3] - c[0]).norm());
}

/// 1.4: seen from the middle of the face.
bool inward(const Corners& c, const Vector& inside) {
  return (c[2] - c[0]).cross(c[3] - c[1]).dot((c[0] + c[1] + c[2] + c[3]) / 4 - inside) < 0;
}

Quad face_nodes(const Element& brick, std::size_t face) {
  Quad nodes;
  for (std::size_t i = 0; i < 4; ++i) nodes[i] = brick.nodes[brick_faces[face][i]];
  return nodes;
}

/// Volume as the sum of pyramids from the middle over all faces, each face as two triangles.
double volume(const Element& brick, const Positions& x) {
  const Vector m = middle(brick, x);
  double sum = 0;
  for (std::size_t f = 0; f < 6; ++f) {
    const Corners c = corners(face_nodes(brick, f), x);
    sum += std::abs((c[0] - m).dot((c[1] - m).cross(c[2] - m))) / 6;
    sum += std::abs((c[0] - m).dot((c[2] - m).cross(c[3] - m))) / 6;
  }
  return sum;
}

std::set<std::int64_t> parts_of(const Scene& scene, const Surface& surface) {
  std::set<std::int64_t> parts, members;
  for (const Set& set : scene.part_sets)
    if (set.id == surface.id) members.insert(set.members.begin(), set.members.end());
  for (const Part& part : scene.parts) {
    const bool member = members.contains(part.id);
    if (surface.type == 5 || surface.id == 0 || (surface.type == 3 && part.id == surface.id) ||
        (surface.type == 2 && member) || (surface.type == 6 && !member))
      parts.insert(part.id);
  }
  return parts;
}

class Maker {
 public:
  Maker(const Scene& scene, const Rules& rules, Which which, const Positions& x)
      : scene_(scene), rules_(rules), which_(which), x_(x) {}

  Side make() {
    const Surface& s = which_ == Which::a ? rules_.contact.a : rules_.contact.b;
    bodies();
    if (s.type == 0) {
      segment_set(s.id);
    } else if (s.type == 1) {
      shell_set(s.id);
    } else if (s.type == 4) {
      node_set(s.id);
    } else {
      side_.turned_by_default = true;
      parts(parts_of(scene_, s));
    }
    apply_box(s.box);
    return std::move(side_);
  }

 private:
  double thickness(const Element& e) const { return contact_thickness(scene_, rules_, which_, e, x_); }

  /// 4.1: free nodes have what the contact gives, but for contacts that count no thickness on this side (4.4).
  [[nodiscard]] bool counts_none() const {
    const int ignroff = rules_.contact.ignroff;
    return rules_.shlthk == 0 || ignroff == 3 || ignroff == (which_ == Which::b ? 1 : 2);
  }

  void track(std::int64_t node, double t) {
    auto& half = side_.nodes.try_emplace(node, 0.0).first->second;
    half = std::max(half, t / 2);
  }

  /// All bricks of the deck, by part: outer faces count whether they are segments or not (3.4).
  void bodies() {
    for (const Element& e : scene_.elements)
      if (e.kind == Kind::solid) side_.bodies[e.part].bricks.push_back(&e);
    for (auto& [part, body] : side_.bodies) {
      body.part = part;
      body.faces = outer_faces(body.bricks);
    }
  }

  bool corner_order_inward(const Element& brick, const Facet& facet) const {
    return inward(corners(facet.nodes, x_), middle(brick, x_));
  }

  Facet face(const Element& brick, std::size_t f) const {
    Facet facet;
    facet.nodes = face_nodes(brick, f);
    facet.solid = true;
    facet.element = brick.id;
    facet.part = brick.part;
    facet.brick = &brick;
    // 4.5: a coat of dummy shells
    facet.thickness = facet.own_thickness = rules_.contact.sldthk;
    facet.coated = facet.thickness > 0;
    facet.solid = !facet.coated;
    if (corner_order_inward(brick, facet)) std::swap(facet.nodes[1], facet.nodes[3]);
    return facet;
  }

  std::vector<Facet> outer_faces(const std::vector<const Element*>& bricks) const {
    std::map<Quad, int> owners;
    for (const Element* e : bricks)
      for (std::size_t f = 0; f < 6; ++f) ++owners[sorted(face_nodes(*e, f))];
    std::vector<Facet> faces;
    for (const Element* e : bricks)
      for (std::size_t f = 0; f < 6; ++f)
        if (owners[sorted(face_nodes(*e, f))] == 1) faces.push_back(face(*e, f));
    return faces;
  }

  void add_shell(const Element& e, const Quad& nodes) {
    Facet facet;
    facet.nodes = nodes;
    facet.triangle = nodes[2] == nodes[3];
    facet.element = e.id;
    facet.part = e.part;
    facet.thickness = thickness(e);
    facet.own_thickness = uncounted_thickness(scene_, e);
    side_.facets.push_back(facet);
    for (const std::int64_t node : nodes) track(node, facet.thickness);
  }

  void add_face(const Facet& facet) {
    side_.facets.push_back(facet);
    for (const std::int64_t node : facet.nodes) track(node, facet.thickness);
  }

  void parts(const std::set<std::int64_t>& chosen) {
    std::set<Quad> covered;
    std::vector<const Element*> bricks;
    for (const Element& e : scene_.elements) {
      if (!chosen.contains(e.part)) continue;
      if (e.kind == Kind::shell) {
        const Quad nodes{e.nodes[0], e.nodes[1], e.nodes[2], e.nodes[3]};
        covered.insert(sorted(nodes));
        add_shell(e, nodes);
      } else if (e.kind == Kind::solid) {
        bricks.push_back(&e);
      }
    }
    for (const Facet& facet : outer_faces(bricks))
      if (!covered.contains(sorted(facet.nodes))) add_face(facet);
    for (const Element& e : scene_.elements)
      if (e.kind == Kind::beam && chosen.contains(e.part)) add_beam(e);
  }

  /// 4.6: tracked nodes; in types 26 reference lines too.
  void add_beam(const Element& e) {
    for (const std::int64_t node : e.nodes) track(node, thickness(e));
    if (!rules_.kind.can(model::Ability::edges)) return;
    Facet facet;
    facet.nodes = {e.nodes[0], e.nodes[1], e.nodes[1], e.nodes[1]};
    facet.line = true;
    facet.element = e.id;
    facet.part = e.part;
    facet.thickness = facet.own_thickness = thickness(e);
    side_.facets.push_back(facet);
  }

  void shell_set(std::int64_t id) {
    for (const Set& set : scene_.shell_sets)
      if (set.id == id)
        for (const std::int64_t member : set.members)
          for (const Element& e : scene_.elements)
            if (e.id == member && e.kind == Kind::shell) add_shell(e, {e.nodes[0], e.nodes[1], e.nodes[2], e.nodes[3]});
  }

  void segment_set(std::int64_t id) {
    for (const SegmentSet& set : scene_.segment_sets)
      if (set.id == id)
        for (auto at = set.segments.begin(); at != set.segments.end(); ++at)
          if (std::find(set.segments.begin(), at, *at) == at) add_segment(*at);  // 1.3: named twice counts once
  }

  /// The shell with these nodes, else the brick with this face.
  void add_segment(const Quad& nodes) {
    for (const Element& e : scene_.elements)
      if (e.kind == Kind::shell && sorted({e.nodes[0], e.nodes[1], e.nodes[2], e.nodes[3]}) == sorted(nodes))
        return add_shell(e, nodes);
    for (const auto& [part, body] : side_.bodies)
      for (const Facet& facet : body.faces)
        if (sorted(facet.nodes) == sorted(nodes)) return add_face(facet);
  }

  /// 4.1: nodes of a set take the largest thickness of all their elements; without elements that of SST.
  void node_set(std::int64_t id) {
    for (const Set& set : scene_.node_sets) {
      if (set.id != id) continue;
      for (const std::int64_t node : set.members) {
        bool any = false;
        track(node, 0);
        for (const Element& e : scene_.elements) {
          if (std::find(e.nodes.begin(), e.nodes.end(), node) == e.nodes.end()) continue;
          any = true;
          track(node, e.kind == Kind::solid ? rules_.contact.sldthk : thickness(e));
        }
        const double given = which_ == Which::a ? rules_.contact.sst : rules_.contact.mst;
        if (!any && !counts_none()) track(node, std::max(0.0, given));
      }
    }
  }

  /// Segments wholly inside, tracked nodes inside.
  void apply_box(std::int64_t id) {
    for (const Box& box : scene_.boxes) {
      if (box.id != id) continue;
      const auto outside = [&](std::int64_t node) {
        const Vector& p = at(x_, node);
        return (p.array() < box.low.array()).any() || (p.array() > box.high.array()).any();
      };
      std::erase_if(side_.facets,
                    [&](const Facet& facet) { return std::any_of(facet.nodes.begin(), facet.nodes.end(), outside); });
      std::erase_if(side_.nodes, [&](const auto& node) { return outside(node.first); });
    }
  }

  const Scene& scene_;
  const Rules& rules_;
  Which which_;
  const Positions& x_;
  Side side_;
};

}  // namespace

bool Facet::has(std::int64_t node) const { return std::find(nodes.begin(), nodes.end(), node) != nodes.end(); }

Corners corners(const std::array<std::int64_t, 4>& nodes, const Positions& x) {
  return {at(x, nodes[0]), at(x, nodes[1]), at(x, nodes[2]), at(x, nodes[3])};
}

Closest closest_of(const Facet& facet, const Corners& x, const Vector& query) {
  return facet.line ? closest_on_line(x, query) : closest(x, facet.triangle, query);
}

double solid_depth(const Facet& facet, const Positions& x) {
  return volume(*facet.brick, x) / area(corners(facet.nodes, x));
}

double shorter_diagonal(const Facet& facet, const Positions& x) {
  const Corners c = corners(facet.nodes, x);
  return std::min((c[2] - c[0]).norm(), (c[3] - c[1]).norm());
}

std::vector<Facet> faces_of(const Element& brick, const Positions& x) {
  std::vector<Facet> faces;
  for (std::size_t f = 0; f < 6; ++f) {
    Facet& face = faces.emplace_back();
    face.nodes = face_nodes(brick, f);
    if (inward(corners(face.nodes, x), middle(brick, x))) std::swap(face.nodes[1], face.nodes[3]);
  }
  return faces;
}

Side make_side(const Scene& scene, const Rules& rules, Which which, const Positions& x) {
  return Maker(scene, rules, which, x).make();
}

}  // namespace gapcheck::reference
