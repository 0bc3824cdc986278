#include "audit/untangle/untangling.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "contact/crossing/crossings.hpp"

namespace gapcheck::audit {
namespace {

/// Half the contact thickness of a node and how far it is from its mid-surface: as tracked, else of its segments.
struct NodeThickness {
  double half = 0;
  Vector shift = Vector::Zero();

  NodeThickness(const CutSurface& surface, NodeIndex node) {
    const contact::TrackedNodes& tracked = surface.side().nodes;
    const auto found = std::lower_bound(tracked.node.begin(), tracked.node.end(), node);
    if (found != tracked.node.end() && *found == node) {
      const auto slot = static_cast<std::size_t>(found - tracked.node.begin());
      half = tracked.half[slot];
      if (!tracked.shift.empty()) shift = tracked.shift[slot];
      return;
    }
    for (const SegmentIndex s : surface.neighbours().at(node)) half = std::max(half, surface.segments().half[s.value]);
  }
};

double diagonal_of(const CutSurface& surface, SegmentIndex s) {
  const auto& n = surface.segments().nodes[s.value];
  return (surface.x()[n[2].value] - surface.x()[n[0].value]).norm();
}

/// How far pieces at a contour may reach.
double reach_at(const CutSurface& first, const CutSurface& second, const model::Mesh& mesh, const Contour& contour) {
  double size = 0, half = 0;
  std::size_t count = 0;
  for (const auto& [surface, elements] : {std::pair(&first, &contour.elements[0]), {&second, &contour.elements[1]}})
    for (const SegmentIndex s : surface->around(mesh, *elements)) {
      size += diagonal_of(*surface, s);
      half = std::max(half, surface->segments().half[s.value]);
      ++count;
    }
  return Untangling::reach(count > 0 ? size / static_cast<double>(count) : 0, 2 * half);
}

/// True if any pair of the contour is among these.
bool contains_any(const Contour& contour, std::span<const ElementPair> pairs, const std::set<ElementPair>& left_alone) {
  if (left_alone.empty()) return false;
  const auto on = [](const std::vector<ElementOfKind>& list, const ElementOfKind& element) {
    return std::binary_search(list.begin(), list.end(), element);
  };
  return std::any_of(pairs.begin(), pairs.end(), [&](const ElementPair& p) {
    return left_alone.contains(p) && ((on(contour.elements[0], p.first) && on(contour.elements[1], p.second)) ||
                                      (on(contour.elements[1], p.first) && on(contour.elements[0], p.second)));
  });
}

}  // namespace

Untangling::Untangling(const model::Model& model, contact::SurfaceStore& surfaces, const std::vector<Vector>& x,
                       std::span<const ContactCrossing> crossings, const std::set<ElementPair>& left_alone,
                       std::uint64_t& work) {
  for (auto from = crossings.begin(); from != crossings.end();) {
    const auto to =
        std::find_if(from, crossings.end(), [&](const ContactCrossing& c) { return c.contact != from->contact; });
    std::vector<ElementPair> pairs;
    for (auto c = from; c != to; ++c) pairs.push_back(c->elements);
    take_contact(model, surfaces.at(from->contact), from->contact, x, pairs, left_alone, work);
    from = to;
  }
}

void Untangling::take_contact(const model::Model& model, const contact::ContactSurfaces& surfaces, ContactIndex contact,
                              const std::vector<Vector>& x, std::span<const ElementPair> pairs,
                              const std::set<ElementPair>& left_alone, std::uint64_t& work) {
  const CutSurface a(surfaces.a, model.mesh, x);
  std::optional<CutSurface> of_b;
  if (surfaces.two_sided()) of_b.emplace(surfaces.b, model.mesh, x);
  const CutSurface& b = of_b ? *of_b : a;
  for (const Contour& contour : find_contours(model.mesh, pairs)) {
    CrossingPlace place;
    place.contact = contact;
    place.elements = contour.elements;
    place.pairs = contour.pairs;
    if (!contains_any(contour, pairs, left_alone)) {
      // On side A are the first elements, or in contacts with two sides perhaps the second ones.
      const bool turned = a.around(model.mesh, contour.elements[0]).empty();
      const CutSurface &first = turned ? b : a, &second = turned ? a : b;
      const double reach = reach_at(first, second, model.mesh, contour);
      for (const WrongPiece& piece : find_wrong_pieces(contour, model.mesh, first, second, reach, work)) {
        place.divided = true;
        if (piece.other_is_second)
          take_piece(piece, first, second, place, work);
        else
          take_piece(piece, second, first, place, work);
      }
    }
    places_.push_back(std::move(place));
  }
}

/// Adds its nodes and sides, or to `place` how deep it is if that is too deep.
void Untangling::take_piece(const WrongPiece& piece, const CutSurface& own, const CutSurface& other,
                            CrossingPlace& place, std::uint64_t& work) {
  const auto facing = face_piece(piece, other, work);
  if (!facing || facing->empty()) return;
  double deepest = 0, distance = 0, size = 0;
  std::vector<KnownSide> found;
  Nodes nodes;
  for (const Facing& f : *facing) {
    const std::size_t segment = f.face.segment.value;
    const NodeThickness thickness(own, f.node);
    KnownSide known;
    known.contact = place.contact;
    known.node = f.node;
    known.corners = other.segments().nodes[segment];
    known.side = f.face.side;
    known.distance = thickness.half + other.segments().half[segment];
    known.shift = thickness.shift;
    if (!other.segments().offset.empty()) known.offset = other.segments().offset[segment];
    known.depth = known.distance + (f.wrong ? f.depth : -f.depth);
    // Segments that graze each other are not far enough from each other, though their corners may be.
    known.step = 2 * contact::crossing_tolerance * diagonal_of(other, f.face.segment);
    if (piece.nodes.empty()) known.depth = std::max(known.depth, known.step);
    nodes.other.insert(known.corners.begin(), known.corners.end());
    if (f.wrong) deepest = std::max(deepest, f.depth);
    distance = std::max(distance, known.distance);
    size += diagonal_of(other, f.face.segment);
    if (known.depth > 0) found.push_back(known);
  }
  size /= static_cast<double>(facing->size());
  if (deepest > reach(size, distance)) {
    place.too_deep = std::max(place.too_deep, deepest);
    return;
  }
  const std::vector<NodeIndex>& changing = piece.nodes.empty() ? piece.rim : piece.nodes;
  place.nodes.insert(place.nodes.end(), changing.begin(), changing.end());
  nodes.piece.insert(piece.nodes.begin(), piece.nodes.end());
  nodes.piece.insert(piece.rim.begin(), piece.rim.end());
  sides_.insert(sides_.end(), found.begin(), found.end());
  nodes_.push_back(std::move(nodes));
}

bool Untangling::at_crossing(NodeIndex node, const model::SegmentNodes& segment) const {
  const auto on = [&](const std::set<NodeIndex>& nodes) {
    return std::any_of(segment.begin(), segment.end(), [&](NodeIndex n) { return nodes.contains(n); });
  };
  return std::any_of(nodes_.begin(), nodes_.end(), [&](const Nodes& at) {
    return (at.piece.contains(node) && on(at.other)) || (at.other.contains(node) && on(at.piece));
  });
}

}  // namespace gapcheck::audit
