#include "contact/surface/erosion.hpp"

#include <algorithm>
#include <optional>
#include <unordered_set>

#include "contact/mesh/faces.hpp"
#include "contact/surface/segment_elements.hpp"
#include "contact/surface/surface_parts.hpp"
#include "contact/surface/symmetry.hpp"

namespace gapcheck::contact {
namespace {

using model::ElementKind;

bool is_gone(const GoneElements& gone, ElementKind kind, std::uint32_t element) {
  switch (kind) {
    case ElementKind::shell:
      return gone.shell(element);
    case ElementKind::solid:
      return gone.solid(element);
    case ElementKind::beam:
      return gone.beam(element);
    default:
      return false;
  }
}

template <class T>
void keep(std::vector<T>& list, const std::vector<bool>& kept) {
  if (list.empty()) return;
  std::size_t place = 0;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) list[place++] = list[i];
  list.resize(place);
}

void keep_segments(Segments& s, const std::vector<bool>& kept) {
  keep(s.nodes, kept);
  keep(s.element, kept);
  keep(s.element_kind, kept);
  keep(s.kind, kept);
  keep(s.half, kept);
  keep(s.rule, kept);
  keep(s.offset, kept);
}

/// A face shared by solids, as one of them has it.
struct NewFace {
  Face face;
  SegmentKey key;
};

/// Faces of solids of the chosen parts that are left, where the solid on the other side is gone; by the position of the
/// gone ones.
std::vector<NewFace> opened_faces(const model::Model& model, const std::vector<bool>& parts, const GoneElements& gone,
                                  MeshIndex& index) {
  const model::Elements<8>& solids = model.mesh.solids;
  std::vector<NewFace> opened;
  const std::uint32_t count = static_cast<std::uint32_t>(std::min(gone.solids.size(), solids.size()));
  for (std::uint32_t e = 0; e < count; ++e) {
    if (!gone.solids[e]) continue;
    for (const model::SegmentNodes& face : model::SolidFaces(solids.nodes[e])) {
      const SegmentKey key = segment_key(face);
      std::uint32_t last = e;
      for (const std::uint32_t other : index.solids.at(face[0])) {
        if (other == last || other == e || gone.solid(other)) continue;
        last = other;
        const PartIndex part = solids.part[other];
        if (part == none<PartIndex> || !parts[part.value]) continue;
        for (const model::SegmentNodes& own : model::SolidFaces(solids.nodes[other]))
          if (segment_key(own) == key) opened.push_back({{own, other}, key});
      }
    }
  }
  return opened;
}

/// Elements of a node: whether there are any, and whether any remain.
struct NodeElements {
  bool any = false, left = false, solids = false;
};

NodeElements elements_at(NodeIndex node, const GoneElements& gone, MeshIndex& index) {
  NodeElements sum;
  for (const std::uint32_t e : index.shells.at(node)) {
    sum.any = true;
    sum.left |= !gone.shell(e);
  }
  for (const std::uint32_t e : index.solids.at(node)) {
    sum.any = sum.solids = true;
    sum.left |= !gone.solid(e);
  }
  for (const std::uint32_t e : index.beams.at(node)) {
    sum.any = true;
    sum.left |= !gone.beam(e);
  }
  for (ElementIndex* others : {&index.thick_shells, &index.particles})
    if (!others->at(node).empty()) sum.any = sum.left = true;
  return sum;
}

class SideErosion {
 public:
  SideErosion(const model::Model& model, const model::SurfaceInput& input, const ContactSide& start,
              const GoneElements& gone, const std::vector<Vector>& x, MeshIndex& index)
      : model_(model), input_(input), start_(start), gone_(gone), x_(x), index_(index) {}

  /// `symmetry`: opened faces on these planes are left out; nullptr: none is.
  void erode(ContactSide& side, bool inner_faces, const SymmetryPlanes* symmetry) const {
    Segments& s = side.selection.segments;
    std::vector<bool> kept(s.size());
    for (std::size_t i = 0; i < s.size(); ++i) kept[i] = !is_gone(gone_, s.element_kind[i], s.element[i]);
    side.lines = static_cast<std::size_t>(
        std::count(kept.end() - static_cast<std::ptrdiff_t>(std::min(side.lines, kept.size())), kept.end(), true));
    keep_segments(s, kept);
    const std::size_t first = s.size() - side.lines;
    const std::size_t added = inner_faces && (whole_parts(input_) || (input_.id == 0 && input_.box == 0))
                                  ? add_faces(side, first, symmetry)
                                  : 0;
    erode_nodes(side);
    if (side.nodes.size() > 0 || start_.nodes.size() > 0) add_nodes(side.nodes, s, first, added);
  }

 private:
  /// Inserts opened faces before the beams' lines; returns their number.
  std::size_t add_faces(ContactSide& side, std::size_t place, const SymmetryPlanes* symmetry) const {
    Segments& s = side.selection.segments;
    std::vector<bool> parts(model_.parts.size(), false);
    for (const PartIndex part : parts_of(model_, start_)) parts[part.value] = true;
    std::unordered_set<SegmentKey, SegmentKeyHash> there;
    for (const model::SegmentNodes& nodes : s.nodes) there.insert(segment_key(nodes));
    std::size_t added = 0;
    const Segments& before = start_.selection.segments;
    const auto solid = std::find(before.element_kind.begin(), before.element_kind.end(), ElementKind::solid);
    if (solid == before.element_kind.end()) return 0;
    const auto like = static_cast<std::size_t>(solid - before.element_kind.begin());
    for (NewFace& opened : opened_faces(model_, parts, gone_, index_)) {
      if (!there.insert(opened.key).second) continue;
      if (symmetry != nullptr && symmetry->holds(opened.face.nodes, x_)) continue;
      turn_outward(opened.face, model_.mesh.solids.nodes[opened.face.element], x_);
      const auto at = static_cast<std::ptrdiff_t>(place + added);
      s.nodes.insert(s.nodes.begin() + at, opened.face.nodes);
      s.element.insert(s.element.begin() + at, opened.face.element);
      s.element_kind.insert(s.element_kind.begin() + at, ElementKind::solid);
      s.kind.insert(s.kind.begin() + at, before.kind[like]);
      s.half.insert(s.half.begin() + at, before.half[like]);
      s.rule.insert(s.rule.begin() + at, before.rule[like]);
      if (!s.offset.empty()) s.offset.insert(s.offset.begin() + at, 0.0);
      ++added;
    }
    return added;
  }

  void erode_nodes(ContactSide& side) const {
    const auto stays = [&](NodeIndex node) {
      const NodeElements elements = elements_at(node, gone_, index_);
      if (!elements.any || elements.left) return true;
      const std::int64_t kept = model_.controls.enmass;
      return kept == 2 || (kept == 1 && elements.solids);
    };
    TrackedNodes& nodes = side.nodes;
    std::vector<bool> kept(nodes.size());
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = stays(nodes.node[i]);
    keep(nodes.node, kept);
    keep(nodes.half, kept);
    keep(nodes.rule, kept);
    keep(nodes.part, kept);
    keep(nodes.shift, kept);
  }

  /// Nodes of the segments from `first` on that are not tracked yet.
  void add_nodes(TrackedNodes& nodes, const Segments& s, std::size_t first, std::size_t count) const {
    for (std::size_t i = first; i < first + count; ++i)
      for (const NodeIndex node : s.nodes[i]) {
        const auto at = std::lower_bound(nodes.node.begin(), nodes.node.end(), node,
                                         [](NodeIndex a, NodeIndex b) { return a.value < b.value; });
        if (at != nodes.node.end() && *at == node) continue;
        const std::ptrdiff_t place = at - nodes.node.begin();
        nodes.node.insert(at, node);
        nodes.half.insert(nodes.half.begin() + place, s.half[i]);
        nodes.rule.insert(nodes.rule.begin() + place, s.rule[i]);
        nodes.part.insert(nodes.part.begin() + place, part_of(model_.mesh, s, i));
        if (!nodes.shift.empty()) nodes.shift.insert(nodes.shift.begin() + place, Vector::Zero());
      }
  }

  const model::Model& model_;
  const model::SurfaceInput& input_;
  const ContactSide& start_;
  const GoneElements& gone_;
  const std::vector<Vector>& x_;
  MeshIndex& index_;
};

}  // namespace

bool is_eroding(const ContactType& type) {
  return type.code == ContactCode::eroding_surface || type.code == ContactCode::eroding_single ||
         type.code == ContactCode::eroding_nodes;
}

ContactSurfaces erode_surfaces(const model::Model& model, const model::Contact& contact, const ContactSurfaces& start,
                               const ContactSurfaces& now, const GoneElements& gone, const std::vector<Vector>& x,
                               MeshIndex& index) {
  const bool inner_faces = is_eroding(now.type) && (contact.erosop == 1 || contact.iadj == 1);
  const std::optional<SymmetryPlanes> symmetry =
      inner_faces && contact.symmetry_faces == 1 ? std::optional<SymmetryPlanes>(model) : std::nullopt;
  const auto left = [&](const model::SurfaceInput& input, const ContactSide& before, const ContactSide& side) {
    ContactSide remaining = side;
    SideErosion(model, input, before, gone, x, index).erode(remaining, inner_faces, symmetry ? &*symmetry : nullptr);
    return std::make_shared<const ContactSide>(std::move(remaining));
  };
  return {now.type, now.settings, left(contact.a, start.a, now.a),
          now.two_sided() ? left(contact.b, start.b, now.b) : nullptr};
}

}  // namespace gapcheck::contact
