#include "contact/surface/contact_mesh.hpp"

#include <algorithm>
#include <array>
#include <unordered_set>

#include "base/parallel.hpp"
#include "contact/surface/segment_elements.hpp"

namespace gapcheck::contact {
namespace {

/// Remembers the segments seen before: shells by element, faces of solids by element and corners, others by their
/// nodes.
class SeenSegments {
 public:
  explicit SeenSegments(const model::Mesh& mesh) : mesh_(mesh) {}

  /// True the first time that a segment is shown.
  bool first(const Segments& s, std::size_t i) {
    const std::uint32_t e = s.element[i];
    if (e == no_position) return others_.insert(segment_key(s.nodes[i])).second;
    switch (s.element_kind[i]) {
      case model::ElementKind::shell: {
        if (shells_.empty()) shells_.resize(mesh_.shells.size());
        const bool is_first = shells_[e] == 0;
        shells_[e] = 1;
        return is_first;
      }
      case model::ElementKind::solid:
        return first_face(solids_, mesh_.solids, e, s.nodes[i]);
      case model::ElementKind::thick_shell:
        return first_face(thick_shells_, mesh_.thick_shells, e, s.nodes[i]);
      default:
        return others_.insert(segment_key(s.nodes[i])).second;
    }
  }

 private:
  /// Faces of one element that were met: for each a bit per corner of the element. An element has six.
  using Faces = std::array<std::uint8_t, 6>;

  static bool first_face(std::vector<Faces>& seen, const model::Elements<8>& elements, std::uint32_t e,
                         const model::SegmentNodes& face) {
    if (seen.empty()) seen.resize(elements.size(), Faces{});
    std::uint8_t corners = 0;
    for (std::size_t k = 0; k < 8; ++k)
      if (std::find(face.begin(), face.end(), elements.nodes[e][k]) != face.end())
        corners = static_cast<std::uint8_t>(corners | (1U << k));
    for (std::uint8_t& known : seen[e]) {
      if (known == corners) return false;
      if (known != 0) continue;
      known = corners;
      return true;
    }
    return true;
  }

  const model::Mesh& mesh_;
  std::vector<std::uint8_t> shells_;
  std::vector<Faces> solids_, thick_shells_;
  std::unordered_set<SegmentKey, SegmentKeyHash> others_;
};

/// Calls visit(lower node, higher node) for every edge of a segment.
template <class Visit>
void for_each_edge(const model::SegmentNodes& n, const Visit& visit) {
  for (std::size_t i = 0; i < 4; ++i) {
    const NodeIndex a = n[i], b = n[(i + 1) % 4];
    if (a != b) visit(std::min(a, b), std::max(a, b));
  }
}

}  // namespace

ContactMesh::ContactMesh(const model::Model& model, SurfaceStore& surfaces, std::span<const ContactIndex> contacts)
    : model_(model) {
  SeenSegments seen(model.mesh);
  const auto add = [&](const ContactSide& side, ContactIndex contact, bool ties) {
    const Segments& s = side.selection.segments;
    if (s.size() == 0) return;
    const auto source = static_cast<std::uint32_t>(sources_.size());
    sources_.push_back({&s, contact, ties});
    segments_.reserve(segments_.empty() ? s.size() : 0);
    for (std::uint32_t i = 0; i < s.size(); ++i)
      if (s.kind[i] != SegmentKind::line && seen.first(s, i)) segments_.push_back({source, i});
  };
  for (const bool ties : {false, true})
    for (const ContactIndex c : contacts) {
      const model::Contact& contact = model.contact(c);
      if (!contact.known || contact.own_layout) continue;
      const ContactType type = classify(contact);
      if (type.treatment == Treatment::none || (type.family == Family::tied) != ties) continue;
      const ContactSurfaces& s = surfaces.at(c);
      add(s.a, c, ties);
      if (s.two_sided()) add(s.b, c, ties);
    }
}

const std::vector<SegmentQuality>& ContactMesh::quality() {
  if (quality_.size() == size()) return quality_;
  quality_.resize(size());
  constexpr std::size_t grain = 8192;
  parallel_for(size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) quality_[i] = segment_quality(nodes(i), model_.mesh.nodes.x);
  });
  return quality_;
}

const std::vector<NodeIndex>& ContactMesh::corners() {
  if (!corners_.empty()) return corners_;
  std::vector<std::uint8_t> used(model_.mesh.nodes.size());
  for (std::size_t i = 0; i < size(); ++i)
    for (const NodeIndex n : nodes(i)) used[n.value] = 1;
  for (std::uint32_t n = 0; n < used.size(); ++n)
    if (used[n] != 0) corners_.emplace_back(n);
  return corners_;
}

void ContactMesh::build_edges() {
  if (!edge_start_.empty()) return;
  edge_start_.assign(model_.mesh.nodes.size() + 2, 0);
  // Counts two entries ahead, so that filling leaves every start correct.
  for (std::size_t i = 0; i < size(); ++i)
    for_each_edge(nodes(i), [&](NodeIndex a, NodeIndex) { ++edge_start_[a.value + 2]; });
  for (std::size_t n = 2; n < edge_start_.size(); ++n) edge_start_[n] += edge_start_[n - 1];
  edges_.resize(edge_start_.back());
  for (std::size_t i = 0; i < size(); ++i)
    for_each_edge(nodes(i), [&](NodeIndex a, NodeIndex b) {
      edges_[edge_start_[a.value + 1]++] = {b, static_cast<std::uint32_t>(i)};
    });
}

}  // namespace gapcheck::contact
